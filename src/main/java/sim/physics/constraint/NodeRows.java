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
    private static final long serialVersionUID = 2L;

    private static final int J = NodeLayout.J;

    /** J, by nodes as {@link NodeLayout} has them, and the blocks of their bodies; −1 for what cannot move. */
    private final double[] j;

    private final int[] blockA;
    private final int[] blockB;
    private final BlockFactor factor;
    private final int nodes;

    /** W J, laid out as J. */
    private final double[] weighted;

    /** Where two nodes that share a body add to A: block, nodes, sides (0 or 6), and the body's block. */
    private final int[] shared;

    NodeRows(double[] j, int[] blockA, int[] blockB, BlockFactor factor, int[] shared) {
        this.j = j;
        this.blockA = blockA;
        this.blockB = blockB;
        this.factor = factor;
        this.shared = shared;
        nodes = blockA.length;
        weighted = new double[J * nodes];
    }

    /** The diagonal blocks of A; rows that are zero get a 1. */
    void diagonal(double[] w, double[] d) {
        for (int p = 0; p < nodes; p++) {
            int rows = factor.rows(p);
            d[3 * p] = 0;
            d[3 * p + 1] = 0;
            d[3 * p + 2] = 0;
            if (rows > 0 && blockA[p] >= 0) {
                add(w, blockA[p], J * p, rows, d, 3 * p);
            }
            if (rows > 0 && blockB[p] >= 0) {
                add(w, blockB[p], J * p + 6, rows, d, 3 * p);
            }
            d[3 * p] = d[3 * p] == 0 ? 1 : d[3 * p];
            d[3 * p + 2] = d[3 * p + 2] == 0 ? 1 : d[3 * p + 2];
        }
    }

    /** Weighs the rows of a node on one side, and adds their products with one another. */
    private void add(double[] w, int block, int o, int rows, double[] d, int at) {
        double mass = w[block];
        double inertia = w[block + State.THETA];
        double x = j[o];
        double y = j[o + 1];
        double turn = j[o + 2];
        double mx = mass * x;
        double my = mass * y;
        double it = inertia * turn;
        weighted[o] = mx;
        weighted[o + 1] = my;
        weighted[o + 2] = it;
        d[at] += mx * x + my * y + it * turn;
        if (rows == 2) {
            double otherX = j[o + 3];
            double otherY = j[o + 4];
            double otherTurn = j[o + 5];
            double ox = mass * otherX;
            double oy = mass * otherY;
            double ot = inertia * otherTurn;
            weighted[o + 3] = ox;
            weighted[o + 4] = oy;
            weighted[o + 5] = ot;
            d[at + 1] += mx * otherX + my * otherY + it * otherTurn;
            d[at + 2] += ox * otherX + oy * otherY + ot * otherTurn;
        }
    }

    /** The blocks of A below its diagonal. */
    void couple(double[] below) {
        for (int k = 0; k < shared.length; k += 3) {
            int q = shared[k + 1];
            int p = shared[k + 2];
            int rowsQ = factor.rows(q / J);
            int rowsP = factor.rows(p / J);
            if (rowsQ > 0 && rowsP > 0) {
                couple(below, shared[k], q, p, rowsQ, rowsP);
            }
        }
    }

    private void couple(double[] below, int e, int q, int p, int rowsQ, int rowsP) {
        double x = weighted[q];
        double y = weighted[q + 1];
        double turn = weighted[q + 2];
        below[e] += x * j[p] + y * j[p + 1] + turn * j[p + 2];
        if (rowsP == 2) {
            below[e + 1] += x * j[p + 3] + y * j[p + 4] + turn * j[p + 5];
        }
        if (rowsQ == 2) {
            x = weighted[q + 3];
            y = weighted[q + 4];
            turn = weighted[q + 5];
            below[e + 2] += x * j[p] + y * j[p + 1] + turn * j[p + 2];
            if (rowsP == 2) {
                below[e + 3] += x * j[p + 3] + y * j[p + 4] + turn * j[p + 5];
            }
        }
    }

    /** Adds to C what rounding has left of the positions, but for the nodes of pins, which have done so themselves. */
    void carry(double[] low, PinRows pins, double[] c) {
        for (int p = 0; p < nodes; p++) {
            for (int k = 0; k < factor.rows(p) && !pins.isAt(p); k++) {
                int o = J * p + 3 * k;
                c[2 * p + k] += product(j, o, low, blockA[p]) + product(j, o + 6, low, blockB[p]);
            }
        }
    }

    private static double product(double[] j, int o, double[] u, int s) {
        return s < 0 ? 0 : j[o] * u[s] + j[o + 1] * u[s + 1] + j[o + 2] * u[s + 2];
    }

    /** −(J u + g) into {@code right}. */
    void residual(double[] u, double[] g, double[] right) {
        for (int p = 0; p < nodes; p++) {
            int rows = factor.rows(p);
            double r0 = g == null ? 0 : g[2 * p];
            double r1 = g == null ? 0 : g[2 * p + 1];
            int o = J * p;
            int s = blockA[p];
            if (s >= 0 && rows > 0) {
                r0 += j[o] * u[s] + j[o + 1] * u[s + 1] + j[o + 2] * u[s + 2];
                r1 += rows == 1 ? 0 : j[o + 3] * u[s] + j[o + 4] * u[s + 1] + j[o + 5] * u[s + 2];
            }
            s = blockB[p];
            if (s >= 0 && rows > 0) {
                r0 += j[o + 6] * u[s] + j[o + 7] * u[s + 1] + j[o + 8] * u[s + 2];
                r1 += rows == 1 ? 0 : j[o + 9] * u[s] + j[o + 10] * u[s + 1] + j[o + 11] * u[s + 2];
            }
            right[2 * p] = -r0;
            right[2 * p + 1] = -r1;
        }
    }

    /** u += W Jᵀ λ, (37) and (40). */
    void apply(double[] w, double[] lambda, double[] u) {
        for (int p = 0; p < nodes; p++) {
            int rows = factor.rows(p);
            if (rows > 0 && blockA[p] >= 0) {
                push(w, blockA[p], J * p, rows, lambda[2 * p], lambda[2 * p + 1], u);
            }
            if (rows > 0 && blockB[p] >= 0) {
                push(w, blockB[p], J * p + 6, rows, lambda[2 * p], lambda[2 * p + 1], u);
            }
        }
    }

    private void push(double[] w, int s, int o, int rows, double l0, double l1, double[] u) {
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
