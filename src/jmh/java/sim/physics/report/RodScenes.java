// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.ArrayList;
import java.util.List;
import org.dyn4j.collision.CategoryFilter;
import org.dyn4j.dynamics.ContinuousDetectionMode;
import org.dyn4j.dynamics.joint.RevoluteJoint;
import org.dyn4j.geometry.Geometry;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Vector2;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.joints.RevoluteJointDef;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.references.RodChain;
import sim.physics.shape.Rectangle;

/** W02 and W03: chains of pinned rods of 1 m and 1 kg, let go from the horizontal. */
final class RodScenes {
    private static final int BEST_ITERATIONS = 50;

    private RodScenes() {}

    static Scene of(String id, String title, int rods, double seconds) {
        double[] tip = RodChain.tip(rods, seconds);
        List<Contender> all = new ArrayList<>(
                Methods.contenders(seconds, (method, step) -> own(rods, seconds, method, step, tip)));
        all.add(new Contender("dyn4j", "dyn4j", false, Methods.STEPS, h -> dyn4j(rods, seconds, h, 10, tip)));
        all.add(new Contender(
                "dyn4j", BEST_ITERATIONS + " iterations", false, Methods.STEPS,
                h -> dyn4j(rods, seconds, h, BEST_ITERATIONS, tip)));
        all.add(new Contender("JBox2D", "JBox2D", false, Methods.STEPS, h -> jbox2d(rods, seconds, h, 8, 3, tip)));
        all.add(new Contender(
                "JBox2D", BEST_ITERATIONS + " iterations", false, Methods.STEPS,
                h -> jbox2d(rods, seconds, h, BEST_ITERATIONS, BEST_ITERATIONS, tip)));
        return new Scene(id, title, seconds, "tip, m", all);
    }

