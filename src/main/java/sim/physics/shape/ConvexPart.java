// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.shape;

/** A convex polygon of a {@link Compound}: its origin is the centroid of the compound, and need not be in it. */
final class ConvexPart extends Shape {
    private static final long serialVersionUID = 1L;

    /** For vertices that go counter-clockwise, in the coordinates of the compound, and its own area and moment of inertia. */
    ConvexPart(double[] vertices, MassProperties massProperties) {
        super(vertices, 0, massProperties);
    }

    @Override
    public String toString() {
        return "ConvexPart[" + vertexCount() + " vertices]";
    }
}
