// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.shape;

import java.io.Serializable;
import java.util.Arrays;
import java.util.Objects;
import sim.physics.internal.Check;

/**
 * The shape of a body: all points within a radius of a convex polygon, which is called the core. The core of a circle is a point,
 * and the radius of a polygon is 0. A {@link Compound} consists of several such parts. Coordinates are local, with the centroid
 * as their origin. Shapes are immutable and may be shared by threads.
 *
 * <p>Two shapes are equal if they are of one class and have the same radius and the same vertices, to the bit and in the same
 * order. The place at which a polygon was given does not matter.
 */
public abstract sealed class Shape implements Serializable permits Circle, Rectangle, Polygon, Compound, ConvexPart {
    private static final long serialVersionUID = 1L;

    /** Vertices of the core, counter-clockwise: x0, y0, x1, y1 … */
    private final double[] vertices;

    private final double radius;
    private final MassProperties massProperties;
    private final double boundingRadius;

    Shape(double[] vertices, double radius, MassProperties massProperties) {
        this(vertices, radius, massProperties, core(vertices) + radius);
    }

    Shape(double[] vertices, double radius, MassProperties massProperties, double boundingRadius) {
        this.vertices = vertices;
        this.radius = radius;
        this.massProperties = massProperties;
        this.boundingRadius = boundingRadius;
    }

    private static double core(double[] vertices) {
        double core = 0;
        for (int k = 0; k < vertices.length; k += 2) {
            double x = vertices[k];
            double y = vertices[k + 1];
            core = Math.max(core, Math.sqrt(x * x + y * y));
        }
        return core;
    }

    /**
     * Returns the number of convex parts.
     *
     * @return 1, except for a {@link Compound}
     */
    public int partCount() {
        return 1;
    }

    /**
     * Returns a convex part.
     *
     * @param part number of the part, from 0
     * @return the part, in the coordinates of the whole shape; the shape itself if it is convex
     * @throws IndexOutOfBoundsException if there is no such part
     */
    public Shape part(int part) {
        Objects.checkIndex(part, 1);
        return this;
    }

    /** Whether another shape of the same class and vertices has the same parts. */
    boolean isCutAs(Shape that) {
        return true;
    }

    /**
     * Returns the number of vertices of the core.
     *
     * @return 1 for a circle
     */
    public final int vertexCount() {
        return vertices.length / 2;
    }

    /**
     * Returns the x coordinate of a vertex of the core. The vertices go round counter-clockwise, from the x axis to the y axis.
     *
     * @param vertex number of the vertex, from 0
     * @return x, length
     * @throws IndexOutOfBoundsException if there is no such vertex
     */
    public final double vertexX(int vertex) {
        return vertices[2 * vertex];
    }

    /**
     * Returns the y coordinate of a vertex of the core.
     *
     * @param vertex number of the vertex, from 0
     * @return y, length
     * @throws IndexOutOfBoundsException if there is no such vertex
     */
    public final double vertexY(int vertex) {
        return vertices[2 * vertex + 1];
    }

    /**
     * Returns the vertices of the core.
     *
     * @return x0, y0, x1, y1 …; a copy
     */
    public final double[] copyVertices() {
        return vertices.clone();
    }

    /**
     * Returns the distance by which the shape reaches beyond its core.
     *
     * @return length; 0 for polygons, and for shapes of several parts, each of which may have a radius of its own
     */
    public final double radius() {
        return radius;
    }

    /**
     * Returns the distance from the centroid to the farthest point of the shape.
     *
     * @return length
     */
    public final double boundingRadius() {
        return boundingRadius;
    }

    /**
     * Returns the area.
     *
     * @return length²
     */
    public final double area() {
        return massProperties.area();
    }

    /**
     * Returns the moment of inertia about the centroid, per unit of mass.
     *
     * @return length²
     */
    public final double unitInertia() {
        return massProperties.unitInertia();
    }

    /**
     * Returns the area, the centroid and the moment of inertia.
     *
     * @return never null
     */
    public final MassProperties massProperties() {
        return massProperties;
    }

    /**
     * Returns whether a point is in the shape or on its border.
     *
     * @param x x of the point, in local coordinates
     * @param y y of the point, in local coordinates
     * @return true if the point is in the shape or on its border
     * @throws IllegalArgumentException if a number is not finite
     */
    public final boolean contains(double x, double y) {
        Check.finite("x", x);
        Check.finite("y", y);
        int count = partCount();
        if (count > 1) {
            boolean is = false;
            for (int k = 0; k < count; k++) {
                is |= part(k).contains(x, y);
            }
            return is;
        }
        int n = vertexCount();
        if (n == 1) {
            double dx = x - vertexX(0);
            double dy = y - vertexY(0);
            return dx * dx + dy * dy <= radius * radius;
        }
        for (int k = 0; k < n; k++) {
            int next = (k + 1) % n;
            double ex = vertexX(next) - vertexX(k);
            double ey = vertexY(next) - vertexY(k);
            if (ex * (y - vertexY(k)) - ey * (x - vertexX(k)) < 0) {
                return false;
            }
        }
        return true;
    }

    @Override
    public final boolean equals(Object other) {
        return other instanceof Shape that
                && that.getClass() == getClass()
                && that.radius == radius
                && Arrays.equals(that.vertices, vertices)
                && isCutAs(that);
    }

    @Override
    public final int hashCode() {
        return 31 * Arrays.hashCode(vertices) + Double.hashCode(radius);
    }
}
