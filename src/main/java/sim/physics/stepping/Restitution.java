// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static sim.physics.stepping.ContactRows.APPROACH;
import static sim.physics.stepping.ContactRows.BOUNCE;
import static sim.physics.stepping.ContactRows.BOUNCED;
import static sim.physics.stepping.ContactRows.FORCED;
import static sim.physics.stepping.ContactRows.FRICTION;
import static sim.physics.stepping.ContactRows.INTS;
import static sim.physics.stepping.ContactRows.LOAD;
import static sim.physics.stepping.ContactRows.NORMAL;
import static sim.physics.stepping.ContactRows.NORMAL_MASS;
import static sim.physics.stepping.ContactRows.NORMAL_SUM;
import static sim.physics.stepping.ContactRows.PAIR;
import static sim.physics.stepping.ContactRows.PRESSED;
import static sim.physics.stepping.ContactRows.RESTORED;
import static sim.physics.stepping.ContactRows.STRIDE;
import static sim.physics.stepping.ContactRows.TANGENT_MASS;
import static sim.physics.stepping.ContactRows.TANGENT_SUM;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.motion.State;

/**
 * What points that have met give once more. One that bounces alone, among all that touch or are tied to one another, parts at the speed of
 * Newton's law, and rubs on the way: the impulse by events ({@link sim.physics.response.TwoBodyImpulse}). Of several, each gives back a part of what it
 * has taken (Poisson), and rubs once more.
 */
final class Restitution implements Serializable {
    private static final long serialVersionUID = 1L;

    /** When an impulse has settled, relative to itself. */
    private static final double SETTLED = 1e-4;

    private final State state;
    private final ContactRows rows;
    private final Groups groups;
    private final StruckPoints struck;

    /** By group: the number of points that bounce, and whether joints tie bodies of it. */
    private int[] counts = {};

    private boolean[] areTied = {};

    /** By body: the number of pairs in which it presses. */
    private int[] touched = {};

    Restitution(State state, ContactRows rows, Groups groups) {
        this.state = state;
        this.rows = rows;
        this.groups = groups;
        struck = new StruckPoints(state, rows);
    }

    /** Notes which points have met and will bounce; false if none does. */
    boolean find(double h) {
        if (counts.length < groups.count) {
            counts = new int[groups.slots.length];
            areTied = new boolean[groups.slots.length];
        }
        Arrays.fill(areTied, 0, groups.count, false);
        groups.markTied(areTied);
        Arrays.fill(counts, 0, groups.count, 0);
        count();
        boolean any = false;
        for (int k = 0; k < rows.count; k++) {
            for (int p = rows.begin(k); rows.mayBounce(k) && p < rows.end(k); p += STRIDE) {
                boolean bounces = rows.points[p + NORMAL_SUM] > 0 && isImpact(k, p, h);
                rows.points[p + RESTORED] = bounces ? rows.normals[PAIR * k + BOUNCE] : 0;
                rows.pairs[INTS * k + BOUNCED] |= bounces ? 1 : 0;
                counts[rows.group(k, groups)] += bounces ? 1 : 0;
                any |= bounces;
            }
        }
        return any;
    }

    /** What lies on something that lies, too, is no impact as long as it is slower than forces make it in two steps. */
    private boolean isImpact(int k, int p, double h) {
        boolean hasPressed = rows.pairs[INTS * k + PRESSED] != 0;
        boolean lies = hasPressed || touched[rows.first(k)] > 1 || touched[rows.second(k)] > 1;
        double pull = h * (lies ? rows.normals[PAIR * k + LOAD] : Math.max(0, -rows.points[p + FORCED]));
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

    private boolean bounces(int k, int p) {
        return rows.points[p + RESTORED] > 0;
    }

    /** Without friction the two laws say the same, and Poisson's keeps the energy also where turns do not reach their end. */
    private boolean isAlone(int k) {
        return counts[rows.group(k, groups)] == 1 && rows.normals[PAIR * k + FRICTION] > 0;
    }

    /** Compresses what will bounce once more in turn, as its gaps are of no more use; whether something has changed. */
    boolean compress(double part) {
        return solve(false, part, 0);
    }

    /** Lets what bounces alone part; whether something has changed. */
    boolean part(double part, double h) {
        return solve(true, part, h);
    }

    private boolean solve(boolean areAlone, double part, double h) {
        boolean goesOn = false;
        for (int k = 0; k < rows.count; k++) {
            for (int p = rows.begin(k); rows.hasBounced(k) && p < rows.end(k); p += STRIDE) {
                if (bounces(k, p) && (!areAlone || isAlone(k))) {
                    double opening = areAlone ? rows.points[p + RESTORED] * Math.max(0, -rows.points[p + APPROACH] - 0.5 * h * rows.points[p + FORCED]) : 0;
                    goesOn |= struck.solve(k, p, NORMAL_SUM, 0, opening, part, opening > 0 && !areTied[rows.group(k, groups)]) > SETTLED;
                }
            }
        }
        return goesOn;
    }

    /** Gives what compression has taken of several once more, in part. What forces alone give in the step does not bounce. */
    void restore(double h) {
        for (int k = 0; k < rows.count; k++) {
            for (int p = rows.begin(k); rows.hasBounced(k) && p < rows.end(k); p += STRIDE) {
                rows.points[p + NORMAL] = 0; // the two part
                if (bounces(k, p) && (!isAlone(k) || areTied[rows.group(k, groups)])) {
                    restore(k, p, h);
                }
            }
        }
    }

    private void restore(int k, int p, double h) {
        double[] v = state.v();
        double[] w = state.w().values();
        double[] points = rows.points;
        double pull = 0.5 * h * Math.max(0, -points[p + FORCED]) * points[p + NORMAL_MASS];
        double by = points[p + RESTORED] * Math.max(0, points[p + NORMAL_SUM] - pull);
        points[p + NORMAL_SUM] += by;
        int a = State.BLOCK * rows.first(k);
        int b = State.BLOCK * rows.second(k);
        double nx = rows.normalX(k);
        double ny = rows.normalY(k);
        rows.push(v, w, a, b, p, nx * by, ny * by);
        double most = rows.normals[PAIR * k + FRICTION] * by; // what restitution gives rubs as what compression has taken
        double along = Math.max(-most, Math.min(most, -points[p + TANGENT_MASS] * rows.slip(k, p, v)));
        points[p + TANGENT_SUM] += along;
        rows.push(v, w, a, b, p, -ny * along, nx * along);
    }
}
