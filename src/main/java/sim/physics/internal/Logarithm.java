// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

/**
 * The natural logarithm of 1 + x, with the same bits on every machine and in every version of Java, and without leaving Java:
 * log(2ᵏ m) = k log 2 + 2 atanh((m − 1)/(m + 1)) with m between √½ and √2, by the power series.
 */
public final class Logarithm {
    /** The logarithm of 2: its first 32 bits, whose multiples by an exponent are exact, and the rest. */
    private static final double LOG2_HIGH = 0x1.62e42feep-1;

    private static final double LOG2_LOW = 0x1.a39ef35793c76p-33;

    private static final double ROOT_2 = 0x1.6a09e667f3bcdp0;

    private Logarithm() {}

    /**
     * The logarithm of 1 + x.
     *
     * @param x not negative, finite
     * @return within two units in the last place
     */
    public static double ofOnePlus(double x) {
        if (x < ROOT_2 - 1) {
            return twiceAtanh(x / (2 + x));
        }
        double y = 1 + x;
        double lost = x < 1 ? x - (y - 1) : 1 - (y - x);
        int k = Math.getExponent(y);
        double m = Math.scalb(y, -k);
        if (m > ROOT_2) {
            m *= 0.5;
            k++;
        }
        return k * LOG2_HIGH + (twiceAtanh((m - 1) / (m + 1)) + (k * LOG2_LOW + lost / y));
    }

    /** 2 atanh s for |s| ≤ 0.1716. */
    private static double twiceAtanh(double s) {
        double z = s * s;
        double sum = 1.0 / 21;
        sum = sum * z + 1.0 / 19;
        sum = sum * z + 1.0 / 17;
        sum = sum * z + 1.0 / 15;
        sum = sum * z + 1.0 / 13;
        sum = sum * z + 1.0 / 11;
        sum = sum * z + 1.0 / 9;
        sum = sum * z + 1.0 / 7;
        sum = sum * z + 1.0 / 5;
        sum = sum * z + 1.0 / 3;
        return 2 * (s + s * (z * sum));
    }
}
