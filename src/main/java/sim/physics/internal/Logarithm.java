// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

/**
 * The natural logarithm of a ratio, with the same bits on every machine and in every version of Java, and without leaving Java:
 * log(a/b) = k log 2 + 2 atanh((a − c)/(a + c)) with c = 2ᵏ b within a third of a, by the power series. No branch, so that
 * several can be computed at a time.
 */
public final class Logarithm {
    /** The logarithm of 2: its first 32 bits, whose multiples by an exponent are exact, and the rest. */
    private static final double LOG2_HIGH = 0x1.62e42feep-1;

    private static final double LOG2_LOW = 0x1.a39ef35793c76p-33;

    /** Bits of a number below its exponent. */
    private static final int FRACTION = 52;

    private Logarithm() {}

    /**
     * The logarithm of a/b.
     *
     * @param a greater than 0, and normal
     * @param b likewise; a/b neither overflows nor underflows
     * @return as right as a − b is: within three units in the last place where a and b are exact
     */
    public static double ofRatio(double a, double b) {
        long bitsOfB = Double.doubleToRawLongBits(b);
        // the bits of a number are its binary logarithm, but for a tenth
        long k = Double.doubleToRawLongBits(a) - bitsOfB + (1L << FRACTION - 1) >> FRACTION;
        double c = Double.longBitsToDouble(bitsOfB + (k << FRACTION));
        return k * LOG2_HIGH + (twiceAtanh((a - c) / (a + c)) + k * LOG2_LOW);
    }

    /** 2 atanh s for |s| ≤ 0.2, the series in two halves, which do not wait for one another. */
    private static double twiceAtanh(double s) {
        double z = s * s;
        double y = z * z;
        double even = 1.0 / 21;
        double odd = 1.0 / 23;
        even = even * y + 1.0 / 17;
        odd = odd * y + 1.0 / 19;
        even = even * y + 1.0 / 13;
        odd = odd * y + 1.0 / 15;
        even = even * y + 1.0 / 9;
        odd = odd * y + 1.0 / 11;
        even = even * y + 1.0 / 5;
        odd = odd * y + 1.0 / 7;
        return 2 * (s + s * (z * (1.0 / 3 + (z * even + y * odd))));
    }
}
