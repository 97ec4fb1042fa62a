// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** A hit counts as clean only if the line of no edge but the one that is hit has all of the other body on it or beyond it. */
class CleanHitTest {
    private static final double TOLERANCE = 1e-14;

    private static final Shape[] SHAPES = {
        new Rectangle(1, 0.5),
        new Rectangle(40, 0.01),
        new Polygon(-0.5, -0.5, 0.7, -0.4, 0.1, 0.9),
        regular(6, 0.5),
        regular(400, 2),
    };

    private static Shape regular(int n, double radius) {
        double[] xy = new double[2 * n];
        for (int k = 0; k < n; k++) {
            xy[2 * k] = radius * StrictMath.cos(2 * Math.PI * k / n);
            xy[2 * k + 1] = radius * StrictMath.sin(2 * Math.PI * k / n);
        }
        return new Polygon(xy);
    }

    private final ShapeTable table = new ShapeTable();
    private double[] shape;

    /** Turns the second body so that its corner lies on an edge of the first one; heights are along that edge's normal. */
    private boolean isClean(int a, int edge, int b, double angle, double part, double turn) {
        int e = vertex(a, edge);
        double ox = StrictMath.cos(angle) * shape[e + ShapeTable.NX] + StrictMath.sin(angle) * shape[e + ShapeTable.NY];
        double oy = StrictMath.cos(angle) * shape[e + ShapeTable.NY] - StrictMath.sin(angle) * shape[e + ShapeTable.NX];
        int corner = table.lowestVertex(b, ox, oy);
        double at = part * shape[e + ShapeTable.LENGTH];
        boolean isClean = CleanHit.is(shape, a, edge, at, 0, b, corner, ox, oy, turn, TOLERANCE);
        if (isClean) {
            double x = shape[e] - at * shape[e + ShapeTable.NY];
            double y = shape[e + 1] + at * shape[e + ShapeTable.NX];
            assertThat(separatingEdges(a, b, corner, x, y, angle, edge)).isZero();
        }
        return isClean;
    }

    private static int vertex(int base, int k) {
        return base + ShapeTable.FIRST + ShapeTable.VERTEX * k;
    }

    /** How many edges but one have all vertices of the other body beyond their line, or within some tolerances of it. */
    private int separatingEdges(int a, int b, int corner, double x, double y, double angle, int hit) {
        int count = 0;
        double cos = StrictMath.cos(angle);
        double sin = StrictMath.sin(angle);
        int c = vertex(b, corner);
        for (int k = 0; k < shape[a]; k++) {
            double least = Double.POSITIVE_INFINITY;
            for (int m = 0; m < shape[b]; m++) {
                double dx = shape[vertex(b, m)] - shape[c];
                double dy = shape[vertex(b, m) + 1] - shape[c + 1];
                double px = x + cos * dx - sin * dy;
                double py = y + sin * dx + cos * dy;
                least = Math.min(least, height(a, k, px, py));
            }
            count += k != hit && least >= -100 * TOLERANCE ? 1 : 0;
        }
        for (int k = 0; k < shape[b]; k++) {
            double least = Double.POSITIVE_INFINITY;
            for (int m = 0; m < shape[a]; m++) {
                double dx = shape[vertex(a, m)] - x;
                double dy = shape[vertex(a, m) + 1] - y;
                double px = shape[c] + cos * dx + sin * dy;
                double py = shape[c + 1] + cos * dy - sin * dx;
                least = Math.min(least, height(b, k, px, py));
            }
            count += least >= -100 * TOLERANCE ? 1 : 0;
        }
        return count;
    }

    private double height(int base, int edge, double x, double y) {
        int e = vertex(base, edge);
        return shape[e + ShapeTable.NX] * x + shape[e + ShapeTable.NY] * y - shape[e + ShapeTable.H];
    }

    @Test
    void noOtherEdgeSeparatesTheBodiesOfACleanHit() {
        SplittableRandom random = new SplittableRandom(3);
        for (int k = 0; k < SHAPES.length; k++) {
            table.set(k, SHAPES[k]);
        }
        shape = table.data();
        int clean = 0;
        int all = 4000;
        for (int k = 0; k < all; k++) {
            int a = table.base(random.nextInt(SHAPES.length));
            int b = table.base(random.nextInt(SHAPES.length));
            int edge = random.nextInt((int) shape[a]);
            clean += isClean(a, edge, b, random.nextDouble(-4, 4), random.nextDouble(), 0) ? 1 : 0;
        }
        assertThat(clean).isBetween(all * 9 / 10, all);
        // near to the ends of the edge, and to lying flat on it: from far over the tolerance to far below it
        for (int k = 0; k < all; k++) {
            int a = table.base(random.nextInt(SHAPES.length));
            int b = table.base(0);
            double small = StrictMath.pow(10, random.nextDouble(-17, -5));
            int edge = random.nextInt((int) shape[a]);
            int e = vertex(a, edge);
            double flat = StrictMath.atan2(shape[e + ShapeTable.NY], shape[e + ShapeTable.NX]);
            isClean(a, edge, b, random.nextInt(4) * Math.PI / 2 + flat + small, random.nextDouble(), 0);
            isClean(a, edge, b, random.nextDouble(-4, 4), random.nextBoolean() ? small : 1 - small, 0);
        }
    }

    @Test
    void cornersOnCornersAndFlatEdgesAreNotClean() {
        table.set(0, SHAPES[0]);
        shape = table.data();
        int base = table.base(0);
        assertThat(isClean(base, 0, base, 0.5, 0.5, 0)).isTrue();
        assertThat(isClean(base, 0, base, 0.5, 0, 0)).isFalse();
        assertThat(isClean(base, 0, base, 0.5, 1, 0)).isFalse();
        assertThat(isClean(base, 0, base, 0, 0.5, 0)).isFalse();
        assertThat(isClean(base, 0, base, 0.5, 0.5, 0.6)).as("it may have turned flat").isFalse();
    }
}
