// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.motion.State;

/**
 * Whether an island is within sight of a pose in which rows of J depend on one another. Small pivots of J W Jᵀ say so only where
 * masses are alike: a heavy body on light ones makes them small in any pose. So where masses are spread the pivots are those of
 * equal masses.
 */
final class Sight implements Serializable {
    private static final long serialVersionUID = 1L;

    private final Island island;

    /** Null until masses were spread. */
    private BlockFactor factor;

    private double[] even = {};

    Sight(Island island) {
        this.island = island;
    }

    /** Whether some pivot is redundant, or within sight of being so, where the island was evaluated and factored last. */
    boolean isWeak(double[] w) {
        return island.factor.pivots.isWeak() && (!DirectSolver.isSpread(island, w) || island.tree == null && evenly(w).pivots.isWeak());
    }

    /** Whether some pivot is redundant, or nearly so. */
    boolean isNear(double[] w) {
        return island.near() > 0 && (!DirectSolver.isSpread(island, w) || island.tree == null && evenly(w).pivots.near() > 0);
    }

    /** The factors of the matrix of equal masses. Rows of a tree of pins never depend on one another: nobody asks for it. */
    private BlockFactor evenly(double[] w) {
        factor = factor == null ? new BlockFactor(island.factor.start, island.factor.row, island.factor.rows, island.isAngle) : factor;
        even = even.length < w.length ? new double[w.length] : even;
        for (int k = 0; k < island.bodies.size; k++) {
            int s = State.BLOCK * island.bodies.values[k];
            Arrays.fill(even, s, s + State.THETA, 1);
            even[s + State.THETA] = 1 / (island.leastSize * island.leastSize);
        }
        island.assembleOther(even, factor);
        factor.factor(0, Pivots.NOISE, false);
        return factor;
    }
}
