// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import java.util.Objects;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.Equations;
import sim.physics.constraint.Reaction;
import sim.physics.motion.Body;

/** A {@link Constraint} of an engine as MASON's inspectors see it: its bodies, what it does to the first of them, and how far it is open. */
public class InspectedConstraint {
    private final PhysicsEngine engine;
    private final Constraint constraint;

    /**
     * Makes the view of a constraint.
     *
     * @param engine that it is, or was, in
     * @param constraint live
     */
    public InspectedConstraint(PhysicsEngine engine, Constraint constraint) {
        this.engine = Objects.requireNonNull(engine, "engine");
        this.constraint = Objects.requireNonNull(constraint, "constraint");
    }

    /** {@return the first body} */
    public Body getBodyA() {
        return constraint.getBodyA();
    }

    /** {@return the second body, null for the world} */
    public Body getBodyB() {
        return constraint.getBodyB();
    }

    /** {@return whether it is in the engine still: it may have broken} */
    public boolean isPresent() {
        return engine.contains(constraint);
    }

    /** {@return x of its force on the first body; 0 if it is gone} */
    public double getForceX() {
        return isPresent() ? reaction().forceX() : 0;
    }

    /** {@return y of its force on the first body; 0 if it is gone} */
    public double getForceY() {
        return isPresent() ? reaction().forceY() : 0;
    }

    /** {@return its torque about the first body's centre of mass; 0 if it is gone} */
    public double getTorque() {
        return isPresent() ? reaction().torque() : 0;
    }

    private Reaction reaction() {
        return engine.getReaction(constraint);
    }

    /** {@return the worst of its equations: a length, or an angle if all are between angles} */
    public double getGap() {
        return gap(constraint);
    }

    static double gap(Constraint constraint) {
        Equations now = new Equations();
        constraint.evaluate(now);
        double length = Double.NaN;
        double angle = 0;
        for (int row = 0; row < constraint.getRows(); row++) {
            double open = Math.abs(now.value(row));
            if (constraint.isAngle(row)) {
                angle = Math.max(angle, open);
            } else {
                length = Double.isNaN(length) ? open : Math.max(length, open);
            }
        }
        return Double.isNaN(length) ? angle : length;
    }
}
