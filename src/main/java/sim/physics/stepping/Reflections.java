// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static sim.physics.stepping.ContactRows.BOUNCED;
import static sim.physics.stepping.ContactRows.FORCED;
import static sim.physics.stepping.ContactRows.INTS;
import static sim.physics.stepping.ContactRows.NORMAL;
import static sim.physics.stepping.ContactRows.OPENING;
import static sim.physics.stepping.ContactRows.RESTORED;
import static sim.physics.stepping.ContactRows.RUBBING;
import static sim.physics.stepping.ContactRows.STEADY;
import static sim.physics.stepping.ContactRows.STRIDE;
import static sim.physics.stepping.ContactRows.TANGENT;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;
import sim.physics.motion.State;

/**
 * Bounces in groups that nothing ties or supports, as in gases, cradles and racks: generalized reflections (Smith, Kaufman, Vouga,
 * Tamstorf and Grinspun, <i>Reflections on simultaneous impact</i>, 2012). What the contacts took in the substep is taken back; then of all points
 * those that approach are mirrored together, those that approach after that, and so on, until none does: a wave goes through a row of
 * bodies at once, symmetric scenes stay so, and elastic bodies keep their energy.
 */
final class Reflections implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Rounds of a step at most. */
    private static final int ROUNDS = 128;

    /** Approach that counts as none, relative to the fastest one of the step. */
    private static final double NEGLIGIBLE = 1e-9;

    private final State state;
    private final ContactRows rows;
    private final Groups groups;
    private final FreeImpacts free;
    private final MetGroups facts;
    private final Wave wave;

    /** By group: the fastest approach, 0 if it is not reflected. */
    private double[] fastest = {};

    /** The points of these groups that have met, or that a wave may go through: row and first value of each. */
    private final IntList points = new IntList();

    private double h;

    Reflections(State state, ContactRows rows, Groups groups, FreeImpacts free, MetGroups facts) {
        this.state = state;
        this.rows = rows;
        this.groups = groups;
        this.free = free;
        this.facts = facts;
        wave = new Wave(state, rows, groups);
    }

    /**
     * Finds the groups that are reflected; their points give nothing back otherwise.
     *
     * @param step the step
     */
    void find(double step) {
        h = step;
        if (fastest.length < groups.count) {
            fastest = new double[groups.slots.length];
        }
        Arrays.fill(fastest, 0, groups.count, 0);
        for (int n = 0; n < groups.struck.size; n++) {
            int k = groups.struck.values[n];
            for (int p = rows.begin(k); free.has(k) && p < rows.end(k); p += STRIDE) {
                if (rows.points[p + RESTORED] > Impacts.PLASTIC) {
                    int group = groups.of(k, rows);
                    fastest[group] = Math.max(fastest[group], -rows.points[p + OPENING]);
                }
            }
        }
        for (int n = 0; n < groups.struck.size; n++) {
            int k = groups.struck.values[n];
            int group = groups.of(k, rows);
            boolean isBound = rows.isDriven(k) || facts.isLoaded(group) && isForced(k);
            fastest[group] = isBound ? 0 : fastest[group];
        }
        for (int g = 0; g < groups.count; g++) {
            facts.areReflected[g] = fastest[g] > 0;
        }
    }

    private boolean isForced(int k) {
        boolean is = false;
        for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
            is |= rows.points[p + FORCED] != 0;
        }
        return is;
    }

    /**
     * Reflects: the impulses of the bodies have been taken back.
     *
     * @param before where the bodies were, and their velocities after all that forces give in the substep
     * @param a accelerations by forces, in the mean
     */
    void reflect(Balance before, double[] a) {
        begin();
        boolean goesOn = points.size > 0;
        for (int round = 0; goesOn && round < ROUNDS; round++) {
            goesOn = choose(before, a);
            wave.reflect();
        }
        end();
    }

    private void begin() {
        points.clear();
        for (int n = 0; n < groups.struck.size; n++) {
            int k = groups.struck.values[n];
            for (int p = rows.begin(k); facts.areReflected[groups.of(k, rows)] && p < rows.end(k); p += STRIDE) {
                if (rows.points[p + RESTORED] > 0 || rows.mayStrike(k)) {
                    points.add(k);
                    points.add(p);
                    rows.points[p + STEADY] = 0;
                    rows.points[p + RUBBING] = 0;
                }
            }
        }
    }

    /** Chooses the points that approach: of those that touch, or will in the rest of the substep. */
    private boolean choose(Balance before, double[] a) {
        boolean any = false;
        wave.begin(h);
        for (int m = 0; m < points.size; m += 2) {
            int k = points.values[m];
            int p = points.values[m + 1];
            double approach = -rows.opening(k, p, state.v());
            if (approach > NEGLIGIBLE * fastest[groups.of(k, rows)] && free.meet(k, p, h, approach, before, a)) {
                wave.add(k, p, -rows.opening(k, p, state.v()));
                any = true;
            }
        }
        return any;
    }

    /** What may bounce parts, or lies; what gives nothing back lies from now on. */
    private void end() {
        wave.end();
        for (int m = 0; m < points.size; m += 2) {
            int k = points.values[m];
            int p = points.values[m + 1];
            rows.points[p + NORMAL] = rows.points[p + STEADY];
            rows.points[p + TANGENT] = rows.points[p + RUBBING];
            rows.points[p + STEADY] = 0;
            rows.points[p + RUBBING] = 0;
            rows.points[p + RESTORED] = rows.mayBounce(k) || rows.points[p + NORMAL] == 0 ? 0 : Impacts.PLASTIC;
            rows.pairs[INTS * k + BOUNCED] |= rows.mayBounce(k) && rows.points[p + NORMAL] > 0 ? 1 : 0;
        }
    }

    /** Ends the bounces of a substep: what a wave gave is no guess for the next one. */
    void endBounces() {
        for (int m = 1; m < points.size; m += 2) {
            Impacts.end(rows.points, points.values[m]);
            rows.points[points.values[m] + RESTORED] = 0;
        }
        points.clear();
    }
}
