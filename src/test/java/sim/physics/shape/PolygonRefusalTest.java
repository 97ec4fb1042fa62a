// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;

import org.junit.jupiter.api.Test;

/** What is no strictly convex polygon is refused, and the message names the vertex. */
class PolygonRefusalTest {
    private static void refused(String message, double... xy) {
        assertThatIllegalArgumentException().isThrownBy(() -> new Polygon(xy)).withMessage(message);
    }

    /** Vertices k·step of n on a circle. */
    private static double[] star(int n, int step, int count) {
        double[] xy = new double[2 * count];
        for (int k = 0; k < count; k++) {
            xy[2 * k] = Math.cos(2 * Math.PI * k * step / n);
            xy[2 * k + 1] = Math.sin(2 * Math.PI * k * step / n);
        }
        return xy;
    }

    @Test
    void tooFewOrHalfVertices() {
        String rule = " coordinates: it needs x and y of at least 3 vertices";
        refused("a polygon was given 0" + rule);
        refused("a polygon was given 4" + rule, 0, 0, 1, 1);
        refused("a polygon was given 5" + rule, 0, 0, 1, 0, 1);
        refused("a polygon was given 7" + rule, 0, 0, 1, 0, 1, 1, 0);
        assertThatNullPointerException().isThrownBy(() -> new Polygon((double[]) null));
    }

    @Test
    void notFinite() {
        refused("x of vertex 0 is NaN: it must be finite", Double.NaN, 0, 1, 0, 0, 1);
        refused("y of vertex 2 is Infinity: it must be finite", 0, 0, 1, 0, 0, Double.POSITIVE_INFINITY);
        refused("x of vertex 1 is -Infinity: it must be finite", 0, 0, Double.NEGATIVE_INFINITY, 0, 0, 1);
    }

    @Test
    void verticesThatCoincide() {
        refused("vertex 1 is (0.0, 0.0): it coincides with vertex 0", 0, 0, 0, 0, 1, 0, 0, 1);
        refused("vertex 3 is (0.0, 0.0): it coincides with vertex 0", 0, 0, 1, 0, 0, 1, 0, 0);
        refused("vertex 2 is (-0.0, 0.0): it coincides with vertex 0", 0, 0, 1, 0, -0.0, 0, 0, 1);
        refused("vertex 1 is (2.0, 2.0): it coincides with vertex 0", 2, 2, 2, 2, 2, 2);
        refused("vertex 3 is (1.0, 0.0): it coincides with vertex 0", 1, 0, 0, 1, -1, 0, 1, 0, 0, 2, -2, 0);
    }

    @Test
    void verticesOnALine() {
        refused(
                "vertex 1 is (1.0, 0.0): it lies on the line through its neighbours, vertices 0 and 2",
                0, 0, 1, 0, 2, 0, 1, 1);
        refused(
                "vertex 0 is (1.0, 0.0): it lies on the line through its neighbours, vertices 3 and 1",
                1, 0, 2, 0, 1, 1, 0, 0);
        refused(
                "vertex 0 is (0.0, 0.0): it lies on the line through its neighbours, vertices 2 and 1",
                0, 0, 1, 1, 2, 2);
        // a spike: there and back
        refused(
                "vertex 1 is (3.0, 0.0): it lies on the line through its neighbours, vertices 0 and 2",
                0, 0, 3, 0, 2, 0, 1, 1);
    }

    @Test
    void whatIsCollinearIsDecidedExactly() {
        // on one line: thirds are not, but these products are representable
        refused(
                "vertex 1 is (0.1, 0.1): it lies on the line through its neighbours, vertices 0 and 2",
                0, 0, 0.1, 0.1, 0.3, 0.3, 0, 1);
        String line = ": it lies on the line through its neighbours, vertices 2 and 1";
        refused("vertex 0 is (0.0, 0.0)" + line, 0, 0, 1, 0, 0.5, 2e-13);
        assertThat(new Polygon(0, 0, 1, 0, 0.5, 3e-12).area()).isEqualTo(1.5e-12);
        // a corner of 1e-13 rad in a wide polygon
        refused(
                "vertex 1 is (1.0, -1.0E-13): it lies on the line through its neighbours, vertices 0 and 2",
                0, 0, 1, -1e-13, 2, 0, 1, 1);
    }

