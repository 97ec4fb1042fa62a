// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos;

import static org.assertj.core.api.Assertions.assertThat;

import demos.robots.Robots;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.Checkpoint;

/** All cans end at home and all robots return, whatever the seed; a checkpoint in the middle changes nothing. */
class RobotsTest {
    private static Robots robots(long seed, int robots, int cans) {
        Robots model = new Robots(seed);
        model.setRobots(robots);
        model.setCans(cans);
        model.start();
        return model;
    }

    @ParameterizedTest
    @CsvSource({"2, 4, 20", "5, 20, 2", "10, 30, 1"})
    void everyCanGetsHomeAndEveryRobotReturns(int robots, int cans, int seeds) {
        collect(robots, cans, seeds);
    }

    @Tag("soak")
    @ParameterizedTest
    @CsvSource({"2, 4, 300", "5, 20, 100", "10, 30, 100"})
    void theyDoSoForHundredsOfSeeds(int robots, int cans, int seeds) {
        collect(robots, cans, seeds);
    }

    private static void collect(int robots, int cans, int seeds) {
        List<Long> steps = new ArrayList<>();
        for (long seed = 1; seed <= seeds; seed++) {
            Robots model = robots(seed, robots, cans);
            while (!model.isDone() && model.physics.getSteps() < 100_000) {
                model.schedule.step(model);
            }
            assertThat(model.isDone()).as("%d robots, %d cans, seed %d", robots, cans, seed).isTrue();
            assertThat(model.physics.allConstraints()).hasSize(2 * robots);
            steps.add(model.physics.getSteps());
        }
        Collections.sort(steps);
        if (robots == 2) {
            assertThat(steps.get(steps.size() / 2)).isLessThanOrEqualTo(2213);
        }
    }

    @Test
    void aCheckpointWhileACanIsCarriedContinuesBitForBit() {
        Robots model = robots(7, 2, 4);
        while (model.physics.allConstraints().size() == 4) {
            model.schedule.step(model);
        }
        Robots restored = Checkpoint.copy(model);
        for (int k = 0; k < 1500; k++) {
            model.schedule.step(model);
            restored.schedule.step(restored);
        }
        Checkpoint.assertSameBodies(model.physics, restored.physics);
    }
}
