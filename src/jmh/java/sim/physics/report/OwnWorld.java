// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.SplittableRandom;
import sim.physics.PhysicsEngine;
import sim.physics.Witness;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.motion.Spring;
import sim.physics.motion.SurfaceFriction;
import sim.physics.shape.Circle;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** A scene in this engine. */
final class OwnWorld implements World {
    private final PhysicsEngine engine = new PhysicsEngine();
    private final Body[] bodies;
    /** Counts evaluations of forces, in the run that is not timed; null in others. */
    private final Witness counter;
    private long steps;

    OwnWorld(Model model, Integrator integrator, double dt, boolean count) {
        this(model, integrator, dt, count, 0);
    }

    /** One moved by time stepping, unless the substeps are 0. */
    OwnWorld(Model model, Integrator integrator, double dt, boolean count, int substeps) {
        engine.setTimeStep(dt);
        engine.setTimeStepping(substeps);
        engine.setSleepAllowed(false); // nor do the peers
        engine.setIntegrator(integrator);
        bodies = new Body[model.parts.size()];
        for (int k = 0; k < bodies.length; k++) {
            bodies[k] = engine.add(body(model.parts.get(k)));
            bodies[k].setFriction(model.friction);
            if (model.surfaceFriction > 0) {
                bodies[k].setSurfaceFriction(model.surfaceFriction);
            }
        }
        if (model.gravity != 0) {
            engine.add(new Gravity(model.across, -model.gravity));
        }
        if (model.surfaceFriction > 0) {
            engine.add(new SurfaceFriction(model.surfaceGravity));
        }
        if (model.torque != 0 || model.push != 0) {
            engine.add(new Drive(bodies[0], model.push, model.torque));
        }
        for (Model.Pin pin : model.pins) {
            engine.add(new PinJoint(bodies[pin.a()], pin.b() < 0 ? null : bodies[pin.b()], pin.x(), pin.y()));
        }
        for (Model.Rod rod : model.rods) {
            double[] start = model.parts.get(rod.a()).start();
            engine.add(new RodJoint(bodies[rod.a()], start[0], start[1], null, rod.x(), rod.y()));
        }
        for (Model.Elastic s : model.springs) {
            double[] start = model.parts.get(s.a()).start();
            engine.add(new Spring(
                    bodies[s.a()], s.px() - start[0], s.py() - start[1], null, s.x(), s.y(),
                    s.length(), s.stiffness(), s.damping()));
        }
        for (Model.Slide slide : model.slides) {
            double[] start = model.parts.get(slide.a()).start();
            engine.add(new SliderJoint(bodies[slide.a()], null, start[0], start[1], 1, 0));
        }
        boolean driven = model.surfaceFriction > 0 || model.hasJoints() || !model.springs.isEmpty();
        counter = count && driven ? new Witness(bodies[0], true) : null;
        if (counter != null) {
            engine.add(counter);
        }
    }

    private static Body body(Model.Part part) {
        double[] size = part.size();
        Shape shape = switch (part.kind()) {
            case DISC -> new Circle(size[0]);
            case BOX -> new Rectangle(size[0], size[1]);
            case POLYGON -> new Polygon(flat(Model.corners(part)));
        };
        double[] s = part.start();
        if (part.fixed()) {
            return Body.fixed(shape).at(s[0], s[1], s[2]);
        }
        Body body = new Body(shape).at(s[0], s[1], s[2]).moving(s[3], s[4], s[5]);
        body.setMass(part.mass(), part.inertia());
        body.setRestitution(part.e());
        if (!part.collides()) {
            body.setCollisionGroup(1, 0);
        }
        return body;
    }

    private static double[] flat(double[][] corners) {
        double[] xy = new double[2 * corners.length];
        for (int k = 0; k < corners.length; k++) {
            xy[2 * k] = corners[k][0];
            xy[2 * k + 1] = corners[k][1];
        }
        return xy;
    }

    @Override
    public void step() {
        engine.step();
        steps++;
    }

    /** Makes each body faster or slower by a speed, along its velocity, and its rim by its turn; joints take what they do not allow. */
    void kick(double speed, SplittableRandom random) {
        for (Body body : bodies) {
            double v = Math.hypot(body.getVelocityX(), body.getVelocityY());
            if (v > 0) {
                double longer = 1 + either(speed, random) / v;
                body.setVelocity(longer * body.getVelocityX(), longer * body.getVelocityY());
            }
            double w = body.getAngularVelocity();
            if (w != 0) {
                body.setAngularVelocity(w + either(speed, random) / body.getShape().boundingRadius());
            }
        }
    }

    private static double either(double speed, SplittableRandom random) {
        return random.nextBoolean() ? speed : -speed;
    }

    @Override
    public void read(double[] state) {
        for (int k = 0; k < bodies.length; k++) {
            int b = Model.BLOCK * k;
            state[b] = bodies[k].getX();
            state[b + 1] = bodies[k].getY();
            state[b + 2] = bodies[k].getAngle();
            state[b + 3] = bodies[k].getVelocityX();
            state[b + 4] = bodies[k].getVelocityY();
            state[b + 5] = bodies[k].getAngularVelocity();
        }
    }

    @Override
    public Map<String, Long> counts() {
        Map<String, Long> counts = new LinkedHashMap<>();
        counts.put("steps", steps);
        counts.put("forces", counter == null ? 0 : counter.calls());
        counts.put("impacts", engine.getImpacts());
        counts.put("looks", engine.getNarrowPhaseEvaluations());
        return counts;
    }

    /** A constant force to the right and a constant torque. */
    private static final class Drive implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private final Body driven;
        private final double push;
        private final double torque;

        Drive(Body driven, double push, double torque) {
            this.driven = driven;
            this.push = push;
            this.torque = torque;
        }

        @Override
        public boolean actsOn(Body body) {
            return body == driven;
        }

        @Override
        public boolean isAutonomous() {
            return true;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            forces.add(body, push, 0);
            forces.addTorque(body, torque);
        }
    }
}
