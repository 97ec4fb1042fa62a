// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import sim.physics.internal.IntList;
import sim.physics.internal.MinimumDegree;

/**
 * The order in which the constraints of an island are eliminated, and which others each one then meets: the constraint
 * with the fewest neighbours first. Trees are so eliminated from their tips, without any fill-in, and a loop costs the little
 * that closes it; a chain is eliminated from both its ends in turn, which the processor does at the same time.
 */
final class EliminationOrder {
    private final MinimumDegree found = new MinimumDegree(true);

    /**
     * Finds the order.
     *
     * @param a first body of each constraint by its number in the island, −1 for one that cannot move
     * @param b second body of each constraint
     * @param bodies number of bodies
     */
    EliminationOrder(int[] a, int[] b, int bodies) {
        found.begin(a.length);
        IntList[] of = new IntList[bodies];
        for (int c = 0; c < a.length; c++) {
            join(of, a[c], c);
            join(of, b[c], c);
        }
        found.find();
    }

    /** Joins a constraint with those before it that its body has. */
    private void join(IntList[] of, int body, int constraint) {
        if (body < 0) {
            return;
        }
        IntList those = of[body] == null ? of[body] = new IntList() : of[body];
        for (int k = 0; k < those.size; k++) {
            if (those.values[k] != constraint) {
                found.join(those.values[k], constraint);
            }
        }
        those.add(constraint);
    }

    /** The constraint that is eliminated at a place. */
    int at(int place) {
        return found.order[place];
    }

    /** When a constraint is eliminated. */
    int place(int constraint) {
        return found.place[constraint];
    }

    /** The constraints that a constraint meets when it is eliminated, all of them later ones. */
    IntList later(int constraint) {
        return found.later(constraint);
    }
}
