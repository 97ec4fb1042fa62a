// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.List;
import sim.physics.internal.DisjointSets;
import sim.physics.internal.Freshness;
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.State;

/** The equations of constraints other than pins, in flat arrays: where they are off, how speeds and impulses pass through them. */
final class TieEquations implements Serializable {
    private static final long serialVersionUID = 1L;

    static final int ROWS = Equations.ROWS;
    private static final int BLOCK = State.BLOCK;

    /** What a constraint is: joints keep places, and wheels, as motors do, velocities alone. */
    enum Kind {
        JOINT,
        WHEEL,
        MOTOR,
        STOP;

        /** Whether it takes as much as it needs, either way. */
        boolean ties() {
            return this == JOINT || this == WHEEL;
        }

        boolean hasPlace() {
            return this == JOINT || this == STOP;
        }
    }

    /** Values of J of a constraint: for its first body, and for its second one. */
    static final int J = 2 * BLOCK * ROWS;

    /** Speed of a row at which it is right, relative to the speeds of the bodies. */
    static final double SETTLED = 1e-8;

    private final State state;
    private int awake;
    private final Equations one = new Equations();
    Constraint[] ties = {};
    Kind[] kinds = {};
    int[] rows = {};
    private double[] sizes = {};

    /** The turn that a constraint is about, whose J does not change; null for others. */
    private GearJoint[] gears = {};

    /** Per constraint: the blocks of its bodies, −1 for the world. */
    int[] blocks = {};

    double[] j = {};
    double[] c = {};

    /** J where the substep began. */
    private double[] before = {};

    /** What the turning of the bodies alone adds to a row's speed in half a substep. */
    double[] bend = {};
    /** The inverse of J W Jᵀ, 3 × 3. */
    double[] inverse = {};
    /** What was given to the first body of each since somebody took note: impulse, and turning impulse about its centre. */
    double[] given = {};
    /** The impulses with which the substep began. */
    private double[] started = {};

    TieEquations(State state) {
        this.state = state;
    }

    /** The size of the smaller body that a constraint moves. */
    static double size(Constraint tie) {
        double a = size(tie.getBodyA());
        double b = tie.getBodyB() == null ? Double.POSITIVE_INFINITY : size(tie.getBodyB());
        return Math.min(a, b);
    }

    private static double size(Body body) {
        return body.isImmobile() ? Double.POSITIVE_INFINITY : body.getShape().boundingRadius();
    }

    /** What a row is off, as far as it is regained: by the size of a body, or a radian. Joints that jam would else throw bodies about. */
    double limited(int k, int row, double off) {
        double most = size(k, row);
        return Math.max(-most, Math.min(most, off));
    }

    /**
     * Takes constraints.
     *
     * @param awakeOnes how many of them, from the first one on, are of bodies that are awake: no others are looked at
     */
    void gather(List<Constraint> all, int awakeOnes) {
        int n = all.size();
        awake = awakeOnes;
        ties = all.toArray(new Constraint[0]);
        kinds = new Kind[n];
        rows = new int[n];
        sizes = new double[n];
        gears = new GearJoint[n];
        blocks = new int[2 * n];
        for (int k = 0; k < n; k++) {
            Constraint tie = ties[k];
            Constraint coordinate = tie instanceof Switched s ? s.coordinate() : tie;
            kinds[k] = kind(tie);
            rows[k] = tie.getRows();
            sizes[k] = size(tie);
            gears[k] = coordinate instanceof GearJoint gear ? gear : null;
            blocks[2 * k] = BLOCK * tie.getBodyA().index();
            blocks[2 * k + 1] = tie.getBodyB() == null ? -1 : BLOCK * tie.getBodyB().index();
        }
        j = new double[J * n];
        before = new double[J * n];
        c = new double[ROWS * n];
        bend = new double[ROWS * n];
        inverse = new double[ROWS * ROWS * n];
        given = new double[BLOCK * n];
        started = new double[ROWS * n];
    }

    /** Whether a constraint is about a turn, whose J does not change. */
    boolean isTurn(int k) {
        return gears[k] != null;
    }

