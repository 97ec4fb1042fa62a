// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import sim.physics.internal.DenseFactor;
import sim.physics.internal.IntList;

/**
 * Newton's method for the stages of {@link RadauIIA} with the derivatives at each of them: for stiff springs that turn in a
 * step. With the derivatives at its start, the step is bounded by the time in which such a spring turns by 1/(ω h).
 *
 * <p>With X and V, the stages less the start, Aᵢₓ and Aᵢᵥ, the derivatives at stage i, and the residuals rₓ and rᵥ, it is
 *
 * <pre>
 *   δV − h Σⱼ aᵢⱼ (Aⱼᵥ δVⱼ + h Aⱼₓ Σₗ aⱼₗ δVₗ) = rᵥ + h Σⱼ aᵢⱼ Aⱼₓ rₓⱼ,   δX = rₓ + h Σⱼ aᵢⱼ δVⱼ
 * </pre>
 */
final class StageNewton implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int MOST_ITERATIONS = 15;

    /** Decrease of the corrections from which the derivatives are good enough. */
    private static final double GOOD = 0.02;

    private final double[][] byX = new double[3][0];
    private final double[][] byV = new double[3][0];
    private double[] matrix = {};
    private int[] pivots = {};
    private double[] right = {};
    private double[] placeX = {};
    private double[] placeV = {};
    private final double[][] openX = new double[3][0];

    StageNewton() {
        // grows with the group
    }

    private void ensure(int n) {
        if (placeX.length >= n) {
            return;
        }
        for (int i = 0; i < 3; i++) {
            byX[i] = new double[n * n];
            byV[i] = new double[n * n];
            openX[i] = new double[n];
        }
        matrix = new double[9 * n * n];
        pivots = new int[3 * n];
        right = new double[3 * n];
        placeX = new double[n];
        placeV = new double[n];
    }

    /** Solves for the stages, from where they are; false if it does not converge. */
    boolean solve(
            EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path, Implicit w,
            double solved) {
        Stages s = path.stages;
        ensure(s.size);
        double before = Double.POSITIVE_INFINITY;
        boolean isGood = false;
        for (int k = 0; k < MOST_ITERATIONS; k++) {
            evaluate(equations, state, bodies, t, h, path, w, !isGood);
            if (!isGood) {
                assemble(w, h, s.size);
                if (!DenseFactor.factor(matrix, 3 * s.size, pivots)) {
                    return false;
                }
            }
            double change = correct(s, w, h);
            double rate = k == 0 ? 0.5 : change / before;
            if (!(change < Double.POSITIVE_INFINITY) || k > 1 && rate > 2) {
                return false;
            }
            if (k > 0 && rate >= 1 && change <= RadauIIA.LOOSE || rate < 1 && rate / (1 - rate) * change <= solved) {
                return true; // the former is rounding
            }
            isGood = k > 0 && rate < GOOD;
            before = change;
        }
        return false;
    }

    /** The accelerations at the stages, and their derivatives if asked for. */
    private void evaluate(
            EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path, Implicit w,
            boolean derivatives) {
        Stages s = path.stages;
        for (int i = 0; i < 3; i++) {
            double at = t + RadauIIA.node(i) * h;
            for (int m = 0; m < s.size; m++) {
                placeX[m] = s.x0[m] + w.stageX[i][m];
                placeV[m] = s.v0[m] + w.stageV[i][m];
            }
            Implicit.put(state, bodies, placeX, placeV);
            equations.acceleration(bodies, at, path.stage);
            Implicit.take(bodies, path.stage, w.slopeV[i]);
            System.arraycopy(placeV, 0, w.slopeX[i], 0, s.size);
            if (derivatives) {
                w.differentiate(equations, state, bodies, at, h, path, placeX, placeV, w.slopeV[i], byX[i], byV[i]);
            }
        }
    }

    private void assemble(Implicit w, double h, int n) {
        int width = 3 * n;
        for (int i = 0; i < 3; i++) {
            for (int l = 0; l < 3; l++) {
                double toV = h * RadauIIA.matrix(i, l);
                for (int row = 0; row < n; row++) {
                    for (int m = 0; m < n; m++) {
                        double sum = toV * byV[l][row * n + m];
                        for (int j = 0; j < 3; j++) {
                            sum += h * RadauIIA.matrix(i, j) * (h * RadauIIA.matrix(j, l)) * byX[j][row * n + m];
                        }
                        matrix[(i * n + row) * width + l * n + m] = w.arm(row) * ((i == l && row == m ? 1 : 0) - sum);
                    }
                }
            }
        }
    }

    /** One correction; returns its size in units of the tolerance. */
    private double correct(Stages s, Implicit w, double h) {
        int n = s.size;
        for (int i = 0; i < 3; i++) {
            for (int m = 0; m < n; m++) {
                double sum = -w.stageX[i][m];
                for (int j = 0; j < 3; j++) {
                    sum += h * RadauIIA.matrix(i, j) * w.slopeX[j][m];
                }
                openX[i][m] = sum;
            }
        }
        for (int i = 0; i < 3; i++) {
            for (int row = 0; row < n; row++) {
                double sum = -w.stageV[i][row];
                for (int j = 0; j < 3; j++) {
                    double slope = w.slopeV[j][row];
                    for (int m = 0; m < n; m++) {
                        slope += byX[j][row * n + m] * openX[j][m];
                    }
                    sum += h * RadauIIA.matrix(i, j) * slope;
                }
                right[i * n + row] = w.arm(row) * sum;
            }
        }
        DenseFactor.solve(matrix, 3 * n, pivots, right);
        double time = h / w.turn;
        double most = 0;
        for (int i = 0; i < 3; i++) {
            for (int m = 0; m < n; m++) {
                double dx = openX[i][m];
                for (int j = 0; j < 3; j++) {
                    dx += h * RadauIIA.matrix(i, j) * right[j * n + m];
                }
                double dv = right[i * n + m];
                w.stageX[i][m] += dx;
                w.stageV[i][m] += dv;
                most = Math.max(most, s.weight[m] * Math.max(Math.abs(dx), Math.abs(time * dv)));
            }
        }
        return most;
    }
}
