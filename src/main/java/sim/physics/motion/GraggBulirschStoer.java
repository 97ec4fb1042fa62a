// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.internal.IntList;

/**
 * Gragg's modified midpoint method, extrapolated to a step of zero as by Bulirsch and Stoer. It chooses its order and its step by
 * their cost. This is the code ODEX of Hairer, Nørsett and Wanner, <i>Solving Ordinary Differential Equations I</i>, 2nd edition,
 * II.9. Use it for 10 to 13 correct digits.
 *
 * <p>A row of the scheme makes n = 2, 4, 6 … small steps y₍ₗ₊₁₎ = y₍ₗ₋₁₎ + 2 (h/n) f(yₗ). Its error has even powers of h/n only,
 * so each additional row raises the order by two: the difference of rows n and m is divided by (n² / m² − 1).
 */
public final class GraggBulirschStoer extends AdaptiveIntegrator {
    private static final long serialVersionUID = 1L;

    private static final int MOST_ROWS = 9;
    private static final int LEAST_ROWS = 3;

    /** Where the middle of the first row is kept, behind the rows and what they come from. */
    private static final int MIDDLE = 2 * MOST_ROWS + 2;

    private static final int ROWS_AT_FIRST = 5;

    private static final double SAFETY = 0.8;

    /**
     * The step times the rate of the fastest change, over the number of rows: from here on the rows' errors are not what
     * they are where they are small, but what stability lets grow. Smooth motions stay below a third of it.
     */
    private static final double STABLE = 1;

    /**
     * Four, six and eight rows damp vibrations up to 3.3 of their frequency times the step; three, five and seven let them grow,
     * if less and less.
     */
    private static final double REACH = 3;

    private static final int LEAST_IF_HELD = 4;

    private static final double AIM = 0.3;

    /** What errors are, over the estimate, in the mean of our scenes. */
    private static final double CAUTION = 0.5;

    /** The same in the angles of a tree of pins. */
    private static final double TIED_CAUTION = 0.75;

    private static final double LEAST_STABLE = 0.3;
    private static final double LEAST = 0.02;
    private static final double MOST = 5;

    /** A row less is taken when it costs this much less, and a row more when its own cost fell this much. */
    private static final double LESS = 0.8;

    private static final double HALF = 0.5;

    private static final double MORE = 0.9;

    /** Nodes of dense output by rows, and its error, in units of that of a step. */
    private static final int FEW_ROWS = 4;

    private static final int FEW_NODES = 3;
    private static final int MORE_ROWS = 6;
    private static final int MORE_NODES = 5;
    private static final int MOST_NODES = 7;
    private static final double OUTPUT = 2;

    private static final double MOST_OF_STOP = 0.9;

    /** How much longer than the engine's a step must be for that to be cheaper. */
    private static final double WORTHWHILE = 6;

    /**
     * Creates the method.
     *
     * @param tolerance error of a position that one step may make, length
     * @throws IllegalArgumentException if the tolerance is not a finite number greater than 0
     */
    public GraggBulirschStoer(double tolerance) {
        super(tolerance);
    }

    @Override
    boolean takesTiedCoordinates(IntList bodies, Path path) {
        return true;
    }

    @Override
    double reach(IntList bodies, Path path) {
        return REACH;
    }

    @Override
    double mostOfStop() {
        return MOST_OF_STOP;
    }

    @Override
    double worthwhile() {
        return WORTHWHILE;
    }

    @Override
    boolean hasFixedOrder() {
        return false;
    }

    @Override
    boolean makeDense(
            EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path, DenseOutput out) {
        int rows = path.stages.rows()[bodies.values[0]];
        int inner = rows <= FEW_ROWS ? FEW_NODES : rows <= MORE_ROWS ? MORE_NODES : MOST_NODES;
        return Bootstrap.make(t, h, path.stages, out, inner, OUTPUT);
    }

