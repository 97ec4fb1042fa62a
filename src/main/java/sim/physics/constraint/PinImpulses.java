// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
import java.util.List;
import sim.physics.internal.Freshness;
import sim.physics.internal.IntList;
import sim.physics.internal.OpenGroups;
import sim.physics.internal.Softness;
import sim.physics.motion.State;

/** The pins of a scene, (42)–(46), as time stepping solves them, all in one loop: two rows each, with equations as in {@link PinJoint}. */
final class PinImpulses implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int BLOCK = State.BLOCK;

    /** What is less of a determinant than this, relative to the diagonal, says that the rows are one. */
    private static final double SINGULAR = 1e-14;

    /** Values of a pin: arms in the bodies' frames, arms in the world, C, the inverse of J W Jᵀ, impulse, the sum of it and of what it turns in the step, largest C. */
    private static final int STRIDE = 23;

    private static final int ARM = 4;
    private static final int C = 8;
    private static final int INVERSE = 10;
    private static final int IMPULSE = 13;
    private static final int SUM = 15;
    private static final int MOST = 18;

    /** What the turning of the arms adds to the speed at which a pin opens, in the mean of a substep. */
    private static final int BEND = 19;

    /** The impulse with which the substep began. */
    private static final int STARTED = 21;

    /** What is kept of one whose velocity is settled: its place, its two bodies, {@link Freshness#FIXED} for what cannot move, and its group. */
    private static final int ENDS = 4;

    private final State state;
    private final ArmTurns turns;

    /** Per pin the blocks of its bodies; the second one is −1 for the world. */
    private int[] blocks = {};

    private double[] data = {};

    /** The pins whose velocities are settled. */
    private final IntList settling = new IntList();

    /** When each was solved last; see {@link Freshness}. */
    private long[] solved = {};

    /** Impulses of which the sums know. */
    private double[] noted = {};

    /** The substep. */
    private double h;

    /** How many of them, from the first one on, are of bodies that are awake. */
    private int awake;

    /** Which do not yield, as their trees are solved at once, or as they answer what their bodies are given by contacts. */
    private boolean[] isStiff = {};
    private boolean[] answers = {};

    /** How places were regained when pins were solved last. */
    Softness softness = Softness.RIGID;

    PinImpulses(State state) {
        this.state = state;
        turns = new ArmTurns(state);
    }

    /**
     * Takes pins; their impulses are zero.
     *
     * @param number how many of them, from the first one on, are to be solved
     */
    void gather(List<PinJoint> pins, int number) {
        awake = number;
        blocks = new int[2 * pins.size()];
        data = new double[STRIDE * pins.size()];
        noted = new double[2 * pins.size()];
        solved = new long[pins.size()];
        isStiff = new boolean[pins.size()];
        answers = new boolean[pins.size()];
        turns.clear();
        for (int k = 0; k < pins.size(); k++) {
            PinJoint pin = pins.get(k);
            int o = STRIDE * k;
            blocks[2 * k] = BLOCK * pin.getBodyA().index();
            blocks[2 * k + 1] = pin.getBodyB() == null ? -1 : BLOCK * pin.getBodyB().index();
            data[o] = pin.getAnchorAX();
            data[o + 1] = pin.getAnchorAY();
            data[o + 2] = pin.getAnchorBX();
            data[o + 3] = pin.getAnchorBY();
            data[o + MOST] = TieEquations.size(pin);
            System.arraycopy(data, o, data, o + ARM, ARM); // as they are where the body does not turn
            if (k < awake) {
                turns.need(blocks[2 * k], data[o], data[o + 1]);
                turns.need(blocks[2 * k + 1], data[o + 2], data[o + 3]);
            }
        }
        turns.forget();
    }

    /** The block of one of the two bodies of a pin, −1 for the world. */
    int block(int k, int end) {
        return blocks[2 * k + end];
    }

    /** Marks the bodies that are pinned. */
    void mark(boolean[] marks) {
        TieEquations.mark(marks, blocks, 0, awake);
    }

    /** Finds the bodies that are pinned to the world, or to what cannot move. */
    void findFastened(IntList found) {
        TieEquations.findFastened(blocks, awake, state.w().values(), found);
    }

    /** Joins the sets of movable bodies that are pinned to one another. */
    void join(int[] parent) {
        TieEquations.join(parent, blocks, awake, state.w().values());
    }

    /** Takes the impulses of marked bodies away, without a change of velocities. */
    void clear(boolean[] marks) {
        for (int k = 0; k < awake; k++) {
            if (TieEquations.isMarked(blocks, k, marks)) {
                data[STRIDE * k + IMPULSE] = 0;
                data[STRIDE * k + IMPULSE + 1] = 0;
            }
        }
    }

    /** Arms, equations, and impulses of a pin where it was evaluated last. */
    double[] record(int k) {
        return Arrays.copyOfRange(data, STRIDE * k + ARM, STRIDE * k + STRIDE);
    }

    void setRecord(int k, double[] record) {
        System.arraycopy(record, 0, data, STRIDE * k + ARM, STRIDE - ARM);
    }

    /** What a pin did in a step, in the mean. */
    Reaction reaction(int k, double time) {
        int o = STRIDE * k + SUM;
        return new Reaction(data[o] / time, data[o + 1] / time, data[o + 2] / time);
    }

    /** Begins a step, with substeps so many times longer than those of the last one: impulses grow with them. */
    void begin(double growth, double substep) {
        h = substep;
        turns.forget();
        for (int k = 0, o = 0; k < awake; k++, o += STRIDE) {
            data[o + IMPULSE] *= growth;
            data[o + IMPULSE + 1] *= growth;
            Arrays.fill(data, o + SUM, o + MOST, 0);
        }
        evaluate(0, null);
    }

    /** Adds the impulses of a substep to those of the step. */
    void add() {
        for (int o = 0; o < STRIDE * awake; o += STRIDE) {
            add(o, data[o + IMPULSE], data[o + IMPULSE + 1]);
        }
    }

    private void add(int o, double jx, double jy) {
        data[o + SUM] += jx;
        data[o + SUM + 1] += jy;
        data[o + SUM + 2] += data[o + ARM] * jy - data[o + ARM + 1] * jx;
    }

    /** Takes a part of the impulses of the substep back. */
    void limit(double[] shares) {
        for (int k = 0; k < awake; k++) {
            double share = TieEquations.share(blocks, k, shares);
            data[STRIDE * k + IMPULSE] *= share;
            data[STRIDE * k + IMPULSE + 1] *= share;
        }
    }

    /**
     * Evaluates all pins where the state vectors say that the bodies are.
     *
     * @param follow the part of the impulses with which the substep began that acts where the arms are now, and not where they were
     * @param marks by body, of those whose pins are meant; null for all
     */
    void evaluate(double follow, boolean[] marks) {
        turns.follow();
        double[] d = data;
        double[] x = state.x();
        double[] v = state.v();
        double[] w = state.w().values();
        for (int k = 0, o = 0; k < awake; k++, o += STRIDE) {
            if (marks != null && !TieEquations.isMarked(blocks, k, marks)) {
                continue;
            }
            int a = blocks[2 * k];
            int b = blocks[2 * k + 1];
            double spin = v[a + 2];
            double part = TieEquations.traced(spin * h);
            double jx = follow * d[o + STARTED];
            double jy = follow * d[o + STARTED + 1];
            v[a + 2] += part * w[a + 2] * arm(o, o + ARM, a, jx, jy);
            double bend = 0.5 * h * part * spin * spin;
            d[o + BEND] = -bend * d[o + ARM];
            d[o + BEND + 1] = -bend * d[o + ARM + 1];
            double ax = d[o + ARM];
            double ay = d[o + ARM + 1];
            double k00 = w[a] + w[a + 2] * ay * ay;
            double k01 = -w[a + 2] * ax * ay;
            double k11 = w[a] + w[a + 2] * ax * ax;
            double placeX = d[o + 2];
            double placeY = d[o + 3];
            if (b >= 0) {
                spin = v[b + 2];
                part = TieEquations.traced(spin * h);
                v[b + 2] -= part * w[b + 2] * arm(o + 2, o + ARM + 2, b, jx, jy);
                double bx = d[o + ARM + 2];
                double by = d[o + ARM + 3];
                k00 += w[b] + w[b + 2] * by * by;
                k01 -= w[b + 2] * bx * by;
                k11 += w[b] + w[b + 2] * bx * bx;
                bend = 0.5 * h * part * spin * spin;
                d[o + BEND] += bend * bx;
                d[o + BEND + 1] += bend * by;
                placeX = x[b] + bx;
                placeY = x[b + 1] + by;
            }
            double cx = x[a] + ax - placeX;
            double cy = x[a + 1] + ay - placeY;
            double square = cx * cx + cy * cy;
            part = square > d[o + MOST] * d[o + MOST] ? d[o + MOST] / Math.sqrt(square) : 1;
            d[o + C] = part * cx;
            d[o + C + 1] = part * cy;
            double det = k00 * k11 - k01 * k01;
            double per = det > SINGULAR * k00 * k11 ? 1 / det : 0;
            d[o + INVERSE] = k11 * per;
            d[o + INVERSE + 1] = -k01 * per;
            d[o + INVERSE + 2] = k00 * per;
        }
    }

    /** Turns an arm; what an impulse at its end turns the body more by than before. */
    private double arm(int from, int to, int block, double jx, double jy) {
        double px = data[from];
        double py = data[from + 1];
        if (px == 0 && py == 0) {
            return 0;
        }
        double cos = turns.values[2 * (block / BLOCK)];
        double sin = turns.values[2 * (block / BLOCK) + 1];
        double x = cos * px - sin * py;
        double y = sin * px + cos * py;
        double more = (x - data[to]) * jy - (y - data[to + 1]) * jx;
        data[to] = x;
        data[to + 1] = y;
        return more;
    }

    /**
     * Notes the impulses of now, which are in the sums; velocities are to be settled.
     *
     * @param groups group of each movable body
     * @param marks by body, of those whose pins will be
     */
    void keep(int[] groups, boolean[] marks) {
        double[] w = state.w().values();
        settling.clear();
        for (int k = 0; k < awake; k++) {
            System.arraycopy(data, STRIDE * k + IMPULSE, noted, 2 * k, 2);
            if (TieEquations.isMarked(blocks, k, marks)) {
                int first = TieEquations.end(blocks[2 * k], w);
                int second = TieEquations.end(blocks[2 * k + 1], w);
                settling.add(k);
                settling.add(first);
                settling.add(second);
                settling.add(groups[Math.max(first, second)]);
            }
        }
    }

    /** Adds what has been given since to the sums; of that the part that bodies keep, all of it for null. */
    void note(double[] shares) {
        for (int k = 0; k < awake; k++) {
            int o = STRIDE * k;
            double share = shares == null ? 1 : TieEquations.share(blocks, k, shares);
            add(o, share * (data[o + IMPULSE] - noted[2 * k]), share * (data[o + IMPULSE + 1] - noted[2 * k + 1]));
            System.arraycopy(data, o + IMPULSE, noted, 2 * k, 2);
        }
    }

    /** Puts the impulses of marked bodies back with which the substep began. */
    void putBack(boolean[] marks) {
        for (int k = 0; k < awake; k++) {
            if (TieEquations.isMarked(blocks, k, marks)) {
                System.arraycopy(data, STRIDE * k + STARTED, data, STRIDE * k + IMPULSE, 2);
            }
        }
    }

    /** Gives the bodies the impulses of the substep before. */
    void start() {
        double[] v = state.v();
        double[] w = state.w().values();
        for (int k = 0, o = 0; k < awake; k++, o += STRIDE) {
            data[o + STARTED] = data[o + IMPULSE];
            data[o + STARTED + 1] = data[o + IMPULSE + 1];
            push(v, w, k, o, data[o + IMPULSE], data[o + IMPULSE + 1]);
        }
    }

    private void push(double[] v, double[] w, int k, int o, double jx, double jy) {
        double[] d = data;
        int a = blocks[2 * k];
        int b = blocks[2 * k + 1];
        v[a] += w[a] * jx;
        v[a + 1] += w[a + 1] * jy;
        v[a + 2] += w[a + 2] * (d[o + ARM] * jy - d[o + ARM + 1] * jx);
        if (b >= 0) {
            v[b] -= w[b] * jx;
            v[b + 1] -= w[b + 1] * jy;
            v[b + 2] -= w[b + 2] * (d[o + ARM + 2] * jy - d[o + ARM + 3] * jx);
        }
    }

    /** Whether a body is the first one of a pin. */
    boolean isFirst(int k, int block) {
        return blocks[2 * k] == block;
    }

    /** {@return how many are solved} */
    int awake() {
        return awake;
    }

    /** Whether a pin gives way to what it bears. */
    boolean yields(int k) {
        return !isStiff[k] && !answers[k];
    }

    /** Says whether a pin answers what its bodies are given elsewhere, so that it is to bear all of it. */
    void setAnswering(int k, boolean answers) {
        this.answers[k] = answers;
    }

    /** A value of the inverse of J W Jᵀ: that of x and x, of x and y, or of y and y. */
    double inverse(int k, int value) {
        return data[STRIDE * k + INVERSE + value];
    }

    /** A pin's velocity along a lever, in the mean of a substep or as it is now. */
    double speed(int k, double x, double y, boolean bends) {
        int o = STRIDE * k;
        double[] d = data;
        double[] v = state.v();
        int a = blocks[2 * k];
        int b = blocks[2 * k + 1];
        double ux = v[a] - d[o + ARM + 1] * v[a + 2];
        double uy = v[a + 1] + d[o + ARM] * v[a + 2];
        if (b >= 0) {
            ux -= v[b] - d[o + ARM + 3] * v[b + 2];
            uy -= v[b + 1] + d[o + ARM + 2] * v[b + 2];
        }
        return bends ? x * (ux + d[o + BEND]) + y * (uy + d[o + BEND + 1]) : x * ux + y * uy;
    }

    /** A component of the arm of one of the two bodies of a pin. */
    double arm(int k, int end, int component) {
        return data[STRIDE * k + ARM + 2 * end + component];
    }

    /** By how much a pin is open. */
    double open(int k, int component) {
        return data[STRIDE * k + C + component];
    }

    /** The impulse of a pin on its first body. */
    double impulse(int k, int component) {
        return data[STRIDE * k + IMPULSE + component];
    }

    /** Takes note of an impulse that the bodies of a pin have got. */
    void book(int k, double jx, double jy) {
        data[STRIDE * k + IMPULSE] += jx;
        data[STRIDE * k + IMPULSE + 1] += jy;
    }

    /** Gives the bodies of a pin an impulse. */
    void give(int k, double jx, double jy) {
        int o = STRIDE * k;
        data[o + IMPULSE] += jx;
        data[o + IMPULSE + 1] += jy;
        push(state.v(), state.w().values(), k, o, jx, jy);
    }

    /** Solves all pins once. */
    void solve(Softness softness) {
        this.softness = softness;
        for (int k = 0; k < awake; k++) {
            solve(k, softness);
        }
    }

    private void solve(int k, Softness softness) {
        boolean yields = yields(k);
        solve(state.v(), state.w().values(), k, STRIDE * k, softness.rate(), softness.mass(yields), softness.impulse(yields));
    }

    /** Says whether a pin yields where its place is regained. */
    void setStiff(int k, boolean isStiff) {
        this.isStiff[k] = isStiff;
    }

    /** Solves velocities of groups that have not settled once more; those have not in which some were off that count for something, compared with those of the bodies. */
    void settle(OpenGroups turns, Freshness fresh) {
        softness = Softness.RIGID;
        for (int n = 0; n < settling.size; n += ENDS) {
            int[] pin = settling.values;
            int k = pin[n];
            if (turns.isOpen(pin[n + 3]) && fresh.isStale(solved[k], pin[n + 1], pin[n + 2])) {
                boolean wasOff = settle(k, STRIDE * k);
                solved[k] = fresh.solve(pin[n + 1], pin[n + 2], wasOff, true);
                turns.change(pin[n + 3], wasOff);
            }
        }
    }

    private boolean settle(int k, int o) {
        double[] v = state.v();
        double all = square(v, blocks[2 * k], o + ARM) + square(v, blocks[2 * k + 1], o + ARM + 2);
        double off = solve(v, state.w().values(), k, o, 0, Softness.EAGER.mass(), 0);
        return off > TieEquations.SETTLED * TieEquations.SETTLED * all;
    }

    /** The squares of the velocities that the one of an arm's end is made of. */
    private double square(double[] v, int block, int arm) {
        if (block < 0) {
            return 0;
        }
        double turning = v[block + 2] * v[block + 2] * (data[arm] * data[arm] + data[arm + 1] * data[arm + 1]);
        return v[block] * v[block] + v[block + 1] * v[block + 1] + turning;
    }

    /** Solves the pins of marked bodies once. */
    void solve(boolean[] marks, Softness softness) {
        this.softness = softness;
        for (int k = 0; k < awake; k++) {
            if (TieEquations.isMarked(blocks, k, marks)) {
                solve(k, softness);
            }
        }
    }

    /** Solves a pin, whose velocities wait in locals for the impulse that they ask for; the square of what that was asked for. */
    private double solve(double[] v, double[] w, int k, int o, double rate, double mass, double back) {
        double[] d = data;
        int a = blocks[2 * k];
        int b = blocks[2 * k + 1];
        double bend = rate > 0 ? 1 : 0; // only where a way is to be gone
        double ax = d[o + ARM], ay = d[o + ARM + 1];
        double vx = v[a], vy = v[a + 1], spin = v[a + 2];
        double ux = vx - ay * spin + rate * d[o + C] + bend * d[o + BEND];
        double uy = vy + ax * spin + rate * d[o + C + 1] + bend * d[o + BEND + 1];
        double oldX = d[o + IMPULSE], oldY = d[o + IMPULSE + 1];
        if (b < 0) {
            double jx = -mass * (d[o + INVERSE] * ux + d[o + INVERSE + 1] * uy) - back * oldX;
            double jy = -mass * (d[o + INVERSE + 1] * ux + d[o + INVERSE + 2] * uy) - back * oldY;
            d[o + IMPULSE] = oldX + jx;
            d[o + IMPULSE + 1] = oldY + jy;
            v[a] = vx + w[a] * jx;
            v[a + 1] = vy + w[a + 1] * jy;
            v[a + 2] = spin + w[a + 2] * (ax * jy - ay * jx);
            return ux * ux + uy * uy;
        }
        double bx = d[o + ARM + 2], by = d[o + ARM + 3];
        double otherX = v[b], otherY = v[b + 1], turn = v[b + 2];
        ux -= otherX - by * turn;
        uy -= otherY + bx * turn;
        double jx = -mass * (d[o + INVERSE] * ux + d[o + INVERSE + 1] * uy) - back * oldX;
        double jy = -mass * (d[o + INVERSE + 1] * ux + d[o + INVERSE + 2] * uy) - back * oldY;
        d[o + IMPULSE] = oldX + jx;
        d[o + IMPULSE + 1] = oldY + jy;
        v[a] = vx + w[a] * jx;
        v[a + 1] = vy + w[a + 1] * jy;
        v[a + 2] = spin + w[a + 2] * (ax * jy - ay * jx);
        v[b] = otherX - w[b] * jx;
        v[b + 1] = otherY - w[b + 1] * jy;
        v[b + 2] = turn - w[b + 2] * (bx * jy - by * jx);
        return ux * ux + uy * uy;
    }
}
