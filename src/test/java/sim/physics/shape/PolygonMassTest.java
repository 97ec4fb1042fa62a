// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Area, centroid and moment of inertia of polygons are right to 1e-13, wherever they are and however thin. */
class PolygonMassTest {
    private static final double RIGHT = 1e-13;

    /** Compares all properties with the reference, and looks whether the centroid has become the origin. */
    private static Polygon check(double... xy) {
        Polygon polygon = new Polygon(xy);
        Exact exact = Exact.of(xy);
        double size = polygon.boundingRadius();
        assertThat(Exact.error(polygon.area(), exact.area())).as("area").isLessThan(RIGHT);
        assertThat(Exact.error(polygon.unitInertia(), exact.unitInertia())).as("inertia").isLessThan(RIGHT);
        double cx = exact.centroidX().doubleValue();
        double cy = exact.centroidY().doubleValue();
        assertThat(polygon.centroidX()).isCloseTo(cx, within(RIGHT * size + Math.ulp(cx)));
        assertThat(polygon.centroidY()).isCloseTo(cy, within(RIGHT * size + Math.ulp(cy)));
        // the local vertices are rounded, which moves the centroid of a sliver along it
        double rounding = 1e-15 * size * size * size / polygon.area();
        Exact local = Exact.of(polygon.copyVertices());
        assertThat(local.centroidX().doubleValue()).isCloseTo(0, within(rounding));
        assertThat(local.centroidY().doubleValue()).isCloseTo(0, within(rounding));
        return polygon;
    }

    /** Points in order on an ellipse that is turned and moved: a convex polygon. */
    private static double[] ellipse(SplittableRandom random, int n, double flat, double x, double y) {
        double[] xy = new double[2 * n];
        double turn = 2 * Math.PI * random.nextDouble();
        for (int k = 0; k < n; k++) {
            double angle = 2 * Math.PI * (k + 0.8 * random.nextDouble()) / n;
            double u = Math.cos(angle);
            double v = flat * Math.sin(angle);
            xy[2 * k] = x + u * Math.cos(turn) - v * Math.sin(turn);
            xy[2 * k + 1] = y + u * Math.sin(turn) + v * Math.cos(turn);
        }
        return xy;
    }

    @Test
    void aTriangleHasItsClosedForm() {
        double a = 3;
        double b = 7;
        Polygon triangle = check(1, 2, 1 + a, 2, 1, 2 + b);
        assertThat(triangle.area()).isEqualTo(10.5);
        assertThat(triangle.centroidX()).isCloseTo(1 + a / 3, within(1e-15));
        assertThat(triangle.centroidY()).isCloseTo(2 + b / 3, within(1e-15));
        assertThat(triangle.unitInertia()).isCloseTo((a * a + b * b) / 18, within(1e-15));
    }

    @Test
    void aRectangleIsThatOfItsOwnClass() {
        Polygon polygon = check(10, 10, 13, 10, 13, 11, 10, 11);
        Rectangle rectangle = new Rectangle(3, 1);
        assertThat(polygon.copyVertices()).containsExactly(rectangle.copyVertices());
        assertThat(polygon.area()).isEqualTo(rectangle.area());
        assertThat(polygon.unitInertia()).isCloseTo(rectangle.unitInertia(), within(1e-15));
        assertThat(polygon.massProperties().centroidX()).isEqualTo(11.5);
        assertThat(polygon.massProperties().centroidY()).isEqualTo(10.5);
    }

    @Test
    void regularPolygonsHaveTheirClosedForms() {
        for (int n = 3; n <= 100_000; n += 1 + n / 3) {
            Polygon polygon = Polygon.regular(n, 5);
            double half = StrictMath.sin(Math.PI / n);
            double area = 12.5 * n * StrictMath.sin(2 * Math.PI / n);
            double inertia = 12.5 * (1 - 2.0 / 3 * half * half);
            assertThat(polygon.area() / area).as("%d", n).isCloseTo(1, within(RIGHT));
            assertThat(polygon.unitInertia() / inertia).as("%d", n).isCloseTo(1, within(RIGHT));
            assertThat(polygon.boundingRadius()).isCloseTo(5, within(1e-14));
        }
    }

    @Test
    void sliversKeepTheirArea() {
        for (double thin = 1e-2; thin > 2e-11; thin /= 7) {
            check(0.1, 0.2, 1.3, 0.7, 0.7, 0.45 + thin);
            check(-1.1, 0.3, 2.9, 1.7, 2.9 - thin, 1.7 + 2 * thin, -1.1 - thin, 0.3 + 2 * thin);
        }
    }

    @Test
    void shortEdgesAreAccepted() {
        double edge = 1e-12;
        Polygon polygon = check(edge, 0, 1, 0, 1, 1, 0, 1, 0, edge);
        assertThat(polygon.vertexCount()).isEqualTo(5);
        assertThat(polygon.area()).isEqualTo(1);
    }

