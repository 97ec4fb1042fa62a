// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static sim.physics.stepping.ContactRows.APPROACH;
import static sim.physics.stepping.ContactRows.BOUNCE;
import static sim.physics.stepping.ContactRows.BOUNCED;
import static sim.physics.stepping.ContactRows.FORCED;
import static sim.physics.stepping.ContactRows.FRICTION;
import static sim.physics.stepping.ContactRows.GAP;
import static sim.physics.stepping.ContactRows.INTS;
import static sim.physics.stepping.ContactRows.LOAD;
import static sim.physics.stepping.ContactRows.NORMAL;
import static sim.physics.stepping.ContactRows.NORMAL_MASS;
import static sim.physics.stepping.ContactRows.NORMAL_SUM;
import static sim.physics.stepping.ContactRows.PAIR;
import static sim.physics.stepping.ContactRows.PRESSED;
import static sim.physics.stepping.ContactRows.RESTORED;
import static sim.physics.stepping.ContactRows.STRIDE;
import static sim.physics.stepping.ContactRows.TANGENT;
import static sim.physics.stepping.ContactRows.TANGENT_MASS;
import static sim.physics.stepping.ContactRows.TANGENT_SUM;
import static sim.physics.stepping.ContactRows.WEIGHT;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.constraint.StopRows;
import sim.physics.internal.IntList;
import sim.physics.motion.State;

/**
 * What has met in a step, at its end: gaps are of no more use, and all that it takes and gives is known, in sums. First, what has met is compressed in
 * turn until it approaches no more. One point that bounces alone, among all that touch or are tied to one another, then parts at the speed of Newton's
 * law, and rubs on the way: the impulse by events ({@link sim.physics.response.TwoBodyImpulse}). Of several, each gives back a part of what it has
 * taken (Poisson), and rubs once more. What does not bounce is compressed, too, where joints have part in it: solved once a substep, they are far off.
 */
final class Impacts implements Serializable {
    private static final long serialVersionUID = 1L;

    /** When an impulse has settled, relative to itself. */
    private static final double SETTLED = 1e-4;

    /** What a point gives back that gives nothing back, but takes part. */
    private static final double PLASTIC = Double.MIN_VALUE;

    private final State state;
    private final ContactRows rows;
    private final Groups groups;
    private final StruckPoints struck;

    /** The points that have met: row and first value of each. */
    private final IntList met = new IntList();

    /** By group: the number of points that have met, and whether joints tie bodies of it. */
    private int[] counts = {};

    private boolean[] areTied = {};

    /** By body: the number of pairs in which it presses. */
    private int[] touched = {};

    Impacts(State state, ContactRows rows, Groups groups) {
        this.state = state;
        this.rows = rows;
        this.groups = groups;
        struck = new StruckPoints(state, rows);
    }

    /** Notes which points have met, and which stops were struck; false if none. */
    boolean find(double h, StopRows stops) {
        if (counts.length < groups.count) {
            counts = new int[groups.slots.length];
            areTied = new boolean[groups.slots.length];
        }
        Arrays.fill(counts, 0, groups.count, 0);
        Arrays.fill(areTied, 0, groups.count, false);
        groups.markTied(areTied);
        count();
        for (int k = 0; k < rows.count; k++) {
            for (int p = rows.begin(k); mayMeet(k) && p < rows.end(k); p += STRIDE) {
                boolean meets = rows.points[p + NORMAL_SUM] > 0 && isImpact(k, p, h);
                rows.points[p + RESTORED] = meets ? Math.max(PLASTIC, rows.normals[PAIR * k + BOUNCE]) : 0;
                rows.pairs[INTS * k + BOUNCED] |= meets && rows.mayBounce(k) ? 1 : 0;
                counts[rows.group(k, groups)] += meets ? 1 : 0;
            }
        }
        stops.find(groups.slots, counts);
        collect();
        return met.size > 0 || stops.haveMet();
    }

    /** Lists the points that have met; what else presses where joints are struck has part in that. */
    private void collect() {
        met.clear();
        for (int k = 0; k < rows.count; k++) {
            for (int p = rows.begin(k); hasMet(k) && p < rows.end(k); p += STRIDE) {
                boolean presses = isTied(k) && rows.points[p + NORMAL_SUM] > 0;
                rows.points[p + RESTORED] = presses ? Math.max(PLASTIC, rows.points[p + RESTORED]) : rows.points[p + RESTORED];
                if (rows.points[p + RESTORED] > 0) {
                    met.add(k);
                    met.add(p);
                }
            }
        }
    }

    /** Whether there is something to be done about a pair: it may bounce, or strikes what joints tie. */
    private boolean mayMeet(int k) {
        return rows.mayBounce(k) || rows.isFast(k) && groups.has(k, rows) && isTied(k);
    }

