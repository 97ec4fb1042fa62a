// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.internal.IntList;

/**
 * The implicit method Radau IIA of order 5. It damps what is too fast for its steps (it is L-stable). Use it for stiff springs
 * and dampers, and for light bodies that carry heavy ones. This is the code RADAU5 of Hairer and Wanner, <i>Solving Ordinary
 * Differential Equations II</i>, 2nd edition, IV.8.
 *
 * <p>Derivatives are found by differences, and systems are solved densely, so it is for groups of some tens of bodies. Because
 * velocities are the derivatives of positions, a system s y − f′ y = r of twice the size becomes
 *
 * <pre>
 *   (s² − Aₓ − s Aᵥ) δx = rᵥ + s rₓ − Aᵥ rₓ,   δv = s δx − rₓ
 * </pre>
 *
 * <p>with the derivatives Aₓ and Aᵥ of the accelerations, for a real s and a complex one.
 */
public final class RadauIIA extends AdaptiveIntegrator {
    private static final long serialVersionUID = 1L;

    private static final double ROOT6 = Math.sqrt(6);
    private static final double[] NODE = {(4 - ROOT6) / 10, (4 + ROOT6) / 10, 1};

    // spotless:off
    /** The transformation that makes the method's matrix diagonal, and its inverse. */
    private static final double[][] T = {
        {9.1232394870892942792e-02, -0.14125529502095420843, -3.0029194105147424492e-02},
        {0.24171793270710701896, 0.20412935229379993199, 0.38294211275726193779},
        {0.96604818261509293619, 1, 0}
    };

    private static final double[][] INVERSE = {
        {4.3255798900631553510, 0.33919925181580986954, 0.54177053993587487119},
        {-4.1787185915519047273, -0.32768282076106238708, 0.47662355450055045196},
        {-0.50287263494578687595, 2.5719269498556054292, -0.59603920482822492497}
    };

    /** Its eigenvalues: a real one, and real and imaginary part of the others. */
    private static final double GAMMA = 3.6378342527444957322;
    private static final double ALPHA = 2.6810828736277521339;
    private static final double BETA = 3.0504301992474105694;
    // spotless:on

    /** Its matrix itself. */
    private static final double[][] MATRIX = {
        {(88 - 7 * ROOT6) / 360, (296 - 169 * ROOT6) / 1800, (-2 + 3 * ROOT6) / 225},
        {(296 + 169 * ROOT6) / 1800, (88 + 7 * ROOT6) / 360, (-2 - 3 * ROOT6) / 225},
        {(16 - ROOT6) / 36, (16 + ROOT6) / 36, 1.0 / 9}
    };

    /** The stages' difference to a formula of third order; and their third divided difference, which has an order less. */
    private static final double[] ERROR = {-(13 + 7 * ROOT6) / 3, (-13 + 7 * ROOT6) / 3, -1.0 / 3};

    private static final double[] DIFFERENCE = new double[3];

    static {
        for (int i = 0; i < 3; i++) {
            DIFFERENCE[i] = 1 / NODE[i];
            for (int k = 0; k < 3; k++) {
                DIFFERENCE[i] /= k == i ? 1 : NODE[i] - NODE[k];
            }
        }
    }

    private static final int MOST_ITERATIONS = 10;

    /** Part of the tolerance to which the stages are solved, over the time in which the motion changes. */
    private static final double SOLVED = 9e-4;

    /** The same where rounding does not let it be less. */
    static final double LOOSE = 3e-3;

    /** The time step over the time in which a vibration changes, over the root of the estimates' ratio. */
    private static final double SMOOTH = 3;

    private static final double LEAST_TURN = 1e-3;

    /** The error that steps leave, over the estimate, in the mean of our scenes. */
    private static final double CALIBRATION = 0.057;

    /** The same where dense output is read. */
    private static final double OPEN_CALIBRATION = 0.067;

    /**
     * The square of a step times the fastest frequency, over that of the number of coordinates, from which derivatives at
     * each stage are cheaper than shorter steps.
     */
    private static final double STIFF = 10;

