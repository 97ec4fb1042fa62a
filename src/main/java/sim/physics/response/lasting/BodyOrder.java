// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.util.Arrays;
import sim.physics.internal.IntList;

/**
 * The order in which the bodies of a heap are eliminated from its equations, and which others each one then meets: the body
 * with the fewest neighbours first (minimum degree; Rose 1972). Who touches whom is a planar graph, whose fill-in stays small.
 */
final class BodyOrder {
    /** Neighbours of each body; when all are ordered, those of them that are eliminated after it. */
    private IntList[] near = {};

    /** Bodies by the number of their neighbours, some of them of before; and how many of each list have been taken. */
    private IntList[] byDegree = {};

    private int[] taken = {};
    private boolean[] isGone = {};
    private int[] mark = {};
    private int marks;
    private int n;

    /** The bodies in their order, and the place of each body in it. */
    int[] order = {};

    int[] place = {};

    BodyOrder() {
        // grows with the heaps
    }

    /** Begins a heap of bodies that do not touch. */
    void begin(int bodies) {
        n = bodies;
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

    /** Takes note that two bodies touch. */
    void touch(int a, int b) {
        IntList of = near[a];
        for (int k = 0; k < of.size; k++) {
            if (of.values[k] == b) {
                return;
            }
        }
        of.add(b);
        near[b].add(a);
    }

    /** The bodies that a body meets when it is eliminated. */
    IntList later(int body) {
        return near[body];
    }

    /** Finds the order. */
    void find() {
        for (int k = 0; k < byDegree.length; k++) {
            byDegree[k].clear();
            taken[k] = 0;
        }
        for (int k = 0; k < n; k++) {
            push(k);
        }
        for (int k = 0; k < n; k++) {
            int body = pop();
            isGone[body] = true;
            order[k] = body;
            place[body] = k;
            IntList met = near[body];
            for (int m = 0; m < met.size; m++) {
                join(met.values[m], body, met);
                push(met.values[m]);
            }
        }
    }

    /** Takes a body that is eliminated from the neighbours of another, which gets its other neighbours for it. */
    private void join(int other, int body, IntList met) {
        IntList of = near[other];
        marks++;
        mark[other] = marks;
        int kept = 0;
        for (int k = 0; k < of.size; k++) {
            if (of.values[k] != body) {
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

    private void push(int body) {
        int degree = near[body].size;
        if (degree >= byDegree.length) {
            int had = byDegree.length;
            byDegree = Arrays.copyOf(byDegree, 2 * degree + 2);
            taken = Arrays.copyOf(taken, byDegree.length);
            for (int k = had; k < byDegree.length; k++) {
                byDegree[k] = new IntList();
            }
        }
        byDegree[degree].add(body);
    }

    private int pop() {
        for (int degree = 0; ; degree++) {
            IntList queue = byDegree[degree];
            while (taken[degree] < queue.size) {
                int body = queue.values[taken[degree]++];
                if (!isGone[body] && near[body].size == degree) {
                    return body;
                }
            }
        }
    }
}
