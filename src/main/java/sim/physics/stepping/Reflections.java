// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static sim.physics.stepping.ContactRows.BOUNCED;
import static sim.physics.stepping.ContactRows.FORCED;
import static sim.physics.stepping.ContactRows.INTS;
import static sim.physics.stepping.ContactRows.NORMAL;
import static sim.physics.stepping.ContactRows.NOW;
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
    private final ContactSolver contacts;
    private final Wave wave;

    /** By group: the fastest approach, 0 if it is not reflected. */
    private double[] fastest = {};

    /** By group: when something strikes first; by body: whether it has been thrown off. */
    private double[] times = {};

    private boolean[] areThrown = {};
    private final IntList thrown = new IntList();

    /** The points of these groups that have met, or that a wave may go through: row and first value of each. */
    private final IntList points = new IntList();

    private double h;

    Reflections(State state, ContactRows rows, Groups groups, FreeImpacts free, MetGroups facts, ContactSolver contacts) {
        this.state = state;
        this.rows = rows;
        this.groups = groups;
        this.free = free;
        this.facts = facts;
        this.contacts = contacts;
        wave = new Wave(state, rows, groups, contacts.struck());
    }

    /**
     * Finds the groups that are reflected; their points give nothing back otherwise.
     *
     * @param step the step
     * @param d the substep
     * @param before velocities after all that forces give in the substep
     */
    void find(double step, double d, Balance before) {
        h = step;
        if (fastest.length < groups.count) {
            fastest = new double[groups.slots.length];
            times = new double[fastest.length];
        }
        if (areThrown.length < state.size()) {
            areThrown = new boolean[groups.slots.length];
        }
        Arrays.fill(fastest, 0, groups.count, 0);
        Arrays.fill(times, 0, groups.count, d);
        for (int n = 0; n < groups.struck.size; n++) {
            int k = groups.struck.values[n];
            int group = groups.of(k, rows);
            for (int p = rows.begin(k); (free.has(k) || facts.mayBeSupported(group)) && p < rows.end(k); p += STRIDE) {
                if (rows.points[p + RESTORED] > Impacts.PLASTIC) {
                    fastest[group] = Math.max(fastest[group], -rows.points[p + OPENING]);
                    times[group] = Math.min(times[group], Impacts.time(rows.points, p, d));
                }
            }
        }
        for (int n = 0; n < groups.struck.size; n++) {
            int k = groups.struck.values[n];
            int group = groups.of(k, rows);
            boolean isApart = rows.pairs[INTS * k + ContactRows.UNLIKE] + rows.pairs[INTS * k + ContactRows.SUNK] > 0 && !free.has(k);
            boolean isBound = rows.isDriven(k) || facts.isLoaded(group) && isForced(k) || isApart;
            fastest[group] = isBound ? 0 : fastest[group];
        }
        for (int g = 0; g < groups.count; g++) {
            facts.areReflected[g] = fastest[g] > 0;
        }
        takeBack(before);
    }

    /** Takes back what the contacts have given in supported groups: what bears bodies there is found anew with what strikes. */
    private void takeBack(Balance before) {
        for (int k = 0; k < groups.bodies; k++) {
            int b = groups.blocks[k];
            if (isSupported(groups.slots[b / State.BLOCK])) {
                System.arraycopy(before.speeds(), b, state.v(), b, State.BLOCK);
            }
        }
        for (int n = 0; n < groups.struck.size; n++) {
            int k = groups.struck.values[n];
            if (!isSupported(groups.of(k, rows))) {
                continue;
            }
            for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
                boolean isClosed = rows.points[p + NORMAL] > 0 || rows.points[p + NOW] <= Impacts.closed(rows, k, h);
                rows.points[p + RESTORED] = isClosed ? Math.max(Impacts.PLASTIC, rows.points[p + RESTORED]) : rows.points[p + RESTORED];
                rows.points[p + NORMAL] = 0;
                rows.points[p + TANGENT] = 0;
            }
            rows.turns.forget(k, 1);
        }
    }

    private boolean isSupported(int group) {
        return facts.areReflected[group] && !free.isOne(group);
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

    /**
     * Chooses the points that approach: of those that touch, or will in the rest of the substep; and those that lie since then, or what presses them would be
     * solved in turns with them.
     */
    private boolean choose(Balance before, double[] a) {
        boolean any = false;
        wave.begin(h, fastest);
        for (int m = 0; m < points.size; m += 2) {
            int k = points.values[m];
            int p = points.values[m + 1];
            double approach = -rows.opening(k, p, state.v());
            if (approach > NEGLIGIBLE * fastest[groups.of(k, rows)] && meet(k, p, approach, before, a)) {
                wave.add(k, p, -rows.opening(k, p, state.v()));
                any = true;
            }
        }
        for (int m = 0; any && m < points.size; m += 2) {
            int k = points.values[m];
            int p = points.values[m + 1];
            if (wave.lies(k, p) && Math.abs(rows.opening(k, p, state.v())) <= NEGLIGIBLE * fastest[groups.of(k, rows)]) {
                wave.add(k, p, 0);
            }
        }
        return any;
    }

    private boolean meet(int k, int p, double approach, Balance before, double[] a) {
        return free.has(k) ? free.meet(k, p, h, approach, before, a) : rows.points[p + RESTORED] > 0;
    }

    /** What may bounce parts, or lies; what gives nothing back lies from now on. */
    private void end() {
        wave.end();
        for (int k = 0; k < thrown.size; k++) {
            areThrown[thrown.values[k]] = false;
        }
        thrown.clear();
        for (int m = 0; m < points.size; m += 2) {
            int k = points.values[m];
            int p = points.values[m + 1];
            rows.points[p + NORMAL] = rows.points[p + STEADY];
            rows.points[p + TANGENT] = rows.points[p + RUBBING];
            rows.points[p + STEADY] = 0;
            rows.points[p + RUBBING] = 0;
            boolean parts = rows.mayBounce(k) && (free.has(k) || rows.opening(k, p, state.v()) > NEGLIGIBLE * fastest[groups.of(k, rows)]);
            rows.points[p + RESTORED] = parts || rows.points[p + NORMAL] == 0 ? 0 : Impacts.PLASTIC;
            if (rows.mayBounce(k) && rows.points[p + NORMAL] > 0) {
                mark(rows.first(k));
                mark(rows.second(k));
            }
            rows.pairs[INTS * k + BOUNCED] |= parts && rows.points[p + NORMAL] > 0 ? 1 : 0;
        }
    }

    private void mark(int body) {
        areThrown[body] = true;
        thrown.add(body);
    }

    /**
     * Lets what has been thrown in supported groups go on from where it was struck: it has gone together with what it struck, and into it.
     *
     * @param before where the bodies were, and their velocities after all that forces give in the substep
     * @param a accelerations by forces, in the mean
     * @param d the substep
     */
    void move(Balance before, double[] a, double d) {
        for (int k = 0; k < groups.bodies; k++) {
            int b = groups.blocks[k];
            int group = groups.slots[b / State.BLOCK];
            for (int o = b; isSupported(group) && areThrown[b / State.BLOCK] && o < b + State.BLOCK; o++) {
                double time = Math.min(d, times[group]);
                state.x()[o] = before.places()[o] + time * (before.speeds()[o] - d * a[o]) + (d - time) * state.v()[o];
            }
        }
        for (int n = 0; n < groups.struck.size; n++) {
            if (isSupported(groups.of(groups.struck.values[n], rows))) {
                contacts.follow(groups.struck.values[n]);
            }
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
