// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import java.io.Serializable;
import sim.physics.motion.State;

/** Keeps the blocks of bodies that authors have written while others are brought in the same vectors. */
final class WrittenBlocks implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int N = State.BLOCK;

    private final State state;

    /** Positions and velocities, body by body. */
    private double[] blocks = {};

    WrittenBlocks(State state) {
        this.state = state;
    }

    /** Keeps those of the bodies that were touched first. */
    void keep(int bodies) {
        if (blocks.length < 2 * N * bodies) {
            blocks = new double[4 * N * bodies];
        }
        for (int k = 0, at = 0; k < bodies; k++, at += 2 * N) {
            int b = N * state.touched(k);
            System.arraycopy(state.x(), b, blocks, at, N);
            System.arraycopy(state.v(), b, blocks, at + N, N);
        }
    }

    /** Puts them back. */
    void putBack(int bodies) {
        for (int k = 0, at = 0; k < bodies; k++, at += 2 * N) {
            int b = N * state.touched(k);
            System.arraycopy(blocks, at, state.x(), b, N);
            System.arraycopy(blocks, at + N, state.v(), b, N);
        }
    }
}
