// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import sim.physics.motion.State;

/**
 * Moves an island onto C = 0 along the directions W Jᵀ of the start of a step, as the method SHAKE does (Ryckaert, Ciccotti
 * and Berendsen 1977): the move of a force that acts there, and so part of a symplectic map.
 *
 * <pre>
 *   x += W J₀ᵀ δ,   ẋ += W J₀ᵀ δ / h,   J₀ W J₀ᵀ δ = −C(x)
 * </pre>
 *
 * <p>The matrix is that of the start throughout, so the error falls by a factor of about the step's relative length each
 * time.
 */
final class Shake implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int CORRECTIONS = 60;

    /** Rounding of C, relative to the coordinates that it is computed from. */
    private static final double ROUNDING = 0x1p-53;

    /** Error, in these units, that is none where a step begins: one so short that it moves nothing. */
    private static final double CLOSED = 16;

    private final Island island;
    private final DirectSolver solver = new DirectSolver();

    private double[] rows = {};
    private double[] push = {};

    Shake(Island island) {
        this.island = island;
    }

    /** Keeps J and the factors of J W Jᵀ. */
    void hold(State state) {
        if (rows.length == 0) {
            rows = new double[island.j.length];
            push = new double[2 * island.nodes];
        }
        island.evaluate(state);
        island.writeRows();
        System.arraycopy(island.j, 0, rows, 0, rows.length);
        solver.prepare(island, state.w().values());
    }

    /** Closes the constraints, as far as rounding lets it. */
    void close(State state, double h) {
        double before = Double.POSITIVE_INFINITY;
        for (int k = 0; k < CORRECTIONS; k++) {
            island.evaluate(state);
            double error = Slack.error(island, state, ROUNDING);
            if (error <= (k == 0 ? CLOSED : 0) || !(error < before) && error < 1e4 || !(error < Double.POSITIVE_INFINITY)) {
                return; // rounding; or there is no closing them, which the projection after the step will find
            }
            before = error;
            for (int m = 0; m < push.length; m++) {
                push[m] = -island.c[m];
            }
            island.solve(push);
            move(state, h);
        }
    }

    private void move(State state, double h) {
        double[] w = state.w().values();
        double[] x = state.x();
        double[] v = state.v();
        for (int p = 0; p < island.nodes; p++) {
            double l0 = push[2 * p];
            double l1 = push[2 * p + 1];
            int o = Island.J * p;
            for (int s = island.blockA[p], side = 0; side < 2; side++, s = island.blockB[p], o += 6) {
                for (int c = 0; s >= 0 && c < State.BLOCK; c++) {
                    double d = w[s + c] * (rows[o + c] * l0 + rows[o + 3 + c] * l1);
                    x[s + c] += d;
                    v[s + c] += d / h;
                }
            }
        }
    }
}
