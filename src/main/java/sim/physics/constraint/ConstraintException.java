// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

/** Constraints that no motion, or no motion near enough, can satisfy. */
public final class ConstraintException extends IllegalStateException {
    private static final long serialVersionUID = 1L;

    private final int iterations;
    private final double residual;

    /**
     * Makes an exception.
     *
     * @param what what cannot be satisfied
     * @param iterations how many corrections were tried
     * @param residual the largest value of C that is left
     */
    public ConstraintException(String what, int iterations, double residual) {
        super(what + ": the equations are off by " + residual + " after " + iterations + " corrections");
        this.iterations = iterations;
        this.residual = residual;
    }

    /**
     * Corrections that were tried.
     *
     * @return their number
     */
    public int iterations() {
        return iterations;
    }

    /**
     * What is left.
     *
     * @return the largest value of C
     */
    public double residual() {
        return residual;
    }
}
