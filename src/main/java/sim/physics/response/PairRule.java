// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

/** Says how the coefficients of two bodies make the coefficient of their contact. */
public enum PairRule {
    /** The smaller one. */
    MINIMUM,
    /** The larger one. */
    MAXIMUM,
    /** Half the sum. */
    AVERAGE,
    /** The product. */
    PRODUCT,
    /** The square root of the product. */
    GEOMETRIC_MEAN;

    /**
     * Returns the coefficient of a contact.
     *
     * @param a coefficient of one body
     * @param b coefficient of the other body
     * @return the coefficient; the same for (a, b) and (b, a)
     */
    public double of(double a, double b) {
        if (a == b && this != PRODUCT) {
            return a;
        }
        return switch (this) {
            case MINIMUM -> Math.min(a, b);
            case MAXIMUM -> Math.max(a, b);
            case AVERAGE -> 0.5 * (a + b);
            case PRODUCT -> a * b;
            case GEOMETRIC_MEAN -> Math.sqrt(a * b);
        };
    }
}
