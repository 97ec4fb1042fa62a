// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static sim.physics.stepping.ContactRows.BOUNCE;
import static sim.physics.stepping.ContactRows.FORCED;
import static sim.physics.stepping.ContactRows.FRICTION;
import static sim.physics.stepping.ContactRows.INTS;
import static sim.physics.stepping.ContactRows.LOAD;
import static sim.physics.stepping.ContactRows.NORMAL;
import static sim.physics.stepping.ContactRows.NORMAL_MASS;
import static sim.physics.stepping.ContactRows.PAIR;
import static sim.physics.stepping.ContactRows.PRESSED;
import static sim.physics.stepping.ContactRows.RESTORED;
import static sim.physics.stepping.ContactRows.RUBBING;
import static sim.physics.stepping.ContactRows.STEADY;
import static sim.physics.stepping.ContactRows.STRIDE;
import static sim.physics.stepping.ContactRows.TANGENT;
import static sim.physics.stepping.ContactRows.TANGENT_MASS;
import static sim.physics.stepping.ContactRows.WEIGHT;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;
import sim.physics.internal.OpenGroups;
import sim.physics.motion.State;

/**
 * One round of {@link Reflections}: the points that approach are mirrored together. Those that rub are stopped with their friction (Moreau), give back their
 * part, and rub once more (Poisson); one that shares its bodies with no other of them has the law that it has by events,
 * {@link sim.physics.response.TwoBodyImpulse}.
 */
