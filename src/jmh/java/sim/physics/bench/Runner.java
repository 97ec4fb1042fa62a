// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

/** One scene in one engine, ready to be stepped. */
public interface Runner {
    /** Advances the scene by its time step. */
    void step();

    /** {@return Σ m v²/2 + I ω²/2 in units that only this runner knows: use ratios} */
    double kineticEnergy();

    /** {@return the number of moving bodies that the engine holds} */
    long bodies();

    /**
     * Reads every moving body's place and angle, as a model does that draws its bodies or looks at them: an engine that
     * works them out only when asked pays here.
     *
     * @return their sum
     */
    double readPoses();
}
