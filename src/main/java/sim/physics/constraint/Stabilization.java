// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import sim.physics.internal.Check;

/**
 * The method that keeps constraints closed despite the errors of the integrator: {@link #projection()} after each step, or
 * {@link #feedback(double, double)} within the constraint forces.
 *
 * @param isFeedback true for feedback, false for projection
 * @param position gain of C, 1/time²
 * @param velocity gain of Ċ, 1/time
 */
public record Stabilization(boolean isFeedback, double position, double velocity) implements Serializable {
    /**
     * Checks the gains.
     *
     * @param isFeedback true for feedback, false for projection
     * @param position gain of C, 1/time², not negative
     * @param velocity gain of Ċ, 1/time, not negative
     * @throws IllegalArgumentException if a gain is negative or not finite
     */
    public Stabilization {
        Check.notNegative("position gain", position);
        Check.notNegative("velocity gain", velocity);
    }

    /**
     * Returns the projection onto C = 0 and Ċ = 0 after each step. Joints stay closed to rounding, and the integrator keeps its
     * order.
     *
     * @return the engine's default
     */
    public static Stabilization projection() {
        return new Stabilization(false, 0, 0);
    }

    /**
     * Returns a feedback by springs and dampers in (41): C″ = −p C − v Ċ (Baumgarte 1972). Joints stay open by an amount that
     * depends on the step's error and the gains, and energy is put in or taken out. It is there for comparison. With Euler's
     * method, a step of 1 and both gains 0.3, the write-up's pendulum of Figure 3 ends its first swing 28.03 degrees above its
     * start.
     *
     * @param position p, 1/time²
     * @param velocity v, 1/time
     * @return a feedback
     * @throws IllegalArgumentException if a gain is negative or not finite
     */
    public static Stabilization feedback(double position, double velocity) {
        return new Stabilization(true, position, velocity);
    }
}
