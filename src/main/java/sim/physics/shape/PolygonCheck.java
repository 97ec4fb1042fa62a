// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.shape;

import java.math.BigDecimal;
import sim.physics.internal.Check;

/** Refuses vertices that are not those of a strictly convex polygon, and says which vertex is to blame. */
final class PolygonCheck {
    /** A corner whose turn has a sine of this or less counts as collinear. */
    private static final double COLLINEAR = 1e-12;

    /** Above this, relative to the edges' lengths, rounding neither changes a turn's sign nor takes it to the limit. */
    private static final double CLEAR = 2e-12;

    /** Sizes beyond 2^±this have squares near the ends of the range of numbers. */
    private static final int SIZE = 510;

    /** Up to so many vertices the cause of a refusal is looked for among all pairs of them. */
    private static final int SMALL = 1000;

    /** As the author gave them. */
    private final double[] given;

    /** The same times a power of two, so that the size is about 1. */
    private final double[] xy;

    private final int n;
    private final double scale;
    private final int sense;

    PolygonCheck(double[] given) {
        if (given.length < 6 || given.length % 2 != 0) {
            throw new IllegalArgumentException("a polygon was given " + given.length
                    + " coordinates: it needs x and y of at least 3 vertices");
        }
        this.given = given;
        n = given.length / 2;
        for (int k = 0; k < n; k++) {
            Check.finite("x of vertex " + k, given[2 * k]);
            Check.finite("y of vertex " + k, given[2 * k + 1]);
        }
        requireNeighboursApart();
        scale = scaleOf();
        xy = new double[given.length];
        for (int i = 0; i < xy.length; i++) {
            xy[i] = scale * given[i];
        }
        sense = senseAtLowest();
        for (int k = 0; k < n; k++) {
            int turn = turn(xy, before(k), k, after(k));
            if (turn == 0) {
                throw collinear(k);
            }
            if (turn != sense) {
                throw crossingOr(k, "the polygon is not convex there");
            }
        }
        requireOneTurn();
    }

    /** 1 if the vertices go counter-clockwise, −1 if clockwise. */
    int sense() {
        return sense;
    }

    /** A power of two that makes the size of the polygon about 1. */
    double scale() {
        return scale;
    }

    /** Refuses a polygon whose corners vanish in the rounding of the vertices relative to the centroid. */
    void requireStillConvex(double[] local) {
        double[] unit = new double[local.length];
        for (int i = 0; i < unit.length; i++) {
            unit[i] = scale * local[i];
        }
        for (int k = 0; k < n; k++) {
            if (turn(unit, before(k), k, after(k)) <= 0) {
                int index = sense > 0 ? k : n - 1 - k;
                throw refusal(index, "its corner is lost in rounding when the centroid is made the origin");
            }
        }
    }

    private int before(int k) {
        return k == 0 ? n - 1 : k - 1;
    }

    private int after(int k) {
        return k == n - 1 ? 0 : k + 1;
    }

    private void requireNeighboursApart() {
        for (int k = 1; k < n; k++) {
            requireApart(k, k - 1);
        }
        requireApart(n - 1, 0);
    }

    private void requireAllApart() {
        for (int k = 0; k < n && n <= SMALL; k++) {
            for (int j = 0; j < k; j++) {
                requireApart(k, j);
            }
        }
    }

    private void requireApart(int k, int j) {
        if (given[2 * k] == given[2 * j] && given[2 * k + 1] == given[2 * j + 1]) {
            throw refusal(k, "it coincides with vertex " + j);
        }
    }

    private double scaleOf() {
        double half = 0;
        int farthest = 0;
        for (int k = 1; k < n; k++) {
            double x = Math.abs(0.5 * given[2 * k] - 0.5 * given[0]);
            double y = Math.abs(0.5 * given[2 * k + 1] - 0.5 * given[1]);
            if (Math.max(x, y) > half) {
                half = Math.max(x, y);
                farthest = k;
            }
        }
        int exponent = Math.getExponent(half);
        if (Math.abs(exponent) > SIZE) {
            throw refusal(farthest, "it is too " + (exponent > 0 ? "far from" : "near") + " vertex 0, the area "
                    + (exponent > 0 ? "overflows" : "underflows"));
        }
        return Math.scalb(1.0, -exponent);
    }

