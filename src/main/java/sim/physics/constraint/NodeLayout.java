// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;

/**
 * The rows of constraints between bodies as nodes, of two rows or one each, in the order in which they are eliminated; and the matrix A = J W Jᵀ of their
 * products, (41), with room for what fills in.
 */
final class NodeLayout implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Values of J of a node: two rows for its first body, and two for its second one. */
    static final int J = 12;

    /** The constraint at each place, by its number before; and the first node of each place. */
    final int[] order;

    final int[] firstNode;
    final int nodes;

    /** By node: its bodies, −1 for one that cannot move. */
    final int[] a;

    final int[] b;

    /** Whether a row is one between angles, 2 per node. */
    final boolean[] isAngle;

    final BlockFactor factor;

    /** Whether a row of a constraint is one between angles. */
    interface Angles {
        boolean isAngle(int constraint, int row);
    }

    /**
     * Finds the order.
     *
     * @param first first body of each constraint, −1 for one that cannot move
     * @param second second body of each
     * @param rows rows of each
     * @param bodies number of bodies
     */
    NodeLayout(int[] first, int[] second, int[] rows, Angles angles, int bodies) {
        EliminationOrder elimination = new EliminationOrder(first, second, bodies);
        int n = first.length;
        order = new int[n];
        firstNode = new int[n + 1];
        for (int k = 0; k < n; k++) {
            order[k] = elimination.at(k);
            firstNode[k + 1] = firstNode[k] + (rows[order[k]] + 1) / 2;
        }
        nodes = firstNode[n];
        a = new int[nodes];
        b = new int[nodes];
        isAngle = new boolean[2 * nodes];
        byte[] those = new byte[nodes];
        for (int k = 0; k < n; k++) {
            Arrays.fill(a, firstNode[k], firstNode[k + 1], first[order[k]]);
            Arrays.fill(b, firstNode[k], firstNode[k + 1], second[order[k]]);
            for (int row = 0; row < rows[order[k]]; row++) {
                isAngle[2 * firstNode[k] + row] = angles.isAngle(order[k], row);
                those[firstNode[k] + row / 2]++;
            }
        }
        factor = factor(elimination, those);
    }

    private BlockFactor factor(EliminationOrder elimination, byte[] rows) {
        int[] start = new int[nodes + 1];
        IntList row = new IntList();
        for (int k = 0; k < order.length; k++) {
            IntList later = elimination.later(order[k]);
            int[] met = new int[later.size];
            for (int m = 0; m < met.length; m++) {
                met[m] = elimination.place(later.values[m]);
            }
            Arrays.sort(met);
            for (int p = firstNode[k]; p < firstNode[k + 1]; p++) {
                for (int own = p + 1; own < firstNode[k + 1]; own++) {
                    row.add(own);
                }
                for (int other : met) {
                    for (int q = firstNode[other]; q < firstNode[other + 1]; q++) {
                        row.add(q);
                    }
                }
                start[p + 1] = row.size;
            }
        }
        return new BlockFactor(start, Arrays.copyOf(row.values, row.size), rows, isAngle);
    }

    /**
     * Where two nodes that share a body add to A.
     *
     * @param bodies number of bodies
     * @return by threes: the block, and where J of the later and of the earlier node is for that body
     */
    int[] shared(int bodies) {
        IntList[] at = new IntList[bodies];
        for (int k = 0; k < bodies; k++) {
            at[k] = new IntList();
        }
        for (int p = 0; p < nodes; p++) {
            if (a[p] >= 0) {
                at[a[p]].add(2 * p);
            }
            if (b[p] >= 0) {
                at[b[p]].add(2 * p + 1);
            }
        }
        IntList found = new IntList();
        for (IntList those : at) {
            for (int k = 0; k < those.size; k++) {
                for (int m = k + 1; m < those.size; m++) {
                    int p = those.values[k];
                    int q = those.values[m];
                    found.add(4 * factor.block(q >> 1, p >> 1));
                    found.add(J * (q >> 1) + 6 * (q & 1));
                    found.add(J * (p >> 1) + 6 * (p & 1));
                }
            }
        }
        return Arrays.copyOf(found.values, found.size);
    }
}
