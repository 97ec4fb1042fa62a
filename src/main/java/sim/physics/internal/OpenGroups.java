// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

import java.io.Serializable;
import java.util.Arrays;

/** Which of some groups are still solved in turn, each until it has settled: how often must not depend on what happens in others. */
public final class OpenGroups implements Serializable {
    private static final long serialVersionUID = 1L;

    private boolean[] open = {};
    private boolean[] changes = {};
    private int count;

    /** Makes one of no group. */
    public OpenGroups() {
        // they are opened
    }

    /**
     * Begins with groups that are not solved.
     *
     * @param groups their number
     */
    public void begin(int groups) {
        count = groups;
        if (open.length < groups) {
            open = new boolean[Growth.length(open.length, groups)];
            changes = new boolean[open.length];
        }
        Arrays.fill(open, 0, groups, false);
        Arrays.fill(changes, 0, groups, false);
    }

    /**
     * A group is to be solved.
     *
     * @param group its number
     */
    public void open(int group) {
        open[group] = true;
    }

    /**
     * Whether a group is to be solved in this turn.
     *
     * @param group its number
     * @return false once it has settled
     */
    public boolean isOpen(int group) {
        return open[group];
    }

    /**
     * Notes of a part of a group whether it has changed in this turn.
     *
     * @param group its number
     * @param isOther whether it has
     */
    public void change(int group, boolean isOther) {
        changes[group] |= isOther;
    }

    /**
     * Ends a turn: what has not changed in it has settled.
     *
     * @return whether there is a group that goes on
     */
    public boolean goOn() {
        boolean any = false;
        for (int g = 0; g < count; g++) {
            open[g] &= changes[g];
            changes[g] = false;
            any |= open[g];
        }
        return any;
    }
}
