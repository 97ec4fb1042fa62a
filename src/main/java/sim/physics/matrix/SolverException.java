// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

/** Thrown when a solver breaks down and has no answer. */
public final class SolverException extends ArithmeticException {
    private static final long serialVersionUID = 1L;

    private final int iterations;
    private final double residual;

    /**
     * Creates an exception.
     *
     * @param what the kind of breakdown
     * @param iterations number of steps until then
     * @param residual relative residual at that point
     */
    public SolverException(String what, int iterations, double residual) {
        super(what + " after " + iterations + " iterations, at a relative residual of " + residual);
        this.iterations = iterations;
        this.residual = residual;
    }

    /**
     * Returns the number of steps until the breakdown.
     *
     * @return number, from 0
     */
    public int iterations() {
        return iterations;
    }

    /**
     * Returns the residual at the breakdown.
     *
     * @return residual relative to the right-hand side
     */
    public double residual() {
        return residual;
    }
}
