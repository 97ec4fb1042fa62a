// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.shape;

import java.math.BigDecimal;
import sim.physics.internal.Check;
import sim.physics.internal.Trig;

/**
 * A convex polygon. Its vertices are given in any coordinates and either sense of rotation; it is moved so that its
 * centroid is the origin, and turned round if they go clockwise.
 */
public final class Polygon extends Shape {
    private static final long serialVersionUID = 1L;

    /** A corner whose neighbours are this close to one line, relative to the edges' lengths, counts as collinear. */
    private static final double COLLINEAR = 1e-12;

    /**
     * Makes a convex polygon.
     *
     * @param xy its vertices in order: x0, y0, x1, y1 …
     * @throws IllegalArgumentException if there are fewer than three, one is not finite, or the polygon is not strictly
     *     convex; the message names the vertex
     */
    public Polygon(double... xy) {
        this(checked(xy), PolygonMass.of(checked(xy)));
    }

    private Polygon(double[] xy, MassProperties mass) {
        super(centred(xy, mass), 0, mass);
    }

    /**
     * Makes a regular polygon.
     *
     * @param vertices how many, at least 3
     * @param circumradius distance of the vertices from the centre, greater than 0
     * @return a polygon whose first vertex lies on the x axis
     */
    public static Polygon regular(int vertices, double circumradius) {
        if (vertices < 3) {
            throw new IllegalArgumentException("vertices is " + vertices + ": a polygon has at least 3");
        }
        Check.positive("circumradius", circumradius);
        double[] xy = new double[2 * vertices];
        for (int k = 0; k < vertices; k++) {
            // angles measured from the nearest axis, so that mirror images have the same bits
            double angle = 2 * Math.PI * k / vertices;
            double mirrored = 2 * Math.PI * (vertices - k) / vertices;
            boolean upper = 2 * k <= vertices;
            xy[2 * k] = circumradius * Trig.cos(upper ? angle : mirrored);
            double y = 2 * k == vertices ? 0 : circumradius * Trig.sin(upper ? angle : mirrored);
            xy[2 * k + 1] = upper ? y : -y;
        }
        return new Polygon(xy);
    }

    private static double[] centred(double[] xy, MassProperties mass) {
        double[] moved = new double[xy.length];
        for (int k = 0; k < xy.length; k += 2) {
            moved[k] = xy[k] - mass.centroidX();
            moved[k + 1] = xy[k + 1] - mass.centroidY();
        }
        return moved;
    }

    /** Checks the vertices and puts them in counter-clockwise order. */
    private static double[] checked(double[] xy) {
        if (xy.length < 6 || xy.length % 2 != 0) {
            throw new IllegalArgumentException(
                    "a polygon was given " + xy.length + " coordinates: it needs x and y of at least 3 vertices");
        }
        int n = xy.length / 2;
        for (int k = 0; k < n; k++) {
            Check.finite("x of vertex " + k, xy[2 * k]);
            Check.finite("y of vertex " + k, xy[2 * k + 1]);
        }
        int sense = 0;
        for (int k = 0; k < n; k++) {
            int turn = turn(xy, (k + n - 1) % n, k, (k + 1) % n);
            if (turn == 0) {
                throw refusal(xy, k, "it coincides with a neighbour or lies on the line through its neighbours");
            }
            if (sense != 0 && turn != sense) {
                throw refusal(xy, k, "the polygon is not convex there");
            }
            sense = turn;
        }
        checkOneTurn(xy, sense);
        return sense > 0 ? xy.clone() : reversed(xy);
    }

    /** A polygon that only turns one way may still go round more than once: then its direction passes the x axis twice. */
    private static void checkOneTurn(double[] xy, int sense) {
        int n = xy.length / 2;
        int crossings = 0;
        for (int k = 0; k < n; k++) {
            double before = sense * (xy[2 * ((k + 1) % n) + 1] - xy[2 * k + 1]);
            double after = sense * (xy[2 * ((k + 2) % n) + 1] - xy[2 * ((k + 1) % n) + 1]);
            if (before < 0 && after >= 0 && ++crossings > 1) {
                throw refusal(xy, (k + 1) % n, "the polygon crosses itself");
            }
        }
    }

    private static IllegalArgumentException refusal(double[] xy, int k, String why) {
        return new IllegalArgumentException(
                "vertex " + k + " is (" + xy[2 * k] + ", " + xy[2 * k + 1] + "): " + why);
    }

    /** Sign of the turn at vertex j on the way from i to k; 0 for a straight line, a reversal or a missing edge. */
    private static int turn(double[] xy, int i, int j, int k) {
        double ax = xy[2 * j] - xy[2 * i];
        double ay = xy[2 * j + 1] - xy[2 * i + 1];
        double bx = xy[2 * k] - xy[2 * j];
        double by = xy[2 * k + 1] - xy[2 * j + 1];
        double cross = ax * by - ay * bx;
        double scale = Math.sqrt((ax * ax + ay * ay) * (bx * bx + by * by));
        if (Math.abs(cross) > 1e-3 * scale) {
            return cross > 0 ? 1 : -1;
        }
        double exact = exactCross(xy, i, j, k).doubleValue();
        return Math.abs(exact) <= COLLINEAR * scale ? 0 : exact > 0 ? 1 : -1;
    }

    private static BigDecimal exactCross(double[] xy, int i, int j, int k) {
        BigDecimal ax = new BigDecimal(xy[2 * j]).subtract(new BigDecimal(xy[2 * i]));
        BigDecimal ay = new BigDecimal(xy[2 * j + 1]).subtract(new BigDecimal(xy[2 * i + 1]));
        BigDecimal bx = new BigDecimal(xy[2 * k]).subtract(new BigDecimal(xy[2 * j]));
        BigDecimal by = new BigDecimal(xy[2 * k + 1]).subtract(new BigDecimal(xy[2 * j + 1]));
        return ax.multiply(by).subtract(ay.multiply(bx));
    }

    private static double[] reversed(double[] xy) {
        double[] r = new double[xy.length];
        for (int k = 0; k < xy.length; k += 2) {
            r[k] = xy[xy.length - 2 - k];
            r[k + 1] = xy[xy.length - 1 - k];
        }
        return r;
    }

    @Override
    public String toString() {
        return "Polygon[" + vertexCount() + " vertices, bounding radius " + boundingRadius() + "]";
    }
}
