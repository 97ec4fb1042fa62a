// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.shape;

/**
 * Area, centroid and moment of inertia of a polygon, by triangles that have vertex 0 in common. Coordinates are taken
 * relative to that vertex, so that nothing is lost far from the origin; all triangles of a convex polygon have the same
 * sign, so that nothing cancels.
 */
final class PolygonMass {
    private PolygonMass() {}

    /** For vertices in counter-clockwise order. */
    static MassProperties of(double[] xy) {
        int n = xy.length / 2;
        double area = 0;
        double mx = 0;
        double my = 0;
        for (int k = 1; k + 1 < n; k++) {
            double ax = xy[2 * k] - xy[0];
            double ay = xy[2 * k + 1] - xy[1];
            double bx = xy[2 * k + 2] - xy[0];
            double by = xy[2 * k + 3] - xy[1];
            double cross = cross(ax, ay, bx, by);
            area += 0.5 * cross;
            mx += cross * (ax + bx) / 6;
            my += cross * (ay + by) / 6;
        }
        double cx = mx / area;
        double cy = my / area;
        double inertia = 0;
        for (int k = 0; k < n; k++) {
            // triangles around the centroid: their second moments are sums of positive terms
            int next = (k + 1) % n;
            double ax = xy[2 * k] - xy[0] - cx;
            double ay = xy[2 * k + 1] - xy[1] - cy;
            double bx = xy[2 * next] - xy[0] - cx;
            double by = xy[2 * next + 1] - xy[1] - cy;
            inertia += cross(ax, ay, bx, by) * (ax * ax + ay * ay + ax * bx + ay * by + bx * bx + by * by) / 12;
        }
        return new MassProperties(area, xy[0] + cx, xy[1] + cy, inertia / area);
    }

    /** ax·by − ay·bx right to the last bit or two (Kahan): slivers keep their area. */
    private static double cross(double ax, double ay, double bx, double by) {
        double w = ay * bx;
        double error = Math.fma(-ay, bx, w);
        return Math.fma(ax, by, -w) + error;
    }
}
