// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

import java.io.Serializable;
import java.util.Arrays;
import java.util.Objects;

/**
 * The biconjugate gradient method for M x = b, which is the solver of the write-up's chapter <i>Matrix Optimization</i> and its
 * reference [9]. It uses M only through {@link Matrix#times} and {@link Matrix#transposeTimes}. Source: Fletcher 1976; Barrett et
 * al., <i>Templates for the Solution of Linear Systems</i>, 1994, section 2.3.5.
 *
 * <p>The residual is updated along the way. Where it is small enough, the true one ‖b − M x‖ is computed, and the method starts
 * again from that one until it is within the tolerance too. A tolerance below 1e-13 may be beyond what doubles can reach. The
 * solver then goes on as long as the true residual halves, and then accepts 1e-13.
 *
 * <p>If a run does not halve the true residual, because of a breakdown or within half of the iterations, it is followed by one
 * with another shadow residual: r̃ = r/‖r‖ + Mh/‖Mh‖ instead of r, where h is a fixed sequence without a pattern. That heals
 * nearly every breakdown unless M is singular. If it does not help, the outcome is an exception if the run broke down, and
 * otherwise a report that says "not converged". In neither case is a wrong answer called right. The breakdowns are those of the
 * method: r̃·r = 0, p̃·M p = 0, overflow.
 *
 * <p>A preconditioner is a diagonal matrix near M⁻¹ (Jacobi: 1/mᵢᵢ), which is multiplied by, not divided by. It changes the way
 * but not the goal, which is always the residual of the system as given.
 *
 * <p>Settings are fixed. The workspace is reused, grows with the largest system so far, and is not serialized.
 */
