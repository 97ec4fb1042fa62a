// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static sim.physics.stepping.ContactRows.BEFORE;
import static sim.physics.stepping.ContactRows.NORMAL;
import static sim.physics.stepping.ContactRows.NORMAL_MASS;
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
 * Groups whose bodies nothing but bounces and even forces have part in within a substep: each body flies to where it meets another one, and on from there
 * with what the bounce gave it. What bounded its way meanwhile is taken back: it has turned the body, too, by up to a half of what the impact gives, and
 * the arms of the impact with it.
 */
final class FreeImpacts implements Serializable {
    private static final long serialVersionUID = 1L;

    /** How often the poses in which two bodies meet are looked for. */
    private static final int LOOKS = 2;

    private final State state;
    private final ContactRows rows;
    private final Groups groups;
    private final Grounds grounds;
    private final ContactSolver contacts;
    private final Flights flights;

    /** By group: whether it is one. */
    private boolean[] areFree = {};

    /** By body: when it has its impact, infinite if it has none; and the velocities before it. */
    private double[] meets = {};

    private double[] velocities = {};

    /** By body: whether it is taken back to its impact: on a plane that rubs, only what others have pressed; and these bodies. */
    private boolean[] areTakenBack = {};

    private final IntList takenBack = new IntList();

    private final IntList goneOn = new IntList();

    private double h;

    FreeImpacts(State state, ContactRows rows, Groups groups, Grounds grounds, ContactSolver contacts, Flights flights) {
        this.state = state;
        this.rows = rows;
        this.groups = groups;
        this.grounds = grounds;
        this.contacts = contacts;
        this.flights = flights;
    }

    /** Whether a group is one. */
    boolean isOne(int group) {
        return areFree[group];
    }

    /** Whether a pair of a group in which something has met is of one. */
    boolean has(int row) {
        return areFree[groups.of(row, rows)];
    }

    /** {@return velocities before the impacts, of the bodies of such groups} */
    double[] velocities() {
        return velocities;
    }

    /**
     * Finds these groups, and takes back what their bodies were given.
     *
     * @param before where the bodies were, and their velocities after all that forces give in the substep
     * @param a accelerations by forces, in the mean
     * @param step the step
     * @param substep the substep
     */
    void begin(Balance before, double[] a, double step, double substep) {
        h = substep;
        find(step);
        mark();
        grounds.note();
        meet(before, a, step);
        grounds.putBack();
        for (int k = 0; k < groups.bodies; k++) {
            if (isOfOne(groups.blocks[k])) {
                takeBack(groups.blocks[k], before, a);
            }
        }
        for (int n = 0; n < groups.struck.size; n++) {
            int row = groups.struck.values[n];
            for (int p = rows.begin(row); has(row) && p < rows.end(row); p += STRIDE) {
                rows.points[p + OPENING] = rows.opening(row, p, state.v());
            }
        }
    }

    /** Gives a body the velocity that it has when it meets another one. */
    private void takeBack(int b, Balance before, double[] a) {
        for (int o = b; o < b + State.BLOCK; o++) {
            velocities[o] = before.speeds()[o] - (h - time(b)) * (a[o] - lift(b, o, a));
            state.v()[o] = velocities[o];
        }
    }

    /** Marks the bodies that are taken back. */
    private void mark() {
        for (int k = 0; k < takenBack.size; k++) {
            areTakenBack[takenBack.values[k]] = false;
        }
        takenBack.clear();
        for (int k = 0; !groups.areRubbed() && k < groups.bodies; k++) {
            int body = groups.blocks[k] / State.BLOCK;
            if (areFree[groups.slots[body]]) {
                mark(body);
            }
        }
        for (int n = 0; groups.areRubbed() && n < groups.struck.size; n++) {
            int row = groups.struck.values[n];
            boolean isPushed = false;
            for (int p = rows.begin(row); p < rows.end(row); p += STRIDE) {
                isPushed |= rows.points[p + RESTORED] > 0 || rows.points[p + NORMAL] > 0;
            }
            if (isPushed && has(row)) {
                mark(rows.first(row));
                mark(rows.second(row));
            }
        }
    }

