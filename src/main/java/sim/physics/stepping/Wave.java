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

    /** Groups that have not settled. */
    private final OpenGroups turns = new OpenGroups();

    /** Length of the step. */
    private double step;

    Wave(State state, ContactRows rows, Groups groups) {
        this.state = state;
        this.rows = rows;
        this.groups = groups;
        struck = new StruckPoints(state, rows);
    }

    /** Begins a round. */
    void begin(double h) {
        step = h;
        if (shared.length < state.size()) {
            shared = new int[Growth.length(shared.length, state.size())];
        }
        for (int m = 0; m < points.size; m += 2) {
            shared[rows.first(points.values[m])] = 0;
            shared[rows.second(points.values[m])] = 0;
        }
        points.clear();
    }

    /** Forgets all points. */
    void end() {
        points.clear();
        Arrays.fill(shared, 0);
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
        rows.points[p + NORMAL] = 0;
        rows.points[p + TANGENT] = 0;
    }

    /** Mirrors the points; what they have given in all rounds is in what is steady of them. */
    void reflect() {
        if (points.size == 0) {
            return;
        }
        turns.begin(groups.count);
        for (int m = 0; m < points.size; m += 2) {
            turns.open(groups.of(points.values[m], rows));
        }
        boolean goesOn = true;
        for (int turn = 0; goesOn && turn < TURNS; turn++) {
            compress();
            goesOn = turns.goOn();
        }
        restore();
        for (int m = 1; m < points.size; m += 2) {
            int p = points.values[m];
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
                turns.change(group, struck.solve(k, p, 0, opening, 1, isAlone) > SETTLED);
            } else {
                turns.change(group, compress(k, p));
            }
        }
    }

    /** Takes what is left of a point's approach; whether there was anything. */
    private boolean compress(int k, int p) {
        double old = rows.points[p + NORMAL];
        double now = Math.max(0, old - rows.points[p + NORMAL_MASS] * rows.opening(k, p, state.v()));
        rows.points[p + NORMAL] = now;
        rows.give(k, p, state.v(), now - old, 0);
        return Math.abs(now - old) > SETTLED * (now + old);
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

    /** What has met gives its part back; what lay there passes a wave on that is faster than forces make it in two steps. */
    private double restitution(int k, int p, double approach) {
        boolean hasMet = rows.points[p + RESTORED] > Impacts.PLASTIC;
        boolean hasPressed = rows.pairs[INTS * k + PRESSED] != 0;
        double pull = groups.areFree[groups.of(k, rows)] ? Math.max(0, -rows.points[p + FORCED]) : rows.normals[PAIR * k + (hasPressed ? WEIGHT : LOAD)];
        return hasMet || approach > 2 * step * pull ? rows.normals[PAIR * k + BOUNCE] : 0;
    }
}
