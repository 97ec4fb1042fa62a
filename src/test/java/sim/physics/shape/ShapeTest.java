// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import sim.physics.Checkpoint;

/** What all shapes have in common: vertices and a radius, about the centroid; values that do not change. */
class ShapeTest {
    private static final List<Shape> SHAPES = List.of(
            new Circle(2), new Rectangle(3, 4), new Polygon(0, 0, 4, 0, 0, 4), Polygon.regular(7, 2));

    @Test
    void aCircleIsAPointAndARadius() {
        Circle circle = new Circle(2);
        assertThat(circle.vertexCount()).isEqualTo(1);
        assertThat(circle.copyVertices()).containsExactly(0, 0);
        assertThat(circle.radius()).isEqualTo(2);
        assertThat(circle.boundingRadius()).isEqualTo(2);
        assertThat(circle.massProperties()).isEqualTo(new MassProperties(Math.PI * 4, 0, 0, 2));
        assertThat(circle).hasToString("Circle[radius 2.0]");
    }

    @Test
    void aRectangleGoesRoundFromItsLowerLeftCorner() {
        Rectangle rectangle = new Rectangle(6, 8);
        assertThat(rectangle.width()).isEqualTo(6);
        assertThat(rectangle.height()).isEqualTo(8);
        assertThat(rectangle.copyVertices()).containsExactly(-3, -4, 3, -4, 3, 4, -3, 4);
        assertThat(rectangle.radius()).isZero();
        assertThat(rectangle.boundingRadius()).isEqualTo(5);
        assertThat(rectangle.area()).isEqualTo(48);
        assertThat(rectangle.unitInertia()).isCloseTo(100 / 12.0, within(1e-15));
        assertThat(rectangle).hasToString("Rectangle[6.0 x 8.0]");
    }

    @Test
    void aPolygonGoesRoundCounterClockwiseAboutItsCentroid() {
        Polygon polygon = new Polygon(10, 10, 10, 13, 13, 10);
        assertThat(polygon.copyVertices()).containsExactly(2, -1, -1, 2, -1, -1);
        assertThat(polygon.centroidX()).isEqualTo(11);
        assertThat(polygon.centroidY()).isEqualTo(11);
        assertThat(polygon.vertexCount()).isEqualTo(3);
        assertThat(polygon.radius()).isZero();
        assertThat(polygon.boundingRadius()).isEqualTo(Math.sqrt(5));
        assertThat(polygon).hasToString("Polygon[3 vertices, bounding radius " + Math.sqrt(5) + "]");
    }

    @Property(tries = 500, seed = "1")
    void regularPolygonsAreSymmetricToTheBit(@ForAll @IntRange(min = 3, max = 2000) int n) {
        Polygon polygon = Polygon.regular(n, 3);
        assertThat(polygon.vertexX(0)).isEqualTo(3);
        assertThat(polygon.centroidX()).isZero();
        assertThat(polygon.centroidY()).isZero();
        for (int k = 0; k < n; k++) {
            int mirror = (n - k) % n;
            assertThat(polygon.vertexX(k)).isEqualTo(polygon.vertexX(mirror));
            assertThat(polygon.vertexY(k) + polygon.vertexY(mirror)).isZero();
            if (n % 2 == 0) {
                int opposite = (k + n / 2) % n;
                assertThat(polygon.vertexX(k) + polygon.vertexX(opposite)).isZero();
                assertThat(polygon.vertexY(k) + polygon.vertexY(opposite)).isZero();
            }
            if (n % 4 == 0) {
                int quarter = (k + n / 4) % n;
                assertThat(polygon.vertexX(k) - polygon.vertexY(quarter)).isZero();
                assertThat(polygon.vertexY(k) + polygon.vertexX(quarter)).isZero();
            }
            assertThat(polygon.vertexX(k)).isCloseTo(3 * StrictMath.cos(2 * Math.PI * k / n), within(4e-15));
            assertThat(polygon.vertexY(k)).isCloseTo(3 * StrictMath.sin(2 * Math.PI * k / n), within(4e-15));
        }
        assertThat(new Polygon(polygon.copyVertices()).vertexCount()).isEqualTo(n);
    }