    /** The sense of a simple polygon is that of its turn at an extreme vertex; the leftmost, of these the lowest. */
    private int senseAtLowest() {
        int low = 0;
        for (int k = 1; k < n; k++) {
            if (xy[2 * k] < xy[2 * low] || xy[2 * k] == xy[2 * low] && xy[2 * k + 1] < xy[2 * low + 1]) {
                low = k;
            }
        }
        int turn = turn(xy, before(low), low, after(low));
        if (turn == 0) {
            throw collinear(low);
        }
        return turn;
    }

    /** A polygon that only turns one way may still go round more than once: then it turns through the x axis twice. */
    private void requireOneTurn() {
        int rounds = 0;
        for (int k = 0; k < n; k++) {
            int next = after(k);
            double in = sense * (xy[2 * next + 1] - xy[2 * k + 1]);
            double out = sense * (xy[2 * after(next) + 1] - xy[2 * next + 1]);
            if (in < 0 && out >= 0 && ++rounds > 1) {
                throw crossingOr(next, "the polygon crosses itself, it winds more than once");
            }
        }
    }

    /** Names vertices that coincide, if there are; else vertex k. */
    private IllegalArgumentException collinear(int k) {
        requireAllApart();
        return refusal(k, "it lies on the line through its neighbours, vertices " + before(k) + " and " + after(k));
    }

    /** Names vertices that coincide or the first two edges that cross, if there are; else vertex k and the reason. */
    private IllegalArgumentException crossingOr(int k, String why) {
        requireAllApart();
        for (int i = 0; i < n && n <= SMALL; i++) {
            for (int j = i + 2; j < n; j++) {
                if (turn(xy, i, i + 1, j) * turn(xy, i, i + 1, after(j)) < 0
                        && turn(xy, j, after(j), i) * turn(xy, j, after(j), i + 1) < 0) {
                    return refusal(i, "the polygon crosses itself, the edge from there and the edge from vertex " + j);
                }
            }
        }
        return refusal(k, why);
    }

    private IllegalArgumentException refusal(int k, String why) {
        return new IllegalArgumentException(
                "vertex " + k + " is (" + given[2 * k] + ", " + given[2 * k + 1] + "): " + why);
    }

    /** Sign of the turn at vertex j on the way from i to k; 0 for a straight line, a reversal or a missing edge. */
    static int turn(double[] xy, int i, int j, int k) {
        double ax = xy[2 * j] - xy[2 * i];
        double ay = xy[2 * j + 1] - xy[2 * i + 1];
        double bx = xy[2 * k] - xy[2 * j];
        double by = xy[2 * k + 1] - xy[2 * j + 1];
        double cross = ax * by - ay * bx;
        double lengths = Math.sqrt(ax * ax + ay * ay) * Math.sqrt(bx * bx + by * by);
        if (Math.abs(cross) > CLEAR * lengths) {
            return cross > 0 ? 1 : -1;
        }
        double exact = exactCross(xy, i, j, k).doubleValue();
        return Math.abs(exact) <= COLLINEAR * lengths ? 0 : exact > 0 ? 1 : -1;
    }

    private static BigDecimal exactCross(double[] xy, int i, int j, int k) {
        BigDecimal ax = new BigDecimal(xy[2 * j]).subtract(new BigDecimal(xy[2 * i]));
        BigDecimal ay = new BigDecimal(xy[2 * j + 1]).subtract(new BigDecimal(xy[2 * i + 1]));
        BigDecimal bx = new BigDecimal(xy[2 * k]).subtract(new BigDecimal(xy[2 * j]));
        BigDecimal by = new BigDecimal(xy[2 * k + 1]).subtract(new BigDecimal(xy[2 * j + 1]));
        return ax.multiply(by).subtract(ay.multiply(bx));
    }
}
