// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import sim.physics.internal.Freshness;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;
import sim.physics.internal.OpenGroups;
import sim.physics.internal.Softness;
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

    /** What is kept of a point's ends. */
    private static final int ENDS = 3;

    private final State state;
    private final ContactRows rows;
    private final Groups groups;
    private final StruckPoints struck;
    private final PinnedPairs pinned;
    private final Freshness fresh = new Freshness();

    /** By point: its group and its two bodies, {@link Freshness#FIXED} for one that cannot move; and when it was solved last. */
    private int[] ends = {};

    private long[] solved = {};

    /** The points that part, of those that have met, and the speeds at which they do. */
    private final IntList parting = new IntList();

    private double[] openings = {};

    Compression(State state, ContactRows rows, Groups groups, StruckPoints struck, PinnedPairs pinned) {
        this.state = state;
        this.rows = rows;
        this.groups = groups;
        this.struck = struck;
        this.pinned = pinned;
    }

    /** Which bodies have changed. */
    Freshness fresh() {
        return fresh;
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
            solved = new long[Growth.length(solved.length, points)];
            openings = new double[solved.length];
            ends = new int[ENDS * solved.length];
        }
        fresh.begin(state.size());
        for (int m = 0; m < points; m++) {
            int k = met.values[2 * m];
            solved[m] = 0;
            ends[ENDS * m] = groups.of(k, rows);
            ends[ENDS * m + 1] = end(rows.first(k));
            ends[ENDS * m + 2] = end(rows.second(k));
        }
    }

    private int end(int body) {
        return body >= 0 && groups.isMovable(body) ? body : Freshness.FIXED;
    }

    /**
     * Compresses the points once more in turn.
     *
     * @param counts by group: its points
     * @param areJoined by group: whether joints change the velocities of its bodies, too
     */
    void compress(IntList met, OpenGroups turns, int[] counts, boolean[] areJoined) {
        for (int m = 0; m < met.size / 2; m++) {
            solve(met, m, 0, false, turns, counts, areJoined);
        }
    }

    /** Begins to let points part. */
    void beginParting() {
        fresh.begin(state.size());
        parting.clear();
    }

    /** Lets a point part at a speed. */
    void add(int m, double opening) {
        openings[parting.size] = opening;
        parting.add(m);
    }

    /** Lets them part once more in turn. */
    void part(IntList met, OpenGroups turns, int[] counts, boolean[] areJoined, boolean[] areTied) {
        for (int n = 0; n < parting.size; n++) {
            int m = parting.values[n];
            solve(met, m, openings[n], !areTied[ends[ENDS * m]], turns, counts, areJoined);
        }
    }

    private void solve(IntList met, int m, double opening, boolean isLimited, OpenGroups turns, int[] counts, boolean[] areJoined) {
        int group = ends[ENDS * m];
        int first = ends[ENDS * m + 1];
        int second = ends[ENDS * m + 2];
        if (turns.isOpen(group) && fresh.isStale(solved[m], first, second)) {
            double part = areJoined[group] ? Softness.EAGER.mass() : 1;
            boolean changes = struck.solve(met.values[2 * m], met.values[2 * m + 1], 0, opening, part, isLimited) > settled(counts[group]);
            if (changes && pinned.has(met.values[2 * m])) {
                fresh.solve(end(pinned.third(met.values[2 * m])), Freshness.FIXED, true, false);
            }
            solved[m] = fresh.solve(first, second, changes, areJoined[group] || opening > 0); // what parts is found in more than one turn
            turns.change(group, changes);
        }
    }
}
