// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static sim.physics.stepping.ContactRows.AX;
import static sim.physics.stepping.ContactRows.AY;
import static sim.physics.stepping.ContactRows.BELT;
import static sim.physics.stepping.ContactRows.BEND;
import static sim.physics.stepping.ContactRows.BX;
import static sim.physics.stepping.ContactRows.BY;
import static sim.physics.stepping.ContactRows.FRICTION;
import static sim.physics.stepping.ContactRows.INTS;
import static sim.physics.stepping.ContactRows.LAST;
import static sim.physics.stepping.ContactRows.NORMAL;
import static sim.physics.stepping.ContactRows.NORMAL_MASS;
import static sim.physics.stepping.ContactRows.NORMAL_SUM;
import static sim.physics.stepping.ContactRows.NOW;
import static sim.physics.stepping.ContactRows.PAIR;
import static sim.physics.stepping.ContactRows.REGAIN;
import static sim.physics.stepping.ContactRows.RESTORED;
import static sim.physics.stepping.ContactRows.RUBBING;
import static sim.physics.stepping.ContactRows.STEADY;
import static sim.physics.stepping.ContactRows.STRIDE;
import static sim.physics.stepping.ContactRows.TANGENT;
import static sim.physics.stepping.ContactRows.TANGENT_MASS;
import static sim.physics.stepping.ContactRows.TANGENT_SUM;

import java.io.Serializable;
import sim.physics.constraint.Constraints;
import sim.physics.constraint.PinLevers;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;
import sim.physics.internal.Softness;
import sim.physics.motion.State;

/**
 * Solves the contacts of a step, but for those of {@link UnlikeRows}: per point an impulse along the normal that keeps what is left of the
 * gap from being passed within a substep, or regains what is missing of it, and one along the tangent within the cone of friction.
 */
final class ContactSolver implements Serializable {
    private static final long serialVersionUID = 1L;

    /** How many times larger an impulse is than the one of the substep before, if it is that of an impact, and none to begin the next substep with. */
    private static final double SUDDEN = 4;

    /** Part of the depth that may be regained in a substep which is rounding: what lies would give way as soon as its gap of 0 is a little less. */
    static final double ROUNDING = 1e-9;

    private final State state;
    private final ContactRows rows;
    private final PinnedPairs pinned;
    private final StruckPoints struck;
    private final ContactArms arms;
    private final UnlikeRows unlike;
    private final LargePiles piles;

    /** Whether large piles are solved from the last row to the first. */
    private transient boolean isBackwards;

    /** Those of the rows, which grow when a step begins. */
    private transient int[] pairs;

    private transient double[] normals;
    private transient double[] points;

    /** By point: the impulses along the normal and the tangent that will not be taken back; by pair, all that is told of them. */
    private transient double[] noted;

    private transient double[] told;

    ContactSolver(State state, ContactRows rows, PinLevers levers) {
        this.state = state;
        this.rows = rows;
        pinned = new PinnedPairs(state, rows, levers);
        struck = new StruckPoints(state, rows, pinned);
        arms = new ContactArms(state, rows);
        unlike = new UnlikeRows(state, rows);
        piles = new LargePiles(state, rows);
    }

    /**
     * Begins a step: all of its rows are there.
     *
     * @param step its length
     * @param h that of its substeps
     * @param a accelerations by forces
     * @param constraints those of the engine, or null
     */
    void begin(double step, double h, double[] a, Constraints constraints) {
        unlike.begin(step, h, constraints);
        piles.begin(a);
        isBackwards = false;
        pairs = rows.pairs;
        normals = rows.normals;
        points = rows.points;
        arms.begin();
    }

    /** Gives the bodies the impulses of the substep before. */
    void start(double[] sudden) {
        double[] v = state.v();
        double[] w = state.w().values();
        for (int k = 0; k < rows.count; k++) {
            int a = State.BLOCK * rows.first(k);
            int b = State.BLOCK * rows.second(k);
            double nx = normals[PAIR * k];
            double ny = normals[PAIR * k + 1];
            rows.turns.begin(k);
            for (int p = STRIDE * pairs[INTS * k + 3]; p < STRIDE * pairs[INTS * k + 4]; p += STRIDE) {
                double now = points[p + NORMAL];
                double last = points[p + LAST];
                points[p + LAST] = now;
                if (SUDDEN * last < now) {
                    points[p + NORMAL] = last;
                    points[p + TANGENT] *= last / now;
                    now = last;
                }
                double jx = nx * points[p + NORMAL] - ny * points[p + TANGENT];
                double jy = ny * points[p + NORMAL] + nx * points[p + TANGENT];
                rows.push(v, w, a, b, p, jx, jy);
                points[p + STEADY] = now;
                points[p + RUBBING] = points[p + TANGENT];
                if (last < now) {
                    halve(last / now, sudden, w, a, b, p, jx, jy);
                }
            }
        }
        unlike.find();
    }

