// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import java.util.Arrays;

/** The points of an impact that push: λ ≥ 0, A λ + b ≥ 0, λ·(A λ + b) = 0, by active sets. */
final class PushingPoints implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Weight that makes redundant systems solvable; refinement removes its effect. */
    private static final double REGULARIZATION = 1e-9;

    /** What is rounding in a number, relative to those that it is the difference of. */
    private static final double ROUNDING = 1e-14;

    /** Approach that is none, relative to the greatest one. */
    private static final double EXACT = 1e-12;

    private static final int REFINEMENTS = 4;
    private static final int MAX_CHANGES = 60;

    /** A, row by row, b and λ. */
    double[] matrix = new double[64];

    double[] rhs = new double[8];
    double[] lambda = new double[8];

    private double[] factor = new double[64];
    private double[] correction = new double[8];
    private boolean[] active = new boolean[8];
    private int points;

    /** What is rounding in the matrix beyond that of its own numbers. */
    private double rounding;

    /** Makes room for a number of points. */
    void begin(int count) {
        points = count;
        rounding = 0;
        if (rhs.length < count) {
            rhs = new double[2 * count];
            lambda = new double[2 * count];
            correction = new double[2 * count];
            active = new boolean[2 * count];
        }
        if (matrix.length < count * count) {
            matrix = new double[2 * count * count];
            factor = new double[2 * count * count];
        }
    }

    /** Says that the matrix is what ties leave of mobilities as great as this one, so that it has their rounding. */
    void roundAt(double mobility) {
        rounding = Math.max(rounding, ROUNDING * mobility);
    }

    /** Finds the points that push: starts with those that approach, then lets go of and adds all that are wrong. */
    void solve() {
        double scale = 0;
        for (int k = 0; k < points; k++) {
            scale = Math.max(scale, Math.abs(rhs[k]));
            active[k] = rhs[k] < 0;
        }
        for (int change = 0; change < MAX_CHANGES; change++) {
            solveActive();
            boolean done = true;
            for (int k = 0; k < points; k++) {
                if (active[k] && lambda[k] < 0) {
                    active[k] = false;
                    done = false;
                }
            }
            double tolerance = tolerance(scale);
            for (int k = 0; k < points && done; k++) {
                if (!active[k] && residual(k) < -tolerance) {
                    addViolated(tolerance);
                    done = false;
                }
            }
            if (done) {
                return;
            }
        }
        relax();
    }

    private double tolerance(double scale) {
        double tolerance = EXACT * scale;
        for (int k = 0; k < points && rounding > 0; k++) {
            tolerance = Math.max(tolerance, rounding * lambda[k]);
        }
        return tolerance;
    }

    private void addViolated(double tolerance) {
        for (int k = 0; k < points; k++) {
            if (!active[k] && residual(k) < -tolerance) {
                active[k] = true;
            }
        }
    }

    /** (A λ + b) of one row, with the products exact and the sum compensated. */
    private double residual(int i) {
        double sum = rhs[i];
        double low = 0;
        for (int j = 0; j < points; j++) {
            double a = matrix[i * points + j];
            double product = a * lambda[j];
            low += Math.fma(a, lambda[j], -product);
            double next = sum + product;
            double part = next - sum;
            low += (sum - (next - part)) + (product - part);
            sum = next;
        }
        return sum + low;
    }

    /** Solves A λ = −b on the active points, λ = 0 elsewhere. */
    private void solveActive() {
        factorize();
        Arrays.fill(lambda, 0, points, 0);
        for (int pass = 0; pass <= REFINEMENTS; pass++) {
            for (int k = 0; k < points; k++) {
                correction[k] = active[k] ? -residual(k) : 0;
            }
            substitute();
            for (int k = 0; k < points; k++) {
                lambda[k] += correction[k];
            }
        }
    }

    /** Cholesky factors of the active part of A, a little heavier on the diagonal. */
    private void factorize() {
        double trace = 0;
        for (int k = 0; k < points; k++) {
            trace = Math.max(trace, matrix[k * points + k]);
        }
        for (int i = 0; i < points; i++) {
            for (int j = 0; j <= i; j++) {
                double sum = active[i] && active[j] ? matrix[i * points + j] : i == j ? 1 : 0;
                if (i == j && active[i]) {
                    sum += Math.max(REGULARIZATION * trace, rounding);
                }
                for (int k = 0; k < j; k++) {
                    sum -= factor[i * points + k] * factor[j * points + k];
                }
                factor[i * points + j] = i == j ? Math.sqrt(sum) : sum / factor[j * points + j];
            }
        }
    }

    private void substitute() {
        for (int i = 0; i < points; i++) {
            double sum = correction[i];
            for (int k = 0; k < i; k++) {
                sum -= factor[i * points + k] * correction[k];
            }
            correction[i] = sum / factor[i * points + i];
        }
        for (int i = points - 1; i >= 0; i--) {
            double sum = correction[i];
            for (int k = i + 1; k < points; k++) {
                sum -= factor[k * points + i] * correction[k];
            }
            correction[i] = sum / factor[i * points + i];
        }
    }

    /** Projected relaxation, for the rare system on which the active sets go round in a circle. */
    private void relax() {
        Arrays.fill(lambda, 0, points, 0);
        for (int sweep = 0; sweep < 2000; sweep++) {
            for (int k = 0; k < points; k++) {
                lambda[k] = Math.max(0, lambda[k] - residual(k) / matrix[k * points + k]);
            }
        }
    }
}
