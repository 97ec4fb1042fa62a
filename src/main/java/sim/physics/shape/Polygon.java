// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.shape;

import java.util.Objects;
import sim.physics.internal.Check;
import sim.physics.internal.Trig;

/**
 * A convex polygon. Its vertices are given in any coordinates and either sense of rotation; it is moved so that its
 * centroid is the origin, and turned round if they go clockwise.
 *
 * <p>Every corner must turn: a vertex on the line through its neighbours, or so near it that the sine of the turn is
 * 10⁻¹² or less, is refused. The test is exact (decimal arithmetic where floating point leaves a doubt), and it is made
 * again after the move to the centroid, so that the vertices of a polygon are always strictly convex.
 */
public final class Polygon extends Shape {
    private static final long serialVersionUID = 1L;

    /** With more vertices than this the corners of a regular polygon come near the limit of rounding. */
    private static final int MOST_REGULAR = 10_000_000;

    /**
     * Makes a convex polygon.
     *
     * @param xy its vertices in order: x0, y0, x1, y1 …, length
     * @throws IllegalArgumentException if there are fewer than three, one is not finite, two coincide, the polygon is
     *     not strictly convex or crosses itself, or it is so large or small that its area or moment of inertia over-
     *     or underflows; the message names the vertex
     */
    public Polygon(double... xy) {
        this(PolygonMass.centred(Objects.requireNonNull(xy, "xy").clone()));
    }

    private Polygon(PolygonMass mass) {
        super(mass.local, 0, mass.properties.requireUsable("a polygon of " + mass.local.length / 2 + " vertices"));
    }

    /**
     * Makes a regular polygon. Its vertices are symmetric to the last bit: always about the x axis, about the y axis if
     * their number is even, about the diagonals if 4 divides it.
     *
     * @param vertices how many, 3 to 10,000,000
     * @param circumradius distance of the vertices from the centre, length, greater than 0
     * @return a polygon whose first vertex lies on the x axis
     * @throws IllegalArgumentException if an argument is out of its range
     */
    public static Polygon regular(int vertices, double circumradius) {
        if (vertices < 3 || vertices > MOST_REGULAR) {
            throw new IllegalArgumentException(
                    "vertices is " + vertices + ": a regular polygon has from 3 to " + MOST_REGULAR);
        }
        Check.positive("circumradius", circumradius);
        double[] xy = new double[2 * vertices];
        for (int k = 0; k < vertices; k++) {
            corner(k, vertices, circumradius, xy);
        }
        return new Polygon(PolygonMass.aboutOrigin(xy));
    }

    /** Vertex k of n: an angle of the first half quadrant, mirrored and turned, so that mirror images are exact. */
    private static void corner(int k, int n, double radius, double[] xy) {
        int quadrant = (int) (4L * k / n);
        int part = (int) (4L * k % n); // of n in the quadrant
        double angle = Math.PI * Math.min(part, n - part) / (2.0 * n);
        double near = radius * (2 * part == n ? Math.sqrt(0.5) : Trig.cos(angle));
        double far = radius * (2 * part == n ? Math.sqrt(0.5) : Trig.sin(angle));
        double c = 2 * part <= n ? near : far;
        double s = 2 * part <= n ? far : near;
        double x = (quadrant & 1) == 0 ? c : -s;
        double y = (quadrant & 1) == 0 ? s : c;
        // + 0 makes −0 to 0
        xy[2 * k] = (quadrant >= 2 ? -x : x) + 0.0;
        xy[2 * k + 1] = (quadrant >= 2 ? -y : y) + 0.0;
    }

    /**
     * Where the centroid was.
     *
     * @return x in the coordinates that the author gave, length
     */
    public double centroidX() {
        return massProperties().centroidX();
    }

    /**
     * Where the centroid was.
     *
     * @return y in the coordinates that the author gave, length
     */
    public double centroidY() {
        return massProperties().centroidY();
    }

    @Override
    public String toString() {
        return "Polygon[" + vertexCount() + " vertices, bounding radius " + boundingRadius() + "]";
    }
}
