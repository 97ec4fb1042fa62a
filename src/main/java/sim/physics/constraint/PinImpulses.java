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
import sim.physics.internal.Trig;
import sim.physics.motion.State;

/** The pins of a scene, (42)–(46), as time stepping solves them, all in one loop: two rows each, with equations as in {@link PinJoint}. */
final class PinImpulses implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int BLOCK = State.BLOCK;

    /** Turn in a substep from which on cosines are found anew. */
    private static final double LARGE = 0.25;

    /** Terms of the series of sine and cosine: 1/n!. */
    private static final double S3 = 1.0 / 6;

    private static final double C4 = 1.0 / 24;
    private static final double S5 = 1.0 / 120;
    private static final double C6 = 1.0 / 720;
    private static final double S7 = 1.0 / 5_040;
    private static final double C8 = 1.0 / 40_320;
    private static final double S9 = 1.0 / 362_880;
    private static final double C10 = 1.0 / 3_628_800;
    private static final double S11 = 1.0 / 39_916_800;

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

    private final State state;

    /** Per pin the blocks of its bodies; the second one is −1 for the world. */
    private int[] blocks = {};

    private double[] data = {};

    /** When each was solved last; see {@link Freshness}. */
    private long[] solved = {};

    /** Impulses of which the sums know. */
    private double[] noted = {};

    /** The substep. */
    private double h;

    /** How many of them, from the first one on, are of bodies that are awake. */
    private int awake;

    /** Bodies with a pin beside their centre; the angles at which their cosines and sines hold. */
    private final IntList turning = new IntList();

    private double[] angles = {};

    /** [cos θ, sin θ] by body. */
    private double[] turns = {};

    PinImpulses(State state) {
        this.state = state;
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
        turning.clear();
        boolean[] turns = new boolean[state.size()];
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
                need(blocks[2 * k], data[o], data[o + 1], turns);
                need(blocks[2 * k + 1], data[o + 2], data[o + 3], turns);
            }
        }
        this.turns = new double[2 * state.size()];
        angles = new double[turning.size];
        Arrays.fill(angles, Double.NaN);
    }

    private void need(int block, double x, double y, boolean[] turns) {
        if (block >= 0 && (x != 0 || y != 0) && !turns[block / BLOCK]) {
            turns[block / BLOCK] = true;
            turning.add(block / BLOCK);
        }
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
        Arrays.fill(angles, Double.NaN);
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
        turn();
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
        double cos = turns[2 * (block / BLOCK)];
        double sin = turns[2 * (block / BLOCK) + 1];
        double x = cos * px - sin * py;
        double y = sin * px + cos * py;
        double more = (x - data[to]) * jy - (y - data[to + 1]) * jx;
        data[to] = x;
        data[to + 1] = y;
        return more;
    }

    /** Cosines and sines: turned on by what the angles have changed since the last substep, with series for small turns. */
    private void turn() {
        double[] x = state.x();
        for (int k = 0; k < turning.size; k++) {
            int body = turning.values[k];
            double theta = x[BLOCK * body + State.THETA];
            double by = theta - angles[k];
            angles[k] = theta;
            if (!(Math.abs(by) < LARGE)) {
                Trig.sinCos(theta, turns, 2 * body);
            } else if (by != 0) {
                double s = by * by;
                double sin = by * (1 - s * (S3 - s * (S5 - s * (S7 - s * (S9 - s * S11)))));
                double cos = 1 - s * (0.5 - s * (C4 - s * (C6 - s * (C8 - s * C10))));
                double c = turns[2 * body];
                double t = turns[2 * body + 1];
                turns[2 * body] = c * cos - t * sin;
                turns[2 * body + 1] = t * cos + c * sin;
            }
        }
    }

    /** Notes the impulses of now, which are in the sums. */
    void keep() {
        for (int k = 0; k < awake; k++) {
            System.arraycopy(data, STRIDE * k + IMPULSE, noted, 2 * k, 2);
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

    /**
     * Finds with what impulse a pin keeps its velocity where something turns its bodies.
     *
     * @param turnA what it turns the first one by
     * @param turnB and the second one
     * @param impulse takes the impulse, less its sign, from {@code at} on
     * @return how much that turns back
     */
    double couple(int k, double turnA, double turnB, double[] impulse, int at) {
        int o = STRIDE * k;
        double[] d = data;
        double ux = -turnA * d[o + ARM + 1];
        double uy = turnA * d[o + ARM];
        if (blocks[2 * k + 1] >= 0) {
            ux += turnB * d[o + ARM + 3];
            uy -= turnB * d[o + ARM + 2];
        }
        impulse[at] = d[o + INVERSE] * ux + d[o + INVERSE + 1] * uy;
        impulse[at + 1] = d[o + INVERSE + 1] * ux + d[o + INVERSE + 2] * uy;
        return impulse[at] * ux + impulse[at + 1] * uy;
    }

    /** A pin's velocity along a lever, in the mean of a substep or as it is now. */
    double speed(int k, double x, double y, boolean bends) {
        int o = STRIDE * k;
        double[] v = state.v();
        double ux = part(v, blocks[2 * k], o + ARM, 0) - part(v, blocks[2 * k + 1], o + ARM + 2, 0);
        double uy = part(v, blocks[2 * k], o + ARM, 1) - part(v, blocks[2 * k + 1], o + ARM + 2, 1);
        return x * (ux + (bends ? data[o + BEND] : 0)) + y * (uy + (bends ? data[o + BEND + 1] : 0));
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
        double[] v = state.v();
        double[] w = state.w().values();
        for (int k = 0, o = 0; k < awake; k++, o += STRIDE) {
            solve(v, w, k, o, softness.rate(), softness.mass(), softness.impulse());
        }
    }

    /** Solves velocities of groups that have not settled once more; those have not in which some were off that count for something, compared with those of the bodies. */
    void settle(int[] groups, OpenGroups turns, Freshness fresh, boolean[] marks) {
        double[] w = state.w().values();
        for (int k = 0; k < awake; k++) {
            if (TieEquations.isMarked(blocks, k, marks)) {
                int first = TieEquations.end(blocks[2 * k], w);
                int second = TieEquations.end(blocks[2 * k + 1], w);
                int group = groups[first >= 0 ? first : second];
                if (turns.isOpen(group) && fresh.isStale(solved[k], first, second)) {
                    boolean wasOff = settle(k, STRIDE * k);
                    solved[k] = fresh.solve(first, second, wasOff, true);
                    turns.change(group, wasOff);
                }
            }
        }
    }

    private boolean settle(int k, int o) {
        double[] v = state.v();
        double off = part(v, blocks[2 * k], o + ARM, 0) - part(v, blocks[2 * k + 1], o + ARM + 2, 0);
        double offY = part(v, blocks[2 * k], o + ARM, 1) - part(v, blocks[2 * k + 1], o + ARM + 2, 1);
        double all = square(v, blocks[2 * k], o + ARM) + square(v, blocks[2 * k + 1], o + ARM + 2);
        solve(v, state.w().values(), k, o, 0, Softness.EAGER.mass(), 0);
        return off * off + offY * offY > TieEquations.SETTLED * TieEquations.SETTLED * all;
    }

    /** A component of the velocity of the end of an arm. */
    private double part(double[] v, int block, int arm, int which) {
        if (block < 0) {
            return 0;
        }
        return which == 0 ? v[block] - data[arm + 1] * v[block + 2] : v[block + 1] + data[arm] * v[block + 2];
    }

    /** The squares of the velocities that it is made of. */
    private double square(double[] v, int block, int arm) {
        if (block < 0) {
            return 0;
        }
        double turning = v[block + 2] * v[block + 2] * (data[arm] * data[arm] + data[arm + 1] * data[arm + 1]);
        return v[block] * v[block] + v[block + 1] * v[block + 1] + turning;
    }

    /** Solves the pins of marked bodies once. */
    void solve(boolean[] marks, Softness softness) {
        for (int k = 0; k < awake; k++) {
            if (TieEquations.isMarked(blocks, k, marks)) {
                solve(state.v(), state.w().values(), k, STRIDE * k, softness.rate(), softness.mass(), softness.impulse());
            }
        }
    }

    private void solve(double[] v, double[] w, int k, int o, double rate, double mass, double back) {
        double[] d = data;
        int a = blocks[2 * k];
        int b = blocks[2 * k + 1];
        double bend = rate > 0 ? 1 : 0; // only where a way is to be gone
        double ux = v[a] - d[o + ARM + 1] * v[a + 2] + rate * d[o + C] + bend * d[o + BEND];
        double uy = v[a + 1] + d[o + ARM] * v[a + 2] + rate * d[o + C + 1] + bend * d[o + BEND + 1];
        if (b >= 0) {
            ux -= v[b] - d[o + ARM + 3] * v[b + 2];
            uy -= v[b + 1] + d[o + ARM + 2] * v[b + 2];
        }
        double jx = -mass * (d[o + INVERSE] * ux + d[o + INVERSE + 1] * uy) - back * d[o + IMPULSE];
        double jy = -mass * (d[o + INVERSE + 1] * ux + d[o + INVERSE + 2] * uy) - back * d[o + IMPULSE + 1];
        d[o + IMPULSE] += jx;
        d[o + IMPULSE + 1] += jy;
        push(v, w, k, o, jx, jy);
    }
}