    @Test
    void manyVerticesLoseNothing() {
        SplittableRandom random = new SplittableRandom(8);
        check(ellipse(random, 1000, 0.3, 5, -3));
        check(ellipse(random, 20_000, 1, 1, 1));
    }

    @Property(tries = 300, seed = "2")
    void anyConvexPolygonIsRight(
            @ForAll long seed,
            @ForAll @IntRange(min = 3, max = 12) int n,
            @ForAll @DoubleRange(min = -6, max = 0) double flat) {
        SplittableRandom random = new SplittableRandom(seed);
        check(ellipse(random, n, Math.pow(10, flat), random.nextDouble(), random.nextDouble()));
    }

    @Property(tries = 300, seed = "3")
    void farFromTheOriginToo(
            @ForAll long seed,
            @ForAll @IntRange(min = 3, max = 12) int n,
            @ForAll @DoubleRange(min = -1e6, max = 1e6) double x,
            @ForAll @DoubleRange(min = -1e6, max = 1e6) double y) {
        check(ellipse(new SplittableRandom(seed), n, 0.5, x, y));
        check(ellipse(new SplittableRandom(seed), n, 0.5, 1e3 * x, 1e3 * y));
    }

    @Property(tries = 200, seed = "4")
    void theFirstVertexAndTheSenseDoNotMatter(@ForAll long seed, @ForAll @IntRange(min = 3, max = 9) int n) {
        double[] xy = ellipse(new SplittableRandom(seed), n, 0.2, 3, 4);
        Polygon polygon = new Polygon(xy);
        for (int shift = 0; shift < n; shift++) {
            double[] rolled = new double[2 * n];
            double[] reversed = new double[2 * n];
            for (int k = 0; k < n; k++) {
                int from = (k + shift) % n;
                rolled[2 * k] = xy[2 * from];
                rolled[2 * k + 1] = xy[2 * from + 1];
                reversed[2 * (n - 1 - k)] = xy[2 * from];
                reversed[2 * (n - 1 - k) + 1] = xy[2 * from + 1];
            }
            same(new Polygon(rolled), polygon);
            same(new Polygon(reversed), polygon);
            assertThat(new Polygon(reversed)).isEqualTo(new Polygon(rolled));
        }
    }

    @Property(tries = 200, seed = "5")
    void turningChangesOnlyTheCentroid(@ForAll long seed, @ForAll @DoubleRange(min = 0, max = 7) double angle) {
        double[] xy = ellipse(new SplittableRandom(seed), 6, 0.5, 0, 0);
        double[] turned = new double[xy.length];
        for (int k = 0; k < xy.length; k += 2) {
            turned[k] = xy[k] * Math.cos(angle) - xy[k + 1] * Math.sin(angle);
            turned[k + 1] = xy[k] * Math.sin(angle) + xy[k + 1] * Math.cos(angle);
        }
        Polygon before = new Polygon(xy);
        Polygon after = new Polygon(turned);
        // the vertices are rounded when they are turned
        assertThat(after.area() / before.area()).isCloseTo(1, within(2e-15));
        assertThat(after.unitInertia() / before.unitInertia()).isCloseTo(1, within(2e-15));
        assertThat(after.boundingRadius() / before.boundingRadius()).isCloseTo(1, within(2e-15));
    }

    private static void same(Polygon a, Polygon b) {
        assertThat(a.area() / b.area()).isCloseTo(1, within(1e-15));
        assertThat(a.unitInertia() / b.unitInertia()).isCloseTo(1, within(1e-15));
        assertThat(a.centroidX()).isCloseTo(b.centroidX(), within(2e-15));
        assertThat(a.centroidY()).isCloseTo(b.centroidY(), within(2e-15));
        assertThat(a.boundingRadius()).isCloseTo(b.boundingRadius(), within(1e-15));
    }

    @Test
    void aPowerOfTwoScalesAllBits() {
        double[] xy = ellipse(new SplittableRandom(6), 7, 0.3, 2, 1);
        Polygon polygon = new Polygon(xy);
        for (int power : new int[] {-480, -20, -1, 1, 20, 480}) {
            double[] scaled = new double[xy.length];
            for (int k = 0; k < xy.length; k++) {
                scaled[k] = Math.scalb(xy[k], power);
            }
            Polygon large = new Polygon(scaled);
            assertThat(large.area()).isEqualTo(Math.scalb(polygon.area(), 2 * power));
            assertThat(large.unitInertia()).isEqualTo(Math.scalb(polygon.unitInertia(), 2 * power));
            for (int k = 0; k < 7; k++) {
                assertThat(large.vertexX(k)).isEqualTo(Math.scalb(polygon.vertexX(k), power));
                assertThat(large.vertexY(k)).isEqualTo(Math.scalb(polygon.vertexY(k), power));
            }
        }
    }
}