    @Test
    void notConvex() {
        String why = ": the polygon is not convex there";
        refused("vertex 2 is (0.5, 0.5)" + why, 0, 0, 2, 0, 0.5, 0.5, 0, 2);
        refused("vertex 0 is (0.5, 0.5)" + why, 0.5, 0.5, 0, 2, 0, 0, 2, 0);
        refused("vertex 3 is (0.5, 0.5)" + why, 0, 2, 0, 0, 2, 0, 0.5, 0.5);
        // clockwise
        refused("vertex 1 is (0.5, 0.5)" + why, 0, 2, 0.5, 0.5, 2, 0, 0, 0);
        refused("vertex 2 is (1.0, 1.0E-11)" + why, 0, 1, 0, 0, 1, 1e-11, 2, 0, 2, 1);
    }

    @Test
    void notConvexWithManyVertices() {
        double[] xy = star(5000, 1, 5000);
        xy[2 * 1234] *= 0.5;
        xy[2 * 1234 + 1] *= 0.5;
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Polygon(xy))
                .withMessageStartingWith("vertex 1234 is (")
                .withMessageEndingWith("the polygon is not convex there");
    }

    @Test
    void crossesItself() {
        refused(
                "vertex 0 is (0.0, 0.0): the polygon crosses itself, the edge from there and the edge from vertex 2",
                0, 0, 1, 1, 1, 0, 0, 1);
        refused(
                "vertex 0 is (1.0, 0.0): the polygon crosses itself, the edge from there and the edge from vertex 2",
                star(5, 2, 5));
        refused(
                "vertex 0 is (1.0, 0.0): the polygon crosses itself, the edge from there and the edge from vertex 2",
                star(7, 3, 7));
        refused(
                "vertex 0 is (1.0, -0.0): the polygon crosses itself, the edge from there and the edge from vertex 2",
                star(7, -3, 7));
    }

    @Test
    void windsMoreThanOnceWithManyVertices() {
        double[] twice = star(2501, 2, 2501);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Polygon(twice))
                .withMessageStartingWith("vertex ")
                .withMessageEndingWith("the polygon crosses itself, it winds more than once");
    }

    @Test
    void overflowAndUnderflow() {
        String far = ": it is too far from vertex 0, the area overflows";
        String near = ": it is too near vertex 0, the area underflows";
        refused("vertex 1 is (1.0E200, 0.0)" + far, 0, 0, 1e200, 0, 0, 1e200);
        refused("vertex 1 is (1.0E308, 0.0)" + far, -1e308, 0, 1e308, 0, 0, 1e308);
        refused("vertex 1 is (1.0E-200, 0.0)" + near, 0, 0, 1e-200, 0, 0, 1e-200);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Polygon(0, 0, 1e-150, 0, 1e-150, 1e-160, 0, 1e-160))
                .withMessageStartingWith("a polygon of 4 vertices is too large or too small: its area is ");
        assertThat(new Polygon(0, 0, 1e100, 0, 0, 1e100).area()).isEqualTo(5e199);
        assertThat(new Polygon(0, 0, 1e-100, 0, 0, 1e-100).area()).isEqualTo(5e-201);
    }

    @Test
    void cornersThatWouldVanish() {
        // representable at the origin, but not relative to the centroid
        refused(
                "vertex 0 is (1.0E-18, 0.0): its corner is lost in rounding when the centroid is made the origin",
                1e-18, 0, 1, 0, 1, 1, 0, 1, 0, 1e-18);
    }

    @Test
    void regularPolygonsOfOddSizes() {
        for (int n : new int[] {Integer.MIN_VALUE, -1, 0, 2, 10_000_001, Integer.MAX_VALUE}) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> Polygon.regular(n, 1))
                    .withMessage("vertices is " + n + ": a regular polygon has from 3 to 10000000");
        }
        for (double radius : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> Polygon.regular(3, radius))
                    .withMessage("circumradius is " + radius + ": it must be a finite number greater than 0");
        }
        for (double radius : new double[] {1e-310, 1e-200, 1e200, Double.MAX_VALUE}) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> Polygon.regular(3, radius))
                    .withMessageContaining("too large or too small");
        }
    }
}