    /** Steps for which derivatives are found at each stage, from one on for which those of its start were not enough. */
    private static final int TURNING = 50;

    /** The stiffness of a step up to which the accelerations at its ends say more than its stages. */
    private static final double SMOOTH_OUTPUT = 1;

    private static final double SAFETY = 0.8;
    private static final double LEAST = 0.02;
    private static final double MOST = 8;

    /** A step that need not be longer by more than this stays as it is, so that the factors can be used again. */
    private static final double STAY = 1.2;

    /**
     * Creates the method.
     *
     * @param tolerance error of a position that one step may make, length
     * @throws IllegalArgumentException if the tolerance is not a finite number greater than 0
     */
    public RadauIIA(double tolerance) {
        super(tolerance);
    }

    /** Where the motion is smooth, the quintic through the step's ends, of the method's order; else the stages' cubic. */
    @Override
    boolean makeDense(
            EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path, DenseOutput out) {
        Stages s = path.stages;
        Implicit w = s.implicit(bodies);
        s.ensureMore(1);
        boolean isSmooth = w.stiffness(h) < SMOOTH_OUTPUT;
        out.begin(s, h, isSmooth ? DenseOutput.QUINTIC : NODE.length);
        if (isSmooth) {
            equations.acceleration(bodies, t + h, path.stage);
            Implicit.take(bodies, path.stage, s.more);
        }
        for (int m = 0; m < s.size; m++) {
            if (isSmooth) {
                out.quintic(m, s.endX[m], s.endV[m], s.a0[m], s.more[m]);
            } else {
                collocate(out.x, NODE.length * m, w.stageX[0][m], w.stageX[1][m], s.endX[m] - s.x0[m]);
                collocate(out.v, NODE.length * m, w.stageV[0][m], w.stageV[1][m], s.endV[m] - s.v0[m]);
            }
        }
        return true;
    }

    /** The cubic through the start and three ways from it, in the form of {@link DenseOutput}. */
    private static void collocate(double[] f, int o, double first, double second, double end) {
        double p = (first / NODE[0] - end) / (1 - NODE[0]);
        double q = (second / NODE[1] - end) / (1 - NODE[1]);
        f[o] = end;
        f[o + 2] = (q - p) / (NODE[1] - NODE[0]);
        f[o + 1] = p - NODE[0] * f[o + 2];
    }

    @Override
    boolean attempt(EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path) {
        Stages s = path.stages;
        Implicit w = s.implicit(bodies);
        if (!s.isRetry) {
            w.differentiate(equations, state, bodies, t, h, path);
        }
        w.last.predict(s, bodies, t, h, w.stageX, w.stageV);
        if (!w.factor(GAMMA / h, ALPHA / h, BETA / h) || !solve(equations, state, bodies, t, h, path, w)) {
            s.factor = 0.25;
            return false;
        }
        double error = estimate(equations, state, bodies, t, h, path, w);
        double root = StrictMath.pow(error, 0.2);
        s.factor = error == 0 ? MOST : Math.max(LEAST, Math.min(MOST, SAFETY / root));
        s.factor = s.factor >= 1 && s.factor < STAY ? 1 : s.factor;
        if (!(error <= 1)) {
            s.factor = error < Double.POSITIVE_INFINITY ? s.factor : LEAST;
            return false;
        }
        w.last.keep(s, bodies, t, h, w.stageX, w.stageV);
        s.maker = this;
        place(state, bodies, s, w.stageX[2], w.stageV[2]);
        return true;
    }

    /** The stages, with the derivatives of the start or, where the forces turn too much for these, with their own. */
    private static boolean solve(
            EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path, Implicit w) {
        Stages s = path.stages;
        if (w.turning == 0) {
            transform(s, w);
            if (iterate(equations, state, bodies, t, h, path, w)) {
                w.plain = Math.abs(h);
                return true;
            }
            boolean isWorthIt = w.plain > 0 && Math.abs(h) > longer(s.size) * w.plain;
            if (!isWorthIt || w.stiffness(h) < STIFF * s.size * s.size) {
                return false;
            }
            w.turning = TURNING;
            w.last.predict(s, bodies, t, h, w.stageX, w.stageV);
        }
        w.turning--;
        return w.newton().solve(equations, state, bodies, t, h, path, w, SOLVED * w.turn);
    }

