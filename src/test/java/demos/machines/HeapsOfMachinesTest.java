// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.machines;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/** Ragdolls jam between pegs, with stops and friction that all but hold them: no step explodes, or goes on for ever. */
class HeapsOfMachinesTest {
    @ParameterizedTest
    @CsvSource({"17, 3, 4, 240", "30, 3, 4, 210", "47, 3, 4, 130", "5, 3, 4, 265", "1, 6, 3, 300", "8, 4, 3, 260"})
    void jammedRagdollsGainNoEnergyAndSinkIntoNothing(long seed, int ragdolls, int rows, int steps) {
        HeapLaws.run(seed, ragdolls, rows, steps);
    }

    /**
     * What a step takes, in searches for impacts: one solution of a heap does for a step, or some do. Heaps of more than a hundred points and
     * stops had no solution (3 and 5 of these), and where regained gaps gave more energy than they may their time was divided as often as
     * could be (4): a thousand solutions a step, seconds each, for as long as they lay there.
     */
    @ParameterizedTest
    @CsvSource({"5, 6, 1, 290", "5, 6, 3, 262", "6, 6, 4, 122"})
    void jamsOfFiveAndSixRagdollsCostNotMuchMoreThanOthers(int ragdolls, int rows, long seed, int steps) {
        assertThat(HeapLaws.run(seed, ragdolls, rows, steps)).isLessThan(10_000);
    }

    @Tag("soak")
    @Test
    void theLawsHoldForSixtySeeds() {
        for (long seed = 1; seed <= 60; seed++) {
            HeapLaws.run(seed, 3, 4, 900);
        }
    }

    @Tag("soak")
    @ParameterizedTest
    @ValueSource(ints = {4, 5, 6})
    void theyHoldForMoreRagdolls(int ragdolls) {
        for (int rows = 3; rows <= 6; rows++) {
            for (long seed = 1; seed <= 8; seed++) {
                HeapLaws.run(seed, ragdolls, rows, 500);
            }
        }
    }

    /** They pass through one another, and stay as deep in the ground as they are. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 9})
    void ragdollsThatArePutIntoOneAnotherGainNoEnergy(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, 98.1));
        engine.add(Body.fixed(new Rectangle(400, 20)).at(100, 200)).setFriction(0.8);
        for (int k = 0; k < 3; k++) {
            new Ragdoll(engine, 0.8, 100 + 20 * random.nextDouble(), 150 + 20 * random.nextDouble(), random.nextDouble() - 0.5);
        }
        assertThat(engine.overlaps()).isNotEmpty();
        double height = 0;
        for (Body body : engine.bodies()) {
            height += body.isFixed() ? 0 : 10 * body.getMass() * 98.1; // of a fall by 10, a third of what they are high
        }
        for (int k = 0; k < 100; k++) {
            double energy = HeapLaws.energy(engine);
            long impacts = engine.getImpacts();
            engine.step();
            assertThat(engine.getImpacts() - impacts).as("seed %d, step %d, impacts", seed, k).isLessThan(2000);
            assertThat(HeapLaws.energy(engine) - energy).as("seed %d, step %d, gain of energy", seed, k).isLessThan(2e-3 * height);
        }
    }

    /** Limbs that turn by more than a radian in a step come to lie all the same: bounces would be thousands, and end nowhere. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void aRagdollComesToLieInStepsOfAQuarterOfASecond(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.25);
        engine.add(new Gravity(0, 98.1));
        engine.add(Body.fixed(new Rectangle(400, 20)).at(100, 200)).setFriction(0.8);
        new Ragdoll(engine, 0.8, 100 + 4 * random.nextDouble(), 150 + 4 * random.nextDouble(), random.nextDouble() - 0.5);
        double energy = HeapLaws.energy(engine);
        for (int k = 0; k < 40; k++) {
            long impacts = engine.getImpacts();
            engine.step();
            assertThat(engine.getImpacts() - impacts).as("seed %d, step %d, impacts", seed, k).isLessThan(150);
            assertThat(HeapLaws.energy(engine)).as("seed %d, step %d, energy", seed, k).isLessThan(energy);
        }
        assertThat(engine.getDeepestPenetration()).isLessThan(1e-5);
    }
}
