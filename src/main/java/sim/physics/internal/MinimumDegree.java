// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

import java.util.Arrays;

/**
 * The order in which unknowns that are joined are eliminated from their equations, and which others each one then meets: that
 * with the fewest neighbours first (minimum degree; Rose 1972), of those with equally many the one that got there first.
 */
public final class MinimumDegree {
    private final boolean isSorted;

    /** Neighbours of each unknown; when all are ordered, those of them that are eliminated after it. */
    private IntList[] near = {};

    /** Unknowns by the number of their neighbours, some of them of before; and how many of each list have been taken. */
    private IntList[] byDegree = {};

    private int[] taken = {};
    private boolean[] isGone = {};
    private int[] mark = {};
    private int marks;
    private int n;

    /** The unknowns in their order. */
    public int[] order = {};

    /** The place of each unknown in it. */
    public int[] place = {};

    /**
     * Makes an order of nothing.
     *
     * @param isSorted whether neighbours get fewer in the order of their numbers, else in that in which they were joined
     */
    public MinimumDegree(boolean isSorted) {
        this.isSorted = isSorted;
    }

    /**
     * Begins with unknowns that are not joined.
     *
     * @param unknowns their number
     */
    public void begin(int unknowns) {
        n = unknowns;
        if (near.length < n) {
            int had = near.length;
            near = Arrays.copyOf(near, 2 * n);
            for (int k = had; k < near.length; k++) {
                near[k] = new IntList();
            }
            isGone = new boolean[2 * n];
            mark = new int[2 * n];
            marks = 0;
            order = new int[2 * n];
            place = new int[2 * n];
        }
        for (int k = 0; k < n; k++) {
            near[k].clear();
            isGone[k] = false;
        }
    }

    /**
     * Joins two unknowns, if they are not yet.
     *
     * @param a one
     * @param b another one
     */
    public void join(int a, int b) {
        IntList of = near[a];
        if (!of.contains(b)) {
            of.add(b);
            near[b].add(a);
        }
    }

    /**
     * What an unknown meets when it is eliminated.
     *
     * @param unknown its number
     * @return the unknowns, live; all come later
     */
    public IntList later(int unknown) {
        return near[unknown];
    }

    /** Finds the order. */
    public void find() {
        for (int k = 0; k < byDegree.length; k++) {
            byDegree[k].clear();
            taken[k] = 0;
        }
        for (int k = 0; k < n; k++) {
            push(k);
        }
        for (int k = 0; k < n; k++) {
            int next = pop();
            isGone[next] = true;
            order[k] = next;
            place[next] = k;
            IntList met = near[next];
            if (isSorted) {
                met.sort();
            }
            for (int m = 0; m < met.size; m++) {
                inherit(met.values[m], next, met);
                push(met.values[m]);
            }
        }
    }

    /** Takes an unknown that is eliminated from the neighbours of another, which gets its other neighbours for it. */
    private void inherit(int other, int gone, IntList met) {
        IntList of = near[other];
        marks++;
        mark[other] = marks;
        int kept = 0;
        for (int k = 0; k < of.size; k++) {
            if (of.values[k] != gone) {
                mark[of.values[k]] = marks;
                of.values[kept++] = of.values[k];
            }
        }
        of.size = kept;
        for (int k = 0; k < met.size; k++) {
            if (mark[met.values[k]] != marks) {
                of.add(met.values[k]);
            }
        }
    }

    private void push(int unknown) {
        int degree = near[unknown].size;
        if (degree >= byDegree.length) {
            int had = byDegree.length;
            byDegree = Arrays.copyOf(byDegree, 2 * degree + 2);
            taken = Arrays.copyOf(taken, byDegree.length);
            for (int k = had; k < byDegree.length; k++) {
                byDegree[k] = new IntList();
            }
        }
        byDegree[degree].add(unknown);
    }

    private int pop() {
        for (int degree = 0; ; degree++) {
            IntList queue = byDegree[degree];
            while (taken[degree] < queue.size) {
                int unknown = queue.values[taken[degree]++];
                if (!isGone[unknown] && near[unknown].size == degree) {
                    return unknown;
                }
            }
        }
    }
}