    private boolean isTied(int k) {
        return areTied[rows.group(k, groups)];
    }

    /** Whether a pair is of a group in which something has met. */
    private boolean hasMet(int k) {
        return groups.has(k, rows) && counts[rows.group(k, groups)] > 0;
    }

    /** Marks the bodies of groups in which something has met, or takes the marks back. */
    void mark(boolean[] marks, boolean as) {
        for (int k = 0; k < groups.bodies; k++) {
            int body = groups.blocks[k] / State.BLOCK;
            marks[body] = as && counts[groups.slots[body]] > 0;
        }
    }

    /** What lies bounces only if it is faster than forces make it in two steps; what has pressed may have been pressed by others, which weigh something. */
    private boolean isImpact(int k, int p, double h) {
        boolean hasPressed = rows.pairs[INTS * k + PRESSED] != 0;
        boolean lies = touched[rows.first(k)] > 1 || touched[rows.second(k)] > 1;
        double apart = lies ? rows.normals[PAIR * k + LOAD] : Math.max(0, -rows.points[p + FORCED]);
        double pull = h * (hasPressed ? rows.normals[PAIR * k + WEIGHT] : apart);
        return rows.points[p + APPROACH] < -2 * pull || !hasPressed && pull == 0;
    }

    /** Counts the pairs in which each body presses. */
    private void count() {
        if (touched.length < state.size()) {
            touched = new int[groups.slots.length];
        }
        Arrays.fill(touched, 0, state.size(), 0);
        for (int k = 0; k < rows.count; k++) {
            int one = rows.impulse(k) > 0 ? 1 : 0;
            touched[rows.first(k)] += one;
            touched[rows.second(k)] += one;
        }
    }

    /** Without friction the two laws say the same, and Poisson's keeps the energy also where turns among joints do not reach their end. */
    private boolean isAlone(int k) {
        return counts[rows.group(k, groups)] == 1 && (rows.normals[PAIR * k + FRICTION] > 0 || !isTied(k));
    }

    /** Whether a point that has met has given back what it took by {@link Reflections}. */
    private boolean isReflected(int p) {
        return rows.points[p + RESTORED] == 0;
    }

    /** Compresses what has met once more in turn; whether something has changed. */
    boolean compress(double part) {
        boolean goesOn = false;
        for (int m = 0; m < met.size; m += 2) {
            goesOn |= struck.solve(met.values[m], met.values[m + 1], NORMAL_SUM, 0, 0, part, false) > SETTLED;
        }
        return goesOn;
    }

    /** Lets what bounces alone part; whether something has changed. */
    boolean part(double part, double h) {
        boolean goesOn = false;
        for (int m = 0; m < met.size; m += 2) {
            int k = met.values[m];
            int p = met.values[m + 1];
            if (isAlone(k) && !isReflected(p)) {
                double speed = Math.max(0, -rows.points[p + APPROACH] - time(p, h) * rows.points[p + FORCED]);
                goesOn |= struck.solve(k, p, NORMAL_SUM, 0, rows.points[p + RESTORED] * speed, part, !isTied(k)) > SETTLED;
            }
        }
        return goesOn;
    }

    /** How long a point took to use its gap up. */
    private double time(int p, double h) {
        double approach = -rows.points[p + APPROACH];
        double gap = Math.max(0, rows.points[p + GAP]);
        return gap < h * approach ? gap / approach : h;
    }

    /** Gives what compression has taken of several once more, in part. What forces alone give in the step does not bounce. */
    void restore(double h) {
        for (int m = 0; m < met.size; m += 2) {
            int k = met.values[m];
            int p = met.values[m + 1];
            if (!isReflected(p)) {
                rows.points[p + NORMAL] = 0; // the two part, or what they will bear is not known
                rows.points[p + TANGENT] = 0;
                if (!isAlone(k) || isTied(k)) {
                    restore(k, p, h);
                }
            }
        }
    }

    private void restore(int k, int p, double h) {
        double[] points = rows.points;
        double pull = (h - time(p, h)) * Math.max(0, -points[p + FORCED]) * points[p + NORMAL_MASS];
        double by = points[p + RESTORED] * Math.max(0, points[p + NORMAL_SUM] - pull);
        points[p + NORMAL_SUM] += by;
        rows.give(k, p, state.v(), by, 0);
        double most = rows.normals[PAIR * k + FRICTION] * by; // what restitution gives rubs as what compression has taken
        double along = Math.max(-most, Math.min(most, -points[p + TANGENT_MASS] * rows.slip(k, p, state.v())));
        points[p + TANGENT_SUM] += along;
        rows.give(k, p, state.v(), 0, along);
    }
}