    /** Lets only a part of what a point was given act by halves. */
    private void halve(double part, double[] sudden, double[] w, int a, int b, int p, double jx, double jy) {
        points[p + STEADY] *= part;
        points[p + RUBBING] *= part;
        rows.push(sudden, w, a, b, p, (1 - part) * jx, (1 - part) * jy);
    }

    /** Solves all points once; those of large piles before the move in the order of the solution before it, and after it in the opposite one. */
    void solve(Softness softness, boolean regains, double h) {
        double[] v = state.v();
        double[] w = state.w().values();
        boolean areSome = unlike.any();
        boolean areLarge = piles.any();
        if (areSome) {
            unlike.solve(null, softness.rate(), regains);
        }
        for (int k = 0; k < rows.count; k++) {
            if (!(areSome && unlike.has(k) || areLarge && piles.has(k))) {
                solve(v, w, k, softness, regains, h);
            }
        }
        if (areLarge) {
            solvePiles(softness, regains, h);
        }
    }

    /** Solves the points of large piles; and after the move some times more, there and back, of those in which that changes much. */
    private void solvePiles(Softness softness, boolean regains, double h) {
        isBackwards = regains == isBackwards;
        piles.open();
        boolean isBack = isBackwards;
        boolean goesOn = true;
        for (int turn = 1; goesOn; turn++) {
            for (int n = 0; n < piles.pairs.size; n++) {
                solvePile(isBack ? piles.pairs.size - 1 - n : n, softness, regains, h);
            }
            isBack = !isBack;
            goesOn = !regains && piles.goOn(turn, h);
        }
    }

    private void solvePile(int n, Softness softness, boolean regains, double h) {
        int k = piles.pairs.values[n];
        if (!piles.isOpen(n) || isOfSet(k)) {
            return;
        }
        double[] v = state.v();
        int a = State.BLOCK * rows.first(k);
        int b = State.BLOCK * rows.second(k);
        double vx = v[a], vy = v[a + 1];
        double ux = v[b], uy = v[b + 1];
        solve(v, state.w().values(), k, softness, regains, h);
        piles.change(n, Math.max(Math.abs(v[a] - vx) + Math.abs(v[a + 1] - vy), Math.abs(v[b] - ux) + Math.abs(v[b + 1] - uy)));
    }

    /** Solves the points of some pairs, which are all of marked bodies, once. */
    void solve(IntList some, boolean[] marks, Softness softness, boolean regains, double h) {
        boolean areSome = unlike.any();
        if (areSome) {
            unlike.solve(marks, softness.rate(), regains);
        }
        for (int n = 0; n < some.size; n++) {
            if (!areSome || !unlike.has(some.values[n])) {
                solve(state.v(), state.w().values(), some.values[n], softness, regains, h);
            }
        }
    }

    /** {@return what solves points for both of their impulses at once} */
    StruckPoints struck() {
        return struck;
    }

    /** {@return what is solved with a pin} */
    PinnedPairs pinned() {
        return pinned;
    }

    /** Whether a pair is solved with all that it hangs together with. */
    boolean isOfSet(int k) {
        return unlike.any() && unlike.has(k);
    }

    /** Solves the points of a pair: friction, and then what matters more, but what strikes or has one point only for both at once. */
    private void solve(double[] v, double[] w, int k, Softness softness, boolean regains, double h) {
        if (regains ? rows.comesToStrike(k) && isOpen(k) : rows.isStruck(k) || rows.pointCount(k) == 1) {
            struck.solve(k, h, regains);
        } else {
            solveOnce(v, w, k, softness, regains, h);
        }
    }

