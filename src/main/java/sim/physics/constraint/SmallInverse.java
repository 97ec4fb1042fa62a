// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

/** Inverts symmetric matrices of three rows. */
final class SmallInverse {
    /** A determinant that is less than this, relative to the product of the diagonal, is rounding. */
    private static final double SINGULAR = 1e-14;

    private SmallInverse() {}

    /** The inverse by cofactors, row after row; false, and nothing written, if there is none. */
    static boolean invert(double k00, double k01, double k02, double k11, double k12, double k22, double[] to, int o) {
        double a = k11 * k22 - k12 * k12;
        double b = k02 * k12 - k01 * k22;
        double d = k01 * k12 - k02 * k11;
        double det = k00 * a + k01 * b + k02 * d;
        if (!(det > SINGULAR * k00 * k11 * k22)) {
            return false;
        }
        to[o] = a / det;
        to[o + 1] = b / det;
        to[o + 2] = d / det;
        to[o + 3] = b / det;
        to[o + 4] = (k00 * k22 - k02 * k02) / det;
        to[o + 5] = (k01 * k02 - k00 * k12) / det;
        to[o + 6] = d / det;
        to[o + 7] = to[o + 5];
        to[o + 8] = (k00 * k11 - k01 * k01) / det;
        return true;
    }
}
