// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.constraint.TieRows;
import sim.physics.internal.DisjointSets;
import sim.physics.internal.IntList;
import sim.physics.motion.SpringRows;
import sim.physics.motion.State;

/**
 * The bodies that are new in a step, or of which joints are new or gone: nothing is known of the impulses there. What hangs together with them is solved some
 * times more; what does not has no part in that, and does as it would without them, to the last bit.
 */
final class Newcomers implements Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;

    /** Those, until the step ends. */
    final IntList bodies = new IntList();

    /** By body: whether it hangs together with one; and the pairs of such bodies. */
    boolean[] marks = {};

    final IntList pairs = new IntList();

    /** By body: parents of what hangs together, and whether it stands for what has a new one. */
    private int[] parents = {};

    private boolean[] areNew = {};

    Newcomers(State state) {
        this.state = state;
    }

    /** All bodies are as if they were new. */
    void addAll() {
        bodies.clear();
        for (int k = 0; k < state.size(); k++) {
            bodies.add(k);
        }
    }

    /** {@return whether there are any} */
    boolean any() {
        return bodies.size > 0;
    }

    /** Finds what hangs together with them. */
    void find(ContactRows rows, TieRows ties, SpringRows springs) {
        int n = state.x().length / State.BLOCK;
        if (parents.length < n) {
            parents = new int[n];
            areNew = new boolean[n];
            marks = new boolean[n];
        }
        Arrays.setAll(parents, k -> k);
        ties.join(parents);
        springs.join(parents);
        Groups.join(rows, state, parents);
        Arrays.fill(areNew, false);
        for (int k = 0; k < bodies.size; k++) {
            areNew[DisjointSets.find(parents, bodies.values[k])] = true;
        }
        spread(rows);
        for (int k = 0; k < state.size(); k++) {
            marks[k] = isMovable(k) && areNew[DisjointSets.find(parents, k)];
        }
        pairs.clear();
        for (int k = 0; k < rows.count; k++) {
            if (marks[rows.first(k)] || marks[rows.second(k)]) {
                pairs.add(k);
            }
        }
    }

    /** What touches a new body that cannot move has got something new, too. */
    private void spread(ContactRows rows) {
        for (int k = 0; k < rows.count; k++) {
            boolean isFirst = isMovable(rows.first(k));
            int ground = isFirst ? rows.second(k) : rows.first(k);
            if (!isMovable(ground) && areNew[ground]) {
                areNew[DisjointSets.find(parents, isFirst ? rows.first(k) : rows.second(k))] = true;
            }
        }
    }

    private boolean isMovable(int body) {
        return Groups.isMovable(state, body);
    }

    /** Ends a step: nobody is new any more. */
    void end() {
        bodies.clear();
    }
}
