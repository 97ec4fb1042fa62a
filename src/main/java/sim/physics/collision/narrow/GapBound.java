// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

/**
 * For how long a gap is surely not negative, given how it changes now and bounds of what changes that:
 *
 * <pre>
 *   g(s)  ≥  g + g' s − M s²/2
 *   g(s)  ≥  g + g' s + g″ s²/2 − T s³/6
 *   g(s)  ≥  g + g' s + g″ s²/2 + g‴ s³/6 − F s⁴/24
 * </pre>
 *
 * <p>with M, T and F bounds of |g″|, |g‴| and |g⁗|. Bodies that lie on one another and push along hardly part or approach: where their gap is
 * next to nothing, only the last one says that they do not for the rest of a step.
 */
final class GapBound {
    /** How much farther a finer bound looks than what is known already, and how often in turn. */
    private static final double AHEAD = 3;

    private static final int TIMES = 8;

    private GapBound() {}

    /**
     * A time in which the gap is not negative by the finer bounds. Up to a time S these are as good as an M of −g″ + T S/3, or of
     * −g″ + max(0, −g‴) S/3 + F S²/12.
     *
     * @param gap that there is, at least 0
     * @param rate g'
     * @param curvature g″
     * @param third T
     * @param jerk g‴, where F is known
     * @param fourth F, or infinite
     * @param known a time that is known to be right
     * @param end up to which it matters
     */
    static double ahead(double gap, double rate, double curvature, double third, double jerk, double fourth, double known, double end) {
        double time = known;
        for (int k = 0; k < TIMES; k++) {
            double ahead = AHEAD * time;
            double ofThird = ahead * third / 3;
            double ofFourth = ahead * (Math.max(0, -jerk) / 3 + ahead * fourth / 12);
            double found = root(gap, rate, Math.max(0, Math.min(ofThird, ofFourth) - curvature));
            if (!(found > time)) {
                return time;
            }
            time = Math.min(ahead, found);
            if (found < ahead || time >= end || fourth == Double.POSITIVE_INFINITY) {
                return time;
            }
        }
        return time;
    }

    /** The time for which g' s + g″ s²/2 − T s³/6 is surely not negative, for g' ≥ 0: a gap that widens does so for a while. */
    static double rise(double rate, double curvature, double third) {
        double half = 0.5 * curvature;
        double d = Math.sqrt(half * half + 2 * third * rate / 3);
        if (curvature > 0) {
            return third == 0 ? Double.POSITIVE_INFINITY : 3 * (half + d) / third;
        }
        return rate == 0 ? 0 : 2 * rate / (d - half);
    }

    /** First root of g + g' s − M s²/2 for g ≥ 0 and M ≥ 0. */
    static double root(double gap, double rate, double bound) {
        if (bound == 0) {
            return rate < 0 ? gap / -rate : Double.POSITIVE_INFINITY;
        }
        double d = Math.sqrt(rate * rate + 2 * bound * gap);
        return rate < 0 ? 2 * gap / (d - rate) : (rate + d) / bound;
    }

    /** Bound of the fourth derivative of a unit vector that turns. */
    static double fourthOfTurn(double spin, double twist) {
        double square = spin * spin;
        return square * square + 6 * square * twist + 3 * twist * twist;
    }
}
