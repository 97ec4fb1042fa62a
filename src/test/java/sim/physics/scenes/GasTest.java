// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** The benchmark scenes are what they say, with the same numbers everywhere. */
class GasTest {
    @Test
    void s3CoversAFifthWithBodiesThatDoNotTouch() {
        for (int n : new int[] {1, 2, 3, 5, 10, 100, 1000}) {
            SceneData scene = Gas.s3(n, 1);
            assertThat(scene.areaFraction()).isCloseTo(0.2, within(1e-5));
            assertThat(smallestGapOfBoundingCircles(scene)).isGreaterThan(0);
        }
    }

    @Test
    void figure1HasItsWorldAndItsBodies() {
        SceneData scene = Gas.figure1(100, Gas.FIGURE_1_FRACTION, 1);
        assertThat(scene.inner().width()).isCloseTo(194, within(1e-12));
        assertThat(scene.walls().get(0)).isEqualTo(new SceneData.Box(scene.inner().x(), 0, 200, 6));
        assertThat(scene.bodyArea()).isCloseTo(6426.99, within(0.01));
    }

    @Test
    void theDemoHasItsMasses() {
        SceneData scene = Gas.demo(1);
        assertThat(scene.size()).isEqualTo(10);
        assertThat(scene.mass()[0]).isCloseTo(153.94, within(0.01));
        assertThat(scene.mass()[1]).isEqualTo(98);
        assertThat(scene.areaFraction()).isCloseTo(0.0416, within(1e-4));
    }

    @Test
    void polygonsHaveTheDensityOfFigure1() {
        SceneData scene = Gas.polygons(300, 1);
        assertThat(scene.areaFraction()).isCloseTo(Gas.FIGURE_1_FRACTION, within(1e-12));
        assertThat(smallestGapOfBoundingCircles(scene)).isGreaterThan(0);
    }

    @Test
    void whatDoesNotFitIsCounted() {
        assertThatThrownBy(() -> Gas.figure1(100, 0.8, 1))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageMatching("only \\d+ of 100 bodies fit .*");
    }

    @Test
    void theNumbersAreTheSameOnEveryJvm() {
        assertThat(hash(Gas.s3(1000, 1))).isEqualTo(7715883296248933203L);
        assertThat(hash(Gas.figure1(1000, 0.17, 1))).isEqualTo(5005204693967377397L);
        assertThat(hash(Gas.polygons(1000, 1))).isEqualTo(1902907145039635152L);
    }

    private static long hash(SceneData s) {
        double[][] columns = {s.x(), s.y(), s.theta(), s.vx(), s.vy(), s.omega(), s.mass()};
        long hash = 1;
        for (double[] column : columns) {
            for (double value : column) {
                hash = 31 * hash + Double.doubleToLongBits(value);
            }
        }
        return hash;
    }

    private static double smallestGapOfBoundingCircles(SceneData s) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < s.size(); i++) {
            double wallX = s.inner().width() / 2 - Math.abs(s.x()[i] - s.inner().x());
            double wallY = s.inner().height() / 2 - Math.abs(s.y()[i] - s.inner().y());
            least = Math.min(least, Math.min(wallX, wallY) - s.boundingRadius(i));
            for (int j = 0; j < i; j++) {
                double distance = Math.hypot(s.x()[i] - s.x()[j], s.y()[i] - s.y()[j]);
                least = Math.min(least, distance - s.boundingRadius(i) - s.boundingRadius(j));
            }
        }
        return least;
    }
}
