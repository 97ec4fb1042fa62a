// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;

/** Mass properties of compounds, and how outlines that are not convex are cut. */
class CompoundShapeTest {
    /** An L of a box 4 x 1 and one of 1 x 2 on its end: area 6, centroid (1.5, 1), moment of inertia 12.5. */
    private static void assertL(Compound shape, double x, double y, double error) {
        assertThat(shape.area()).isEqualTo(6, within(6 * error));
        assertThat(shape.centroidX() - x).isEqualTo(1.5, within(error));
        assertThat(shape.centroidY() - y).isEqualTo(1, within(error));
        assertThat(shape.unitInertia()).isEqualTo(12.5 / 6, within(2 * error));
    }

    @Test
    void massAndInertiaAreThoseOfTheParts() {
        assertL(new Compound(Compound.box(2, 0.5, 4, 1), Compound.box(0.5, 2, 1, 2)), 0, 0, 1e-15);
        assertL(Compound.outline(0, 0, 4, 0, 4, 1, 1, 1, 1, 3, 0, 3), 0, 0, 1e-15);
        assertL(Compound.outline(0, 3, 1, 3, 1, 1, 4, 1, 4, 0, 0, 0), 0, 0, 1e-15); // clockwise
    }

    /** A disc of radius 2 at (1, 0) with two boxes 1 x 1/2 beside it, by the parallel axes. */
    @Test
    void discsArePartsToo() {
        Compound shape = new Compound(Compound.disc(1, 0, 2), Compound.box(4, 1, 1, 0.5), Compound.box(4, -1, 1, 0.5));
        double disc = 4 * Math.PI;
        double x = (disc + 2 * 0.5 * 4) / (disc + 1);
        double inertia = disc * (2 + (x - 1) * (x - 1)) + 2 * 0.5 * ((1 + 0.25) / 12 + 1 + (4 - x) * (4 - x));
        assertThat(shape.area()).isEqualTo(disc + 1, within(1e-14));
        assertThat(shape.centroidX()).isEqualTo(x, within(1e-15));
        assertThat(shape.centroidY()).isEqualTo(0, within(1e-15));
        assertThat(shape.unitInertia()).isEqualTo(inertia / (disc + 1), within(1e-14));
        assertThat(shape.boundingRadius()).isEqualTo(Math.max(Math.hypot(4.5 - x, 1.25), 2 + x - 1), within(1e-14));
        assertThat(shape.contains(-1 - x + 1e-9, 0)).isTrue();
        assertThat(shape.contains(-1 - x - 1e-9, 0)).isFalse();
        assertThat(shape.contains(4 - x, 0)).isFalse();
        Compound single = new Compound(Compound.disc(7, 8, 2));
        assertThat(single.partCount()).isEqualTo(1);
        assertThat(single.radius()).isEqualTo(2);
        assertThat(single.unitInertia()).isEqualTo(2);
    }

    /** Coordinates that are exact, far from the origin, are so to their differences. */
    @Test
    void nothingIsLostFarFromTheOrigin() {
        double far = 0x1p30;
        Compound shape = Compound.outline(
                far, far, far + 4, far, far + 4, far + 1, far + 1, far + 1, far + 1, far + 3, far, far + 3);
        assertThat(shape.area()).isEqualTo(6, within(1e-14));
        assertThat(shape.unitInertia()).isEqualTo(12.5 / 6, within(1e-14));
    }

    @Test
    void aPolygonThatIsCutHasTheMassOfTheWhole() {
        Polygon whole = new Polygon(0, 0, 5, 1, 6, 4, 2, 6, -1, 3);
        Compound cut = new Compound(new double[] {0, 0, 5, 1, 6, 4}, new double[] {0, 0, 6, 4, 2, 6}, new double[] {0, 0, 2, 6, -1, 3});
        assertThat(cut.area()).isEqualTo(whole.area(), within(1e-14 * whole.area()));
        assertThat(cut.centroidX()).isEqualTo(whole.centroidX(), within(1e-14));
        assertThat(cut.centroidY()).isEqualTo(whole.centroidY(), within(1e-14));
        assertThat(cut.unitInertia()).isEqualTo(whole.unitInertia(), within(1e-14 * whole.unitInertia()));
        assertThat(cut.boundingRadius()).isEqualTo(whole.boundingRadius(), within(1e-14 * whole.boundingRadius()));
    }

