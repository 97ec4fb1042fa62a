// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import java.util.List;
import java.util.SplittableRandom;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.Joint;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.motion.Body;
import sim.physics.shape.Circle;

/** Calls that every {@link EditedWorld} must refuse. */
final class BadEdits {
    private static final int OF_BODIES = 12;
    private static final int KINDS = 24;

    private BadEdits() {}

    /**
     * Makes a bad call.
     *
     * @param a any body of the world; null if there is none
     * @throws IllegalArgumentException as it must be
     * @throws IllegalStateException as it must be
     */
    static void make(EditedWorld world, SplittableRandom r, Body a, List<Constraint> ties) {
        int kind = r.nextInt(KINDS);
        if (a == null) {
            throw new IllegalArgumentException("nobody is there");
        }
        if (kind < OF_BODIES) {
            write(kind, a, world.mass);
        } else {
            call(kind, world.engine, r, a, ties, world.length);
        }
    }

    private static void write(int kind, Body a, double mass) {
        switch (kind) {
            case 0 -> a.setPosition(Double.NaN, 0);
            case 1 -> a.setAngle(Double.POSITIVE_INFINITY);
            case 2 -> a.setVelocity(0, Double.NaN);
            case 3 -> a.setVelocity(1e200, 0);
            case 4 -> a.setMass(0);
            case 5 -> a.setMass(mass, Double.NaN);
            case 6 -> a.setRestitution(1.5);
            case 7 -> a.setFriction(-1);
            case 8 -> a.addForce(Double.NaN, 0);
            case 9 -> a.addForceAt(1, Double.NaN, 0, 0);
            case 10 -> a.addTorque(Double.NaN);
            default -> a.addImpulseAt(1, 1, Double.NaN, 0);
        }
    }

    private static void call(int kind, PhysicsEngine engine, SplittableRandom r, Body a, List<Constraint> ties, double length) {
        boolean needsTies = kind == 17 || kind == 21;
        if (needsTies && ties.isEmpty()) {
            throw new IllegalStateException("there are no constraints");
        }
        Body stranger = new Body(new Circle(length));
        switch (kind) {
            case 12 -> engine.add(a);
            case 13 -> engine.remove(stranger);
            case 14 -> engine.setTimeStep(-1);
            case 15 -> engine.setTimeStepping(-1);
            case 16 -> engine.add(PinJoint.bodyPoints(a, 0, 0, null, a.getX() + 5 * length, a.getY())); // it is open
            case 17 -> engine.add(Edits.any(ties, r));
            case 18 -> engine.setCollisions(a, a, true);
            case 19 -> engine.add(new PinJoint(a, stranger, 0, 0));
            case 20 -> engine.assemble(RodJoint.bodyPoints(a, 0, 0, stranger, 0, 0, length));
            case 21 -> setBadly(Edits.any(ties, r));
            case 22 -> contradict(engine, a, length);
            default -> engine.remove(new PinJoint(a, a.getX() + length, a.getY()));
        }
    }

    private static void setBadly(Constraint c) {
        if (c instanceof Motor motor) {
            motor.setLimit(-1);
        } else if (c instanceof RodJoint rod) {
            rod.setLength(-1);
        } else if (c instanceof Limit limit) {
            limit.setBounds(1, 0);
        } else if (c instanceof Joint joint) {
            joint.setBreakingLoad(-1, 1);
        } else {
            throw new IllegalStateException("it has nothing to be set");
        }
    }

    /** One point of a body cannot be at two places. */
    private static void contradict(PhysicsEngine engine, Body a, double length) {
        if (a.isFixed()) {
            throw new IllegalStateException("it is fixed");
        }
        engine.assemble(
                PinJoint.bodyPoints(a, 0, 0, null, a.getX(), a.getY()),
                PinJoint.bodyPoints(a, 0, 0, null, a.getX() + 30 * length, a.getY()));
    }
}