    private void mark(int body) {
        if (!areTakenBack[body]) {
            areTakenBack[body] = true;
            takenBack.add(body);
        }
    }

    /** {@return by body of the groups: whether it has been taken back} */
    boolean[] areTakenBack() {
        return areTakenBack;
    }

    private void find(double step) {
        if (areFree.length < groups.count) {
            areFree = new boolean[groups.slots.length];
        }
        if (velocities.length < state.v().length) {
            meets = new double[state.v().length / State.BLOCK];
            velocities = new double[state.v().length];
            areTakenBack = new boolean[meets.length];
        }
        Arrays.fill(areFree, 0, groups.count, false);
        for (int n = 0; n < groups.struck.size; n++) {
            int row = groups.struck.values[n];
            for (int p = rows.begin(row); p < rows.end(row); p += STRIDE) {
                areFree[groups.of(row, rows)] |= rows.points[p + RESTORED] > 0;
            }
        }
        for (int n = 0; n < groups.struck.size; n++) {
            int row = groups.struck.values[n];
            for (int p = rows.begin(row); p < rows.end(row); p += STRIDE) {
                double closed = Impacts.closed(rows, row, step);
                boolean regains = rows.points[p + BEFORE] < -closed && h * rows.points[p + OPENING] > -closed;
                boolean isDeep = regains && rows.normals[ContactRows.PAIR * row + ContactRows.BOUNCE] < 1; // what is elastic does not stay there
                boolean comes = rows.isNew(row) || rows.mayBounce(row) && flights.comes(row, p, step);
                boolean isBounce = Impacts.touches(rows, row, p, step) && comes && !isDeep;
                areFree[groups.of(row, rows)] &= isBounce || rows.points[p + NORMAL] == 0;
            }
        }
        groups.clearTied(areFree);
    }

    /**
     * Finds when bodies have their impacts, and the normals and points of these there; and takes back what was given. What has part in one impact has it
     * at one time, the first: else it would act at two points, and give angular momentum.
     */
    private void meet(Balance before, double[] a, double step) {
        flights.count();
        for (int k = 0; k < groups.bodies; k++) {
            meets[groups.blocks[k] / State.BLOCK] = Double.POSITIVE_INFINITY;
        }
        for (int n = 0; n < groups.struck.size; n++) {
            int row = groups.struck.values[n];
            if (has(row)) {
                meet(row, before, a);
            }
        }
        boolean goesOn = true;
        for (int turn = 0; goesOn && turn < rows.count; turn++) {
            goesOn = false;
            for (int n = 0; n < groups.struck.size; n++) {
                int row = groups.struck.values[n];
                goesOn |= has(row) && links(row, step) && share(rows.first(row), rows.second(row));
            }
        }
        for (int n = 0; n < groups.struck.size; n++) {
            int row = groups.struck.values[n];
            if (has(row) && links(row, step)) {
                double first = Math.min(meets(rows.first(row)), meets(rows.second(row)));
                double time = Math.min(h, first);
                if (first <= h) {
                    mark(rows.first(row));
                    mark(rows.second(row));
                }
                fly(rows.first(row), time, before, a);
                fly(rows.second(row), time, before, a);
                follow(row);
            }
        }
    }

    /** Whether a pair may have part in an impact: it strikes, or a wave may go through it. */
    private boolean links(int row, double step) {
        boolean yes = false;
        for (int p = rows.begin(row); p < rows.end(row); p += STRIDE) {
            yes |= Impacts.touches(rows, row, p, step);
        }
        return yes;
    }

    /** Lets two bodies have the time of the first of them; whether it was another. */
    private boolean share(int first, int second) {
        if (!groups.isMovable(first) || !groups.isMovable(second) || meets[first] == meets[second]) {
            return false;
        }
        meets[first] = Math.min(meets[first], meets[second]);
        meets[second] = meets[first];
        return true;
    }

    private double meets(int body) {
        return groups.isMovable(body) ? meets[body] : Double.POSITIVE_INFINITY;
    }

