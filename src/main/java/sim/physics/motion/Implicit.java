// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import sim.physics.internal.DenseFactor;
import sim.physics.internal.IntList;

/** The workspace of an implicit method for a group of bodies: derivatives of its accelerations, factors, and stages. */
final class Implicit implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Change of a coordinate for a difference, relative to its size. */
    private static final double SMALL = 0x1p-26;

    /** Stages less the start, the same transformed, slopes at the stages, and right sides: 3 each. */
    final double[][] stageX = new double[3][];

    final double[][] stageV = new double[3][];
    final double[][] partX = new double[3][];
    final double[][] partV = new double[3][];
    final double[][] slopeX = new double[3][];
    final double[][] slopeV = new double[3][];
    final double[][] rightX = new double[3][];
    final double[][] rightV = new double[3][];
    double[] errorX = {};
    double[] errorV = {};

    /** The last step over the time in which the motion changes, at most 1: for that, velocities matter. */
    double turn = 1;

    /** The length of the last step that was solved with the derivatives of its start; 0: none was. */
    double plain;

    /** Steps to come whose derivatives are found at each stage, as they change too much from one to the other. */
    int turning;

    /** Null until that is needed. */
    private StageNewton newton;

    /** The last step. */
    final Collocation last = new Collocation();

    private int n;
    private double[] byX = {};
    private double[] byV = {};
    private double[] real = {};
    private double[] complexRe = {};
    private double[] complexIm = {};
    private int[] pivots = {};
    private int[] complexPivots = {};
    private double[] re = {};
    private double[] im = {};

    /**
     * By coordinate: 1, or the arm at which a turn is taken for a way, so that pivots are chosen among rows of one unit. Powers of two: no
     * bit is lost by them.
     */
    private double[] arm = {};

    StageNewton newton() {
        newton = newton == null ? new StageNewton() : newton;
        return newton;
    }

    /** Makes room for a number of coordinates. */
    void ensure(int size) {
        n = size;
        if (re.length >= n) {
            return;
        }
        for (int i = 0; i < 3; i++) {
            stageX[i] = new double[n];
            stageV[i] = new double[n];
            partX[i] = new double[n];
            partV[i] = new double[n];
            slopeX[i] = new double[n];
            slopeV[i] = new double[n];
            rightX[i] = new double[n];
            rightV[i] = new double[n];
        }
        errorX = new double[n];
        errorV = new double[n];
        byX = new double[n * n];
        byV = new double[n * n];
        real = new double[n * n];
        complexRe = new double[n * n];
        complexIm = new double[n * n];
        pivots = new int[n];
        complexPivots = new int[n];
        re = new double[n];
        im = new double[n];
        arm = new double[n];
    }

    /** What the row of a coordinate is multiplied by before an elimination. */
    double arm(int row) {
        return arm[row];
    }

    /** The derivatives of the accelerations by positions and velocities, at the start of the step. */
    void differentiate(EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path) {
        Stages s = path.stages;
        differentiate(equations, state, bodies, t, h, path, s.x0, s.v0, s.a0, byX, byV);
    }

    /** The same at a place where the accelerations are known; the derivatives are put row by row. */
    void differentiate(
            EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path,
            double[] x, double[] v, double[] a, double[] toX, double[] toV) {
        for (int k = 0, m = 0; k < bodies.size; k++) {
            double radius = state.body(bodies.values[k]).getShape().boundingRadius();
            for (int c = 0; c < State.BLOCK; c++, m++) {
                int b = State.BLOCK * bodies.values[k] + c;
                double size = c == State.THETA ? 1 : radius;
                arm[m] = c == State.THETA ? Math.scalb(1.0, Math.getExponent(radius)) : 1;
                double dx = SMALL * Math.max(Math.abs(x[m]), size);
                put(state, bodies, x, v);
                state.x()[b] += dx;
                column(equations, bodies, t, path, state.x()[b] - x[m], a, toX, m);
                double dv = SMALL * Math.max(Math.abs(v[m]), size / Math.abs(h));
                put(state, bodies, x, v);
                state.v()[b] += dv;
                column(equations, bodies, t, path, state.v()[b] - v[m], a, toV, m);
            }
        }
    }

    /** Takes a group's block of accelerations. */
    static void take(IntList bodies, double[] a, double[] to) {
        for (int k = 0; k < bodies.size; k++) {
            System.arraycopy(a, State.BLOCK * bodies.values[k], to, State.BLOCK * k, State.BLOCK);
        }
    }

    /** Writes a group's places and velocities into the state vectors. */
    static void put(State state, IntList bodies, double[] x, double[] v) {
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            System.arraycopy(x, State.BLOCK * k, state.x(), b, State.BLOCK);
            System.arraycopy(v, State.BLOCK * k, state.v(), b, State.BLOCK);
        }
    }

    private void column(
            EquationsOfMotion equations, IntList bodies, double t, Path path, double d, double[] a, double[] to, int m) {
        equations.acceleration(bodies, t, path.stage);
        for (int k = 0, row = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int end = b + State.BLOCK; b < end; b++, row++) {
                to[row * n + m] = (path.stage[b] - a[row]) / d;
            }
        }
    }

    /** The size of the derivatives times a step: of a damping, or the square of that of a vibration. */
    double stiffness(double h) {
        double most = 0;
        for (int row = 0; row < n; row++) {
            double x = 0;
            double v = 0;
            for (int m = 0; m < n; m++) {
                double unit = arm[row] / arm[m];
                x += unit * Math.abs(byX[row * n + m]);
                v += unit * Math.abs(byV[row * n + m]);
            }
            most = Math.max(most, Math.max(h * h * x, Math.abs(h) * v));
        }
        return most;
    }

    /** Factors s² − Aₓ − s Aᵥ for s = γ and s = α + i β; false if one is singular. */
    boolean factor(double gamma, double alpha, double beta) {
        for (int m = 0; m < n * n; m++) {
            real[m] = -byX[m] - gamma * byV[m];
            complexRe[m] = -byX[m] - alpha * byV[m];
            complexIm[m] = -beta * byV[m];
        }
        for (int m = 0; m < n; m++) {
            real[m * n + m] += gamma * gamma;
            complexRe[m * n + m] += alpha * alpha - beta * beta;
            complexIm[m * n + m] += 2 * alpha * beta;
        }
        for (int m = 0; m < n * n; m++) {
            real[m] *= arm[m / n];
            complexRe[m] *= arm[m / n];
            complexIm[m] *= arm[m / n];
        }
        return DenseFactor.factor(real, n, pivots)
                && DenseFactor.factor(complexRe, complexIm, n, complexPivots);
    }

    /** Solves for δx and δv in place of their right sides. */
    void solveReal(double gamma, double[] x, double[] v) {
        for (int row = 0; row < n; row++) {
            double sum = v[row] + gamma * x[row];
            for (int m = 0; m < n; m++) {
                sum -= byV[row * n + m] * x[m];
            }
            re[row] = arm[row] * sum;
        }
        DenseFactor.solve(real, n, pivots, re);
        for (int m = 0; m < n; m++) {
            v[m] = gamma * re[m] - x[m];
            x[m] = re[m];
        }
    }

    /** The same for the right sides 1 and 2, real and imaginary part. */
    void solveComplex(double alpha, double beta) {
        double[] xr = rightX[1];
        double[] xi = rightX[2];
        for (int row = 0; row < n; row++) {
            double sumRe = rightV[1][row] + alpha * xr[row] - beta * xi[row];
            double sumIm = rightV[2][row] + alpha * xi[row] + beta * xr[row];
            for (int m = 0; m < n; m++) {
                sumRe -= byV[row * n + m] * xr[m];
                sumIm -= byV[row * n + m] * xi[m];
            }
            re[row] = arm[row] * sumRe;
            im[row] = arm[row] * sumIm;
        }
        DenseFactor.solve(complexRe, complexIm, n, complexPivots, re, im);
        for (int m = 0; m < n; m++) {
            rightV[1][m] = alpha * re[m] - beta * im[m] - xr[m];
            rightV[2][m] = alpha * im[m] + beta * re[m] - xi[m];
            xr[m] = re[m];
            xi[m] = im[m];
        }
    }
}
