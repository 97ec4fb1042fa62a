// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.util.Arrays;
import sim.physics.motion.State;

/** The inverse of K = J W Jᵀ of one constraint of up to three rows; a row that nothing can move gets zeros. */
final class RowInverse {
    private static final int BLOCK = State.BLOCK;
    private static final int ROWS = Equations.ROWS;

    /** What is less of a diagonal entry than this, relative to the largest, is no equation. */
    private static final double SINGULAR = 1e-14;

    private RowInverse() {}

    /**
     * Inverts it.
     *
     * @param rows how many
     * @param w the masses
     * @param a block of the first body
     * @param b of the second one, −1 for the world
     * @param j takes J from {@code at} on: the rows for the first body, and those for the second one
     * @param inverse takes the inverse, 3 × 3, from {@code o} on
     */
    static void invert(int rows, double[] w, int a, int b, double[] j, int at, double[] inverse, int o) {
        double k00 = stiffness(0, 0, w, a, b, j, at);
        if (rows == 1) {
            inverse[o] = k00 > 0 ? 1 / k00 : 0;
            return;
        }
        double k01 = stiffness(0, 1, w, a, b, j, at);
        double k11 = stiffness(1, 1, w, a, b, j, at);
        if (rows == 2) {
            double det = k00 * k11 - k01 * k01;
            boolean isRegular = det > SINGULAR * k00 * k11;
            inverse[o] = isRegular ? k11 / det : k00 > 0 ? 1 / k00 : 0;
            inverse[o + 1] = isRegular ? -k01 / det : 0;
            inverse[o + 3] = inverse[o + 1];
            inverse[o + 4] = isRegular ? k00 / det : k11 > 0 && !(k00 > 0) ? 1 / k11 : 0;
            return;
        }
        double k02 = stiffness(0, 2, w, a, b, j, at);
        double k12 = stiffness(1, 2, w, a, b, j, at);
        double k22 = stiffness(2, 2, w, a, b, j, at);
        if (!SmallInverse.invert(k00, k01, k02, k11, k12, k22, inverse, o)) { // row by row
            Arrays.fill(inverse, o, o + ROWS * ROWS, 0);
            inverse[o] = k00 > 0 ? 1 / (ROWS * k00) : 0;
            inverse[o + 4] = k11 > 0 ? 1 / (ROWS * k11) : 0;
            inverse[o + 8] = k22 > 0 ? 1 / (ROWS * k22) : 0;
        }
    }

    private static double stiffness(int row, int column, double[] w, int a, int b, double[] j, int at) {
        int o = at + BLOCK * row;
        int p = at + BLOCK * column;
        double entry = w[a] * j[o] * j[p] + w[a + 1] * j[o + 1] * j[p + 1] + w[a + 2] * j[o + 2] * j[p + 2];
        if (b >= 0) {
            o += BLOCK * ROWS;
            p += BLOCK * ROWS;
            entry += w[b] * j[o] * j[p] + w[b + 1] * j[o + 1] * j[p + 1] + w[b + 2] * j[o + 2] * j[p + 2];
        }
        return entry;
    }
}