    @Test
    void theBorderBelongsToTheShape() {
        Circle circle = new Circle(1);
        assertThat(circle.contains(0.6, 0.8)).isTrue();
        assertThat(circle.contains(0.8, 0.8)).isFalse();
        Rectangle rectangle = new Rectangle(2, 4);
        assertThat(rectangle.contains(1, 2)).isTrue();
        assertThat(rectangle.contains(-1, 0.3)).isTrue();
        assertThat(rectangle.contains(1.0000001, 0)).isFalse();
        assertThat(rectangle.contains(0, -2.0000001)).isFalse();
        Polygon triangle = new Polygon(0, 0, 3, 0, 0, 3);
        assertThat(triangle.contains(0, 0)).isTrue();
        assertThat(triangle.contains(0.5, 0.5)).isTrue();
        assertThat(triangle.contains(0.6, 0.5)).isFalse();
        assertThat(triangle.contains(-1, -1)).isTrue();
    }

    @Test
    void sizesThatAreNotPositiveAreRefused() {
        for (double bad : new double[] {0, -0.0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
            String why = " is " + bad + ": it must be a finite number greater than 0";
            assertThatIllegalArgumentException().isThrownBy(() -> new Circle(bad)).withMessage("radius" + why);
            assertThatIllegalArgumentException().isThrownBy(() -> new Rectangle(bad, 1)).withMessage("width" + why);
            assertThatIllegalArgumentException().isThrownBy(() -> new Rectangle(1, bad)).withMessage("height" + why);
        }
    }

    @Test
    void sizesWhoseSquaresOverOrUnderflowAreRefused() {
        for (double bad : new double[] {1e-200, 1e-160, 1e160, Double.MAX_VALUE}) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> new Circle(bad))
                    .withMessageStartingWith("a circle of radius " + bad + " is too large or too small: its area is ");
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> new Rectangle(bad, bad))
                    .withMessageStartingWith("a rectangle of width " + bad + " and height " + bad + " is too large");
        }
        assertThat(new Circle(1e150).area()).isFinite();
        assertThat(new Circle(1e-150).unitInertia()).isPositive();
        assertThat(new Rectangle(1e-200, 1).area()).isEqualTo(1e-200);
    }

    @Test
    void shapesDoNotChange() {
        double[] xy = {0, 0, 4, 0, 0, 4};
        Polygon polygon = new Polygon(xy);
        double[] vertices = polygon.copyVertices();
        xy[0] = 99;
        polygon.copyVertices()[0] = 99;
        assertThat(polygon.copyVertices()).containsExactly(vertices);
        double[] clockwise = {0, 4, 4, 0, 0, 0};
        new Polygon(clockwise);
        assertThat(clockwise).containsExactly(0, 4, 4, 0, 0, 0);
    }

    @Test
    void shapesWithTheSameBitsAreEqual() {
        assertThat(new Circle(2)).isEqualTo(new Circle(2)).hasSameHashCodeAs(new Circle(2)).isNotEqualTo(new Circle(3));
        assertThat(new Rectangle(1, 2)).isEqualTo(new Rectangle(1, 2)).isNotEqualTo(new Rectangle(2, 1));
        Polygon square = new Polygon(0, 0, 2, 0, 2, 2, 0, 2);
        assertThat(square)
                .isEqualTo(new Polygon(10, 10, 12, 10, 12, 12, 10, 12))
                .isNotEqualTo(new Rectangle(2, 2))
                .isNotEqualTo(new Polygon(0, 0, 2, 0, 2, 2, 0, 3))
                .isNotEqualTo(null);
        assertThat(square).hasSameHashCodeAs(new Polygon(10, 10, 12, 10, 12, 12, 10, 12));
    }

    @Test
    void shapesSurviveSerialization() {
        for (Shape shape : SHAPES) {
            Shape copy = Checkpoint.copy(shape);
            assertThat(copy).isEqualTo(shape).isNotSameAs(shape).hasToString(shape.toString());
            assertThat(copy.massProperties()).isEqualTo(shape.massProperties());
            assertThat(copy.boundingRadius()).isEqualTo(shape.boundingRadius());
        }
    }
}
