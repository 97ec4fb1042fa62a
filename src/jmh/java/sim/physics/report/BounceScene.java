// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.ArrayList;
import java.util.List;
import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.dynamics.ContinuousDetectionMode;
import org.dyn4j.geometry.Geometry;
import org.dyn4j.geometry.Mass;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Vector2;
import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.references.RodBounce;
import sim.physics.shape.Rectangle;

/**
 * W11: a smooth rod falls on a smooth floor and bounces elastically, from heights that are spread over the step of a
 * stepping engine, so that none is favoured by an impact at the end of a step.
 */
final class BounceScene {
    private static final double G = 9.81;
    private static final double HALF = 0.01;
    private static final double ANGLE = 0.3;
    private static final double SECONDS = 2;
    private static final int PHASES = 8;

    private BounceScene() {}

    static Scene of() {
        double[][] ends = new double[PHASES][];
        for (int k = 0; k < PHASES; k++) {
            ends[k] = RodBounce.after(height(k), ANGLE, HALF, SECONDS);
        }
        List<Contender> all = new ArrayList<>();
        all.add(new Contender("mason-physics", "any method", false, Methods.STEPS, h -> own(h, ends)));
        all.add(new Contender("dyn4j", "dyn4j", false, Methods.STEPS, h -> dyn4j(h, ends)));
        all.add(new Contender("JBox2D", "JBox2D", false, Methods.STEPS, h -> jbox2d(h, ends)));
        return new Scene("W11", "a rod bounces elastically for 2 s, 8 heights", PHASES * SECONDS, "largest of height, m, and angle, rad", all);
    }

    private static double height(int k) {
        return 1.5 + 0.01 * k;
    }

    /** Runs of one engine from all heights. */
    private abstract static class Runs implements Trial {
        private final double step;
        private final double[][] ends;

        Runs(double step, double[][] ends) {
            this.step = step;
            this.ends = ends;
        }

        abstract void step(int k);

        abstract double heightOf(int k);

        abstract double angleOf(int k);

        abstract double energyOf(int k);

        @Override
        public void run() {
            for (int k = 0; k < PHASES; k++) {
                for (long m = Math.round(SECONDS / step); m > 0; m--) {
                    step(k);
                }
            }
        }

        @Override
        public double error() {
            double most = 0;
            for (int k = 0; k < PHASES; k++) {
                double turn = Math.IEEEremainder(angleOf(k) - ends[k][1], 2 * Math.PI);
                most = Math.max(most, Math.max(Math.abs(heightOf(k) - ends[k][0]), Math.abs(turn)));
            }
            return most;
        }

        @Override
        public double energy() {
            double most = 0;
            for (int k = 0; k < PHASES; k++) {
                most = Math.max(most, Math.abs(energyOf(k) / (G * height(k)) - 1));
            }
            return most;
        }
    }

    private static Trial own(double step, double[][] ends) {
        PhysicsEngine[] engines = new PhysicsEngine[PHASES];
        Body[] rods = new Body[PHASES];
        for (int k = 0; k < PHASES; k++) {
            engines[k] = new PhysicsEngine();
            engines[k].setTimeStep(step);
            engines[k].add(new Gravity(0, -G));
            engines[k].add(Body.fixed(new Rectangle(100, 1)).at(0, -0.5));
            rods[k] = engines[k].add(new Body(new Rectangle(1, 2 * HALF)).at(0, height(k)));
            rods[k].setAngle(ANGLE);
            rods[k].setMass(1, 1 / 12.0);
        }
        return new Runs(step, ends) {
            @Override
            void step(int k) {
                engines[k].step();
            }

            @Override
            double heightOf(int k) {
                return rods[k].getY();
            }

            @Override
            double angleOf(int k) {
                return rods[k].getAngle();
            }

            @Override
            double energyOf(int k) {
                return rods[k].kineticEnergy() + G * rods[k].getY();
            }
        };
    }

