// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.internal.IntList;

/**
 * The implicit method Radau IIA of order 5, which damps what is too fast for its steps (it is L-stable): the one to take
 * for stiff springs and dampers, and light bodies that carry heavy ones. The code is RADAU5 of Hairer and Wanner,
 * <i>Solving Ordinary Differential Equations II</i>, 2nd edition, IV.8.
 *
 * <p>Its derivatives are found by differences, and its systems solved densely: for groups of some tens of bodies. Because
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

    private static final double[] ERROR = {-(13 + 7 * ROOT6) / 3, (-13 + 7 * ROOT6) / 3, -1.0 / 3};

    private static final int MOST_ITERATIONS = 10;

    /** Part of the tolerance to which the stages are solved. */
    private static final double SOLVED = 1e-3;

    /** The same where steps are as short as Newton's method wants them: there are many, and what each leaves adds up. */
    private static final double WELL_SOLVED = 1e-6;

    /** Steps for which that counts, from one on for which it did not converge. */
    private static final int SHORT = 200;

    private static final double SAFETY = 0.9;
    private static final double LEAST = 0.02;
    private static final double MOST = 8;

    /** A step that need not be longer by more than this stays as it is, so that the factors can be used again. */
    private static final double STAY = 1.2;

    /**
     * Makes the method.
     *
     * @param tolerance error of a position that a step may make, length
     * @throws IllegalArgumentException if it is not a finite number greater than 0
     */
    public RadauIIA(double tolerance) {
        super(tolerance);
    }

    @Override
    boolean attempt(EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path) {
        Stages s = path.stages;
        Implicit w = s.implicit();
        w.ensure(s.size);
        if (!s.isRetry) {
            w.differentiate(equations, state, bodies, t, h, path);
        }
        w.clear();
        int first = bodies.values[0];
        double solved = path.isShort(first) ? WELL_SOLVED : SOLVED;
        if (!w.factor(GAMMA / h, ALPHA / h, BETA / h) || !solve(equations, state, bodies, t, h, path, w, solved)) {
            if (!s.isRetry && path.next[first] > 0) {
                path.shorten(first, SHORT);
            }
            s.factor = 0.25;
            return false;
        }
        double error = estimate(equations, state, bodies, t, h, path, w);
        double root = Math.sqrt(Math.sqrt(error));
        s.factor = error == 0 ? MOST : Math.max(LEAST, Math.min(MOST, SAFETY / root));
        s.factor = s.factor >= 1 && s.factor < STAY ? 1 : s.factor;
        if (!(error <= 1)) {
            s.factor = error < Double.POSITIVE_INFINITY ? s.factor : LEAST;
            return false;
        }
        place(state, bodies, s, w.stageX[2], w.stageV[2], 1);
        return true;
    }

    /** Newton's method for the stages, from where it is to a part of the tolerance; false if it does not converge. */
    private static boolean solve(
            EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path, Implicit w,
            double solved) {
        Stages s = path.stages;
        for (int end = w.iterations + MOST_ITERATIONS; w.left > solved && w.iterations < end; w.iterations++) {
            for (int i = 0; i < NODE.length; i++) {
                place(state, bodies, s, w.stageX[i], w.stageV[i], 1);
                equations.acceleration(bodies, t + NODE[i] * h, path.stage);
                take(bodies, s, path.stage, w.slopeV[i]);
                for (int m = 0; m < s.size; m++) {
                    w.slopeX[i][m] = s.v0[m] + w.stageV[i][m];
                }
            }
            double change = correct(s, w, h);
            double rate = w.iterations == 0 ? 0.5 : change / w.change;
            if (!(change < Double.POSITIVE_INFINITY) || w.iterations > 1 && rate > 1) {
                return w.left <= SOLVED; // then this is rounding
            }
            if (w.iterations > 0 && rate < 1 || change == 0) {
                w.left = rate / (1 - rate) * change;
            }
            w.change = change;
        }
        return w.left <= SOLVED;
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
        double most = 0;
        for (int m = 0; m < n; m++) {
            for (int i = 0; i < 3; i++) {
                w.partX[i][m] += w.rightX[i][m];
                w.partV[i][m] += w.rightV[i][m];
                double change = Math.max(Math.abs(w.rightX[i][m]), Math.abs(h * w.rightV[i][m]));
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

    /** The difference to a formula of third order, damped where the motion is stiff. */
    private static double estimate(
            EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path, Implicit w) {
        Stages s = path.stages;
        for (int m = 0; m < s.size; m++) {
            w.errorX[m] = dot(ERROR, w.stageX, m) / h;
            w.errorV[m] = dot(ERROR, w.stageV, m) / h;
            w.rightX[0][m] = w.errorX[m] + s.v0[m];
            w.rightV[0][m] = w.errorV[m] + s.a0[m];
        }
        w.solveReal(GAMMA / h, w.rightX[0], w.rightV[0]);
        double error = norm(s, w, h);
        if (error < 1) {
            return error;
        }
        place(state, bodies, s, w.rightX[0], w.rightV[0], 1);
        equations.acceleration(bodies, t, path.stage);
        take(bodies, s, path.stage, w.slopeV[0]);
        for (int m = 0; m < s.size; m++) {
            w.rightX[0][m] = w.errorX[m] + s.v0[m] + w.rightV[0][m];
            w.rightV[0][m] = w.errorV[m] + w.slopeV[0][m];
        }
        w.solveReal(GAMMA / h, w.rightX[0], w.rightV[0]);
        return norm(s, w, h);
    }

    private static double norm(Stages s, Implicit w, double h) {
        double most = 0;
        for (int m = 0; m < s.size; m++) {
            double size = Math.max(Math.abs(w.rightX[0][m]), Math.abs(h * w.rightV[0][m]));
            most = Math.max(most, s.weight[m] * size);
        }
        return most;
    }

    private static void place(State state, IntList bodies, Stages s, double[] x, double[] v, double part) {
        for (int k = 0, m = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int end = b + State.BLOCK; b < end; b++, m++) {
                state.x()[b] = s.x0[m] + part * x[m];
                state.v()[b] = s.v0[m] + part * v[m];
            }
        }
    }

    private static void take(IntList bodies, Stages s, double[] a, double[] to) {
        for (int k = 0, m = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int end = b + State.BLOCK; b < end; b++, m++) {
                to[m] = a[b];
            }
        }
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
