// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

/** A solver broke down and has no answer. */
public final class SolverException extends ArithmeticException {
    private static final long serialVersionUID = 1L;

    private final int iterations;
    private final double residual;

    /**
     * Makes an exception.
     *
     * @param what which breakdown
     * @param iterations steps until then
     * @param residual relative residual then
     */
    public SolverException(String what, int iterations, double residual) {
        super(what + " after " + iterations + " iterations, at a relative residual of " + residual);
        this.iterations = iterations;
        this.residual = residual;
    }

    /**
     * Steps until the breakdown.
     *
     * @return 0 …
     */
    public int iterations() {
        return iterations;
    }

    /**
     * Residual at the breakdown.
     *
     * @return relative to the right side
     */
    public double residual() {
        return residual;
    }
}
