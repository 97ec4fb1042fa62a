// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import demos.collisions.Collisions;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.motion.Body;
import sim.physics.motion.Euler;
import sim.physics.motion.Integrator;
import sim.physics.motion.RungeKutta4;

/**
 * The write-up's bouncing objects: "circles and rectangles should theoretically continue to bounce around forever". The
 * original keeps 0.12 % of the energy of Figure 1's scene after 10,000 steps.
 */
class BouncingObjectsTest {
    private static List<Integrator> integrators() {
        return List.of(new Euler(), new RungeKutta4());
    }

    @ParameterizedTest
    @CsvSource({
        "FIGURE_1, 10, 20000, 1", "FIGURE_1, 30, 20000, 2", "FIGURE_1, 100, 10000, 3", "FIGURE_1, 300, 2000, 4",
        "FIGURE_1, 1000, 400, 5", "POLYGONS, 10, 20000, 6", "POLYGONS, 100, 5000, 7", "POLYGONS, 300, 1000, 8"
    })
    void bounceForEverAndKeepTheirEnergy(Scenes.Kind kind, int bodies, int steps, long seed) {
        for (Integrator integrator : integrators()) {
            run(Scenes.gas(kind, bodies, seed), integrator, steps, Scenes.halfWidth(bodies), 0);
        }
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
            for (Integrator integrator : integrators()) {
                run(Scenes.gas(kind, bodies, seed), integrator, steps, Scenes.halfWidth(bodies), 0);
            }
        }
    }

    @Test
    void theDefaultSceneOfTheDemoKeepsItsEnergy() {
        demo(1);
    }

    @Tag("soak")
    @Test
    void theDefaultSceneOfTheDemoKeepsItsEnergyWithTwentySeeds() {
        for (long seed = 0; seed < 20; seed++) {
            demo(seed);
        }
    }

    /** The model itself: 5 circles, 5 rectangles, size 7, walls at 10. */
    private static void demo(long seed) {
        for (Integrator integrator : integrators()) {
            Collisions model = new Collisions(seed);
            model.start();
            assertThat(model.movers).hasSize(10);
            run(model.physics, integrator, 20_000, 0.5 * Collisions.WORLD - 13, 0.5 * Collisions.WORLD);
        }
    }

    /** The walls' inner faces are at the given distance from the centre (c, c) of the world. */
    private static void run(PhysicsEngine engine, Integrator integrator, int steps, double half, double c) {
        engine.setIntegrator(integrator);
        double energy = engine.kineticEnergy();
        int look = Math.max(1, steps / 50);
        for (int k = 1; k <= steps; k++) {
            engine.step();
            if (k % look == 0) {
                assertThat(Scenes.smallestGap(engine)).as("gap after %d steps", k).isGreaterThan(-1e-9 * 5);
                for (Body body : engine.bodies()) {
                    boolean inside = Math.abs(body.getX() - c) < half && Math.abs(body.getY() - c) < half;
                    assertThat(body.isFixed() || inside).isTrue();
                }
            }
        }
        assertThat(engine.getImpacts()).isGreaterThan(steps / 50);
        assertThat(engine.kineticEnergy() / energy).isCloseTo(1, within(1e-11));
        assertThat(engine.getDeepestPenetration()).isLessThan(1e-9 * 5);
    }
}