    private static Kind kind(Constraint tie) {
        if (tie instanceof Switched) {
            return tie instanceof Motor ? Kind.MOTOR : Kind.STOP;
        }
        return tie instanceof Wheel ? Kind.WHEEL : Kind.JOINT;
    }

    /** Marks the bodies of motors that are set, and of constraints of authors. */
    void markDriven(double[] limits, boolean[] marks) {
        for (int k = 0; k < awake; k++) {
            if (isSet(k, limits[k]) || !Joint.isOwn(ties[k])) {
                mark(k, marks);
            }
        }
    }

    /** Finds the bodies of sleeping motors that were set, of fixed ones, too. */
    void findSet(double[] limits, IntList found) {
        found.clear();
        for (int k = awake; k < ties.length; k++) {
            if (isSet(k, limits[k])) {
                found.add(ties[k].getBodyA().index());
                found.add(ties[k].getBodyB() == null ? ties[k].getBodyA().index() : ties[k].getBodyB().index());
            }
        }
    }

    /** Whether a constraint is a motor that wants to run, or is of another strength than in its last step. */
    private boolean isSet(int k, double limit) {
        return ties[k] instanceof Motor motor && (motor.getSpeed() != 0 || motor.getLimit() != limit);
    }

    /** How many there are of bodies that are awake. */
    int count() {
        return awake;
    }

    /** Adds what motors may have given bodies with impulses, by group: twice impulse times speed. */
    void give(double[] impulse, int[] group, double[] given) {
        for (int k = 0; k < awake; k++) {
            if (kinds[k] == Kind.MOTOR) {
                given[group[movable(k)]] += 2 * Math.max(0, impulse[ROWS * k] * ((Motor) ties[k]).getSpeed());
            }
        }
    }

    /** Adds the impulses of motors, by group; of those that turn as if they acted at the size of their bodies. */
    void press(double[] impulse, int[] group, double[] pressed) {
        for (int k = 0; k < awake; k++) {
            if (kinds[k] == Kind.MOTOR) {
                pressed[group[movable(k)]] += Math.abs(impulse[ROWS * k]) / (ties[k].isAngle(0) ? sizes[k] : 1);
            }
        }
    }

    /** The first body of a constraint that can move: what is fixed has no group. */
    int movable(int k) {
        boolean isFirst = state.w().values()[blocks[2 * k]] > 0;
        return blocks[isFirst ? 2 * k : 2 * k + 1] / BLOCK;
    }

    /** The body of one of two blocks of a constraint; {@link Freshness#FIXED} if it cannot move. */
    int end(int block) {
        return end(blocks[block], state.w().values());
    }

    /** The same of a block. */
    static int end(int block, double[] w) {
        return block >= 0 && w[block] > 0 ? block / BLOCK : Freshness.FIXED;
    }

    /** Marks the bodies that are tied. */
    void mark(boolean[] marks) {
        mark(marks, blocks, 0, awake);
    }

    /** Marks the bodies of the constraints from one to another. */
    static void mark(boolean[] marks, int[] blocks, int from, int to) {
        for (int k = 2 * from; k < 2 * to; k++) {
            if (blocks[k] >= 0) {
                marks[blocks[k] / BLOCK] = true;
            }
        }
    }

    /** Marks the bodies of a constraint. */
    void mark(int k, boolean[] marks) {
        mark(marks, blocks, k, k + 1);
    }

    /** Finds the bodies that are tied to the world, to what cannot move, or by what hangs in the world itself; and what to, −1 for the world. */
    void findFastened(IntList found) {
        findFastened(blocks, awake, state.w().values(), found);
        for (int k = 0; k < 2 * awake; k++) {
            if (blocks[k] >= 0 && !Joint.isInternal(ties[k / 2])) {
                found.add(blocks[k] / BLOCK);
                found.add(-1);
            }
        }
    }

    /** Finds the bodies of pins, or other constraints that have these blocks, which tie them to the world or to what cannot move. */
    static void findFastened(int[] blocks, int count, double[] w, IntList found) {
        for (int k = 0; k < 2 * count; k += 2) {
            int a = blocks[k];
            int b = blocks[k + 1];
            if (b < 0 || w[a] == 0 || w[b] == 0) {
                boolean isFirst = b < 0 || w[b] == 0;
                found.add((isFirst ? a : b) / BLOCK);
                found.add(b < 0 ? -1 : (isFirst ? b : a) / BLOCK);
            }
        }
    }

