// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.motion.Automatic;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.GraggBulirschStoer;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.motion.RungeKutta4;
import sim.physics.motion.SurfaceFriction;

/** The same scene gives the same bits: again, in another JVM, after a checkpoint, beside other engines. */
class DeterminismTest {
    /** Computed once; the same on every JDK, interpreted or compiled. */
    private static final long GOLDEN_GAS = 8737119095546984472L;

    private static final long GOLDEN_POLYGONS = 4887223604970660957L;

    private static final long GOLDEN_CHAINS = -1021779205363064869L;

    private static void run(PhysicsEngine engine, int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    @Test
    void theGasOfFigure1HasItsGoldenHash() {
        PhysicsEngine engine = Scenes.gas(Scenes.Kind.FIGURE_1, 40, 11);
        run(engine, 400);
        assertThat(engine.getImpacts()).isGreaterThan(100);
        assertThat(Scenes.hash(engine)).isEqualTo(GOLDEN_GAS);
    }

    @Test
    void polygonsOnARoughGroundHaveTheirGoldenHash() {
        PhysicsEngine engine = Scenes.gas(Scenes.Kind.POLYGONS, 24, 12);
        engine.add(new SurfaceFriction(0.1));
        for (Body body : engine.bodies()) {
            body.setSurfaceFriction(0.02);
        }
        run(engine, 300);
        assertThat(Scenes.hash(engine)).isEqualTo(GOLDEN_POLYGONS);
    }

    /** Chains of pins in their angles, by one method after the other. */
    @Test
    void chainsUnderMethodsWithAToleranceHaveTheirGoldenHash() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.add(new Gravity(0, -9.81));
        engine.setTimeStep(1 / 240.0);
        Scenes.rods(engine, 7, 0);
        for (int k = 0; k < 6; k++) {
            Integrator[] methods = {
                new DormandPrince853(1e-8), new RungeKutta4(), new GraggBulirschStoer(1e-9), new DormandPrince853(1e-2), new Automatic(1e-4),
                new GraggBulirschStoer(1e-3)
            };
            engine.setIntegrator(methods[k]);
            run(engine, 40);
        }
        assertThat(Scenes.hash(engine)).isEqualTo(GOLDEN_CHAINS);
    }

    @Test
    void aRestoredEngineContinuesBitForBit() {
        PhysicsEngine engine = Scenes.gas(Scenes.Kind.POLYGONS, 60, 13);
        run(engine, 137);
        PhysicsEngine restored = Checkpoint.copy(engine);
        for (int k = 0; k < 300; k++) {
            engine.step();
            restored.step();
            assertThat(Scenes.hash(restored)).as("after %d steps", k).isEqualTo(Scenes.hash(engine));
        }
    }

    @Test
    void enginesInManyThreadsDoNotMeet() throws InterruptedException {
        PhysicsEngine alone = Scenes.gas(Scenes.Kind.FIGURE_1, 40, 14);
        run(alone, 300);
        long[] hashes = new long[4];
        Thread[] threads = new Thread[hashes.length];
        for (int k = 0; k < threads.length; k++) {
            int number = k;
            threads[k] = new Thread(() -> {
                PhysicsEngine engine = Scenes.gas(Scenes.Kind.FIGURE_1, 40, 14);
                run(engine, 300);
                hashes[number] = Scenes.hash(engine);
            });
            threads[k].start();
        }
        for (Thread thread : threads) {
            thread.join();
        }
        assertThat(hashes).containsOnly(Scenes.hash(alone));
    }
}
