// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import sim.physics.PhysicsEngine;
import sim.physics.collision.Overlap;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/** Scenes and measures that the tests of time stepping share. */
final class Stepped {
    static final double G = 10;

    private Stepped() {}

    static PhysicsEngine engine(double step, int substeps) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        engine.setTimeStepping(substeps);
        return engine;
    }

    static void run(PhysicsEngine engine, int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    /** A fixed body whose upper side is y = 0, rough and plastic. */
    static Body ground(PhysicsEngine engine) {
        return rough(engine.add(Body.fixed(new Rectangle(1000, 2)).at(0, -1)));
    }

    static Body rough(Body body) {
        body.setFriction(0.5);
        body.setRestitution(0);
        return body;
    }

    /** A rough and plastic box of uniform density. */
    static Body box(PhysicsEngine engine, double width, double height, double mass, double x, double y) {
        Body body = rough(engine.add(new Body(new Rectangle(width, height)).at(x, y)));
        body.setMass(mass, mass * (width * width + height * height) / 12);
        return body;
    }

    /** Gravity, and a ground. */
    static PhysicsEngine onGround(double step, int substeps) {
        PhysicsEngine engine = engine(step, substeps);
        engine.add(new Gravity(0, -G));
        ground(engine);
        return engine;
    }

    /** Unit squares of mass 1 on one another, on the ground, under gravity; from the lowest up. */
    static Body[] stack(PhysicsEngine engine, int count) {
        engine.add(new Gravity(0, -G));
        ground(engine);
        Body[] all = new Body[count];
        for (int k = 0; k < count; k++) {
            all[k] = rough(engine.add(new Body(new Rectangle(1, 1)).at(0, 0.5 + k)));
        }
        return all;
    }

    static double fastest(PhysicsEngine engine) {
        double most = 0;
        for (Body body : engine.bodies()) {
            most = Math.max(most, Math.hypot(body.getVelocityX(), body.getVelocityY()));
            most = Math.max(most, Math.abs(body.getAngularVelocity()));
        }
        return most;
    }

    static double depth(PhysicsEngine engine) {
        double most = 0;
        for (Overlap overlap : engine.overlaps()) {
            most = Math.max(most, overlap.depth());
        }
        return most;
    }

    /** Momentum, and angular momentum about the origin, of all movable bodies. */
    static double[] momentum(PhysicsEngine engine) {
        double[] sum = new double[3];
        for (Body body : engine.bodies()) {
            if (!body.isFixed()) {
                double m = body.getMass();
                sum[0] += m * body.getVelocityX();
                sum[1] += m * body.getVelocityY();
                sum[2] += m * (body.getX() * body.getVelocityY() - body.getY() * body.getVelocityX());
                sum[2] += body.getInertia() * body.getAngularVelocity();
            }
        }
        return sum;
    }
}
