// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import sim.physics.internal.IntList;

/** Advances positions and velocities over a step; see the write-up's <i>Numerical Integration</i>. */
public sealed interface Integrator extends Serializable
        permits Euler, SymplecticEuler, RungeKutta4, Rattle, AdaptiveIntegrator {
    /**
     * Advances the blocks of some bodies in the state vectors from time t to t + h.
     *
     * @param equations the equations of motion
     * @param state the state vectors, at t before and at t + h afterwards
     * @param bodies the bodies to advance
     * @param t time
     * @param h length of the step, of either sign
     * @param path takes the path in between: for each coordinate of each body of the list, in its order, half the second
     *     derivative and a sixth of the third one at t
     * @return the time advanced: h, or less if the method chooses its own steps
     */
    double advance(EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path);

    /**
     * Returns the order of the global error in h.
     *
     * @return 1 for Euler, 4 for RK4; the highest order if the method chooses it
     */
    int order();

    /**
     * Returns whether the method chooses its own steps. Those of the engine then only say when its state is published.
     *
     * @return false unless overridden
     */
    default boolean isAdaptive() {
        return false;
    }

    /**
     * Returns whether several threads may advance different bodies at the same time. The method must then keep nothing from call
     * to call, and must write only to the blocks of the bodies.
     *
     * @return false unless overridden
     */
    default boolean isConcurrent() {
        return false;
    }
}
