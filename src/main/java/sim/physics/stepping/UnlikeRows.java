// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.constraint.Constraints;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;
import sim.physics.motion.State;

/**
 * The contacts of what hangs together with a light body on which forces press a heavy one. Solved one after the other, these would need some thousand
 * turns: impulses that stop the light body are next to nothing for the heavy one. If they are few, or form a column, they are a set, which is solved at once
 * ({@link UnlikeSet}); and so are {@link Columns} of any bodies. Scenes that have neither pay a look at each pair.
 */
final class UnlikeRows implements Serializable {
    private static final long serialVersionUID = 1L;

    /** How many times as heavy as the light one a heavy body is at least. */
    private static final double HEAVY = 4;

    /** And how many times as heavy as any of its set at most: rounding would be as large as what the light ones ask for. */
    private static final double TOO_HEAVY = 2e6;

    /**
     * Points of a set at most; and of a column, for which as much is to be done at most. That goes with the squares of how many pairs wait for their turn
     * while those that hang together are listed.
     */
    private static final int MOST = 40;

    private static final int MOST_OF_COLUMN = 400;
    private static final int WORK = 2700;

    /** What a row is of: a set, or of what hangs together and is no set. */
    private static final byte SET = 1;

    private static final byte NO_SET = 2;

    private final State state;
    private final ContactRows rows;
    private final UnlikeSet set;
    private final Columns columns;

    /** Length of the substeps. */
    private double h;

    /** What each row is of. */
    private transient byte[] kinds;

    /** The rows, set by set, and where each set ends. */
    private final IntList order = new IntList();

    private final IntList ends = new IntList();

    /** How many of the sets are columns: the first ones. */
    private int columnCount;

    UnlikeRows(State state, ContactRows rows) {
        this.state = state;
        this.rows = rows;
        set = new UnlikeSet(state, rows);
        columns = new Columns(state, rows);
    }

    /** Whether forces press a heavy body on a light one; what its author moves is the ground to others. */
    static boolean presses(State state, int a, int b, Touch touch, double[] forces) {
        double first = state.w().values()[State.BLOCK * a];
        double second = state.w().values()[State.BLOCK * b];
        boolean isFirst = first > HEAVY * second;
        if (!isFirst && !(second > HEAVY * first)) {
            return false;
        }
        int heavy = State.BLOCK * (isFirst ? b : a);
        double push = touch.nx * forces[heavy] + touch.ny * forces[heavy + 1];
        return (isFirst ? second : first) > 0 && (isFirst ? push < 0 : push > 0) && state.body(isFirst ? b : a).isDynamic();
    }

    /**
     * Begins a step.
     *
     * @param step its length
     * @param h that of its substeps
     * @param constraints those of the engine, or null
     */
    void begin(double step, double h, Constraints constraints) {
        this.h = h;
        set.begin(step, h);
        order.clear();
        ends.clear();
        columns.find(step, constraints, order, ends);
        columnCount = ends.size;
        if (rows.unlike > 0 || columnCount > 0) {
            if (kinds == null || kinds.length < rows.count) {
                kinds = new byte[Growth.length(kinds == null ? 0 : kinds.length, rows.count)];
            }
            Arrays.fill(kinds, 0, rows.count, (byte) 0);
        }
        for (int r = 0; r < order.size; r++) {
            kinds[order.values[r]] = SET;
        }
    }

    /** Begins a substep: finds the sets of what presses, or will, and is of none yet. */
    void find() {
        for (int k = 0; rows.unlike > 0 && k < rows.count; k++) {
            boolean isNew = rows.pairs[ContactRows.INTS * k + ContactRows.UNLIKE] != 0 && kinds[k] == 0;
            if (isNew && !(rows.mayBounce(k) && rows.isStruck(k)) && presses(k)) {
                gather(k);
            }
        }
    }

    private boolean presses(int k) {
        boolean is = false;
        double[] points = rows.points;
        for (int p = rows.begin(k); !is && p < rows.end(k); p += ContactRows.STRIDE) {
            double way = h * (points[p + ContactRows.APPROACH] + h * points[p + ContactRows.FORCED]);
            is = points[p + ContactRows.NORMAL] > 0 || points[p + ContactRows.NOW] + way <= 0;
        }
        return is;
    }

    /**
     * Lists all rows that hang together with one, if that is a set. Those that share a body are to be near one another, so it is done from one end: that
     * is the last one of the list from anywhere.
     */
    private void gather(int k) {
        int begin = order.size;
        if (spread(k)) {
            int end = order.values[order.size - 1];
            mark(begin, (byte) 0);
            spread(end);
            ends.add(order.size);
        } else {
            mark(begin, NO_SET);
        }
    }

    /** Marks the rows of the list from one on, and takes them off it. */
    private void mark(int begin, byte kind) {
        for (int r = begin; r < order.size; r++) {
            kinds[order.values[r]] = kind;
        }
        order.size = begin;
    }

    /** Lists what hangs together with a row; whether that is a set. */
    private boolean spread(int row) {
        double[] w = state.w().values();
        int next = order.size;
        int points = 0;
        int work = 0;
        double heaviest = Double.POSITIVE_INFINITY;
        double lightest = 0;
        boolean isSet = take(row);
        while (isSet && next < order.size) {
            int k = order.values[next++];
            double first = w[State.BLOCK * rows.first(k)];
            double second = w[State.BLOCK * rows.second(k)];
            points += rows.pointCount(k);
            lightest = Math.max(lightest, Math.max(first, second));
            heaviest = Math.min(heaviest, Math.min(first > 0 ? first : second, second > 0 ? second : first));
            work += (order.size - next) * (order.size - next);
            isSet = points <= (work <= WORK ? MOST_OF_COLUMN : MOST) && lightest <= TOO_HEAVY * heaviest && reach(rows.first(k)) && reach(rows.second(k));
        }
        return isSet;
    }

    /** Lists the rows of a body that can move; whether none of them is of no set. */
    private boolean reach(int body) {
        int k = state.w().values()[State.BLOCK * body] > 0 ? rows.byBody.first(body) : -1;
        while (k >= 0 && take(k)) {
            k = rows.byBody.next(k, body);
        }
        return k < 0;
    }

    private boolean take(int k) {
        if (kinds[k] == 0) {
            kinds[k] = SET;
            order.add(k);
        }
        return kinds[k] == SET;
    }

    /** {@return whether there are sets} */
    boolean any() {
        return ends.size > 0;
    }

    /** Whether a row is of a set. */
    boolean has(int k) {
        return kinds[k] == SET;
    }

    /** Solves the sets of marked bodies once; null for all. */
    void solve(boolean[] marks, double rate, boolean regains) {
        for (int m = 0; m < ends.size; m++) {
            int begin = m == 0 ? 0 : ends.values[m - 1];
            int row = order.values[begin];
            if (marks == null || marks[rows.first(row)] || marks[rows.second(row)]) {
                set.solve(order.values, begin, ends.values[m], m < columnCount, rate, regains);
            }
        }
    }
}
