// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import sim.physics.matrix.Matrix;

/**
 * Solves J W Jᵀ λ = b as far as it can be where constraints are redundant. There b has a part that no forces can meet, by rounding or because
 * bodies are not quite where all is closed, and conjugate gradients on the system itself break down or circle. These on the system times itself
 * (CGLS) find the λ that leaves no more than that part. Of all such λ they are the smallest.
 *
 * <p>Rows are scaled by the roots of the diagonal, so that units do not matter.
 */
final class LeastForces {
    /** What can still be met is that small relative to b when it will do, and when it is as small as it gets. */
    private static final double ENOUGH = 1e-10;

    private static final double ROUNDING = 1e-15;

    private static final int STEPS_PER_ROW = 40;

    private final Matrix system;
    private final double[] scale;
    private final double[] inner;
    private final double[] outer;
    private int steps;
    private double left;

    /**
     * Takes a system.
     *
     * @param system symmetric, and not negative
     * @param inverse one over its diagonal
     */
    LeastForces(Matrix system, double[] inverse) {
        this.system = system;
        int n = inverse.length;
        scale = new double[n];
        for (int k = 0; k < n; k++) {
            scale[k] = Math.sqrt(inverse[k]);
        }
        inner = new double[n];
        outer = new double[n];
    }

    /** {@return the number of steps of the last solution} */
    int steps() {
        return steps;
    }

    /** {@return what the last solution leaves that could still be met, relative to the right-hand side} */
    double left() {
        return left;
    }

    /**
     * Solves.
     *
     * @param b right-hand side
     * @param lambda takes the solution
     * @return whether nothing is left that forces can meet
     */
    boolean solve(double[] b, double[] lambda) {
        int n = scale.length;
        double[] x = new double[n];
        double[] best = new double[n];
        double[] r = new double[n];
        double[] s = new double[n];
        double[] q = new double[n];
        for (int k = 0; k < n; k++) {
            r[k] = scale[k] * b[k];
        }
        double size = Math.sqrt(square(r));
        times(r, s);
        double[] p = s.clone();
        double gamma = square(s);
        left = Math.sqrt(gamma) / size;
        int limit = STEPS_PER_ROW * n;
        for (steps = 0; steps < limit && left > ROUNDING; steps++) {
            times(p, q);
            double alpha = gamma / square(q);
            if (!(Math.abs(alpha) < Double.POSITIVE_INFINITY)) {
                break;
            }
            for (int k = 0; k < n; k++) {
                x[k] += alpha * p[k];
                r[k] -= alpha * q[k];
            }
            times(r, s);
            double next = square(s);
            for (int k = 0; k < n; k++) {
                p[k] = s[k] + next / gamma * p[k];
            }
            gamma = next;
            if (Math.sqrt(gamma) < left * size) {
                left = Math.sqrt(gamma) / size;
                System.arraycopy(x, 0, best, 0, n);
            }
        }
        for (int k = 0; k < n; k++) {
            lambda[k] = scale[k] * best[k];
        }
        return left <= ENOUGH;
    }

    private void times(double[] x, double[] y) {
        for (int k = 0; k < x.length; k++) {
            inner[k] = scale[k] * x[k];
        }
        system.times(inner, outer);
        for (int k = 0; k < x.length; k++) {
            y[k] = scale[k] * outer[k];
        }
    }

    private static double square(double[] x) {
        double sum = 0;
        for (double value : x) {
            sum += value * value;
        }
        return sum;
    }
}
