// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

/** The length of a vector. */
public final class Length {
    /** Below it the squares of a length have lost digits, or are 0. */
    public static final double TINY = 1e-150;

    private Length() {}

    /**
     * Finds it, also where its square is less than the least number.
     *
     * @param x a component
     * @param y the other one
     * @return their length; 0 only if both are 0
     */
    public static double of(double x, double y) {
        double length = Math.sqrt(x * x + y * y);
        return length < TINY ? StrictMath.hypot(x, y) : length;
    }
}
