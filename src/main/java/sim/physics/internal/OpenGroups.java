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

    /** The open ones: most settle long before the last one does. */
    private final IntList list = new IntList();

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
        list.clear();
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
        if (!open[group]) {
            open[group] = true;
            list.add(group);
        }
    }

    /**
     * A group is not to be solved any more.
     *
     * @param group its number
     */
    public void close(int group) {
        open[group] = false;
        changes[group] = false;
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
        int left = 0;
        for (int k = 0; k < list.size; k++) {
            int group = list.values[k];
            open[group] = changes[group];
            changes[group] = false;
            if (open[group]) {
                list.values[left++] = group;
            }
        }
        list.size = left;
        return left > 0;
    }
}