    /** Whether one of the bodies of a constraint is marked. */
    boolean isMarked(int k, boolean[] marks) {
        return isMarked(blocks, k, marks);
    }

    /** The same of constraints whose bodies have these blocks. */
    static boolean isMarked(int[] blocks, int k, boolean[] marks) {
        return marks[blocks[2 * k] / BLOCK] || blocks[2 * k + 1] >= 0 && marks[blocks[2 * k + 1] / BLOCK];
    }

    /** Joins the sets of movable bodies that are tied to one another. */
    static void join(int[] parent, int[] blocks, int count, double[] w) {
        for (int k = 0; k < 2 * count; k += 2) {
            int a = blocks[k];
            int b = blocks[k + 1];
            if (b >= 0 && w[a] > 0 && w[b] > 0) {
                DisjointSets.join(parent, a / BLOCK, b / BLOCK);
            }
        }
    }

    /**
     * Evaluates all of them where the state vectors say that the bodies are.
     *
     * @param isFirst whether the step begins: within it what does not change is kept
     * @param marks by body, of those whose constraints are meant; null for all
     */
    void evaluate(boolean isFirst, double h, boolean[] marks) {
        double[] x = state.x();
        double[] w = state.w().values();
        for (int k = 0; k < awake; k++) {
            if (marks != null && !isMarked(k, marks)) {
                continue;
            }
            if (gears[k] != null && !isFirst) {
                int b = blocks[2 * k + 1];
                double off = gears[k].open(x[blocks[2 * k] + State.THETA], b < 0 ? 0 : x[b + State.THETA]);
                c[ROWS * k] = kinds[k] == Kind.JOINT ? limited(k, 0, off) : off;
                continue;
            }
            one.clear(rows[k]);
            (ties[k] instanceof Switched s ? s.coordinate() : ties[k]).evaluate(one);
            one.check(ties[k], rows[k]);
            for (int r = 0; r < rows[k]; r++) {
                c[ROWS * k + r] = kinds[k] == Kind.JOINT ? limited(k, r, one.c[r]) : one.c[r];
                bend[ROWS * k + r] = one.rate[r] == 0 ? 0 : traced(k, h) * limited(k, r, 0.5 * h * h * one.rate[r]) / h;
            }
            for (int r = 0; r < rows[k]; r++) {
                copy(r, one.jA, J * k);
                copy(r, one.jB, J * k + BLOCK * ROWS);
            }
            RowInverse.invert(rows[k], w, blocks[2 * k], blocks[2 * k + 1], j, J * k, inverse, ROWS * ROWS * k);
        }
    }

    private void copy(int row, double[] from, int to) {
        int o = BLOCK * row;
        j[to + o] = from[o];
        j[to + o + 1] = from[o + 1];
        j[to + o + 2] = from[o + 2];
    }

    /** Gives the bodies the impulse with which a row begins the substep. */
    void start(int k, int row, double by) {
        started[ROWS * k + row] = by;
        push(k, row, by);
    }

    /**
     * Evaluates all of them where the bodies have moved to in a substep; half of what they began with follows. It is taken off its old directions after that: without
     * it, what bears much has velocities that nothing has, and would bend its ways by their squares.
     */
    void follow(double h) {
        for (int k = 0; k < awake; k++) {
            double part = 0.5 * traced(k, h);
            for (int r = 0; r < rows[k]; r++) {
                started[ROWS * k + r] *= part;
            }
        }
        System.arraycopy(j, 0, before, 0, J * awake);
        evaluate(false, h, null);
        turn(-1);
        turn(1);
    }

    /** Exchanges J of before and of now, and gives the bodies so many times what they began with along it. */
    private void turn(int times) {
        double[] other = j;
        j = before;
        before = other;
        for (int k = 0; k < awake; k++) {
            for (int r = 0; gears[k] == null && r < rows[k]; r++) { // of gears, J does not change
                push(k, r, times * started[ROWS * k + r]);
            }
        }
    }

