// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

import java.io.Serializable;

/**
 * How a constraint that is off its place is brought back by time stepping: as by a damped spring that is integrated implicitly
 * (Catto, <i>Soft constraints</i>, GDC 2011), whose frequency is a part of that of the substeps.
 *
 * @param rate part of what it is off that goes in a unit of time
 * @param mass how much of the impulse counts that a rigid constraint would take
 * @param impulse how much of what it has taken so far is given back
 */
public record Softness(double rate, double mass, double impulse) implements Serializable {
    /** A constraint that has no place to go back to. */
    public static final Softness RIGID = new Softness(0, 1, 0);

    /**
     * The same, solved beyond what one row asks for (successive over-relaxation; of unknowns that are bounded, Cryer, <i>The solution of a quadratic
     * programming problem using systematic overrelaxation</i>, 1971): where rows all but depend on one another, many times less turns are needed.
     */
    public static final Softness EAGER = new Softness(0, 1.7, 0);

    /**
     * How much of the impulse counts that a rigid constraint would take.
     *
     * @param yields whether it gives way to loads
     * @return that much; of one that does not, all of it at least
     */
    public double mass(boolean yields) {
        return yields || mass > 1 ? mass : 1;
    }

    /**
     * How much of what it has taken so far is given back.
     *
     * @param yields whether it gives way to loads
     * @return that much; of one that does not, nothing
     */
    public double impulse(boolean yields) {
        return yields ? impulse : 0;
    }

    /**
     * That of a spring.
     *
     * @param frequency in oscillations a substep
     * @param damping ratio
     * @param h substep
     * @return its softness
     */
    public static Softness of(double frequency, double damping, double h) {
        double angle = 2 * Math.PI * frequency;
        double sum = 2 * damping + angle;
        double product = angle * sum;
        return new Softness(angle / (h * sum), product / (1 + product), 1 / (1 + product));
    }
}
