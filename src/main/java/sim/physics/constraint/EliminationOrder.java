// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import sim.physics.internal.IntList;

/**
 * The order in which the constraints of an island are eliminated, and which others each one then meets: the constraint
 * with the fewest neighbours first (minimum degree; Rose 1972). Trees are so eliminated from their tips, without any
 * fill-in, and a loop costs the little that closes it.
 */
final class EliminationOrder {
    /** Constraints in the order of their elimination. */
    final int[] order;

    /** The constraints that a constraint meets when it is eliminated, all of them later ones. */
    final List<TreeSet<Integer>> later;

    /**
     * Finds the order.
     *
     * @param a first body of each constraint by its number in the island, −1 for one that cannot move
     * @param b second body of each constraint
     * @param bodies number of bodies
     */
    EliminationOrder(int[] a, int[] b, int bodies) {
        int n = a.length;
        later = neighbours(a, b, bodies);
        order = new int[n];
        boolean[] gone = new boolean[n];
        List<IntList> byDegree = new ArrayList<>();
        for (int c = 0; c < n; c++) {
            push(byDegree, later.get(c).size(), c);
        }
        int[] taken = new int[n + 1];
        for (int k = 0; k < n; k++) {
            int next = pop(byDegree, taken, gone);
            gone[next] = true;
            order[k] = next;
            TreeSet<Integer> met = later.get(next);
            for (int other : met) {
                TreeSet<Integer> of = later.get(other);
                of.remove(next);
                if (met.size() > 1) {
                    of.addAll(met);
                    of.remove(other);
                }
                push(byDegree, of.size(), other);
            }
        }
    }

    private static List<TreeSet<Integer>> neighbours(int[] a, int[] b, int bodies) {
        List<IntList> of = new ArrayList<>();
        for (int k = 0; k < bodies; k++) {
            of.add(new IntList());
        }
        List<TreeSet<Integer>> sets = new ArrayList<>();
        for (int c = 0; c < a.length; c++) {
            sets.add(new TreeSet<>());
            note(of, sets, a[c], c);
            note(of, sets, b[c], c);
        }
        return sets;
    }

    private static void note(List<IntList> of, List<TreeSet<Integer>> sets, int body, int constraint) {
        if (body < 0) {
            return;
        }
        IntList those = of.get(body);
        for (int k = 0; k < those.size; k++) {
            if (those.values[k] != constraint) {
                sets.get(constraint).add(those.values[k]);
                sets.get(those.values[k]).add(constraint);
            }
        }
        those.add(constraint);
    }

    private static void push(List<IntList> byDegree, int degree, int constraint) {
        while (byDegree.size() <= degree) {
            byDegree.add(new IntList());
        }
        byDegree.get(degree).add(constraint);
    }

    /**
     * The constraint of least degree that was pushed first: a chain is eliminated from both its ends in turn, which the
     * processor does at the same time.
     */
    private int pop(List<IntList> byDegree, int[] taken, boolean[] gone) {
        for (int degree = 0; ; degree++) {
            IntList queue = byDegree.get(degree);
            while (taken[degree] < queue.size) {
                int c = queue.values[taken[degree]++];
                if (!gone[c] && later.get(c).size() == degree) {
                    return c;
                }
            }
        }
    }
}
