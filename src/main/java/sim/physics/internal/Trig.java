// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

/**
 * Sine and cosine with the same bits on every machine: only + − × and rounding to a whole number are used, which Java
 * defines exactly. {@code Math.sin} may differ by a bit between processors and between interpreted and compiled code.
 *
 * <p>Reduction by quarter turns in three parts (Cody and Waite 1980), then the polynomials of fdlibm (Sun Microsystems
 * 1993) for |x| ≤ π/4. From 10⁵ on {@code StrictMath}, which is slower, takes over. All results tried, also
 * the nearest to the zeros, were equal to {@code StrictMath}'s or next to it.
 */
public final class Trig {
    /** From here on the number of quarter turns may have too many bits for the reduction to be exact. */
    private static final double LARGE = 1e5;

    private static final double TWO_OVER_PI = 0x1.45f306dc9c883p-1;

    /** π/2 in three parts; the first two have 33 bits, so that their products with a count of turns are exact. */
    private static final double PART_1 = 0x1.921fb544p0;

    private static final double PART_2 = 0x1.0b4611a6p-34;
    private static final double PART_3 = 0x1.3198a2e037073p-69;

    private Trig() {}

    /**
     * Sine.
     *
     * @param x rad
     * @return sin x, −0 for −0, NaN for NaN and infinities
     */
    public static double sin(double x) {
        if (x == 0) {
            return x;
        }
        if (!(Math.abs(x) < LARGE)) {
            return StrictMath.sin(x);
        }
        double turns = Math.rint(x * TWO_OVER_PI);
        double head = x - turns * PART_1;
        double tail = turns * PART_2;
        double r = head - tail;
        double low = head - r - tail - turns * PART_3;
        return switch ((int) turns & 3) {
            case 0 -> sine(r, low);
            case 1 -> cosine(r, low);
            case 2 -> -sine(r, low);
            default -> -cosine(r, low);
        };
    }

    /**
     * Cosine.
     *
     * @param x rad
     * @return cos x, NaN for NaN and infinities
     */
    public static double cos(double x) {
        if (!(Math.abs(x) < LARGE)) {
            return StrictMath.cos(x);
        }
        double turns = Math.rint(x * TWO_OVER_PI);
        double head = x - turns * PART_1;
        double tail = turns * PART_2;
        double r = head - tail;
        double low = head - r - tail - turns * PART_3;
        return switch ((int) turns & 3) {
            case 0 -> cosine(r, low);
            case 1 -> -sine(r, low);
            case 2 -> -cosine(r, low);
            default -> sine(r, low);
        };
    }

    /**
     * Cosine and sine of one angle: the same bits as {@link #cos} and {@link #sin}, with one reduction for both.
     *
     * @param x rad
     * @param out gets cos x at index {@code at} and sin x behind it
     * @param at index into {@code out}
     * @throws IndexOutOfBoundsException if {@code out} has no such places
     */
    public static void sinCos(double x, double[] out, int at) {
        if (x == 0) {
            out[at] = 1;
            out[at + 1] = x;
            return;
        }
        if (!(Math.abs(x) < LARGE)) {
            out[at] = StrictMath.cos(x);
            out[at + 1] = StrictMath.sin(x);
            return;
        }
        double turns = Math.rint(x * TWO_OVER_PI);
        double head = x - turns * PART_1;
        double tail = turns * PART_2;
        double r = head - tail;
        double low = head - r - tail - turns * PART_3;
        double cos = cosine(r, low);
        double sin = sine(r, low);
        // no branches, since nobody could foretell the quarter of an angle: exchange by a mask, then the signs
        long quarter = (long) turns;
        long cosBits = Double.doubleToRawLongBits(cos);
        long sinBits = Double.doubleToRawLongBits(sin);
        long exchange = (cosBits ^ sinBits) & -(quarter & 1);
        out[at] = Double.longBitsToDouble(cosBits ^ exchange ^ (quarter + 1 & 2) << 62);
        out[at + 1] = Double.longBitsToDouble(sinBits ^ exchange ^ (quarter & 2) << 62);
    }

    /**
     * Angle of a vector; {@code StrictMath}'s, whose bits Java defines.
     *
     * @param y second component
     * @param x first component
     * @return rad, from −π to π; NaN if a component is NaN
     */
    public static double atan2(double y, double x) {
        return StrictMath.atan2(y, x);
    }

    /** sin(x + low) for |x| ≤ π/4 and a tiny low. */
    private static double sine(double x, double low) {
        double z = x * x;
        double p = 8.33333333332248946124e-03
                + z * (-1.98412698298579493134e-04
                        + z * (2.75573137070700676789e-06
                                + z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)));
        double v = z * x;
        return x - ((z * (0.5 * low - v * p) - low) - v * -1.66666666666666324348e-01);
    }

    /** cos(x + low) for |x| ≤ π/4 and a tiny low. */
    private static double cosine(double x, double low) {
        double z = x * x;
        double p = z * (4.16666666666666019037e-02
                + z * (-1.38888888888741095749e-03
                        + z * (2.48015872894767294178e-05
                                + z * (-2.75573143513906633035e-07
                                        + z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)))));
        double half = 0.5 * z;
        double w = 1 - half;
        return w + (((1 - w) - half) + (z * p - x * low));
    }
}