    private void meet(int row, Balance before, double[] a) {
        double time = Double.POSITIVE_INFINITY;
        for (int p = rows.begin(row); p < rows.end(row); p += STRIDE) {
            time = rows.points[p + RESTORED] > 0 ? Math.min(time, Impacts.time(rows.points, p, h)) : time;
            rows.points[p + NORMAL] = 0;
            rows.points[p + TANGENT] = 0;
        }
        rows.turns.forget(row, 1);
        for (int look = 0; time <= h && look < LOOKS; look++) { // of what forces alone bring together within the time, too
            fly(rows.first(row), time, before, a);
            fly(rows.second(row), time, before, a);
            follow(row);
            time = refine(row, time, before.speeds());
        }
        if (time < h) { // else a wave has driven them together
            meets[rows.first(row)] = Math.min(meets[rows.first(row)], time);
            meets[rows.second(row)] = Math.min(meets[rows.second(row)], time);
        } else if (flights.mayMiss(row)) {
            miss(row);
        }
    }

    /** Two that nothing else drives together have not met: ways are bent. */
    private void miss(int row) {
        for (int p = rows.begin(row); p < rows.end(row); p += STRIDE) {
            rows.points[p + RESTORED] = 0;
        }
    }

    /** When two bodies meet, by what is left of their gap: ways are bent. */
    private double refine(int row, double time, double[] v) {
        double left = Double.POSITIVE_INFINITY;
        for (int p = rows.begin(row); p < rows.end(row); p += STRIDE) {
            double opening = rows.opening(row, p, v);
            boolean meets = rows.points[p + RESTORED] > 0 && opening < 0 && !(rows.points[p + BEFORE] < 0);
            left = meets ? Math.min(left, -rows.points[p + NOW] / opening) : left;
        }
        return left < h ? Math.max(0, Math.min(h, time + left)) : time;
    }

    /** Puts a body where it is at a time of the substep if it has met nobody. */
    private void fly(int body, double time, Balance before, double[] a) {
        int b = State.BLOCK * body;
        for (int o = b; (groups.isMovable(body) ? areTakenBack[body] : grounds.has(body)) && o < b + State.BLOCK; o++) {
            state.x()[o] = before.places()[o] + time * (before.speeds()[o] - (h - 0.5 * time) * a[o]);
        }
    }

    /** Lets the points of a pair of which nothing is steady go along. */
    private void follow(int row) {
        for (int p = rows.begin(row); p < rows.end(row); p += STRIDE) {
            rows.points[p + STEADY] = 0;
            rows.points[p + RUBBING] = 0;
        }
        contacts.follow(row);
    }

    /**
     * Whether two that approach have an impact now: they touch, or a wave drives them together before the substep is over. They have it when it has come
     * to them, both at one time.
     *
     * @param step the step
     * @param approach the speed at which they come nearer now
     */
    boolean meet(int row, int p, double step, double approach, Balance before, double[] a) {
        int first = rows.first(row);
        int second = rows.second(row);
        double time = Math.min(h, Math.min(meets(first), meets(second)));
        boolean isMet = isAt(first, time) && isAt(second, time);
        boolean touches = Impacts.touches(rows, row, p, step);
        if (!touches && !rows.turns.areFollowed(row) || !touches && rows.points[p + BEFORE] + time * rows.points[p + OPENING] > (h - time) * approach) {
            return false;
        }
        if (!isMet && !(waits(first, time) && waits(second, time))) {
            return false;
        }
        if (!isMet || !hasMet(row)) {
            hold(first, time, before, a);
            hold(second, time, before, a);
            follow(row);
        }
        boolean closes = touches || rows.points[p + NOW] <= (h - time) * approach;
        rows.points[p + RESTORED] = closes ? Math.max(Impacts.PLASTIC, rows.points[p + RESTORED]) : rows.points[p + RESTORED];
        return closes;
    }

    /** Whether a pair has part in an impact already. */
    private boolean hasMet(int row) {
        boolean yes = false;
        for (int p = rows.begin(row); p < rows.end(row); p += STRIDE) {
            yes |= rows.points[p + RESTORED] > 0;
        }
        return yes;
    }

    private boolean isAt(int body, double time) {
        return !groups.isMovable(body) || meets[body] == time;
    }

    /** Whether a body has not had an impact at another time. */
    private boolean waits(int body, double time) {
        return isAt(body, time) || meets[body] == Double.POSITIVE_INFINITY;
    }

