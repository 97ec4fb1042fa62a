// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import sim.physics.motion.State;

/**
 * Products with the rows of J of an island that has other constraints than pins: J u, W Jᵀ λ and A = J W Jᵀ, (41). Rows that are
 * empty, and nodes of motors and stops that do not act, are left out.
 */
final class NodeRows implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int J = Island.J;

    private final Island island;

    /** W J, laid out as {@link Island#j}. */
    private final double[] weighted;

    /** Where two nodes that share a body add to A: block, nodes, sides (0 or 6), and the body's block. */
    private final int[] shared;

    NodeRows(Island island, int[] shared) {
        this.island = island;
        this.shared = shared;
        weighted = new double[J * island.nodes];
    }

    /** The diagonal blocks of A; rows that are zero get a 1. */
    void diagonal(double[] w, double[] d) {
        double[] j = island.j;
        for (int p = 0; p < island.nodes; p++) {
            int rows = island.factor.rows(p);
            double d00 = 0;
            double d01 = 0;
            double d11 = 0;
            int o = J * p;
            for (int block = island.blockA[p], side = 0; side < 2 && rows > 0; side++, block = island.blockB[p], o += 6) {
                if (block >= 0) {
                    weigh(w, block, o);
                    d00 += product(o, j, o);
                    if (rows == 2) {
                        weigh(w, block, o + 3);
                        d01 += product(o, j, o + 3);
                        d11 += product(o + 3, j, o + 3);
                    }
                }
            }
            d[3 * p] = d00 == 0 ? 1 : d00;
            d[3 * p + 1] = d01;
            d[3 * p + 2] = d11 == 0 ? 1 : d11;
        }
    }

    private void weigh(double[] w, int block, int o) {
        weighted[o] = w[block] * island.j[o];
        weighted[o + 1] = w[block + 1] * island.j[o + 1];
        weighted[o + 2] = w[block + State.THETA] * island.j[o + 2];
    }

    private double product(int one, double[] j, int other) {
        return weighted[one] * j[other] + weighted[one + 1] * j[other + 1] + weighted[one + 2] * j[other + 2];
    }

    /** The blocks of A below its diagonal. */
    void couple(double[] below) {
        double[] j = island.j;
        BlockFactor factor = island.factor;
        for (int k = 0; k < shared.length; k += 3) {
            int e = shared[k];
            int q = shared[k + 1];
            int p = shared[k + 2];
            int rowsQ = factor.rows(q / J);
            int rowsP = factor.rows(p / J);
            if (rowsQ == 0 || rowsP == 0) {
                continue;
            }
            below[e] += product(q, j, p);
            if (rowsP == 2) {
                below[e + 1] += product(q, j, p + 3);
            }
            if (rowsQ == 2) {
                below[e + 2] += product(q + 3, j, p);
                if (rowsP == 2) {
                    below[e + 3] += product(q + 3, j, p + 3);
                }
            }
        }
    }

    /** −(J u + g) into {@code right}. */
    void residual(double[] u, double[] g, double[] right) {
        for (int p = 0; p < island.nodes; p++) {
            int rows = island.factor.rows(p);
            double r0 = g == null ? 0 : g[2 * p];
            double r1 = g == null ? 0 : g[2 * p + 1];
            int o = J * p;
            for (int s = island.blockA[p], side = 0; side < 2 && rows > 0; side++, s = island.blockB[p], o += 6) {
                if (s >= 0) {
                    r0 += along(u, s, o);
                    r1 += rows == 2 ? along(u, s, o + 3) : 0;
                }
            }
            right[2 * p] = -r0;
            right[2 * p + 1] = -r1;
        }
    }

    private double along(double[] u, int s, int o) {
        double[] j = island.j;
        return j[o] * u[s] + j[o + 1] * u[s + 1] + j[o + 2] * u[s + 2];
    }

    /** u += W Jᵀ λ, (37) and (40). */
    void apply(double[] w, double[] lambda, double[] u) {
        double[] j = island.j;
        for (int p = 0; p < island.nodes; p++) {
            int rows = island.factor.rows(p);
            double l0 = lambda[2 * p];
            double l1 = lambda[2 * p + 1];
            int o = J * p;
            for (int s = island.blockA[p], side = 0; side < 2 && rows > 0; side++, s = island.blockB[p], o += 6) {
                if (s < 0) {
                    continue;
                }
                if (rows == 1) {
                    u[s] += w[s] * (j[o] * l0);
                    u[s + 1] += w[s + 1] * (j[o + 1] * l0);
                    u[s + 2] += w[s + 2] * (j[o + 2] * l0);
                } else {
                    u[s] += w[s] * (j[o] * l0 + j[o + 3] * l1);
                    u[s + 1] += w[s + 1] * (j[o + 1] * l0 + j[o + 4] * l1);
                    u[s + 2] += w[s + 2] * (j[o + 2] * l0 + j[o + 5] * l1);
                }
            }
        }
    }
}