    private static Trial dyn4j(double step, double[][] ends) {
        List<org.dyn4j.world.World<org.dyn4j.dynamics.Body>> worlds = new ArrayList<>();
        org.dyn4j.dynamics.Body[] rods = new org.dyn4j.dynamics.Body[PHASES];
        for (int k = 0; k < PHASES; k++) {
            org.dyn4j.world.World<org.dyn4j.dynamics.Body> world = new org.dyn4j.world.World<>();
            world.setGravity(0, -G);
            world.getSettings().setAtRestDetectionEnabled(false);
            world.getSettings().setStepFrequency(step);
            world.getSettings().setContinuousDetectionMode(ContinuousDetectionMode.ALL);
            org.dyn4j.dynamics.Body floor = new org.dyn4j.dynamics.Body();
            elastic(floor.addFixture(Geometry.createRectangle(100, 1)));
            floor.setMass(MassType.INFINITE);
            floor.translate(0, -0.5);
            world.addBody(floor);
            rods[k] = new org.dyn4j.dynamics.Body();
            elastic(rods[k].addFixture(Geometry.createRectangle(1, 2 * HALF)));
            rods[k].setMass(new Mass(new Vector2(), 1, 1 / 12.0));
            rods[k].rotate(ANGLE);
            rods[k].translate(0, height(k));
            world.addBody(rods[k]);
            worlds.add(world);
        }
        return new Runs(step, ends) {
            @Override
            void step(int k) {
                worlds.get(k).step(1);
            }

            @Override
            double heightOf(int k) {
                return rods[k].getWorldCenter().y;
            }

            @Override
            double angleOf(int k) {
                return rods[k].getTransform().getRotationAngle();
            }

            @Override
            double energyOf(int k) {
                double omega = rods[k].getAngularVelocity();
                return 0.5 * rods[k].getLinearVelocity().getMagnitudeSquared() + omega * omega / 24
                        + G * rods[k].getWorldCenter().y;
            }
        };
    }

    private static void elastic(BodyFixture fixture) {
        fixture.setRestitution(1);
        fixture.setRestitutionVelocity(0);
        fixture.setFriction(0);
    }

    private static Trial jbox2d(double step, double[][] ends) {
        World[] worlds = new World[PHASES];
        org.jbox2d.dynamics.Body[] rods = new org.jbox2d.dynamics.Body[PHASES];
        for (int k = 0; k < PHASES; k++) {
            worlds[k] = new World(new Vec2(0, (float) -G));
            worlds[k].setAllowSleep(false);
            BodyDef floor = new BodyDef();
            floor.position.set(0, -0.5f);
            box(worlds[k].createBody(floor), 50, 0.5f);
            BodyDef definition = new BodyDef();
            definition.type = BodyType.DYNAMIC;
            definition.position.set(0, (float) height(k));
            definition.angle = (float) ANGLE;
            rods[k] = worlds[k].createBody(definition);
            box(rods[k], 0.5f, (float) HALF);
            MassData mass = new MassData();
            mass.mass = 1;
            mass.I = 1 / 12f;
            rods[k].setMassData(mass);
        }
        return new Runs(step, ends) {
            @Override
            void step(int k) {
                worlds[k].step((float) step, 8, 3);
            }

            @Override
            double heightOf(int k) {
                return rods[k].getPosition().y;
            }

            @Override
            double angleOf(int k) {
                return rods[k].getAngle();
            }

            @Override
            double energyOf(int k) {
                double omega = rods[k].getAngularVelocity();
                return 0.5 * rods[k].getLinearVelocity().lengthSquared() + omega * omega / 24
                        + G * rods[k].getPosition().y;
            }
        };
    }

    private static void box(org.jbox2d.dynamics.Body body, float halfX, float halfY) {
        PolygonShape shape = new PolygonShape();
        shape.setAsBox(halfX, halfY);
        FixtureDef fixture = new FixtureDef();
        fixture.shape = shape;
        fixture.density = 1;
        fixture.friction = 0;
        fixture.restitution = 1;
        body.createFixture(fixture);
    }
}
