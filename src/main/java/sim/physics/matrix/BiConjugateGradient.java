// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

import java.io.Serializable;
import sim.physics.internal.Check;

/**
 * The biconjugate gradient method for M x = b (Fletcher 1976; Barrett et al., <i>Templates for the Solution of Linear
 * Systems</i>, 1994, section 2.3.5), the write-up's reference [9]. It uses M only through {@link Matrix#times} and
 * {@link Matrix#transposeTimes}.
 *
 * <p>It stops when the updated residual is within the tolerance and the true one agrees; where they part it starts
 * again from the true one. A breakdown (r̃·r or p̃·M p vanishes although r does not) is tried again once with another
 * shadow residual r̃, and is an exception then, never a wrong answer.
 */
public final class BiConjugateGradient implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Two vectors count as orthogonal when their product is this small relative to their lengths. */
    private static final double ORTHOGONAL = 1e-30;

    private static final int RESTARTS = 6;

    private final double tolerance;
    private final int maxIterations;

    private double[] r = {};
    private double[] shadow = {};
    private double[] p = {};
    private double[] q = {};
    private double[] mp = {};
    private double[] mq = {};
    private int iterations;

    /** Makes a solver with the relative tolerance 1e-14 and 20 iterations per unknown. */
    public BiConjugateGradient() {
        this(1e-14, 0);
    }

    /**
     * Makes a solver.
     *
     * @param tolerance of ‖b − M x‖ / ‖b‖, greater than 0
     * @param maxIterations 0 for 20 per unknown
     */
    public BiConjugateGradient(double tolerance, int maxIterations) {
        this.tolerance = Check.positive("tolerance", tolerance);
        if (maxIterations < 0) {
            throw new IllegalArgumentException("maxIterations is " + maxIterations + ": it must not be negative");
        }
        this.maxIterations = maxIterations;
    }

    /**
     * Solves M x = b.
     *
     * @param m a square matrix
     * @param b right side
     * @param x start value, replaced by the solution; left as it was on an exception
     * @return how it went; not converged if the iterations were used up
     * @throws SolverException on a breakdown or if a value is not a number
     * @throws IllegalArgumentException if the sizes do not fit
     */
    public SolveReport solve(Matrix m, double[] b, double[] x) {
        int n = m.rows();
        if (m.columns() != n) {
            throw new IllegalArgumentException("matrix is " + n + " x " + m.columns() + ": it must be square");
        }
        Matrix.check(b, n, x, n);
        ensure(n);
        double scale = Math.sqrt(dot(b, b, n));
        double[] start = x.clone();
        iterations = 0;
        if (scale == 0) {
            java.util.Arrays.fill(x, 0, n, 0);
            return new SolveReport(true, 0, 0);
        }
        int limit = maxIterations > 0 ? maxIterations : 20 * n;
        try {
            return iterate(m, b, x, n, scale, limit);
        } catch (SolverException e) {
            System.arraycopy(start, 0, x, 0, n);
            throw e;
        }
    }

    private SolveReport iterate(Matrix m, double[] b, double[] x, int n, double scale, int limit) {
        double best = Double.POSITIVE_INFINITY;
        String breakdown = null;
        for (int attempt = 0; attempt < RESTARTS; attempt++) {
            double residual = trueResidual(m, b, x, n) / scale;
            if (Double.isNaN(residual)) {
                throw new SolverException("a value is not a number", iterations, residual);
            }
            boolean stalled = residual > 0.5 * best;
            best = Math.min(best, residual);
            if (residual <= tolerance || iterations >= limit || stalled && breakdown == null) {
                return new SolveReport(residual <= Math.max(tolerance, 1e-13), iterations, residual);
            }
            breakdown = run(m, x, n, scale, limit, breakdown != null);
        }
        double residual = trueResidual(m, b, x, n) / scale;
        if (breakdown != null && residual > Math.max(tolerance, 1e-13)) {
            throw new SolverException(breakdown, iterations, residual);
        }
        return new SolveReport(residual <= Math.max(tolerance, 1e-13), iterations, residual);
    }

    /** One run from the residual in r; the name of the breakdown that ended it, or null. */
    private String run(Matrix m, double[] x, int n, double scale, int limit, boolean otherShadow) {
        for (int i = 0; i < n; i++) {
            shadow[i] = otherShadow ? r[i] * (1 + (i % 3)) + (i % 2 == 0 ? 1 : -0.5) * scale / n : r[i];
            p[i] = r[i];
            q[i] = shadow[i];
        }
        double rho = dot(shadow, r, n);
        while (iterations < limit) {
            if (isZero(rho, shadow, r, n)) {
                return "breakdown: the residual is orthogonal to its shadow";
            }
            m.times(p, mp);
            m.transposeTimes(q, mq);
            double product = dot(q, mp, n);
            if (isZero(product, q, mp, n)) {
                return "breakdown: the search direction is orthogonal to its image";
            }
            double alpha = rho / product;
            for (int i = 0; i < n; i++) {
                x[i] += alpha * p[i];
                r[i] -= alpha * mp[i];
                shadow[i] -= alpha * mq[i];
            }
            iterations++;
            if (!(Math.sqrt(dot(r, r, n)) > 0.1 * tolerance * scale)) {
                return null;
            }
            double next = dot(shadow, r, n);
            double beta = next / rho;
            rho = next;
            for (int i = 0; i < n; i++) {
                p[i] = r[i] + beta * p[i];
                q[i] = shadow[i] + beta * q[i];
            }
        }
        return null;
    }

    private static boolean isZero(double product, double[] a, double[] b, int n) {
        return Double.isNaN(product) || product * product <= ORTHOGONAL * dot(a, a, n) * dot(b, b, n);
    }

    /** r = b − M x; its length. */
    private double trueResidual(Matrix m, double[] b, double[] x, int n) {
        m.times(x, mp);
        for (int i = 0; i < n; i++) {
            r[i] = b[i] - mp[i];
        }
        return Math.sqrt(dot(r, r, n));
    }

    private static double dot(double[] a, double[] b, int n) {
        double sum = 0;
        for (int i = 0; i < n; i++) {
            sum += a[i] * b[i];
        }
        return sum;
    }

    private void ensure(int n) {
        if (r.length < n) {
            r = new double[n];
            shadow = new double[n];
            p = new double[n];
            q = new double[n];
            mp = new double[n];
            mq = new double[n];
        }
    }
}
