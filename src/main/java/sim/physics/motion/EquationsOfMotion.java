// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.internal.IntList;

/** The right side of the equations of motion, as the integrators see it. */
public interface EquationsOfMotion {
    /**
     * Evaluates the accelerations at the positions and velocities that the state vectors hold.
     *
     * @param bodies the bodies
     * @param time simulated time of the evaluation
     * @param a takes the accelerations, [x″, y″, θ″] per body of the state
     */
    void acceleration(IntList bodies, double time, double[] a);

    /**
     * Takes from small changes of places or velocities, such as errors, what constraints do not let pass: what is left when
     * the bodies are brought back onto them.
     *
     * @param bodies the bodies, where accelerations were evaluated last
     * @param change [x, y, θ] per body of the state
     * @return false if nothing is taken away of any change, or nobody knows what; then nothing has changed
     */
    default boolean pass(IntList bodies, double[] change) {
        return false; // nothing ties the bodies
    }

    /**
     * Keeps the directions in which constraints act at the positions of the state vectors, for {@link #close}.
     *
     * @param bodies the bodies
     */
    default void hold(IntList bodies) {
        // nothing ties the bodies
    }

    /**
     * Moves the bodies along the directions that were kept to where their constraints are satisfied, and changes their
     * velocities by the same over the step.
     *
     * @param bodies the bodies
     * @param h the step
     */
    default void close(IntList bodies, double h) {
        // nothing ties the bodies
    }

    /**
     * Gives the bodies the nearest velocities that their constraints allow at their positions, where accelerations have
     * just been evaluated.
     *
     * @param bodies the bodies
     */
    default void settle(IntList bodies) {
        // nothing ties the bodies
    }
}