    /** How much longer a step with derivatives at each stage must be: some three times six per coordinate, in place of two. */
    private static double longer(int n) {
        return 30.0 * n / (2 * n + 21);
    }

    private static void transform(Stages s, Implicit w) {
        for (int m = 0; m < s.size; m++) {
            for (int i = 0; i < 3; i++) {
                w.partX[i][m] = dot(INVERSE[i], w.stageX, m);
                w.partV[i][m] = dot(INVERSE[i], w.stageV, m);
            }
        }
    }

    /** Newton's method with the derivatives of the start, to a part of the tolerance; false if it does not converge. */
    private static boolean iterate(
            EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path, Implicit w) {
        Stages s = path.stages;
        double before = Double.POSITIVE_INFINITY;
        double solved = SOLVED * w.turn;
        for (int k = 0; k < MOST_ITERATIONS; k++) {
            for (int i = 0; i < NODE.length; i++) {
                place(state, bodies, s, w.stageX[i], w.stageV[i]);
                equations.acceleration(bodies, t + NODE[i] * h, path.stage);
                Implicit.take(bodies, path.stage, w.slopeV[i]);
                for (int m = 0; m < s.size; m++) {
                    w.slopeX[i][m] = s.v0[m] + w.stageV[i][m];
                }
            }
            double change = correct(s, w, h);
            double rate = k == 0 ? 0.5 : change / before;
            if (!(change < Double.POSITIVE_INFINITY) || k > 1 && rate >= 1 && change > LOOSE) {
                return false;
            }
            if (rate >= 1 && change <= LOOSE || rate < 1 && rate / (1 - rate) * change <= solved) {
                return true; // the former is rounding
            }
            before = change;
        }
        return false;
    }

    /** One correction of the stages; returns its size in units of the tolerance. */
    private static double correct(Stages s, Implicit w, double h) {
        double gamma = GAMMA / h;
        double alpha = ALPHA / h;
        double beta = BETA / h;
        int n = s.size;
        for (int m = 0; m < n; m++) {
            for (int i = 0; i < 3; i++) {
                w.rightX[i][m] = dot(INVERSE[i], w.slopeX, m);
                w.rightV[i][m] = dot(INVERSE[i], w.slopeV, m);
            }
            w.rightX[0][m] -= gamma * w.partX[0][m];
            w.rightV[0][m] -= gamma * w.partV[0][m];
            w.rightX[1][m] += -alpha * w.partX[1][m] + beta * w.partX[2][m];
            w.rightV[1][m] += -alpha * w.partV[1][m] + beta * w.partV[2][m];
            w.rightX[2][m] += -beta * w.partX[1][m] - alpha * w.partX[2][m];
            w.rightV[2][m] += -beta * w.partV[1][m] - alpha * w.partV[2][m];
        }
        w.solveReal(gamma, w.rightX[0], w.rightV[0]);
        w.solveComplex(alpha, beta);
        double time = h / w.turn;
        double most = 0;
        for (int m = 0; m < n; m++) {
            for (int i = 0; i < 3; i++) {
                w.partX[i][m] += w.rightX[i][m];
                w.partV[i][m] += w.rightV[i][m];
                double change = Math.max(Math.abs(w.rightX[i][m]), Math.abs(time * w.rightV[i][m]));
                most = Math.max(most, s.weight[m] * change);
            }
            for (int i = 0; i < 3; i++) {
                w.stageX[i][m] = dot(T[i], w.partX, m);
                w.stageV[i][m] = dot(T[i], w.partV, m);
            }
        }
        return most;
    }