    /** Lets a body have its impact at a time, if it has none yet. */
    private void hold(int body, double time, Balance before, double[] a) {
        if (!isAt(body, time)) {
            meets[body] = time;
            mark(body);
            takeBack(State.BLOCK * body, before, a);
        }
        fly(body, Math.min(h, meets(body)), before, a);
    }

    /** Lets the bodies go on from where they have met. */
    void end(Balance before, double[] a) {
        double[] v = state.v();
        for (int k = 0; k < groups.bodies; k++) {
            int b = groups.blocks[k];
            if (!isOfOne(b)) {
                continue;
            }
            fly(b / State.BLOCK, time(b), before, a);
            double left = h - time(b);
            for (int o = b; o < b + State.BLOCK; o++) {
                double lift = lift(b, o, a);
                state.x()[o] += left * (v[o] - left * lift + 0.5 * left * a[o]);
                v[o] += left * (a[o] - lift);
            }
        }
        for (int n = 0; n < groups.struck.size; n++) {
            int row = groups.struck.values[n];
            if (has(row)) {
                follow(row);
                bear(row);
            }
        }
    }

    /** {@return the bodies that forces move which have gone on from where they have met something} */
    IntList goneOn() {
        goneOn.clear();
        for (int k = 0; k < groups.bodies; k++) {
            if (isOfOne(groups.blocks[k]) && time(groups.blocks[k]) < h && !groups.areSteered[k]) {
                goneOn.add(groups.blocks[k] / State.BLOCK);
            }
        }
        return goneOn;
    }

    /**
     * Lets bodies part as they do under the forces of the way on which they have gone on, where these have changed: with those of the way that they did not
     * go, springs would throw them ever faster. The impulses of the contacts do that: what forces give is that of the same times for all bodies, or momentum
     * would not be kept.
     *
     * @param mean accelerations by forces that have acted in the substep
     * @param then those of where bodies have met
     * @param now those of where they are now
     */
    void reload(double[] mean, double[] then, double[] now) {
        for (int n = 0; n < groups.struck.size; n++) {
            int row = groups.struck.values[n];
            for (int p = rows.begin(row); has(row) && p < rows.end(row); p += STRIDE) {
                if (rows.points[p + NORMAL] > 0 && rows.points[p + RESTORED] != Impacts.PLASTIC) {
                    double left = Math.max(0, h - Math.min(meets(rows.first(row)), meets(rows.second(row))));
                    double more = 0.5 * (rows.opening(row, p, then) + rows.opening(row, p, now)) - rows.opening(row, p, mean);
                    double by = Math.max(-rows.points[p + NORMAL], left * more * rows.points[p + NORMAL_MASS]);
                    rows.points[p + NORMAL] += by;
                    rows.give(row, p, state.v(), by, 0);
                }
            }
        }
    }

    /** Bears what has struck and does not bounce from then on: it would fall deeper by what forces move it in the rest of the time. */
    private void bear(int row) {
        for (int p = rows.begin(row); p < rows.end(row); p += STRIDE) {
            double mass = rows.points[p + NORMAL_MASS];
            double fallen = Math.min(0, rows.points[p + BEFORE]) - rows.points[p + NOW];
            double opening = rows.opening(row, p, state.v());
            if (rows.points[p + RESTORED] == Impacts.PLASTIC && fallen > 0 && opening < 0) {
                rows.points[p + NORMAL] -= mass * opening;
                rows.give(row, p, state.v(), -mass * opening, 0);
                rows.give(row, p, state.x(), mass * fallen, 0);
                follow(row);
            }
        }
    }

    /** How a ground accelerates that nothing can move: its velocity remains that of the end of the substep, and those of its bodies are seen from it. */
    private double lift(int block, int o, double[] a) {
        int group = groups.slots[block / State.BLOCK];
        return groups.areHeld[group] ? a[groups.anchors[group] + o - block] : 0;
    }

    private boolean isOfOne(int block) {
        return areTakenBack[block / State.BLOCK];
    }

    private double time(int block) {
        return Math.min(h, meets[block / State.BLOCK]);
    }
}