    @Override
    boolean attempt(EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path) {
        Stages s = path.stages;
        s.ensureWork(MIDDLE + 3);
        s.ensureRows(bodies.values[0], MOST_ROWS);
        int aim = s.rows()[bodies.values[0]] == 0 ? ROWS_AT_FIRST : s.rows()[bodies.values[0]];
        aim = s.held == 1 ? aim : Math.max(aim, LEAST_IF_HELD);
        Ground rough = rough(equations, state, bodies, s);
        for (int row = 0; ; row++) {
            s.factor = LEAST;
            if (!midpoint(t, h, s, row, rough, bodies)) {
                return false;
            }
            extrapolate(s, row);
            int count = row + 1;
            double fast = row == 0 ? 0 : h * h * s.rate;
            double error = row == 0 ? Double.POSITIVE_INFINITY : error(s);
            propose(s, count, error);
            if (fast > STABLE * aim) {
                s.factor = Math.max(LEAST_STABLE, SAFETY * STABLE * aim / fast);
                return false;
            }
            boolean isDamped = s.held == 1 || count >= LEAST_IF_HELD && (count & 1) == 0;
            if (count >= aim - 1 && error <= 1 && isDamped) {
                int next = next(s, count, Math.min(count, aim));
                s.rows()[bodies.values[0]] = s.isCut ? aim : next; // those of what was left of a step say little of the next one
                finish(s);
                return !turnsRound(rough, bodies, s);
            }
            if (count > aim || count >= aim - 1 && !(error <= reach(count, aim + 1))) {
                s.rows()[bodies.values[0]] = next(s, count, Math.min(count, aim));
                s.factor = error < Double.POSITIVE_INFINITY ? Math.min(s.factor, SAFETY) : LEAST;
                return false;
            }
        }
    }

    /**
     * The plane, if there is friction on it that may turn round within the step, which all rows would pass over alike: what they extrapolate
     * to is a motion that goes on, or any other one. Velocities from which it turns are kept.
     */
    private static Ground rough(EquationsOfMotion equations, State state, IntList bodies, Stages s) {
        if (!(equations instanceof Motion motion && motion.ground().isSoft(bodies))) {
            return null;
        }
        s.ensureBefore(State.BLOCK * bodies.size);
        s.coordinates.put(s.x0, s.v0);
        for (int k = 0; k < bodies.size; k++) {
            System.arraycopy(state.v(), State.BLOCK * bodies.values[k], s.before, State.BLOCK * k, State.BLOCK);
        }
        return motion.ground();
    }

    /** Whether friction of the plane has turned round on the way to a place, which is put into the state vectors; a part of the step is tried then. */
    private static boolean turnsRound(Ground rough, IntList bodies, Stages s) {
        if (rough == null) {
            return false;
        }
        s.coordinates.put(s.x, s.v);
        boolean is = rough.turnsRound(bodies, s.before);
        s.factor = is ? HALF : s.factor;
        return is;
    }

    /** By how much the rows that are still to come may lower the error. */
    private static double reach(int count, int last) {
        double product = 1;
        for (int k = count + 1; k <= last; k++) {
            product *= (double) k * k;
        }
        return product;
    }

    private static double cost(int count) {
        return count * count + 1;
    }

    /** How much longer the step may be with so many rows, and what a unit of time then costs. */
    private static void propose(Stages s, int count, double error) {
        double longer = error == 0 ? MOST : SAFETY * StrictMath.pow(AIM / error, 1.0 / (2 * count - 1));
        s.longer[count] = error < Double.POSITIVE_INFINITY ? Math.max(LEAST, Math.min(MOST, longer)) : LEAST;
        s.cost[count] = cost(count) / Math.min(s.longer[count], s.most);
    }

    /** How many rows to aim at in the next step, which sets its length too. */
    private static int next(Stages s, int count, int about) {
        int best = Math.max(about, LEAST_ROWS);
        if (best <= count && best > LEAST_ROWS && s.cost[best - 1] < LESS * s.cost[best]) {
            best--;
        } else if (best <= count && s.cost[count] < MORE * s.cost[count - 1] && s.longer[count] < s.most) {
            best = Math.min(count + 1, MOST_ROWS - 1);
        }
        s.factor = best > count ? s.longer[count] * cost(best) / cost(count) : s.longer[best];
        return best;
    }

