// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import sim.physics.shape.Shape;

/**
 * A shape's corners and the outward normals of its edges, in the body's own frame; one for all bodies of a shape. That of a shape of
 * several parts has the corners of all, which give its box, and the hulls of its parts, which touch others.
 */
final class Hull implements Serializable {
    private static final long serialVersionUID = 2L;

    final Shape shape;

    /** How many bodies have it. */
    int users;

    /** Number of corners; 1: a circle. */
    final int count;

    /** Of a circle; the largest one of the parts. */
    final double radius;

    final double bounding;
    final double[] x;
    final double[] y;

    /** Normals of the edges from each corner to the next one. */
    final double[] nx;

    final double[] ny;

    private final Hull[] parts;

    Hull(Shape shape) {
        this.shape = shape;
        count = shape.vertexCount();
        radius = radius(shape);
        bounding = shape.boundingRadius();
        x = new double[count];
        y = new double[count];
        nx = new double[count];
        ny = new double[count];
        for (int k = 0; k < count; k++) {
            x[k] = shape.vertexX(k);
            y[k] = shape.vertexY(k);
        }
        for (int k = 0; count > 1 && k < count; k++) {
            int next = k + 1 < count ? k + 1 : 0;
            double ex = x[next] - x[k];
            double ey = y[next] - y[k];
            double length = Math.sqrt(ex * ex + ey * ey);
            nx[k] = ey / length;
            ny[k] = -ex / length;
        }
        parts = new Hull[shape.partCount()];
        for (int k = 0; k < parts.length; k++) {
            parts[k] = parts.length == 1 ? this : new Hull(shape.part(k));
        }
    }

    private static double radius(Shape shape) {
        double most = 0;
        for (int k = 0; k < shape.partCount(); k++) {
            most = Math.max(most, shape.part(k).radius());
        }
        return most;
    }

    Hull part(int k) {
        return parts[k];
    }

    int next(int k) {
        return k + 1 < count ? k + 1 : 0;
    }

    /** The corner that is lowest along a direction. */
    int lowest(double dx, double dy) {
        int lowest = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int m = 0; m < count; m++) {
            double height = dx * x[m] + dy * y[m];
            if (height < least) {
                least = height;
                lowest = m;
            }
        }
        return lowest;
    }
}
