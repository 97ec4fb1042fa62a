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
 * Bodies that are pinned where they lie press others against the ground, where impulses without bounds do as well as small ones: nothing
 * is thrown about by these.
 */
class RandomMachineTest {
    private static final int STEPS = 240;

    /** A fall through the whole box, and what motors and shoves may add, are far less. */
    private static final double FAST = 100;

    private static void run(long seed) {
        RandomMachine scene = new RandomMachine(seed);
        for (int step = 0; step < STEPS; step++) {
            scene.step();
            for (Body body : scene.bodies) {
                double speed = Math.hypot(body.getVelocityX(), body.getVelocityY());
                assertThat(speed).as("seed %s, step %s, %s", seed, step, body).isLessThan(FAST);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {34, 66, 85, 181, 219, 285})
    void nothingIsThrownAbout(long seed) {
        run(seed);
    }

    /**
     * Bodies that turn on one another, and are tied, kept forces along normals that had turned away: this gave energy, was given up for that,
     * and they sank into one another, twice as deep in each step.
     */
    @ParameterizedTest
    @ValueSource(longs = {48, 87, 107, 151})
    void nothingSinksIn(long seed) {
        RandomMachine scene = new RandomMachine(seed);
        for (int step = 0; step < STEPS; step++) {
            scene.step();
            double deepest = 0;
            for (Overlap overlap : scene.engine.overlaps()) {
                deepest = Math.max(deepest, overlap.depth());
            }
            assertThat(deepest).as("seed %s, step %s", seed, step).isLessThan(1e-5);
        }
    }

    /**
     * A body that can only turn, and that friction stops as soon as it does, met the ground 10^5 times in a step, at whatever restitution;
     * it comes to lie.
     */
    @ParameterizedTest
    @ValueSource(longs = {156, 177, 288})
    void whatIsWedgedComesToLie(long seed) {
        RandomMachine scene = new RandomMachine(seed);
        for (int step = 0; step < STEPS; step++) {
            long before = scene.engine.getImpacts();
            scene.step();
            assertThat(scene.engine.getImpacts() - before).as("seed %s, step %s", seed, step).isLessThan(2000);
        }
    }

    /** Forces from which the search for those of a heap set out bent a rod that a machine stood on beyond what keeps it closed. */
    @Test
    void forcesThatJointsCannotBearAreForgotten() {
        run(415);
    }

    @Tag("soak")
    @Test
    void nothingIsThrownAboutInOneHundredRuns() {
        for (long seed = 0; seed < 100; seed++) {
            run(seed);
        }
    }
}
