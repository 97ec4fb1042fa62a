// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import sim.physics.shape.Shape;

/** The corners of a convex polygon that is put somewhere, or the centre of a disc. */
final class Corners {
    double[] x = new double[8];
    double[] y = new double[8];
    int count;
    double radius;

    void put(Shape part, double cx, double cy, double cos, double sin) {
        count = part.vertexCount();
        radius = part.radius();
        if (x.length < count) {
            x = new double[count];
            y = new double[count];
        }
        for (int k = 0; k < count; k++) {
            x[k] = cx + (cos * part.vertexX(k) - sin * part.vertexY(k));
            y[k] = cy + (sin * part.vertexX(k) + cos * part.vertexY(k));
        }
    }

    private int next(int k) {
        return k + 1 < count ? k + 1 : 0;
    }

    double edgeX(int k) {
        return x[next(k)] - x[k];
    }

    double edgeY(int k) {
        return y[next(k)] - y[k];
    }

    double length(int k) {
        return Math.sqrt(edgeX(k) * edgeX(k) + edgeY(k) * edgeY(k));
    }

    /** How fast what moves in a direction rises from the line of an edge, times the edge's length. */
    double across(int k, double ddx, double ddy) {
        return ddx * edgeY(k) - ddy * edgeX(k);
    }

    /** Height of a point over the line of an edge, times the edge's length. */
    double over(int k, double px, double py) {
        return (px - x[k]) * edgeY(k) - (py - y[k]) * edgeX(k);
    }

    /** Height of the lowest corner of a polygon over the line of an edge, times the edge's length. */
    double least(int k, Corners from) {
        double ex = edgeX(k);
        double ey = edgeY(k);
        double least = Double.POSITIVE_INFINITY;
        for (int m = 0; m < from.count; m++) {
            least = Math.min(least, (from.x[m] - x[k]) * ey - (from.y[m] - y[k]) * ex);
        }
        return least;
    }

    /** Whether the line of an edge has all of a polygon beyond it, and no corner on it. */
    boolean parts(Corners from) {
        for (int k = 0; k < count; k++) {
            if (least(k, from) > 0) {
                return true;
            }
        }
        return false;
    }

    /** Square of the distance of a point from a polygon, 0 inside. */
    double square(double px, double py) {
        double least = Double.POSITIVE_INFINITY;
        boolean isInside = true;
        for (int k = 0; k < count; k++) {
            double ex = edgeX(k);
            double ey = edgeY(k);
            double qx = px - x[k];
            double qy = py - y[k];
            isInside &= qx * ey - qy * ex <= 0;
            least = Math.min(least, Outline.squareToEdge(qx, qy, ex, ey));
        }
        return isInside ? 0 : least;
    }
}
