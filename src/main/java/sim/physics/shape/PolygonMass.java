// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.shape;

/**
 * Area, centroid and moment of inertia of a polygon, by triangles that have vertex 0 in common.
 *
 * <p>Coordinates are taken relative to that vertex together with the rounding error of the subtraction, so that nothing
 * is lost far from the origin and slivers keep their area. The triangles of a convex polygon have one sign and the
 * second moments are sums of squares, so that nothing cancels. A power of two keeps the numbers near 1.
 */
final class PolygonMass {
    /** In the author's coordinates. */
    final MassProperties properties;

    /** The vertices counter-clockwise and relative to the centroid; and as they were given. */
    final double[] local;

    final double[] given;

    private PolygonMass(MassProperties properties, double[] local, double[] given) {
        this.properties = properties;
        this.local = local;
        this.given = given;
    }

    /** For vertices in any coordinates and either sense, which are checked here. */
    static PolygonMass centred(double[] given) {
        PolygonCheck check = new PolygonCheck(given);
        double[] xy = check.sense() > 0 ? given : reversed(given);
        double scale = check.scale();
        Sums sums = new Sums(xy, scale);
        double cx = sums.cx / scale;
        double cy = sums.cy / scale;
        double[] local = new double[xy.length];
        for (int k = 0; k < xy.length; k += 2) {
            double x = xy[k] - xy[0];
            double y = xy[k + 1] - xy[1];
            local[k] = x - cx + lost(xy[k], xy[0], x);
            local[k + 1] = y - cy + lost(xy[k + 1], xy[1], y);
        }
        check.requireStillConvex(local);
        return new PolygonMass(sums.properties(xy[0] + cx, xy[1] + cy, scale), local, xy);
    }

    /** For vertices that go counter-clockwise about their centroid, the origin. */
    static PolygonMass aboutOrigin(double[] xy) {
        double scale = Math.scalb(1.0, -Math.getExponent(xy[0]));
        return new PolygonMass(new Sums(xy, scale).properties(0, 0, scale), xy, xy);
    }

    private static double[] reversed(double[] xy) {
        double[] r = new double[xy.length];
        for (int k = 0; k < xy.length; k += 2) {
            r[k] = xy[xy.length - 2 - k];
            r[k + 1] = xy[xy.length - 1 - k];
        }
        return r;
    }

    /** What rounding took from the difference a − b (Knuth). */
    private static double lost(double a, double b, double difference) {
        double minusB = difference - a;
        return (a - (difference - minusB)) - (b + minusB);
    }

    /** Sums over the triangles, for coordinates multiplied by a power of two; centroid relative to vertex 0. */
    private static final class Sums {
        final double area;
        final double cx;
        final double cy;
        final double unitInertia;

        Sums(double[] xy, double scale) {
            int n = xy.length / 2;
            double[] crosses = new double[n];
            Sum twiceArea = new Sum();
            Sum mx = new Sum();
            Sum my = new Sum();
            for (int k = 1; k + 1 < n; k++) {
                double cross = cross(xy, 2 * k, scale);
                crosses[k] = cross;
                twiceArea.add(cross);
                mx.add(cross * (scale * (xy[2 * k] - xy[0]) + scale * (xy[2 * k + 2] - xy[0])));
                my.add(cross * (scale * (xy[2 * k + 1] - xy[1]) + scale * (xy[2 * k + 3] - xy[1])));
            }
            area = 0.5 * twiceArea.total();
            cx = mx.total() / (3 * twiceArea.total());
            cy = my.total() / (3 * twiceArea.total());
            Sum inertia = new Sum();
            for (int k = 1; k + 1 < n; k++) {
                // corners p = −c, a, b of the triangle relative to the centroid
                double ax = scale * (xy[2 * k] - xy[0]) - cx;
                double ay = scale * (xy[2 * k + 1] - xy[1]) - cy;
                double bx = scale * (xy[2 * k + 2] - xy[0]) - cx;
                double by = scale * (xy[2 * k + 3] - xy[1]) - cy;
                double sumX = ax + bx - cx;
                double sumY = ay + by - cy;
                double squares = cx * cx + cy * cy + ax * ax + ay * ay + bx * bx + by * by;
                inertia.add(crosses[k] * (squares + sumX * sumX + sumY * sumY));
            }
            unitInertia = inertia.total() / (12 * twiceArea.total());
        }

        MassProperties properties(double centroidX, double centroidY, double scale) {
            return new MassProperties(area / scale / scale, centroidX, centroidY, unitInertia / scale / scale);
        }

        /** Twice the area of the triangle of vertex 0, the one at index i and the next. */
        private static double cross(double[] xy, int i, double scale) {
            double ax = xy[i] - xy[0];
            double ay = xy[i + 1] - xy[1];
            double bx = xy[i + 2] - xy[0];
            double by = xy[i + 3] - xy[1];
            double lostAx = scale * lost(xy[i], xy[0], ax);
            double lostAy = scale * lost(xy[i + 1], xy[1], ay);
            double lostBx = scale * lost(xy[i + 2], xy[0], bx);
            double lostBy = scale * lost(xy[i + 3], xy[1], by);
            ax *= scale;
            ay *= scale;
            bx *= scale;
            by *= scale;
            // ax·by − ay·bx right to the last bit or two (Kahan), then what the differences had lost
            double w = ay * bx;
            double cross = Math.fma(ax, by, -w) + Math.fma(-ay, bx, w);
            return cross + ((ax * lostBy - ay * lostBx) + (lostAx * by - lostAy * bx));
        }
    }

    /** A compensated sum (Neumaier 1974). */
    private static final class Sum {
        private double sum;
        private double lost;

        void add(double value) {
            double next = sum + value;
            lost += Math.abs(sum) >= Math.abs(value) ? (sum - next) + value : (value - next) + sum;
            sum = next;
        }

        double total() {
            return sum + lost;
        }
    }
}
