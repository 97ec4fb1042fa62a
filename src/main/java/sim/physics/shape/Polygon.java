// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.shape;

import java.util.Objects;
import sim.physics.internal.Check;
import sim.physics.internal.Trig;

/**
 * A convex polygon. You may give its vertices in any coordinates, and clockwise or counter-clockwise. The polygon is moved so
 * that its centroid is the origin. Clockwise vertices are put into the opposite order.
 *
 * <p>Every corner must turn. A vertex is refused if it is on the line through its neighbours, or so near to it that the sine of
 * the turn is 10⁻¹² or less. The test is exact: it uses decimal arithmetic where floating point leaves a doubt. It is made again
 * after the move to the centroid, so the vertices of a polygon are always strictly convex.
 */
public final class Polygon extends Shape {
    private static final long serialVersionUID = 1L;

    /** With more vertices than this the corners of a regular polygon come near the limit of rounding. */
    private static final int MOST_REGULAR = 10_000_000;

    /**
     * Creates a convex polygon.
     *
     * @param xy its vertices in order: x0, y0, x1, y1 …, length
     * @throws IllegalArgumentException if there are fewer than three vertices, one is not finite, two coincide, the polygon is
     *     not strictly convex or crosses itself, or it is so large or small that its area or moment of inertia over- or
     *     underflows; the message names the vertex
     */
    public Polygon(double... xy) {
        this(PolygonMass.centred(Objects.requireNonNull(xy, "xy").clone()));
    }

    private Polygon(PolygonMass mass) {
        super(mass.local, 0, mass.properties.requireUsable("a polygon of " + mass.local.length / 2 + " vertices"));
    }

    /**
     * Returns a regular polygon. Its vertices are symmetric to the last bit: always about the x axis, about the y axis if their
     * number is even, and about the diagonals if it is divisible by 4.
     *
     * @param vertices number of vertices, 3 to 10,000,000
     * @param circumradius distance from the centre to the vertices, length, greater than 0
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
     * Returns the x coordinate of the place where the centroid was.
     *
     * @return x in the coordinates in which the vertices were given, length
     */
    public double centroidX() {
        return massProperties().centroidX();
    }

    /**
     * Returns the y coordinate of the place where the centroid was.
     *
     * @return y in the coordinates in which the vertices were given, length
     */
    public double centroidY() {
        return massProperties().centroidY();
    }

    @Override
    public String toString() {
        return "Polygon[" + vertexCount() + " vertices, bounding radius " + boundingRadius() + "]";
    }
}
