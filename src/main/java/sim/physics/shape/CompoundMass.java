// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.shape;

import java.util.Objects;
import sim.physics.internal.Check;

/** Area, centroid and moment of inertia of convex parts that are one shape, and the parts about that centroid. */
final class CompoundMass {
    /** Numbers that a disc is given by. */
    private static final int DISC = 3;

    final ConvexPart[] parts;

    private final double area;
    private final double centroidX;
    private final double centroidY;
    private double unitInertia;

    CompoundMass(double[][] given) {
        Objects.requireNonNull(given, "parts");
        if (given.length == 0 || given.length > Compound.MOST_PARTS) {
            throw new IllegalArgumentException(
                    "a compound was given " + given.length + " parts: it needs 1 to " + Compound.MOST_PARTS);
        }
        Piece[] pieces = new Piece[given.length];
        for (int k = 0; k < given.length; k++) {
            pieces[k] = piece(k, Objects.requireNonNull(given[k], "parts[" + k + "]").clone(), given[0]);
        }
        double sum = 0;
        double x = 0;
        double y = 0;
        for (Piece piece : pieces) {
            double own = piece.mass.area();
            sum += own;
            x += own * piece.centreX;
            y += own * piece.centreY;
        }
        area = sum;
        double cx = x / area;
        double cy = y / area;
        centroidX = given[0][0] + cx;
        centroidY = given[0][1] + cy;
        parts = new ConvexPart[given.length];
        for (int k = 0; k < given.length; k++) {
            Piece piece = pieces[k];
            parts[k] = part(k, piece, cx, cy);
            double dx = piece.centreX - cx;
            double dy = piece.centreY - cy;
            unitInertia += piece.mass.area() / area * (piece.mass.unitInertia() + (dx * dx + dy * dy));
        }
    }

    /**
     * A part, relative to the first coordinates of all, so that nothing more is lost far from the origin.
     *
     * @param vertices counter-clockwise
     */
    private record Piece(double[] vertices, double radius, MassProperties mass, double centreX, double centreY) {}

    private static Piece piece(int k, double[] given, double[] origin) {
        try {
            if (given.length == DISC) {
                double[] centre = {Check.finite("x", given[0]) - origin[0], Check.finite("y", given[1]) - origin[1]};
                return new Piece(centre, given[2], new Circle(given[2]).massProperties(), centre[0], centre[1]);
            }
            PolygonMass mass = PolygonMass.centred(given);
            mass.properties.requireUsable("a polygon of " + given.length / 2 + " vertices");
            double[] near = new double[given.length];
            for (int m = 0; m < near.length; m += 2) {
                near[m] = mass.given[m] - origin[0];
                near[m + 1] = mass.given[m + 1] - origin[1];
            }
            // the centroid: the first vertex less its place about it
            return new Piece(near, 0, mass.properties, near[0] - mass.local[0], near[1] - mass.local[1]);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("part " + k + " of the compound: " + e.getMessage(), e);
        }
    }

    private static ConvexPart part(int k, Piece piece, double cx, double cy) {
        double[] local = new double[piece.vertices.length];
        for (int m = 0; m < local.length; m += 2) {
            local[m] = piece.vertices[m] - cx;
            local[m + 1] = piece.vertices[m + 1] - cy;
        }
        if (piece.radius == 0) {
            piece(k, local.clone(), new double[2]); // its corners may be lost in rounding, far from the others
        }
        return new ConvexPart(local, piece.radius, piece.mass);
    }

    double[] allVertices() {
        int length = 0;
        for (ConvexPart part : parts) {
            length += 2 * part.vertexCount();
        }
        double[] all = new double[length];
        int at = 0;
        for (ConvexPart part : parts) {
            double[] vertices = part.copyVertices();
            System.arraycopy(vertices, 0, all, at, vertices.length);
            at += vertices.length;
        }
        return all;
    }

    double boundingRadius() {
        double most = 0;
        for (ConvexPart part : parts) {
            most = Math.max(most, part.boundingRadius());
        }
        return most;
    }

    MassProperties properties() {
        return new MassProperties(area, centroidX, centroidY, unitInertia);
    }
}
