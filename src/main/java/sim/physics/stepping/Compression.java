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

    /** The most points that are few. */
    private static final int FEW = 24;

    private final State state;
    private final ContactRows rows;
    private final Groups groups;
    private final StruckPoints struck;

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
        return points <= FEW ? SETTLED : NEARLY_SETTLED;
    }

    /**
     * Begins to compress.
     *
     * @param met the points: row and first value of each
     */
    void begin(IntList met) {
        if (solved.length < met.size) {
            solved = new int[Growth.length(solved.length, met.size)];
        }
        if (changed.length < state.size()) {
            changed = new int[Growth.length(changed.length, state.size())];
        }
        clock = 0;
        for (int m = 0; m < met.size; m += 2) {
            solved[m] = -1;
            changed[rows.first(met.values[m])] = 0;
            changed[rows.second(met.values[m])] = 0;
        }
    }

    /**
     * Compresses the points once more in turn.
     *
     * @param part of what they ask for that they get
     * @param counts by group: its points
     * @param areTied by group: whether joints change the velocities of its bodies, too
     */
    void compress(IntList met, OpenGroups turns, double part, int[] counts, boolean[] areTied) {
        for (int m = 0; m < met.size; m += 2) {
            int k = met.values[m];
            int group = groups.of(k, rows);
            if (turns.isOpen(group) && (areTied[group] || isStale(m, k))) {
                boolean changes = struck.solve(k, met.values[m + 1], 0, 0, part, false) > settled(counts[group]);
                note(m, k, changes);
                turns.change(group, changes);
            }
        }
    }

    /** Whether one of the bodies of a point has another velocity than when it was solved last. */
    private boolean isStale(int m, int k) {
        return solved[m] < changed[rows.first(k)] || solved[m] < changed[rows.second(k)];
    }

    private void note(int m, int k, boolean changes) {
        solved[m] = ++clock;
        if (changes) {
            changed[rows.first(k)] = groups.isMovable(rows.first(k)) ? clock : 0;
            changed[rows.second(k)] = groups.isMovable(rows.second(k)) ? clock : 0;
        }
    }
}
