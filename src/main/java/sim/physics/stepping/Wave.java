// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static sim.physics.stepping.ContactRows.BOUNCE;
import static sim.physics.stepping.ContactRows.COUPLING;
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
import sim.physics.internal.CoulombImpulse;
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
    private final CoulombImpulse law = new CoulombImpulse();

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
        approaches[n / 2] = approach;
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
            compress(turn == 0);
            goesOn = turns.goOn();
        }
        restore();
        for (int m = 1; m < points.size; m += 2) {
            int p = points.values[m];
            rows.points[p + STEADY] += rows.points[p + NORMAL];
            rows.points[p + RUBBING] += rows.points[p + TANGENT];
        }
    }

    /** Takes what is left of the approaches once more in turn; what is alone is solved for good in the first one. */
    private void compress(boolean isFirst) {
        for (int m = 0; m < points.size; m += 2) {
            int k = points.values[m];
            int p = points.values[m + 1];
            int group = groups.of(k, rows);
            if (!turns.isOpen(group)) {
                continue;
            }
            boolean rubs = rows.normals[PAIR * k + FRICTION] > 0;
            if (!rubs) {
                turns.change(group, compress(k, p));
            } else if (!isAlone(k)) {
                turns.change(group, struck.solve(k, p, 0, 0, 1, false) > SETTLED);
            } else if (isFirst) {
                bounce(k, p, restitution(k, p, approaches[m / 2]));
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

    /** Lets a point that is alone part. */
    private void bounce(int k, int p, double restitution) {
        double kn = 1 / rows.points[p + NORMAL_MASS];
        double kt = 1 / rows.points[p + TANGENT_MASS];
        double knt = rows.points[p + COUPLING];
        double opening = rows.opening(k, p, state.v());
        double slide = rows.slip(k, p, state.v());
        law.solve(kn, kt, knt, -(1 + restitution) * opening, slide, rows.normals[PAIR * k + FRICTION]);
        law.limit(kn, kt, knt, opening, slide, 0);
        give(k, p, law.normal, law.tangent);
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