    /**
     * A row: 2 (row + 1) small steps; its end, from the start of the step, is put behind those of the other rows. False if one
     * of them leads nowhere, so that no force must be asked for there, or friction of the plane turns round.
     */
    private static boolean midpoint(double t, double h, Stages s, int row, Ground rough, IntList bodies) {
        int n = 2 * (row + 1);
        double small = h / n;
        double[] y = s.work;
        int x = 2 * row * s.size;
        int v = x + s.size;
        int oldX = 2 * MOST_ROWS * s.size;
        int oldV = oldX + s.size;
        for (int m = 0; m < s.size; m++) {
            y[oldX + m] = 0;
            y[oldV + m] = 0;
            y[x + m] = small * s.v0[m];
            y[v + m] = small * s.a0[m];
        }
        for (int l = 1; l < n; l++) {
            if (!place(s, x, v)) {
                return false;
            }
            if (turnsRound(rough, bodies, s)) {
                return false;
            }
            s.coordinates.accelerate(s.x, s.v, t + l * small, s.a);
            if (row == 0) {
                keepMiddle(s, x, v);
            } else if (row == 1 && l == 2) {
                s.rate = rate(s, x, v, h);
            }
            for (int m = 0; m < s.size; m++) {
                double nextX = y[oldX + m] + 2 * small * (s.v0[m] + y[v + m]);
                double nextV = y[oldV + m] + 2 * small * s.a[m];
                y[oldX + m] = y[x + m];
                y[oldV + m] = y[v + m];
                y[x + m] = nextX;
                y[v + m] = nextV;
            }
        }
        return true;
    }

    /** Keeps the middle of the first row, after which the second one passes at the same time. */
    private static void keepMiddle(Stages s, int x, int v) {
        int at = MIDDLE * s.size;
        System.arraycopy(s.work, x, s.work, at, s.size);
        System.arraycopy(s.work, v, s.work, at + s.size, s.size);
        System.arraycopy(s.a, 0, s.work, at + 2 * s.size, s.size);
    }

    /** How fast the accelerations change from one row's middle to the other's: the square of a frequency, at least. */
    private static double rate(Stages s, int x, int v, double h) {
        int at = MIDDLE * s.size;
        for (int m = 0; m < s.size; m++) {
            s.offX[m] = s.work[x + m] - s.work[at + m];
            s.offV[m] = s.work[v + m] - s.work[at + s.size + m];
        }
        double way = s.norm(s.offX, s.offV, h);
        for (int m = 0; m < s.size; m++) {
            s.offX[m] = s.a[m] - s.work[at + 2 * s.size + m];
        }
        return way > 0 ? s.norm(s.offX) / way : 0;
    }

    private static boolean place(Stages s, int x, int v) {
        double off = 0;
        for (int m = 0; m < s.size; m++) {
            s.x[m] = s.x0[m] + s.work[x + m];
            s.v[m] = s.v0[m] + s.work[v + m];
            off += (s.x[m] - s.x[m]) + (s.v[m] - s.v[m]);
        }
        return off == 0; // NaN if something is not finite
    }

    /** Aitken's and Neville's scheme: place i takes the value that is extrapolated from the rows i … row. */
    private static void extrapolate(Stages s, int row) {
        double[] y = s.work;
        int width = 2 * s.size;
        for (int i = row - 1; i >= 0; i--) {
            double ratio = (double) (row + 1) / (i + 1);
            double part = 1 / (ratio * ratio - 1);
            for (int m = i * width, end = m + width; m < end; m++) {
                double finer = y[m + width];
                y[m] = finer + part * (finer - y[m]);
            }
        }
    }

    /** The last two extrapolations' difference in units of what is allowed: of positions, and of velocities. */
    private static double error(Stages s) {
        double[] y = s.work;
        int n = s.size;
        for (int m = 0; m < n; m++) {
            s.offX[m] = y[m] - y[2 * n + m];
            s.offV[m] = y[n + m] - y[3 * n + m];
        }
        return (s.isTied() ? TIED_CAUTION : CAUTION) * s.left(s.offX, s.offV, s.time);
    }

    private static void finish(Stages s) {
        place(s, 0, s.size);
        s.coordinates.put(s.x, s.v);
    }

    @Override
    public int order() {
        return 2 * MOST_ROWS;
    }

    @Override
    public String toString() {
        return "GraggBulirschStoer(" + getTolerance() + ")";
    }
}