public final class BiConjugateGradient implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Two vectors count as orthogonal when their product is this small relative to their lengths. */
    private static final double ORTHOGONAL = 1e-15;

    /** A true residual that will do when it does not fall any more. */
    private static final double ROUNDING = 1e-13;

    /** The updated residual goes this far below the tolerance, so that the true one is likely to be within. */
    private static final double MARGIN = 0.25;

    private static final int ITERATIONS_PER_UNKNOWN = 20;

    /** How a run from one true residual to the next ended. */
    private enum Ending {
        SMALL(null),
        LIMIT(null),
        SHADOW("breakdown: the residual is orthogonal to its shadow (r~.r = 0)"),
        DIRECTION("breakdown: the search direction is orthogonal to its image (p~.Mp = 0)"),
        OVERFLOW("breakdown: overflow");

        final String breakdown;

        Ending(String breakdown) {
            this.breakdown = breakdown;
        }
    }

    private final double tolerance;
    private final int maxIterations;

    // of the last solution
    private boolean converged;
    private int iterations;
    private double residual;

    // of the present one: size, limit, unit of the residuals (a power of two near ‖b‖), ‖b‖ in this unit
    private transient int n;
    private transient int limit;
    private transient double unit;
    private transient double length;

    // workspace: iterate and best iterate; r, r̃; p, p̃; M p, Mᵀ p̃; preconditioned r, r̃
    private transient double[] at;
    private transient double[] best;
    private transient double[] r;
    private transient double[] shadow;
    private transient double[] p;
    private transient double[] q;
    private transient double[] mp;
    private transient double[] mq;
    private transient double[] z;
    private transient double[] zShadow;

    /** Creates a solver with the relative tolerance 1e-14 and 20 iterations per unknown. */
    public BiConjugateGradient() {
        this(1e-14, 0);
    }

    /**
     * Creates a solver.
     *
     * @param tolerance tolerance of ‖b − M x‖ / ‖b‖, greater than 0
     * @param maxIterations greatest number of iterations; 0 for 20 per unknown
     * @throws IllegalArgumentException if an argument is out of its range
     */
    public BiConjugateGradient(double tolerance, int maxIterations) {
        if (!(tolerance > 0 && tolerance < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    "tolerance is " + tolerance + ": it must be a finite number greater than 0");
        }
        Vectors.checkNotNegative("maxIterations", maxIterations);
        this.tolerance = tolerance;
        this.maxIterations = maxIterations;
    }

    /**
     * Solves M x = b.
     *
     * @param m a square matrix of n rows
     * @param b right-hand side, at least n values
     * @param x start value, at least n values; replaced by the solution, or by the best iterate if the method did not converge;
     *     left as it was on an exception
     * @return report on the solution; not converged if the iterations were used up or the residual does not fall any more
     * @throws SolverException on a breakdown or if a value is not a number
     * @throws IllegalArgumentException if the sizes do not fit
     */
    public SolveReport solve(Matrix m, double[] b, double[] x) {
        return solve(m, b, x, null);
    }

    /**
     * Solves M x = b with a preconditioner.
     *
     * @param m a square matrix of n rows
     * @param b right-hand side, at least n values
     * @param x start value, as without a preconditioner
     * @param inverse n finite values near M⁻¹, none of them zero; null for no preconditioner
     * @return report on the solution
     * @throws SolverException on a breakdown or if a value is not a number
     * @throws IllegalArgumentException if the sizes do not fit or a value of the preconditioner is zero or not finite
     */
    public SolveReport solve(Matrix m, double[] b, double[] x, DiagonalMatrix inverse) {
        solveInPlace(m, b, x, inverse);
        return new SolveReport(converged, iterations, residual);
    }

    /**
     * Solves M x = b and allocates nothing. The report is in {@link #converged()}, {@link #iterations()} and {@link #residual()}.
     *
     * @param m a square matrix of n rows
     * @param b right-hand side, at least n values
     * @param x start value, as in {@link #solve(Matrix, double[], double[])}
     * @param inverse n finite values near M⁻¹, none of them zero; null for no preconditioner
     * @return whether it converged
     * @throws SolverException on a breakdown or if a value is not a number
     * @throws IllegalArgumentException if the sizes do not fit or a value of the preconditioner is zero or not finite
     */
    public boolean solveInPlace(Matrix m, double[] b, double[] x, DiagonalMatrix inverse) {
        check(m, b, x, inverse);
        n = m.rows();
        limit = maxIterations > 0 ? maxIterations : ITERATIONS_PER_UNKNOWN * n;
        ensureRoom();
        converged = false;
        iterations = 0;
        residual = Double.NaN;
        double norm = Vectors.norm(b, n);
        if (!(norm < Double.POSITIVE_INFINITY)) {
            throw new SolverException("a value of b is infinite or not a number", 0, residual);
        }
        if (norm == 0) {
            Arrays.fill(x, 0, n, 0);
            residual = 0;
            converged = true;
            return true;
        }
        unit = Math.scalb(1.0, Math.max(Double.MIN_EXPONENT, Math.min(Math.getExponent(norm), -Double.MIN_EXPONENT)));
        length = norm / unit;
        System.arraycopy(x, 0, at, 0, n);
        iterate(m, b, inverse);
        converged = residual <= Math.max(tolerance, ROUNDING);
        System.arraycopy(best, 0, x, 0, n);
        return converged;
    }

    /**
     * Returns whether the last solution converged.
     *
     * @return true if it did; false also if it ended in an exception
     */
    public boolean converged() {
        return converged;
    }

    /**
     * Returns the number of steps of the last solution.
     *
     * @return number, from 0
     */
    public int iterations() {
        return iterations;
    }

    /**
     * Returns the true residual of the last solution.
     *
     * @return ‖b − M x‖ / ‖b‖
     */
    public double residual() {
        return residual;
    }

    /** Runs from true residual to true residual; the best iterate is in {@code best} and has {@code residual}. */
    private void iterate(Matrix m, double[] b, DiagonalMatrix inverse) {
        residual = trueResidual(m, b);
        if (!(residual < Double.POSITIVE_INFINITY)) {
            throw new SolverException("a value of the matrix or of x is infinite or not a number", 0, residual);
        }
        System.arraycopy(at, 0, best, 0, n);
        boolean otherShadow = false;
        while (residual > tolerance && iterations < limit) {
            double before = residual;
            Ending ending = run(m, inverse, otherShadow);
            keepTheBetter(m, b);
            if (residual <= 0.5 * before) {
                continue;
            }
            if (residual <= ROUNDING) {
                return;
            }
            if (otherShadow) {
                if (ending.breakdown != null && residual > tolerance) {
                    throw new SolverException(ending.breakdown, iterations, residual);
                }
                return;
            }
            otherShadow = true;
        }
    }

    private void keepTheBetter(Matrix m, double[] b) {
        double reached = trueResidual(m, b);
        if (reached < residual) {
            residual = reached;
            System.arraycopy(at, 0, best, 0, n);
        } else {
            System.arraycopy(best, 0, at, 0, n);
            trueResidual(m, b);
        }
    }

    /** One run of the method from the residual in r. */
    private Ending run(Matrix m, DiagonalMatrix inverse, boolean otherShadow) {
        chooseShadow(m, otherShadow);
        double[] pr = precondition(inverse, r, z);
        double[] ps = precondition(inverse, shadow, zShadow);
        System.arraycopy(pr, 0, p, 0, n);
        System.arraycopy(ps, 0, q, 0, n);
        double rho = Vectors.dotOrZero(pr, shadow, n, ORTHOGONAL);
        int left = limit - iterations;
        // keep half for the other shadow, but let this one finish the n steps of exact arithmetic twice
        int end = otherShadow ? limit : iterations + Math.min(left, Math.max(2 * n, left / 2));
        while (iterations < end) {
            if (rho == 0) {
                return Ending.SHADOW;
            }
            m.times(p, mp);
            m.transposeTimes(q, mq);
            double product = Vectors.dotOrZero(q, mp, n, ORTHOGONAL);
            if (product == 0) {
                return Ending.DIRECTION;
            }
            iterations++;
            double size = advance(rho / product);
            if (!(size < Double.POSITIVE_INFINITY)) {
                return Ending.OVERFLOW;
            }
            if (size <= MARGIN * tolerance * length) {
                return Ending.SMALL;
            }
            precondition(inverse, r, z);
            precondition(inverse, shadow, zShadow);
            double next = Vectors.dotOrZero(pr, shadow, n, ORTHOGONAL);
            turn(pr, ps, next / rho);
            rho = next;
        }
        return Ending.LIMIT;
    }

    /** r̃ = r, or r/‖r‖ + Mh/‖Mh‖, which keeps to the range of M. */
    private void chooseShadow(Matrix m, boolean other) {
        System.arraycopy(r, 0, shadow, 0, n);
        if (!other) {
            return;
        }
        for (int i = 0; i < n; i++) {
            q[i] = Vectors.scattered(i);
        }
        m.times(q, mp);
        double imageSize = Vectors.norm(mp, n);
        double size = Vectors.norm(r, n);
        for (int i = 0; i < n; i++) {
            shadow[i] = r[i] / size + (imageSize > 0 ? mp[i] / imageSize : 0);
        }
    }

    /** x += α p, r −= α M p, r̃ −= α Mᵀ p̃; the length of r. */
    private double advance(double alpha) {
        double alphaX = alpha * unit;
        double square = 0;
        for (int i = 0; i < n; i++) {
            at[i] += alphaX * p[i];
            r[i] -= alpha * mp[i];
            shadow[i] -= alpha * mq[i];
            square += r[i] * r[i];
        }
        return Vectors.norm(square, r, n);
    }

    /** p = z + β p, p̃ = z̃ + β p̃. */
    private void turn(double[] pr, double[] ps, double beta) {
        for (int i = 0; i < n; i++) {
            p[i] = pr[i] + beta * p[i];
            q[i] = ps[i] + beta * q[i];
        }
    }

    /** r = b − M x in the unit of the residuals; its length relative to that of b. */
    private double trueResidual(Matrix m, double[] b) {
        m.times(at, mp);
        for (int i = 0; i < n; i++) {
            r[i] = (b[i] - mp[i]) / unit;
        }
        return Vectors.norm(r, n) / length;
    }

    /** The operand itself if there is no preconditioner. */
    private static double[] precondition(DiagonalMatrix inverse, double[] operand, double[] result) {
        if (inverse == null) {
            return operand;
        }
        inverse.times(operand, result);
        return result;
    }

    private static void check(Matrix m, double[] b, double[] x, DiagonalMatrix inverse) {
        int size = Objects.requireNonNull(m, "m").rows();
        Objects.requireNonNull(b, "b");
        Objects.requireNonNull(x, "x");
        if (m.columns() != size) {
            throw new IllegalArgumentException("matrix is " + size + " x " + m.columns() + ": it must be square");
        }
        if (b.length < size || x.length < size) {
            throw new IllegalArgumentException((b.length < size ? "b has " + b.length : "x has " + x.length)
                    + " values: the system has " + size + " unknowns");
        }
        if (b == x) {
            throw new IllegalArgumentException("b and x are the same array: the solution would overwrite b");
        }
        if (inverse == null) {
            return;
        }
        if (inverse.rows() != size) {
            throw new IllegalArgumentException(
                    "preconditioner has " + inverse.rows() + " values: the system has " + size + " unknowns");
        }
        for (int i = 0; i < size; i++) {
            double value = inverse.values()[i];
            if (value == 0 || !(Math.abs(value) < Double.POSITIVE_INFINITY)) {
                throw new IllegalArgumentException(
                        "preconditioner has " + value + " in row " + i + ": it must be finite and not zero");
            }
        }
    }

    private void ensureRoom() {
        if (at == null || at.length < n) {
            at = new double[n];
            best = new double[n];
            r = new double[n];
            shadow = new double[n];
            p = new double[n];
            q = new double[n];
            mp = new double[n];
            mq = new double[n];
            z = new double[n];
            zShadow = new double[n];
        }
    }
}
