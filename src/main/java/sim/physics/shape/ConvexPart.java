// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.shape;

/** A convex polygon or a disc of a {@link Compound}: its origin is the centroid of the compound, and need not be in it. */
final class ConvexPart extends Shape {
    private static final long serialVersionUID = 1L;

    /**
     * Makes a part.
     *
     * @param vertices counter-clockwise, in the coordinates of the compound; the centre of a disc
     * @param radius 0 for a polygon
     * @param massProperties its own area, and its moment of inertia about its own centroid
     */
    ConvexPart(double[] vertices, double radius, MassProperties massProperties) {
        super(vertices, radius, massProperties);
    }

    @Override
    public String toString() {
        return vertexCount() == 1 ? "disc of radius " + radius() : "polygon of " + vertexCount() + " vertices";
    }
}
