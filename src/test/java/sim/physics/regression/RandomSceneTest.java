// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.collision.Overlap;
import sim.physics.motion.Body;

/**
 * What holds in any scene, on random ones: no exception, no NaN, no penetration, bounded work, and without forces that
 * do work no gain of energy.
 */
class RandomSceneTest {
    private static final int STEPS = 100;

    /** A body comes to rest at latest at its 20,000th impact on a surface in one step, and others have few. */
    private static final int MOST_IMPACTS = 25_000;

    @Test
    void lawsHoldInFortyRandomScenes() {
        for (long seed = 0; seed < 40; seed++) {
            run(seed, false);
        }
    }

    @Tag("soak")
    @Test
    void lawsHoldInFourHundredRandomScenes() {
        for (long seed = 0; seed < 400; seed++) {
            run(seed, false);
        }
    }

    /** What lies on one another and turns, without forces, and is struck in the middle of a step: up to 4 · 10⁻⁴ of the energy was added then. */
    @ParameterizedTest
    @ValueSource(longs = {81, 150, 184})
    void whatIsStruckAsItTurnsOnSomethingGainsNothing(long seed) {
        run(seed, false);
    }

    /** What is open in a heap without forces, and closes by another corner: it was found when it was as deep as what touches may be. */
    @ParameterizedTest
    @ValueSource(longs = {55, 220, 351})
    void whatIsOpenInAHeapStrikesWhereItTouches(long seed) {
        run(seed, false);
    }

    @ParameterizedTest
    @ValueSource(longs = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19})
    void lawsHoldForDrivenBodiesToo(long seed) {
        run(seed, true);
    }

    @Test
    void lawsHoldForBodiesOfSeveralParts() {
        for (long seed = 0; seed < 25; seed++) {
            run(new RandomScene(seed, seed % 5 == 0, true), seed, 1e-5, 1e-4);
        }
    }

    @Tag("soak")
    @Test
    void lawsHoldForBodiesOfSeveralPartsInFourHundredScenes() {
        for (long seed = 0; seed < 400; seed++) {
            run(new RandomScene(seed, seed % 5 == 0, true), seed, 1e-5, 1e-4);
        }
    }

    /** What slides and turns on something on a plane: it closed hundreds of times in a step, and was let in by 10⁻⁵ to 10⁻³. */
    @ParameterizedTest
    @ValueSource(longs = {205, 300, 305, 380})
    void whatSlidesAndTurnsOnAPlaneIsNotLetIn(long seed) {
        run(new RandomScene(seed, true, true), seed, 1e-6, 1e-4);
    }

    /** Driven bodies of several parts in steps of 1 s, that strike what lies on others: these were 2 · 10⁻⁴ deep, and relieved. */
    @Test
    void whatIsStruckInALongStepIsNotLetIn() {
        run(new RandomScene(320, true, true), 320, 1e-6, 1e-6);
    }

    private static void run(long seed, boolean mayDrive) {
        run(new RandomScene(seed, mayDrive), seed, 1e-5, mayDrive ? 1e-6 : 1e-9);
    }

    private static void run(RandomScene scene, long seed, double deepest, double deepestStruck) {
        for (int k = 0; k < STEPS; k++) {
            scene.change();
            double energy = scene.engine.kineticEnergy();
            scene.step();
            String when = "seed " + seed + ", step " + k;
            assertFinite(scene, when);
            assertThat(depth(scene)).as(when + ", depth").isLessThan(deepest);
            assertThat(scene.impactsInStep).as(when + ", impacts").isLessThanOrEqualTo(MOST_IMPACTS);
            if (scene.passive) {
                assertThat(scene.engine.kineticEnergy()).as(when + ", energy").isLessThanOrEqualTo(energy * (1 + 1e-12));
            }
        }
        assertThat(scene.engine.getDeepestPenetration()).as("seed " + seed).isLessThan(deepestStruck);
    }

    /** Fast bodies in corners, at steps of an eighth to half a second, collapse on one another: they are stopped, and not let in. */
    @ParameterizedTest
    @ValueSource(longs = {581, 845, 852, 1302, 1804})
    void wedgedBodiesAreNotLetIn(long seed) {
        RandomScene scene = new RandomScene(seed, true);
        for (int k = 0; k < STEPS; k++) {
            scene.change();
            scene.step();
            assertFinite(scene, "step " + k);
            assertThat(depth(scene)).as("step " + k).isLessThan(1e-5);
        }
    }

    /** Twenty bodies of 0.02 to 18 kg run into a corner together in steps of 0.28 s. */
    @Test
    void aCrowdInACornerIsNotLetIn() {
        RandomScene scene = new RandomScene(180, true);
        for (int k = 0; k < 30; k++) {
            scene.change();
            double energy = scene.engine.kineticEnergy();
            scene.step();
            assertThat(depth(scene)).as("step " + k).isLessThan(1e-5);
            // forces give at most 0.4 of what is there at 0 in a step, and no impact gives anything
            assertThat(scene.engine.kineticEnergy()).as("step " + k).isLessThan(2 * energy);
        }
    }

    /** A listener removes a body at the instant at which its pair in a heap closes. */
    @Test
    void whatAListenerRemovesAsItsHeapIsSolvedIsGone() {
        RandomScene scene = new RandomScene(950, true);
        for (int k = 0; k < STEPS; k++) {
            scene.change();
            scene.step();
            assertFinite(scene, "step " + k);
        }
    }

    private static double depth(RandomScene scene) {
        return scene.engine.overlaps().stream().mapToDouble(Overlap::depth).max().orElse(0);
    }

    private static void assertFinite(RandomScene scene, String when) {
        for (Body b : scene.engine.bodies()) {
            double sum = b.getX() + b.getY() + b.getAngle() + b.getVelocityX() + b.getVelocityY() + b.getAngularVelocity();
            assertThat(Double.isFinite(sum)).as(when + ", " + b).isTrue();
        }
    }
}