    private static double dot(double[] row, double[][] columns, int m) {
        return row[0] * columns[0][m] + row[1] * columns[1][m] + row[2] * columns[2][m];
    }

    /**
     * The difference to a formula of third order, damped where the motion is stiff, and its ratio to the third differences,
     * which says how smooth the motion is: the product falls with the fifth power of the step, as what the steps of a unit
     * of time leave does. Where forces jump the ratio is 1.
     */
    private static double estimate(
            EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path, Implicit w) {
        Stages s = path.stages;
        for (int m = 0; m < s.size; m++) {
            w.rightX[0][m] = dot(DIFFERENCE, w.stageX, m) / h;
            w.rightV[0][m] = dot(DIFFERENCE, w.stageV, m) / h;
        }
        w.solveReal(GAMMA / h, w.rightX[0], w.rightV[0]);
        double third = norm(s, w.rightX[0]) * norm(s, w.rightV[0]);
        for (int m = 0; m < s.size; m++) {
            w.errorX[m] = dot(ERROR, w.stageX, m) / h;
            w.errorV[m] = dot(ERROR, w.stageV, m) / h;
            w.rightX[0][m] = w.errorX[m] + s.v0[m];
            w.rightV[0][m] = w.errorV[m] + s.a0[m];
        }
        w.solveReal(GAMMA / h, w.rightX[0], w.rightV[0]);
        double error = smooth(s, w, h, third);
        if (error < 1) {
            return error;
        }
        for (int m = 0; m < s.size; m++) {
            w.partX[0][m] = w.rightX[0][m];
            w.partV[0][m] = w.rightV[0][m];
        }
        place(state, bodies, s, w.partX[0], w.partV[0]);
        equations.acceleration(bodies, t, path.stage);
        Implicit.take(bodies, path.stage, w.slopeV[0]);
        for (int m = 0; m < s.size; m++) {
            w.rightX[0][m] = w.errorX[m] + s.v0[m] + w.partV[0][m];
            w.rightV[0][m] = w.errorV[m] + w.slopeV[0][m];
        }
        w.solveReal(GAMMA / h, w.rightX[0], w.rightV[0]);
        return smooth(s, w, h, third);
    }

    /**
     * The estimate. A vibration's differences of positions and of velocities vanish at different times, so that their
     * products tell the step times its frequency; and what a velocity is off counts for one over that, not for the step.
     */
    private static double smooth(Stages s, Implicit w, double h, double third) {
        double x = norm(s, w.rightX[0]);
        double v = norm(s, w.rightV[0]);
        double turn = x * v < third ? Math.max(LEAST_TURN, Math.min(1, SMOOTH * Math.sqrt(x * v / third))) : 1;
        w.turn = turn;
        if (s.isOpen) { // what is read on the way had better be near to where ties want it
            return OPEN_CALIBRATION * turn * Math.max(x, Math.abs(h) * v / turn);
        }
        System.arraycopy(w.rightX[0], 0, w.rightX[1], 0, s.size);
        System.arraycopy(w.rightV[0], 0, w.rightV[1], 0, s.size);
        return CALIBRATION * turn * s.left(w.rightX[1], w.rightV[1], h / turn);
    }

    private static double norm(Stages s, double[] values) {
        double most = 0;
        for (int m = 0; m < s.size; m++) {
            most = Math.max(most, s.weight[m] * Math.abs(values[m]));
        }
        return most;
    }

    private static void place(State state, IntList bodies, Stages s, double[] x, double[] v) {
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int c = 0, m = State.BLOCK * k; c < State.BLOCK; c++, m++) {
                state.x()[b + c] = s.x0[m] + x[m];
                state.v()[b + c] = s.v0[m] + v[m];
            }
        }
    }

    static double node(int i) {
        return NODE[i];
    }

    static double matrix(int i, int j) {
        return MATRIX[i][j];
    }

    @Override
    public int order() {
        return 5;
    }

    @Override
    public String toString() {
        return "RadauIIA(" + getTolerance() + ")";
    }
}