    /** Stars of random corners: parts fill the outline, and are no more than four times as few as there can be. */
    @ParameterizedTest
    @ValueSource(ints = {4, 7, 12, 30, 100})
    void outlinesAreCutIntoConvexParts(int corners) {
        SplittableRandom random = new SplittableRandom(corners);
        for (int round = 0; round < 20; round++) {
            double[] xy = star(corners, random);
            double area = 0;
            int reflex = 0;
            for (int k = 0; k < corners; k++) {
                int next = (k + 1) % corners;
                int last = (k + corners - 1) % corners;
                area += 0.5 * (xy[2 * k] * xy[2 * next + 1] - xy[2 * k + 1] * xy[2 * next]);
                double ux = xy[2 * k] - xy[2 * last];
                double uy = xy[2 * k + 1] - xy[2 * last + 1];
                reflex += ux * (xy[2 * next + 1] - xy[2 * k + 1]) - uy * (xy[2 * next] - xy[2 * k]) < 0 ? 1 : 0;
            }
            Compound shape = Compound.outline(xy);
            assertThat(shape.area()).isEqualTo(area, within(1e-12 * area));
            assertThat(shape.partCount()).isLessThanOrEqualTo(4 * ((reflex + 1) / 2 + 1));
            for (int m = 0; m < 100; m++) {
                double x = 4 * random.nextDouble() - 2;
                double y = 4 * random.nextDouble() - 2;
                assertThat(shape.contains(x - shape.centroidX(), y - shape.centroidY())).isEqualTo(isInside(xy, x, y));
            }
        }
    }

    private static double[] star(int corners, SplittableRandom random) {
        double[] xy = new double[2 * corners];
        for (int k = 0; k < corners; k++) {
            double angle = 2 * Math.PI * (k + 0.6 * random.nextDouble()) / corners;
            double radius = 0.5 + 1.5 * random.nextDouble();
            xy[2 * k] = radius * Math.cos(angle);
            xy[2 * k + 1] = radius * Math.sin(angle);
        }
        return xy;
    }

    /** By how often a ray crosses the outline. */
    private static boolean isInside(double[] xy, double x, double y) {
        boolean is = false;
        for (int k = 0, last = xy.length - 2; k < xy.length; last = k, k += 2) {
            if (xy[k + 1] > y != xy[last + 1] > y && x < xy[k] + (y - xy[k + 1]) * (xy[last] - xy[k]) / (xy[last + 1] - xy[k + 1])) {
                is = !is;
            }
        }
        return is;
    }

    @Test
    void aConvexOutlineIsOnePartAndPointsOnItsSidesAreLeftOut() {
        assertThat(Compound.outline(0, 0, 1, 0, 2, 0, 2, 1, 2, 2, 0, 2).partCount()).isEqualTo(1);
        assertThat(Compound.outline(0, 0, 1, 0, 2, 0, 2, 1, 2, 2, 0, 2).vertexCount()).isEqualTo(4);
        assertThat(Compound.outline(0, 0, 4, 0, 4, 1, 2, 1, 1, 1, 1, 3, 0, 3).partCount()).isEqualTo(2);
    }

    @Test
    void whatCannotBeUsedIsRefusedAndNamed() {
        assertThatThrownBy(() -> new Compound()).isInstanceOf(IllegalArgumentException.class).hasMessageContaining("0 parts");
        assertThatThrownBy(() -> new Compound(Compound.box(0, 0, 1, 1), new double[] {0, 0, 1, 0, 1, 1, 0.9, 0.2}))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("part 1 of the compound: vertex 3 is (0.9, 0.2)");
        assertThatThrownBy(() -> new Compound(Compound.box(0, 0, 1, 1), new double[] {0, 0, -1}))
                .hasMessageContaining("part 1 of the compound: radius is -1");
        assertThatThrownBy(() -> new Compound(new double[] {0, 0, 1, 1})).hasMessageContaining("part 0").hasMessageContaining("4 coordinates");
        assertThatThrownBy(() -> Compound.disc(0, Double.NaN, 1)).hasMessageContaining("y");
        assertThatThrownBy(() -> Compound.outline(0, 0, 2, 0)).hasMessageContaining("4 coordinates");
        assertThatThrownBy(() -> Compound.outline(0, 0, 2, 2, 2, 0, 0, 2)).hasMessageContaining("meets itself");
        assertThatThrownBy(() -> Compound.outline(0, 0, 2, 0, 2, 2, 1, 0, 0, 2)).hasMessageContaining("meets itself");
        assertThatThrownBy(() -> Compound.outline(0, 0, 1, 1, 2, 2, 3, 3)).hasMessageContaining("line");
        assertThatThrownBy(() -> Compound.outline(0, 0, 2, 0, 2, Double.NaN)).hasMessageContaining("vertex 2");
        assertThatThrownBy(() -> Compound.outline(0, 0, 2, 0, 2, 2, 2, 0, 1, 3)).hasMessageContaining("coincides with vertex 1");
        assertThatThrownBy(() -> Compound.box(0, 0, 0, 1)).hasMessageContaining("width");
        assertThatThrownBy(() -> new Compound(Compound.box(0, 0, 1, 1)).part(1)).isInstanceOf(IndexOutOfBoundsException.class);
    }

    @Test
    void equalMeansOfTheSameParts() {
        Compound one = new Compound(Compound.box(0, 0, 2, 1), Compound.box(0, 1, 1, 1));
        assertThat(new Compound(Compound.box(0, 0, 2, 1), Compound.box(0, 1, 1, 1))).isEqualTo(one).hasSameHashCodeAs(one);
        assertThat(new Compound(Compound.box(0, 1, 1, 1), Compound.box(0, 0, 2, 1))).isNotEqualTo(one);
        assertThat(Checkpoint.copy(one)).isEqualTo(one);
    }
}
