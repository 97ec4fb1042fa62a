// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

/** Sums over the first n values of arrays, and checks of indices, which the classes of this package share. */
final class Vectors {
    /** Between these a sum of squares has neither overflowed nor lost values by underflow. */
    private static final double SMALL = 1e-280;

    private static final double LARGE = 1e280;

    private Vectors() {}

    /** a·b = Σ aᵢ bᵢ. */
    static double dot(double[] a, double[] b, int n) {
        double sum = 0;
        for (int i = 0; i < n; i++) {
            sum += a[i] * b[i];
        }
        return sum;
    }

    /** a·b, or 0 if it is not above the given part of ‖a‖ ‖b‖; all in one pass. */
    static double dotOrZero(double[] a, double[] b, int n, double part) {
        double ab = 0;
        double aa = 0;
        double bb = 0;
        for (int i = 0; i < n; i++) {
            ab += a[i] * b[i];
            aa += a[i] * a[i];
            bb += b[i] * b[i];
        }
        return Math.abs(ab) > part * norm(aa, a, n) * norm(bb, b, n) ? ab : 0;
    }

    /** ‖a‖ = √Σ aᵢ², whatever the magnitude of the values. */
    static double norm(double[] a, int n) {
        return norm(dot(a, a, n), a, n);
    }

    /** ‖a‖ when a·a is known, as far as doubles can tell it. */
    static double norm(double square, double[] a, int n) {
        if (square > SMALL && square < LARGE) {
            return Math.sqrt(square);
        }
        double largest = 0;
        for (int i = 0; i < n; i++) {
            largest = Math.max(largest, Math.abs(a[i]));
        }
        if (largest == 0 || !(largest < Double.POSITIVE_INFINITY)) {
            return largest;
        }
        // ‖a‖ = m √Σ (aᵢ/m)²
        double sum = 0;
        for (int i = 0; i < n; i++) {
            double ratio = a[i] / largest;
            sum += ratio * ratio;
        }
        return largest * Math.sqrt(sum);
    }

    /** Value i of a fixed sequence without a pattern, in [-1, 1): the mixing function of SplitMix64. */
    static double scattered(int i) {
        long bits = (i + 1) * 0x9E3779B97F4A7C15L;
        bits = (bits ^ (bits >>> 30)) * 0xBF58476D1CE4E5B9L;
        bits = (bits ^ (bits >>> 27)) * 0x94D049BB133111EBL;
        return ((bits ^ (bits >>> 31)) >> 11) * 0x1p-52;
    }

    /** Requires a value from 0 to end − 1. */
    static void checkIndex(String name, int value, int end) {
        if (value < 0 || value >= end) {
            throw new IllegalArgumentException(name + " is " + value + ": it must be from 0 to " + (end - 1));
        }
    }

    /** Requires value ≥ 0. */
    static void checkNotNegative(String name, int value) {
        if (value < 0) {
            throw new IllegalArgumentException(name + " is " + value + ": it must not be negative");
        }
    }
}