final class Wave implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Turns at most: what has not settled gives back more or less energy than it took. */
    private static final int TURNS = 256;

    /** When an impulse has settled, relative to itself. */
    private static final double SETTLED = 1e-12;

    private final State state;
    private final ContactRows rows;
    private final Groups groups;
    private final StruckPoints struck;

    /** The points of the round: row and first value of each, the speed at which it approaches, and how much it may rub, and has, as it gives back. */
    private final IntList points = new IntList();

    private double[] approaches = {};
    private double[] limits = {};

    /** By body: how many of these points it has. */
    private int[] shared = {};

    /** By point of the rows: whether it gave nothing back when it was in a round last; it lies, and has part in all rounds that follow while it does not open. */
    private boolean[] lies = {};

    /** By point: whether it has part in the round. */
    private boolean[] isIn = {};

    private final IntList lying = new IntList();

    /** Groups that have not settled. */
    private final OpenGroups turns = new OpenGroups();

    /** Length of the step; and by group the fastest approach, of which impulses are parts that have settled. */
    private double step;

    private double[] scales = {};

    Wave(State state, ContactRows rows, Groups groups, StruckPoints struck) {
        this.state = state;
        this.rows = rows;
        this.groups = groups;
        this.struck = struck;
    }

    /**
     * Begins a round.
     *
     * @param h the step
     * @param fastest by group: the fastest approach of all rounds
     */
    void begin(double h, double[] fastest) {
        step = h;
        scales = fastest;
        turns.begin(groups.count);
        if (shared.length < state.size()) {
            shared = new int[Growth.length(shared.length, state.size())];
        }
        if (lies.length * STRIDE < rows.points.length) {
            lies = Arrays.copyOf(lies, Growth.length(lies.length, rows.points.length / STRIDE));
            isIn = Arrays.copyOf(isIn, lies.length);
        }
        forget();
    }

    /** Whether a point that is not in the round lies since an earlier one, of a group in which something approaches in this one. */
    boolean lies(int k, int p) {
        return lies[p / STRIDE] && !isIn[p / STRIDE] && turns.isOpen(groups.of(k, rows));
    }

    private void lie(int p, boolean yes) {
        if (yes && !lies[p / STRIDE]) {
            lying.add(p / STRIDE);
        }
        lies[p / STRIDE] = yes;
    }

    /** Forgets all points. */
    void end() {
        forget();
        for (int n = 0; n < lying.size; n++) {
            lies[lying.values[n]] = false;
        }
        lying.clear();
    }

    private void forget() {
        for (int m = 0; m < points.size; m += 2) {
            shared[rows.first(points.values[m])] = 0;
            shared[rows.second(points.values[m])] = 0;
            isIn[points.values[m + 1] / STRIDE] = false;
        }
        points.clear();
    }

    /** A point has part in the round. */
    void add(int k, int p, double approach) {
        int n = points.size;
        if (approaches.length < n / 2 + 1) {
            approaches = Arrays.copyOf(approaches, Growth.length(approaches.length, n / 2 + 1));
            limits = new double[2 * approaches.length];
        }
        approaches[n / 2] = Math.max(0, approach);
        points.add(k);
        points.add(p);
        shared[rows.first(k)]++;
        shared[rows.second(k)]++;
        isIn[p / STRIDE] = true;
        turns.open(groups.of(k, rows));
        rows.points[p + NORMAL] = 0;
        rows.points[p + TANGENT] = 0;
    }

    /** Mirrors the points; what they have given in all rounds is in what is steady of them. */
    void reflect() {
        if (points.size == 0) {
            return;
        }
        boolean goesOn = true;
        for (int turn = 0; goesOn && turn < TURNS; turn++) {
            compress();
            goesOn = turns.goOn();
        }
        restore();
        for (int m = 0; m < points.size; m += 2) {
            int p = points.values[m + 1];
            lie(p, restitution(points.values[m], p, approaches[m / 2]) == 0);
            rows.points[p + STEADY] += rows.points[p + NORMAL];
            rows.points[p + RUBBING] += rows.points[p + TANGENT];
        }
    }

    /** Takes what is left of the approaches once more in turn; what rubs alone parts. */
    private void compress() {
        for (int m = 0; m < points.size; m += 2) {
            int k = points.values[m];
            int p = points.values[m + 1];
            int group = groups.of(k, rows);
            if (!turns.isOpen(group)) {
                continue;
            }
            if (rows.normals[PAIR * k + FRICTION] > 0) {
                boolean isAlone = isAlone(k);
                double opening = isAlone ? restitution(k, p, approaches[m / 2]) * approaches[m / 2] : 0;
                double normal = rows.points[p + NORMAL];
                double tangent = rows.points[p + TANGENT];
                boolean isOther = struck.solve(k, p, 0, opening, 1, isAlone) > SETTLED;
                double most = SETTLED * scales[group];
                boolean isFast = Math.abs(rows.points[p + NORMAL] - normal) > most * rows.points[p + NORMAL_MASS];
                boolean isRubbed = Math.abs(rows.points[p + TANGENT] - tangent) > most * rows.points[p + TANGENT_MASS];
                turns.change(group, isOther && (isFast || isRubbed));
            } else {
                turns.change(group, compress(k, p, SETTLED * scales[group]));
            }
        }
    }

    /** Takes what is left of a point's approach; whether there was anything. */
    private boolean compress(int k, int p, double most) {
        double old = rows.points[p + NORMAL];
        double now = Math.max(0, old - rows.points[p + NORMAL_MASS] * rows.opening(k, p, state.v()));
        rows.points[p + NORMAL] = now;
        rows.give(k, p, state.v(), now - old, 0);
        return Math.abs(now - old) > Math.max(SETTLED * (now + old), most * rows.points[p + NORMAL_MASS]);
    }

    private boolean isAlone(int k) {
        return isOnly(rows.first(k)) && isOnly(rows.second(k));
    }

    private boolean isOnly(int body) {
        return shared[body] == 1 || !groups.isMovable(body);
    }

    private void give(int k, int p, double normal, double tangent) {
        rows.points[p + NORMAL] += normal;
        rows.points[p + TANGENT] += tangent;
        rows.give(k, p, state.v(), normal, tangent);
    }

    /** Gives what was taken once more, in part: first along normals, and then what rubs. */
    private void restore() {
        boolean rubs = false;
        for (int m = 0; m < points.size; m += 2) {
            int k = points.values[m];
            int p = points.values[m + 1];
            double friction = rows.normals[PAIR * k + FRICTION];
            double given = friction > 0 && isAlone(k) ? 0 : restitution(k, p, approaches[m / 2]) * rows.points[p + NORMAL];
            limits[m] = friction * given;
            limits[m + 1] = 0;
            give(k, p, given, 0);
            if (limits[m] > 0) {
                turns.open(groups.of(k, rows));
                rubs = true;
            }
        }
        for (int turn = 0; rubs && turn < TURNS; turn++) {
            for (int m = 0; m < points.size; m += 2) {
                int group = groups.of(points.values[m], rows);
                if (limits[m] > 0 && turns.isOpen(group)) {
                    turns.change(group, rub(points.values[m], points.values[m + 1], m));
                }
            }
            rubs = turns.goOn();
        }
    }

    private boolean rub(int k, int p, int m) {
        double old = limits[m + 1];
        double wanted = old - rows.points[p + TANGENT_MASS] * rows.slip(k, p, state.v());
        limits[m + 1] = Math.max(-limits[m], Math.min(limits[m], wanted));
        give(k, p, 0, limits[m + 1] - old);
        return Math.abs(limits[m + 1] - old) > SETTLED * limits[m];
    }

    /** What has met gives its part back; what lay there, or meets once more, passes a wave on that is faster than forces make it in two steps. */
    private double restitution(int k, int p, double approach) {
        boolean hasMet = rows.points[p + RESTORED] > Impacts.PLASTIC && rows.points[p + STEADY] == 0;
        boolean hasPressed = rows.pairs[INTS * k + PRESSED] != 0;
        double pull = groups.areFree[groups.of(k, rows)] ? Math.max(0, -rows.points[p + FORCED]) : rows.normals[PAIR * k + (hasPressed ? WEIGHT : LOAD)];
        return hasMet || approach > 2 * step * pull ? rows.normals[PAIR * k + BOUNCE] : 0;
    }
}
