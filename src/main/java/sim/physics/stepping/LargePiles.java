// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import sim.physics.internal.DisjointSets;
import sim.physics.internal.Growth;
import sim.physics.motion.State;

/**
 * Which pairs are of large piles. In one order alone, an impulse goes through a whole pile one way in a substep, and by one pair the other way: high piles
 * swing by that, and ever more. So large ones are solved in one order and the other by turns (symmetric Gauss–Seidel; Axelsson, <i>Iterative
 * Solution Methods</i>, 1994). In small ones what is solved once in the order in which it meets is often right at once.
 */
final class LargePiles implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Pairs of a large pile at least. */
    private static final int MANY = 100;

    private final State state;
    private final ContactRows rows;

    /** By body: parents of what touches, and the number of pairs of what each one stands for. */
    private int[] parents = {};

    private int[] counts = {};
    private boolean areAny;

    LargePiles(State state, ContactRows rows) {
        this.state = state;
        this.rows = rows;
    }

    /** Begins a step: all of its rows are there. */
    void begin() {
        areAny = rows.count >= MANY;
        if (!areAny) {
            return;
        }
        int n = state.size();
        if (parents.length < n) {
            parents = new int[Growth.length(parents.length, n)];
            counts = new int[parents.length];
        }
        for (int k = 0; k < rows.count; k++) {
            parents[rows.first(k)] = rows.first(k);
            parents[rows.second(k)] = rows.second(k);
            counts[rows.first(k)] = 0;
            counts[rows.second(k)] = 0;
        }
        Groups.join(rows, state, parents);
        areAny = false;
        for (int k = 0; k < rows.count; k++) {
            areAny |= ++counts[root(k)] >= MANY;
        }
    }

    private int root(int k) {
        return DisjointSets.find(parents, Groups.isMovable(state, rows.first(k)) ? rows.first(k) : rows.second(k));
    }

    /** {@return whether there are any} */
    boolean any() {
        return areAny;
    }

    /** {@return whether a pair is of one; valid if there are any} */
    boolean has(int k) {
        return counts[root(k)] >= MANY;
    }
}
