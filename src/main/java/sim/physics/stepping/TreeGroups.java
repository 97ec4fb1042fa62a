// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.constraint.TieRows;
import sim.physics.motion.State;

/**
 * Groups in which nothing acts but trees of joints that are solved at once. They are right on their joints before and after a substep, so energy that comes
 * and goes is an error of the method, and no more than that has to be taken off them.
 */
final class TreeGroups implements Serializable {
    private static final long serialVersionUID = 1L;

    /** By body: whether it is of such a tree; by group: whether it is such a group. */
    private boolean[] bodies = {};

    private boolean[] those = {};
    private boolean any;

    /** Finds them. */
    void find(TieRows ties, ContactRows rows, Groups groups) {
        any = ties.trees().count() > 0;
        if (!any) {
            return;
        }
        int n = groups.slots.length;
        bodies = bodies.length < n ? new boolean[n] : bodies;
        those = those.length < groups.count ? new boolean[n] : those;
        Arrays.fill(bodies, false);
        for (int k = 0; k < rows.count; k++) {
            bodies[rows.first(k)] = true;
            bodies[rows.second(k)] = true;
        }
        ties.trees().touch(bodies);
        Arrays.fill(bodies, false);
        ties.trees().markOpen(bodies);
        for (int g = 0; g < groups.count; g++) {
            those[g] = true;
            for (int k = groups.begins[g]; k < groups.begins[g + 1]; k++) {
                those[g] &= bodies[groups.blocks[k] / State.BLOCK];
            }
        }
        Arrays.fill(bodies, false);
        ties.trees().markPressed(bodies);
        for (int g = 0; g < groups.count; g++) {
            for (int k = groups.begins[g]; k < groups.begins[g + 1]; k++) {
                those[g] |= bodies[groups.blocks[k] / State.BLOCK];
            }
        }
    }

    /** Whether there may be any. */
    boolean any() {
        return any;
    }

    /** Whether a group is one of them. */
    boolean has(int group) {
        return any && those[group];
    }
}