    /** Whether nothing of a pair is to be regained. */
    private boolean isOpen(int k) {
        boolean is = true;
        for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
            is &= points[p + NOW] >= 0;
        }
        return is;
    }

    /** Solves the points of a pair: friction, and then what matters more; but where nothing is regained any more it is bounded by what presses in the end. */
    private void solveOnce(double[] v, double[] w, int k, Softness softness, boolean regains, double h) {
        if (pinned.has(k)) {
            pinned.solve(k, softness, regains, h);
        } else if (regains) {
            rub(v, w, k, 0.5 * h);
            press(v, w, k, softness, true, h);
        } else {
            press(v, w, k, softness, false, h);
            rub(v, w, k, 0);
        }
    }

    /**
     * Solves for the friction of the points of a pair. Velocities wait in locals, as each impulse needs what the one before has made of them.
     *
     * @param ahead time to when what sticks is not to slip: what turns goes round its centre until then, as joints and motors do
     */
    private void rub(double[] v, double[] w, int k, double ahead) {
        double[] points = this.points;
        int a = State.BLOCK * rows.first(k);
        int b = State.BLOCK * rows.second(k);
        int end = STRIDE * pairs[INTS * k + 4];
        double nx = normals[PAIR * k], ny = normals[PAIR * k + 1];
        double friction = normals[PAIR * k + FRICTION];
        double vx = v[a], vy = v[a + 1], spin = v[a + 2];
        double ux = v[b], uy = v[b + 1], turn = v[b + 2];
        for (int p = STRIDE * pairs[INTS * k + 3]; p < end; p += STRIDE) {
            double most = friction * points[p + NORMAL];
            double old = points[p + TANGENT];
            if (most == 0 && old == 0) {
                continue;
            }
            double slipX = ux - points[p + BY] * turn - vx + points[p + AY] * spin;
            double slipY = uy + points[p + BX] * turn - vy - points[p + AX] * spin;
            double round = spin * spin * (nx * points[p + AY] - ny * points[p + AX]) - turn * turn * (nx * points[p + BY] - ny * points[p + BX]);
            double now = old - points[p + TANGENT_MASS] * (nx * slipY - ny * slipX + normals[PAIR * k + BELT] + ahead * round);
            now = now > most ? most : now < -most ? -most : now;
            points[p + TANGENT] = now;
            double jx = -ny * (now - old), jy = nx * (now - old);
            vx -= w[a] * jx;
            vy -= w[a] * jy;
            spin -= w[a + 2] * (points[p + AX] * jy - points[p + AY] * jx);
            ux += w[b] * jx;
            uy += w[b] * jy;
            turn += w[b + 2] * (points[p + BX] * jy - points[p + BY] * jx);
        }
        v[a] = vx;
        v[a + 1] = vy;
        v[a + 2] = spin;
        v[b] = ux;
        v[b + 1] = uy;
        v[b + 2] = turn;
    }

    /** Solves for what presses the points of a pair. */
    private void press(double[] v, double[] w, int k, Softness softness, boolean regains, double h) {
        double[] points = this.points;
        int a = State.BLOCK * rows.first(k);
        int b = State.BLOCK * rows.second(k);
        int end = STRIDE * pairs[INTS * k + 4];
        double nx = normals[PAIR * k], ny = normals[PAIR * k + 1];
        double regain = -normals[PAIR * k + REGAIN];
        double vx = v[a], vy = v[a + 1], spin = v[a + 2];
        double ux = v[b], uy = v[b + 1], turn = v[b + 2];
        for (int p = STRIDE * pairs[INTS * k + 3]; p < end; p += STRIDE) {
            double gap = points[p + NOW];
            double bend = regains ? 0.5 * h * points[p + BEND] : 0;
            boolean isDeep = gap < ROUNDING * h * regain && gap + h * bend < 0 && regains;
            double old = points[p + NORMAL];
            double apartX = ux - points[p + BY] * turn - vx + points[p + AY] * spin;
            double apartY = uy + points[p + BX] * turn - vy - points[p + AX] * spin;
            double mass = isDeep ? softness.mass() * points[p + NORMAL_MASS] : points[p + NORMAL_MASS];
            double kept = isDeep ? softness.impulse() * old : 0;
            double most = isDeep ? regain - kept / mass : 0; // beyond what gives way: else what is small under its load would sink for ever
            double aim = bend + (isDeep ? Math.max(softness.rate() * gap, most) : regains || gap >= 0 ? gap / h : 0);
            double now = old - mass * (nx * apartX + ny * apartY + aim) - kept;
            now = now > 0 ? now : 0;
            if (now == 0 && old == 0) {
                continue; // it is open, and stays so
            }
            points[p + NORMAL] = now;
            if (now == 0 && !regains && rows.mayBounce(k)) {
                points[p + RESTORED] = Flights.TAKEN_BACK;
            }
            double jx = nx * (now - old), jy = ny * (now - old);
            vx -= w[a] * jx;
            vy -= w[a] * jy;
            spin -= w[a + 2] * (points[p + AX] * jy - points[p + AY] * jx);
            ux += w[b] * jx;
            uy += w[b] * jy;
            turn += w[b + 2] * (points[p + BX] * jy - points[p + BY] * jx);
        }
        v[a] = vx;
        v[a + 1] = vy;
        v[a + 2] = spin;
        v[b] = ux;
        v[b + 1] = uy;
        v[b + 2] = turn;
    }

    private boolean isMarked(int k, boolean[] marks) {
        return marks[rows.first(k)] || marks[rows.second(k)];
    }

    /** Takes the impulses of marked bodies away, without a change of their velocities. */
    void clear(boolean[] marks) {
        for (int k = 0; k < rows.count; k++) {
            for (int m = pairs[INTS * k + 3]; isMarked(k, marks) && m < pairs[INTS * k + 4]; m++) {
                points[STRIDE * m + NORMAL] = 0;
                points[STRIDE * m + TANGENT] = 0;
                points[STRIDE * m + STEADY] = 0;
                points[STRIDE * m + RUBBING] = 0;
            }
            rows.turns.forget(k, isMarked(k, marks) ? 1 : 0);
        }
    }

    /** Takes a part of the impulses of the substep back, of whose velocities that was taken: what each body keeps. */
    void limit(double[] shares) {
        for (int k = 0; k < rows.count; k++) {
            double share = share(k, shares);
            for (int m = pairs[INTS * k + 3]; share < 1 && m < pairs[INTS * k + 4]; m++) {
                points[STRIDE * m + NORMAL] *= share;
                points[STRIDE * m + TANGENT] *= share;
            }
            if (share < 1) {
                rows.turns.forget(k, 1 - share);
            }
        }
    }

    private double share(int k, double[] shares) {
        return Math.min(shares[rows.first(k)], shares[rows.second(k)]);
    }

    /** Notes what will not be taken back of the impulses of the substep. */
    void note() {
        if (noted == null || noted.length < 2 * rows.used) {
            noted = new double[2 * Growth.length(noted == null ? 0 : noted.length / 2, rows.used)];
        }
        for (int m = 0; m < rows.used; m++) {
            noted[2 * m] = points[STRIDE * m + NORMAL];
            noted[2 * m + 1] = points[STRIDE * m + TANGENT];
        }
        told = told == null || told.length < 2 * rows.count ? new double[2 * Growth.length(0, rows.count)] : told;
        for (int k = 0; k < rows.count; k++) {
            told[2 * k] = told(k, 0);
            told[2 * k + 1] = told(k, 1);
        }
    }

    /** What a pair is told to have given in the step and in this substep, in x or y. */
    private double told(int k, int axis) {
        double along = normals[PAIR * k + axis];
        double across = axis == 0 ? -normals[PAIR * k + 1] : normals[PAIR * k];
        double normal = rows.sum(k, NORMAL) + rows.impulse(k);
        return normal * along + (rows.sum(k, TANGENT) + rows.rubbed(k)) * across + rows.turned[ContactRows.TURNED * k + axis];
    }

    /** Takes a part back of what has been given since. */
    void limitNoted(double[] shares) {
        for (int k = 0; k < rows.count; k++) {
            double share = share(k, shares);
            if (share < 1) {
                double x = between(told[2 * k], told(k, 0), share);
                double y = between(told[2 * k + 1], told(k, 1), share);
                for (int m = pairs[INTS * k + 3]; m < pairs[INTS * k + 4]; m++) {
                    points[STRIDE * m + NORMAL] = between(noted[2 * m], points[STRIDE * m + NORMAL], share);
                    points[STRIDE * m + TANGENT] = between(noted[2 * m + 1], points[STRIDE * m + TANGENT], share);
                }
                rows.turned[ContactRows.TURNED * k] += x - told(k, 0);
                rows.turned[ContactRows.TURNED * k + 1] += y - told(k, 1);
            }
        }
    }

    private static double between(double before, double now, double share) {
        return before + share * (now - before);
    }

    /** Solves the points of marked bodies once. */
    void solve(boolean[] marks, Softness softness, boolean regains, double h) {
        for (int k = 0; k < rows.count; k++) {
            if (isMarked(k, marks)) {
                solve(state.v(), state.w().values(), k, softness, regains, h);
            }
        }
    }

    /** Finds the gaps of marked bodies where they are now. */
    void measure(boolean[] marks) {
        for (int k = 0; k < rows.count; k++) {
            if (isMarked(k, marks)) {
                rows.turns.measure(k);
            }
        }
    }

    /** Lets points of marked bodies go along when these have moved. */
    void follow(boolean[] marks) {
        for (int k = 0; k < rows.count; k++) {
            if (isMarked(k, marks)) {
                follow(k);
            }
        }
    }

    /** Lets points go along when the bodies have moved. */
    void follow() {
        double[] w = state.w().values();
        for (int k = 0; k < rows.count; k++) {
            rows.turns.measure(k);
            arms.follow(w, k);
        }
    }

    /** Lets the points of a pair go along. */
    void follow(int k) {
        rows.turns.measure(k);
        arms.follow(state.w().values(), k);
    }

    /** Ends a substep of discs: what does not press in the end has done nothing, though its normal has turned. */
    void straighten() {
        arms.straighten();
    }

    /** Adds the impulses of a substep to those of the step. */
    void add() {
        for (int p = 0; p < STRIDE * rows.used; p += STRIDE) {
            points[p + NORMAL_SUM] += points[p + NORMAL];
            points[p + TANGENT_SUM] += points[p + TANGENT];
        }
    }
}
