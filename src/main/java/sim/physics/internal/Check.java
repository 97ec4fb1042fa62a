// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

/** Checks of arguments. The messages name the argument, its value and the rule. */
public final class Check {
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
