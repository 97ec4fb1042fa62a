// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import sim.physics.internal.DisjointSets;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;
import sim.physics.motion.State;

/**
 * The pairs of large piles. In one order alone, an impulse goes through a whole pile one way in a substep, and by one pair the other way: high piles
 * swing by that, and walls of bricks walk, ever more. So large ones are solved in one order and the other by turns (symmetric Gauss–Seidel; Axelsson,
 * <i>Iterative Solution Methods</i>, 1994), and some times more where that changes much. In small ones, what is solved once in the order in which it
 * meets is often right at once.
 */
final class LargePiles implements Serializable {
    private static final long serialVersionUID = 1L;

    /**
     * Pairs of a large pile at least; for how many each is solved once more at most, and how often any. Of still larger ones, something always changes,
     * and they are solved once more at most.
     */
    private static final int MANY = 100;

    private static final int MORE = 200;
    private static final int MOST = 8;
    private static final int HUGE = 3000;

    /** Change of a velocity that is much, relative to what forces change in a substep. */
    private static final double MUCH = 1;

    private final State state;
    private final ContactRows rows;

    /** The pairs, in the order of their rows, and for each the body by which its pile is known; and these bodies. */
    final IntList pairs = new IntList();

    private final IntList piles = new IntList();
    private final IntList roots = new IntList();

    /** By body: parents of what touches; and of what it stands for, the number of pairs, the largest acceleration, and the largest change of a velocity. */
    private int[] parents = {};

    private int[] counts = {};
    private double[] pulls = {};
    private double[] changes = {};

    /** By body: whether the pile is solved once more. */
    private boolean[] areOpen = {};

    LargePiles(State state, ContactRows rows) {
        this.state = state;
        this.rows = rows;
    }

    /**
     * Begins a step: all of its rows are there.
     *
     * @param a accelerations by forces
     */
    void begin(double[] a) {
        pairs.clear();
        piles.clear();
        roots.clear();
        if (rows.count < MANY) {
            return;
        }
        clear();
        Groups.join(rows, state, parents);
        for (int k = 0; k < rows.count; k++) {
            int root = root(k);
            counts[root]++;
            pulls[root] = Math.max(pulls[root], Math.max(pull(a, rows.first(k)), pull(a, rows.second(k))));
        }
        for (int k = 0; k < rows.count; k++) {
            if (counts[root(k)] >= MANY) {
                add(k, root(k));
            }
        }
    }

    private void add(int k, int root) {
        pairs.add(k);
        piles.add(root);
        if (!areOpen[root]) { // it is not listed yet
            roots.add(root);
            areOpen[root] = true;
        }
    }

    private void clear() {
        int n = state.size();
        if (parents.length < n) {
            parents = new int[Growth.length(parents.length, n)];
            counts = new int[parents.length];
            pulls = new double[parents.length];
            changes = new double[parents.length];
            areOpen = new boolean[parents.length];
        }
        for (int k = 0; k < rows.count; k++) {
            clear(rows.first(k));
            clear(rows.second(k));
        }
    }

    private void clear(int body) {
        parents[body] = body;
        counts[body] = 0;
        pulls[body] = 0;
        areOpen[body] = false;
    }

    private int root(int k) {
        return DisjointSets.find(parents, Groups.isMovable(state, rows.first(k)) ? rows.first(k) : rows.second(k));
    }

    private static double pull(double[] a, int body) {
        return Math.abs(a[State.BLOCK * body]) + Math.abs(a[State.BLOCK * body + 1]);
    }

    /** {@return whether there are any} */
    boolean any() {
        return pairs.size > 0;
    }

    /** {@return whether a pair is of one; valid if there are any} */
    boolean has(int k) {
        return counts[root(k)] >= MANY;
    }

    /** Opens all of them. */
    void open() {
        for (int n = 0; n < roots.size; n++) {
            areOpen[roots.values[n]] = true;
            changes[roots.values[n]] = 0;
        }
    }

    /** {@return whether the pile of a pair is open; n is the pair's place in the list} */
    boolean isOpen(int n) {
        return areOpen[piles.values[n]];
    }

    /** Takes note of the change of a velocity that the solution of a pair has made; n is its place in the list. */
    void change(int n, double speed) {
        changes[piles.values[n]] = Math.max(changes[piles.values[n]], speed);
    }

    /**
     * Closes those of which little has changed, or which have been solved as often as they may.
     *
     * @param turns how often
     * @param h substep
     * @return whether one is open
     */
    boolean goOn(int turns, double h) {
        boolean any = false;
        for (int n = 0; n < roots.size; n++) {
            int root = roots.values[n];
            boolean isMuch = changes[root] > MUCH * h * pulls[root];
            areOpen[root] &= isMuch && turns <= mostTurns(counts[root]);
            changes[root] = 0;
            any |= areOpen[root];
        }
        return any;
    }

    private static int mostTurns(int pairs) {
        return pairs > HUGE ? 1 : Math.min(MOST, 1 + pairs / MORE);
    }
}
