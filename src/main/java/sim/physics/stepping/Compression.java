// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;
import sim.physics.internal.OpenGroups;
import sim.physics.motion.State;

/**
 * Compresses the points that have met in turn, until they approach no more. Of what hangs together, most is settled long before all is: a point is left
 * alone until one of its bodies has got another velocity.
 */
final class Compression implements Serializable {
    private static final long serialVersionUID = 1L;

    /** When an impulse has settled, relative to itself: few points are solved to what rounding leaves, as a box that falls flat is not to turn. */
    private static final double SETTLED = 1e-10;

    private static final double NEARLY_SETTLED = 1e-4;

    /** What is kept of a point's ends, and a body that cannot move. */
    private static final int ENDS = 3;

    private static final int FIXED = -1;

    private final State state;
    private final ContactRows rows;
    private final Groups groups;
    private final StruckPoints struck;

    /** By point: its group and its two bodies, −1 for one that cannot move. */
    private int[] ends = {};

    /** By point: when it was solved last; by body: when that changed its velocity last; counted in points that were solved. */
    private int[] solved = {};

    private int[] changed = {};

    private int clock;

    Compression(State state, ContactRows rows, Groups groups, StruckPoints struck) {
        this.state = state;
        this.rows = rows;
        this.groups = groups;
        this.struck = struck;
    }

    /** The change of an impulse of a group with so many points, relative to it, that is none. */
    static double settled(int points) {
        return points <= Impacts.FEW ? SETTLED : NEARLY_SETTLED;
    }

    /**
     * Begins to compress.
     *
     * @param met the points: row and first value of each
     */
    void begin(IntList met) {
        int points = met.size / 2;
        if (solved.length < points) {
            solved = new int[Growth.length(solved.length, points)];
            ends = new int[ENDS * solved.length];
        }
        if (changed.length < state.size()) {
            changed = new int[Growth.length(changed.length, state.size())];
        }
        clock = 0;
        for (int m = 0; m < points; m++) {
            int k = met.values[2 * m];
            solved[m] = -1;
            ends[ENDS * m] = groups.of(k, rows);
            ends[ENDS * m + 1] = begin(rows.first(k));
            ends[ENDS * m + 2] = begin(rows.second(k));
        }
    }

    private int begin(int body) {
        changed[body] = 0;
        return groups.isMovable(body) ? body : FIXED;
    }

    /**
     * Compresses the points once more in turn.
     *
     * @param part of what they ask for that they get
     * @param counts by group: its points
     * @param areTied by group: whether joints change the velocities of its bodies, too
     */
    void compress(IntList met, OpenGroups turns, double part, int[] counts, boolean[] areTied) {
        for (int m = 0; m < met.size / 2; m++) {
            int group = ends[ENDS * m];
            if (turns.isOpen(group) && (areTied[group] || isStale(m))) {
                boolean changes = struck.solve(met.values[2 * m], met.values[2 * m + 1], 0, 0, part, false) > settled(counts[group]);
                note(m, changes);
                turns.change(group, changes);
            }
        }
    }

    /** Whether one of the bodies of a point has another velocity than when it was solved last. */
    private boolean isStale(int m) {
        return solved[m] < changed(ends[ENDS * m + 1]) || solved[m] < changed(ends[ENDS * m + 2]);
    }

    private int changed(int body) {
        return body == FIXED ? 0 : changed[body];
    }

    private void note(int m, boolean changes) {
        solved[m] = ++clock;
        for (int end = ENDS * m + 1; changes && end < ENDS * m + ENDS; end++) {
            if (ends[end] != FIXED) {
                changed[ends[end]] = clock;
            }
        }
    }
}
