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
}
