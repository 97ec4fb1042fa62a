// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.util.List;

/** Thrown when no motion, or no motion near enough, can satisfy the constraints. */
public final class ConstraintException extends IllegalStateException {
    private static final long serialVersionUID = 1L;

    private final int iterations;
    private final double residual;

    /**
     * Creates an exception.
     *
     * @param what the equations that cannot be satisfied
     * @param iterations number of corrections that were tried
     * @param residual the largest value of C that is left
     */
    public ConstraintException(String what, int iterations, double residual) {
        super(what + ": the equations are off by " + residual + " after " + iterations + " corrections");
        this.iterations = iterations;
        this.residual = residual;
    }

    private ConstraintException(int iterations, double residual, String message) {
        super(message);
        this.iterations = iterations;
        this.residual = residual;
    }

    /**
     * Of constraints that bodies cannot be moved onto, and are where they were.
     *
     * @param all what cannot be satisfied
     * @param widest the one of them that is farthest open
     * @param gap how far it is open where the bodies are
     * @param isAngle whether that is an angle
     * @param corrections how many were tried
     */
    static ConstraintException of(List<Constraint> all, Constraint widest, double gap, boolean isAngle, int corrections) {
        return new ConstraintException(corrections, gap, "constraints " + all + " cannot be satisfied: number " + (all.indexOf(widest) + 1) + " of them, " + widest + ", is open by " + gap
                + (isAngle ? " rad" : "") + " where the bodies are, and " + corrections + " corrections have led to no place where all are closed");
    }

    /**
     * Of constraints whose forces an iteration does not find.
     *
     * @param all what they are
     * @param steps how many were made
     * @param left what is left, relative to what is to be met
     */
    static ConstraintException ofForces(List<Constraint> all, int steps, double left) {
        return new ConstraintException(steps, left, "the forces of constraints " + all + " did not converge in " + steps
                + " steps, " + left + " of what they must meet is left: set a DirectSolver, which does not iterate, or remove what is redundant");
    }

    /**
     * Returns how many corrections were tried.
     *
     * @return number of corrections
     */
    public int iterations() {
        return iterations;
    }

    /**
     * Returns the residual.
     *
     * @return the largest value of C that is left, a length or an angle; if the bodies could not be moved onto the constraints,
     *     its value where they are
     */
    public double residual() {
        return residual;
    }
}
