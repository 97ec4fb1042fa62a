// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.motion.Body;
import sim.physics.motion.Euler;
import sim.physics.motion.RungeKutta4;

/**
 * The write-up's bouncing objects: "circles and rectangles should theoretically continue to bounce around forever". The
 * original keeps 0.12 % of the energy of Figure 1's scene after 10,000 steps.
 */
class BouncingObjectsTest {
    @ParameterizedTest
    @CsvSource({
        "FIGURE_1, 10, 20000, 1", "FIGURE_1, 30, 20000, 2", "FIGURE_1, 100, 20000, 3", "FIGURE_1, 300, 4000, 4",
        "FIGURE_1, 1000, 1000, 5", "POLYGONS, 10, 20000, 6", "POLYGONS, 100, 10000, 7", "POLYGONS, 300, 2000, 8"
    })
    void bounceForEverAndKeepTheirEnergy(Scenes.Kind kind, int bodies, int steps, long seed) {
        run(kind, bodies, steps, seed);
    }

    @Tag("soak")
    @ParameterizedTest
    @CsvSource({
        "FIGURE_1, 10, 20000", "FIGURE_1, 30, 20000", "FIGURE_1, 100, 20000", "FIGURE_1, 300, 20000",
        "FIGURE_1, 1000, 5000", "POLYGONS, 10, 20000", "POLYGONS, 30, 20000", "POLYGONS, 100, 20000",
        "POLYGONS, 300, 20000", "POLYGONS, 1000, 5000"
    })
    void bounceForEverWithTwentySeeds(Scenes.Kind kind, int bodies, int steps) {
        for (long seed = 0; seed < 20; seed++) {
            run(kind, bodies, steps, seed);
        }
    }

    private static void run(Scenes.Kind kind, int bodies, int steps, long seed) {
        PhysicsEngine engine = Scenes.gas(kind, bodies, seed);
        engine.setIntegrator(seed % 2 == 0 ? new Euler() : new RungeKutta4());
        double energy = engine.kineticEnergy();
        double half = Scenes.halfWidth(bodies);
        int look = Math.max(1, steps / 50);
        for (int k = 1; k <= steps; k++) {
            engine.step();
            if (k % look == 0) {
                assertThat(Scenes.smallestGap(engine)).as("gap after %d steps", k).isGreaterThan(-1e-9 * 5);
                for (Body body : engine.bodies()) {
                    boolean inside = Math.abs(body.getX()) < half && Math.abs(body.getY()) < half;
                    assertThat(body.isFixed() || inside).isTrue();
                }
            }
        }
        assertThat(engine.kineticEnergy() / energy).isCloseTo(1, within(1e-11));
        assertThat(engine.getDeepestPenetration()).isLessThan(1e-9 * 5);
    }
}
