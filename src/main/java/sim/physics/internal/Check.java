// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

/** Checks of arguments. The messages name the argument, its value and the rule. */
public final class Check {
    /** Directions shorter or longer than this have squares that are no numbers. */
    private static final double SHORT = 1e-140;

    private static final double LONG = 1e150;
    private static final double FACTOR = 0x1p600;

    private Check() {}

    /**
     * Requires a finite number.
     *
     * @param name of the argument
     * @param value of the argument
     * @return the value
     */
    public static double finite(String name, double value) {
        if (!(Math.abs(value) < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(name + " is " + value + ": it must be finite");
        }
        return value;
    }

    /**
     * Requires a finite number greater than 0.
     *
     * @param name of the argument
     * @param value of the argument
     * @return the value
     */
    public static double positive(String name, double value) {
        if (!(value > 0 && value < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(name + " is " + value + ": it must be a finite number greater than 0");
        }
        return value;
    }

    /**
     * Requires a finite number not less than 0.
     *
     * @param name of the argument
     * @param value of the argument
     * @return the value
     */
    public static double notNegative(String name, double value) {
        if (!(value >= 0 && value < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(name + " is " + value + ": it must be a finite number, not negative");
        }
        return value;
    }

    /**
     * Requires a direction, of any length but 0.
     *
     * @param nameX of its x component
     * @param x of the direction
     * @param nameY of its y component
     * @param y of the direction
     * @return by what to multiply both, a power of two, so that the length can be computed; 1 for all but extreme ones
     */
    public static double direction(String nameX, double x, String nameY, double y) {
        double most = Math.max(Math.abs(finite(nameX, x)), Math.abs(finite(nameY, y)));
        if (most == 0) {
            throw new IllegalArgumentException("direction is (" + x + ", " + y + "): it must not be zero");
        }
        return most < SHORT ? FACTOR : most > LONG ? 1 / FACTOR : 1;
    }

    /**
     * Requires a number in a closed interval.
     *
     * @param name of the argument
     * @param value of the argument
     * @param low lower bound
     * @param high upper bound
     * @return the value
     */
    public static double between(String name, double value, double low, double high) {
        if (!(value >= low && value <= high)) {
            throw new IllegalArgumentException(name + " is " + value + ": it must be from " + low + " to " + high);
        }
        return value;
    }
}
