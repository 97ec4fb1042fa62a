// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.shape;

import java.util.Objects;
import sim.physics.internal.Check;
import sim.physics.internal.Trig;

/**
 * A shape that is made of convex polygons and discs which keep their places to one another, so that a single body may be an L, a
 * cup, a gripper, a gear or a robot with two arms. It need not be convex nor all of one piece; its parts never collide with one
 * another.
 *
 * <p>The parts are given in common coordinates of the author's. They are moved so that the centroid of all is the
 * origin. Where parts overlap the area counts twice: let them touch instead, if the mass is to be that of the shape, or set the
 * body's mass and inertia. The vertices of a compound are those of its parts, one after the other, of a disc its centre.
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
     * Makes a shape of convex parts.
     *
     * @param parts at least one, each a polygon with its vertices in order, in either sense, x0, y0, x1, y1 …, or a disc with
     *     its centre and radius, x, y, r; length
     * @throws IllegalArgumentException if there is none, a polygon is not strictly convex, or a part cannot be used for another
     *     reason that {@link Polygon} or {@link Circle} has; the message names the part and the vertex
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
     * Makes a shape of a polygon that need not be convex. It is cut into convex ones; a vertex on the line through its neighbours is
     * left out.
     *
     * @param xy its vertices in order, in either sense: x0, y0, x1, y1 …, length
     * @return a compound of as few parts as are easily found
     * @throws IllegalArgumentException if there are fewer than three vertices, one is not finite, or the polygon crosses or
     *     touches itself
     */
    public static Compound outline(double... xy) {
        return new Compound(new Convexer(Objects.requireNonNull(xy, "xy")).parts());
    }

    /**
     * A disc, to be a part of a compound.
     *
     * @param x its centre, in the author's coordinates
     * @param y its centre
     * @param radius length, greater than 0
     * @return x, y, radius
     * @throws IllegalArgumentException if a number is not finite, or the radius not greater than 0
     */
    public static double[] disc(double x, double y, double radius) {
        return new double[] {Check.finite("x", x), Check.finite("y", y), Check.positive("radius", radius)};
    }

    /**
     * The vertices of a rectangle, to be a part of a compound.
     *
     * @param x its centre, in the author's coordinates
     * @param y its centre
     * @param width along x, length, greater than 0
     * @param height along y, length, greater than 0
     * @return x0, y0, x1, y1 …, four vertices
     * @throws IllegalArgumentException if a number is not finite, or a length not greater than 0
     */
    public static double[] box(double x, double y, double width, double height) {
        return box(x, y, width, height, 0);
    }

    /**
     * The vertices of a rectangle that is turned.
     *
     * @param x its centre, in the author's coordinates
     * @param y its centre
     * @param width length, greater than 0
     * @param height length, greater than 0
     * @param angle by which the width is turned from the x to the y axis, rad
     * @return x0, y0, x1, y1 …, four vertices
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
        return "Compound[" + parts.length + " parts, bounding radius " + boundingRadius() + "]";
    }
}
