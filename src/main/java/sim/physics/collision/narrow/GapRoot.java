// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

/** First roots of the lower bounds of {@link SeparatingLine}: polynomials of the fourth degree in time. */
final class GapRoot {
    private static final int NEWTON = 3;
    /** Part of the way to the root of a quadratic at which one of the whole polynomial is hardly passed. */
    private static final double SHORT = 1 - 0x1p-9;

    private static final double INFINITE = Double.POSITIVE_INFINITY;

    /** Bound of the fourth derivative, by 24; not negative. */
    double fourth;

    /** Gap at which surfaces touch. */
    double tolerance;

    /** Whether what {@link #before} returned is the root but for rounding, with or without the bound. */
    boolean sharp;

    /**
     * A time before which g + c1 s + c2 s² + c3 s³ − fourth s⁴ is positive: its first root if that is {@link #sharp}.
     *
     * @param beyond how far to look if that costs nothing
     * @param rest how far to look in any case, and for a sharp root
     */
    double before(double g, double c1, double c2, double c3, double beyond, double rest) {
        sharp = false;
        if (isPositive(g, c1, c2, c3, beyond)) {
            return INFINITE;
        }
        double d = c1 * c1 - 4 * c2 * g;
        if (c1 < 0 && d > 0) {
            double s = 2 * g / (Math.sqrt(d) - c1);
            double least = SHORT * s;
            if (fourth * least * least * least * least > tolerance && isBefore(least, g, c1, c2, c3)) {
                return Math.min(least, beyond); // it will not be sharp anyhow: the next look begins close enough to the root
            }
            double f = g + s * (c1 + s * (c2 + s * (c3 - s * fourth)));
            for (int k = 0; k < NEWTON && Math.abs(f) > 0.25 * tolerance; k++) {
                s -= f / (c1 + s * (2 * c2 + s * (3 * c3 - 4 * s * fourth)));
                f = g + s * (c1 + s * (c2 + s * (c3 - s * fourth)));
            }
            if (s > 0 && falls(s, c1, c2, c3) && Math.abs(f) <= 0.25 * tolerance) {
                sharp = s < rest && fourth * s * s * s * s <= 0.25 * tolerance;
                return Math.min(s, beyond);
            }
        }
        double far = boundedRoot(g, c1, c2, c3, beyond);
        return far >= rest ? far : Math.max(far, boundedRoot(g, c1, c2, c3, rest));
    }

    /** Whether the polynomial falls all the way to a time, and is positive there. */
    private boolean isBefore(double s, double g, double c1, double c2, double c3) {
        return falls(s, c1, c2, c3) && g + s * (c1 + s * (c2 + s * (c3 - s * fourth))) > 0;
    }

    private static boolean falls(double s, double c1, double c2, double c3) {
        return c1 + s * (2 * (c2 - fall(c2)) + 3 * s * (c3 - fall(c3))) < 0;
    }

    /** The same up to a time, with one bound for all terms but the first two. */
    private double boundedRoot(double g, double c1, double c2, double c3, double until) {
        double bound = until * until * fourth - fall(c2 + until * fall(c3));
        return Math.min(until, firstRoot(g, c1, bound));
    }

    /** Whether g + c1 s + c2 s² + c3 s³ − fourth s⁴ is positive up to a time; false may also mean not known. */
    boolean isPositive(double g, double c1, double c2, double c3, double s) {
        return g + s * (fall(c1) + s * (fall(c2) + s * (fall(c3) - s * fourth))) > 0;
    }

    /** The smaller of a number and 0; quicker than {@code Math.min}. */
    private static double fall(double c) {
        return 0.5 * (c - Math.abs(c));
    }

    /** First root of g + c1 s − bound s² for g ≥ 0 and a bound ≥ 0. */
    private static double firstRoot(double g, double c1, double bound) {
        double d = Math.sqrt(c1 * c1 + 4 * bound * g);
        if (c1 < 0) {
            return 2 * g / (d - c1);
        }
        return bound == 0 ? INFINITE : (d + c1) / (2 * bound);
    }

    /** How long a vertex that is on the line and rises at a rate c1 surely stays above it. */
    double parting(double c1, double c2, double c3, double beyond) {
        double bound = beyond * beyond * fourth - fall(c2 + beyond * fall(c3));
        return c1 >= beyond * bound ? INFINITE : c1 / bound;
    }
}