    private static Trial own(int rods, double seconds, Integrator method, double step, double[] tip) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(seconds / Math.round(seconds / step));
        engine.setIntegrator(method);
        engine.add(new Gravity(0, -RodChain.G));
        List<Body> chain = new ArrayList<>();
        for (int k = 0; k < rods; k++) {
            Body rod = engine.add(new Body(new Rectangle(1, 0.02)).at(k + 0.5, 0));
            rod.setMass(1, 1 / 12.0);
            rod.setCollisionGroup(1, 0);
            engine.add(k == 0 ? new PinJoint(rod, 0, 0) : new PinJoint(chain.get(k - 1), rod, k, 0));
            chain.add(rod);
        }
        return new Trial() {
            @Override
            public void run() {
                for (long k = Math.round(seconds / step); k > 0; k--) {
                    engine.step();
                }
            }

            @Override
            public double error() {
                Body last = chain.get(rods - 1);
                return Math.hypot(end(last, 0.5, true) - tip[0], end(last, 0.5, false) - tip[1]);
            }

            @Override
            public double energy() {
                double sum = 0;
                for (Body rod : chain) {
                    sum += rod.kineticEnergy() + RodChain.G * rod.getY();
                }
                return sum / (RodChain.G * rods * rods / 2.0);
            }

            @Override
            public double gap() {
                double most = Math.hypot(end(chain.get(0), -0.5, true), end(chain.get(0), -0.5, false));
                for (int k = 1; k < rods; k++) {
                    Body a = chain.get(k - 1);
                    Body b = chain.get(k);
                    double x = end(a, 0.5, true) - end(b, -0.5, true);
                    most = Math.max(most, Math.hypot(x, end(a, 0.5, false) - end(b, -0.5, false)));
                }
                return most;
            }
        };
    }

    private static double end(Body rod, double along, boolean isX) {
        return isX
                ? rod.getX() + along * StrictMath.cos(rod.getAngle())
                : rod.getY() + along * StrictMath.sin(rod.getAngle());
    }

    private static Trial dyn4j(int rods, double seconds, double step, int iterations, double[] tip) {
        org.dyn4j.world.World<org.dyn4j.dynamics.Body> world = new org.dyn4j.world.World<>();
        world.setGravity(0, -RodChain.G);
        world.getSettings().setAtRestDetectionEnabled(false);
        world.getSettings().setStepFrequency(step);
        world.getSettings().setVelocityConstraintSolverIterations(iterations);
        world.getSettings().setPositionConstraintSolverIterations(iterations);
        world.getSettings().setContinuousDetectionMode(ContinuousDetectionMode.NONE);
        CategoryFilter nothing = new CategoryFilter(1, 0);
        org.dyn4j.dynamics.Body anchor = new org.dyn4j.dynamics.Body();
        anchor.addFixture(Geometry.createCircle(0.01)).setFilter(nothing);
        anchor.setMass(MassType.INFINITE);
        world.addBody(anchor);
        List<org.dyn4j.dynamics.Body> chain = new ArrayList<>();
        for (int k = 0; k < rods; k++) {
            org.dyn4j.dynamics.Body rod = new org.dyn4j.dynamics.Body();
            rod.addFixture(Geometry.createRectangle(1, 0.02), 50).setFilter(nothing);
            rod.setMass(new org.dyn4j.geometry.Mass(new Vector2(), 1, 1 / 12.0));
            rod.translate(k + 0.5, 0);
            world.addBody(rod);
            world.addJoint(new RevoluteJoint<>(k == 0 ? anchor : chain.get(k - 1), rod, new Vector2(k, 0)));
            chain.add(rod);
        }
        return new Trial() {
            @Override
            public void run() {
                for (long k = Math.round(seconds / step); k > 0; k--) {
                    world.step(1);
                }
            }

            @Override
            public double error() {
                Vector2 end = chain.get(rods - 1).getWorldPoint(new Vector2(0.5, 0));
                return Math.hypot(end.x - tip[0], end.y - tip[1]);
            }

            @Override
            public double energy() {
                double sum = 0;
                for (org.dyn4j.dynamics.Body rod : chain) {
                    double omega = rod.getAngularVelocity();
                    sum += 0.5 * rod.getLinearVelocity().getMagnitudeSquared() + omega * omega / 24
                            + RodChain.G * rod.getWorldCenter().y;
                }
                return sum / (RodChain.G * rods * rods / 2.0);
            }

            @Override
            public double gap() {
                double most = chain.get(0).getWorldPoint(new Vector2(-0.5, 0)).getMagnitude();
                for (int k = 1; k < rods; k++) {
                    Vector2 a = chain.get(k - 1).getWorldPoint(new Vector2(0.5, 0));
                    most = Math.max(most, a.distance(chain.get(k).getWorldPoint(new Vector2(-0.5, 0))));
                }
                return most;
            }
        };
    }

    private static Trial jbox2d(
            int rods, double seconds, double step, int velocityIterations, int positionIterations, double[] tip) {
        World world = new World(new Vec2(0, (float) -RodChain.G));
        world.setAllowSleep(false);
        List<org.jbox2d.dynamics.Body> chain = new ArrayList<>();
        org.jbox2d.dynamics.Body last = world.createBody(new BodyDef());
        for (int k = 0; k < rods; k++) {
            BodyDef definition = new BodyDef();
            definition.type = BodyType.DYNAMIC;
            definition.position.set(k + 0.5f, 0);
            org.jbox2d.dynamics.Body rod = world.createBody(definition);
            PolygonShape shape = new PolygonShape();
            shape.setAsBox(0.5f, 0.01f);
            FixtureDef fixture = new FixtureDef();
            fixture.shape = shape;
            fixture.density = 50;
            fixture.filter.maskBits = 0;
            rod.createFixture(fixture);
            org.jbox2d.collision.shapes.MassData mass = new org.jbox2d.collision.shapes.MassData();
            mass.mass = 1;
            mass.I = 1 / 12f;
            rod.setMassData(mass);
            RevoluteJointDef joint = new RevoluteJointDef();
            joint.initialize(last, rod, new Vec2(k, 0));
            world.createJoint(joint);
            chain.add(rod);
            last = rod;
        }
        return new Trial() {
            @Override
            public void run() {
                for (long k = Math.round(seconds / step); k > 0; k--) {
                    world.step((float) step, velocityIterations, positionIterations);
                }
            }

            @Override
            public double error() {
                Vec2 end = chain.get(rods - 1).getWorldPoint(new Vec2(0.5f, 0));
                return Math.hypot(end.x - tip[0], end.y - tip[1]);
            }

            @Override
            public double energy() {
                double sum = 0;
                for (org.jbox2d.dynamics.Body rod : chain) {
                    double omega = rod.getAngularVelocity();
                    sum += 0.5 * rod.getLinearVelocity().lengthSquared() + omega * omega / 24
                            + RodChain.G * rod.getPosition().y;
                }
                return sum / (RodChain.G * rods * rods / 2.0);
            }

            @Override
            public double gap() {
                double most = chain.get(0).getWorldPoint(new Vec2(-0.5f, 0)).length();
                for (int k = 1; k < rods; k++) {
                    Vec2 a = chain.get(k - 1).getWorldPoint(new Vec2(0.5f, 0));
                    most = Math.max(most, a.sub(chain.get(k).getWorldPoint(new Vec2(-0.5f, 0))).length());
                }
                return most;
            }
        };
    }
}
