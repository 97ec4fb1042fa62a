// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.internal.IntList;

/** What acts on bodies, but for what ties them together: for ties that make a step of their own, stage by stage. */
public interface Loads {
    /**
     * The accelerations that some bodies would have without their ties, at the positions and velocities of the state vectors.
     *
     * @param bodies indices
     * @param t simulated time of the evaluation
     * @param a takes [x″, y″, θ″] per body of the state
     */
    void load(IntList bodies, double t, double[] a);
}
