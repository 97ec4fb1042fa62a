// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.shape;

import java.util.Objects;

/** Area, centroid and moment of inertia of convex polygons that are one shape, and the polygons about that centroid. */
final class CompoundMass {
    final ConvexPart[] parts;

    private final double area;
    private final double centroidX;
    private final double centroidY;
    private double unitInertia;

    CompoundMass(double[][] polygons) {
        Objects.requireNonNull(polygons, "polygons");
        if (polygons.length == 0 || polygons.length > Compound.MOST_PARTS) {
            throw new IllegalArgumentException(
                    "a compound was given " + polygons.length + " polygons: it needs 1 to " + Compound.MOST_PARTS);
        }
        double[][] near = new double[polygons.length][];
        PolygonMass[] masses = new PolygonMass[polygons.length];
        for (int k = 0; k < polygons.length; k++) {
            Objects.requireNonNull(polygons[k], "polygons[" + k + "]");
            masses[k] = mass(k, polygons[k].clone());
            near[k] = relative(masses[k].given, polygons[0]);
        }
        double sum = 0;
        double x = 0;
        double y = 0;
        double[][] centres = new double[polygons.length][];
        for (int k = 0; k < polygons.length; k++) {
            centres[k] = centre(near[k], masses[k]);
            double own = masses[k].properties.area();
            sum += own;
            x += own * centres[k][0];
            y += own * centres[k][1];
        }
        area = sum;
        double cx = x / area;
        double cy = y / area;
        centroidX = polygons[0][0] + cx;
        centroidY = polygons[0][1] + cy;
        parts = new ConvexPart[polygons.length];
        for (int k = 0; k < polygons.length; k++) {
            parts[k] = part(k, near[k], cx, cy, masses[k].properties);
            double dx = centres[k][0] - cx;
            double dy = centres[k][1] - cy;
            MassProperties own = masses[k].properties;
            unitInertia += own.area() / area * (own.unitInertia() + (dx * dx + dy * dy));
        }
    }

    private static PolygonMass mass(int k, double[] xy) {
        try {
            PolygonMass mass = PolygonMass.centred(xy);
            mass.properties.requireUsable("a polygon of " + xy.length / 2 + " vertices");
            return mass;
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("polygon " + k + " of the compound: " + e.getMessage(), e);
        }
    }

    /** The vertices counter-clockwise, and relative to the first one of all, so that nothing more is lost far from the origin. */
    private static double[] relative(double[] xy, double[] origin) {
        double[] near = new double[xy.length];
        for (int k = 0; k < xy.length; k += 2) {
            near[k] = xy[k] - origin[0];
            near[k + 1] = xy[k + 1] - origin[1];
        }
        return near;
    }

    /** The centroid in the same coordinates: the first vertex less its place about the centroid. */
    private static double[] centre(double[] near, PolygonMass mass) {
        return new double[] {near[0] - mass.local[0], near[1] - mass.local[1]};
    }

    private static ConvexPart part(int k, double[] near, double cx, double cy, MassProperties own) {
        double[] local = new double[near.length];
        for (int m = 0; m < near.length; m += 2) {
            local[m] = near[m] - cx;
            local[m + 1] = near[m + 1] - cy;
        }
        mass(k, local.clone()); // its corners may be lost in rounding, far from the others
        return new ConvexPart(local, own);
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

    MassProperties properties() {
        return new MassProperties(area, centroidX, centroidY, unitInertia);
    }
}
