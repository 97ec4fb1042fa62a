// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.shape;

import java.util.Objects;
import sim.physics.internal.Check;
import sim.physics.internal.Trig;

/**
 * A shape that consists of convex polygons and discs, which keep their places relative to one another. So a single body may be an
 * L, a cup, a gripper, a gear or a robot with two arms. A compound need not be convex, nor all in one piece. Its parts never
 * collide with one another.
 *
 * <p>Give all parts in the same coordinates. They are moved so that their common centroid is the origin. Where parts overlap,
 * their area counts twice. If the mass is to be that of the shape, let the parts touch instead, or set the body's mass and
 * inertia. The vertices of a compound are those of its parts, one part after the other; the vertex of a disc is its centre.
 *
 * <pre>
 *   new Compound(Compound.box(0, 0, 4, 1), Compound.box(-1.5, 1, 1, 1), Compound.box(1.5, 1, 1, 1)); // a U
 *   new Compound(Compound.disc(0, 0, 2), Compound.box(2.4, 1, 1, 0.2), Compound.box(2.4, -1, 1, 0.2)); // a robot with a gripper
 *   Compound.outline(0, 0, 4, 0, 4, 1, 1, 1, 1, 3, 0, 3);                                            // an L
 * </pre>
 */
public final class Compound extends Shape {
    private static final long serialVersionUID = 1L;

    /** Most parts of a shape, so that a pair of parts fits into a number. */
    static final int MOST_PARTS = 1 << 15;

    private final ConvexPart[] parts;

    /**
     * Creates a shape from convex parts.
     *
     * @param parts at least one part: a polygon with its vertices in order, clockwise or counter-clockwise, x0, y0, x1, y1 …, or
     *     a disc with its centre and radius, x, y, r; length
     * @throws IllegalArgumentException if there is no part, a polygon is not strictly convex, or {@link Polygon} or
     *     {@link Circle} would refuse a part for another reason; the message names the part and the vertex
     */
    public Compound(double[]... parts) {
        this(new CompoundMass(parts));
    }

    private Compound(CompoundMass mass) {
        super(
                mass.allVertices(),
                mass.parts.length == 1 ? mass.parts[0].radius() : 0,
                mass.properties().requireUsable("a compound of " + mass.parts.length + " parts"),
                mass.boundingRadius());
        parts = mass.parts;
    }

    /**
     * Returns the shape of a polygon that need not be convex. The polygon is cut into convex ones. A vertex on the line through
     * its neighbours is left out.
     *
     * @param xy its vertices in order, clockwise or counter-clockwise: x0, y0, x1, y1 …, length
     * @return a compound with as few parts as can easily be found
     * @throws IllegalArgumentException if there are fewer than three vertices, one is not finite, or the polygon crosses or
     *     touches itself
     */
    public static Compound outline(double... xy) {
        return new Compound(new Convexer(Objects.requireNonNull(xy, "xy")).parts());
    }

    /**
     * Returns a disc, as a part of a compound.
     *
     * @param x x of its centre, in the coordinates of all parts
     * @param y y of its centre
     * @param radius length, greater than 0
     * @return x, y, radius
     * @throws IllegalArgumentException if a number is not finite, or the radius not greater than 0
     */
    public static double[] disc(double x, double y, double radius) {
        return new double[] {Check.finite("x", x), Check.finite("y", y), Check.positive("radius", radius)};
    }

    /**
     * Returns the vertices of a rectangle, as a part of a compound.
     *
     * @param x x of its centre, in the coordinates of all parts
     * @param y y of its centre
     * @param width extent along x, length, greater than 0
     * @param height extent along y, length, greater than 0
     * @return the four vertices: x0, y0, x1, y1 …
     * @throws IllegalArgumentException if a number is not finite, or a length not greater than 0
     */
    public static double[] box(double x, double y, double width, double height) {
        return box(x, y, width, height, 0);
    }

    /**
     * Returns the vertices of a rectangle that is turned.
     *
     * @param x x of its centre, in the coordinates of all parts
     * @param y y of its centre
     * @param width length, greater than 0
     * @param height length, greater than 0
     * @param angle angle of its width from the x axis towards the y axis, rad
     * @return the four vertices: x0, y0, x1, y1 …
     * @throws IllegalArgumentException if a number is not finite, or a length not greater than 0
     */
    public static double[] box(double x, double y, double width, double height, double angle) {
        Check.finite("x", x);
        Check.finite("y", y);
        double cos = Trig.cos(Check.finite("angle", angle));
        double sin = Trig.sin(angle);
        double a = 0.5 * Check.positive("width", width);
        double b = 0.5 * Check.positive("height", height);
        double[] xy = {-a, -b, a, -b, a, b, -a, b};
        for (int k = 0; k < xy.length; k += 2) {
            double u = xy[k];
            xy[k] = x + (cos * u - sin * xy[k + 1]);
            xy[k + 1] = y + (sin * u + cos * xy[k + 1]);
        }
        return xy;
    }

    @Override
    public int partCount() {
        return parts.length;
    }

    @Override
    public Shape part(int part) {
        Objects.checkIndex(part, parts.length);
        return parts.length == 1 ? this : parts[part];
    }

    @Override
    boolean isCutAs(Shape that) {
        boolean yes = that.partCount() == parts.length;
        for (int k = 0; yes && k < parts.length && parts.length > 1; k++) {
            yes = that.part(k).equals(parts[k]);
        }
        return yes;
    }

    /**
     * Returns the x coordinate of the place where the centroid was.
     *
     * @return x in the coordinates in which the parts were given, length
     */
    public double centroidX() {
        return massProperties().centroidX();
    }

    /**
     * Returns the y coordinate of the place where the centroid was.
     *
     * @return y in the coordinates in which the parts were given, length
     */
    public double centroidY() {
        return massProperties().centroidY();
    }

    @Override
    public String toString() {
        return "Compound[" + parts.length + " parts, bounding radius " + boundingRadius() + "]";
    }
}