    /**
     * How far what a body turns by in a substep can be followed: all but all of it up to a quarter of a radian, next to nothing from a radian on,
     * where levers of before and after have nothing to do with one another.
     */
    static double traced(double turn) {
        double square = 4 * turn * turn;
        return 1 / (1 + square * square);
    }

    private double traced(int k, double h) {
        double[] v = state.v();
        double first = traced(v[blocks[2 * k] + State.THETA] * h);
        return blocks[2 * k + 1] < 0 ? first : Math.min(first, traced(v[blocks[2 * k + 1] + State.THETA] * h));
    }

    /** The part that the bodies of a constraint keep of what they got: the world keeps all. */
    static double share(int[] blocks, int k, double[] shares) {
        double second = blocks[2 * k + 1] < 0 ? 1 : shares[blocks[2 * k + 1] / BLOCK];
        return Math.min(shares[blocks[2 * k] / BLOCK], second);
    }

    /** The speed of a row. */
    double speed(int k, int row, double[] v) {
        int o = J * k + BLOCK * row;
        int a = blocks[2 * k];
        int b = blocks[2 * k + 1];
        if (gears[k] != null) {
            return j[o + 2] * v[a + 2] + (b < 0 ? 0 : j[o + BLOCK * ROWS + 2] * v[b + 2]);
        }
        double speed = j[o] * v[a] + j[o + 1] * v[a + 1] + j[o + 2] * v[a + 2];
        if (b >= 0) {
            o += BLOCK * ROWS;
            speed += j[o] * v[b] + j[o + 1] * v[b + 1] + j[o + 2] * v[b + 2];
        }
        return speed;
    }

    /** Whether the speeds of the rows count for something, compared with those of the bodies; those of turns count at the size of a body. */
    boolean areOff(int k) {
        double[] v = state.v();
        double off = 0;
        double all = 0;
        for (int r = 0; r < rows[k]; r++) {
            double arm = ties[k].isAngle(r) ? sizes[k] : 1;
            double speed = arm * speed(k, r, v);
            off += speed * speed;
            for (int m = 0; m < BLOCK; m++) {
                double first = arm * j[J * k + BLOCK * r + m] * v[blocks[2 * k] + m];
                double second = blocks[2 * k + 1] < 0 ? 0 : arm * j[J * k + BLOCK * (ROWS + r) + m] * v[blocks[2 * k + 1] + m];
                all += first * first + second * second;
            }
        }
        return off > SETTLED * SETTLED * all;
    }

    /** Gives the bodies an impulse along a row. */
    void push(int k, int row, double by) {
        int o = J * k + BLOCK * row;
        push(state.v(), k, row, by);
        if (gears[k] != null) {
            given[BLOCK * k + 2] += j[o + 2] * by;
            return;
        }
        given[BLOCK * k] += j[o] * by;
        given[BLOCK * k + 1] += j[o + 1] * by;
        given[BLOCK * k + 2] += j[o + 2] * by;
    }

    /** The size that counts for a row. */
    private double size(int k, int row) {
        return ties[k].isAngle(row) ? 1 : sizes[k];
    }

    /** Changes velocities as an impulse along a row does. */
    void push(double[] v, int k, int row, double by) {
        double[] w = state.w().values();
        int o = J * k + BLOCK * row;
        int a = blocks[2 * k];
        int b = blocks[2 * k + 1];
        if (gears[k] != null) {
            v[a + 2] += w[a + 2] * j[o + 2] * by;
            if (b >= 0) {
                v[b + 2] += w[b + 2] * j[o + BLOCK * ROWS + 2] * by;
            }
            return;
        }
        v[a] += w[a] * j[o] * by;
        v[a + 1] += w[a + 1] * j[o + 1] * by;
        v[a + 2] += w[a + 2] * j[o + 2] * by;
        if (b >= 0) {
            o += BLOCK * ROWS;
            v[b] += w[b] * j[o] * by;
            v[b + 1] += w[b + 1] * j[o + 1] * by;
            v[b + 2] += w[b + 2] * j[o + 2] * by;
        }
    }
}
