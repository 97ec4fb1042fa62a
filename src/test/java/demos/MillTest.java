// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import demos.mill.Mill;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.motion.Body;

/** Toothed wheels turn one another by their teeth, in the ratio of these, and what tumbles in the drum stays there. */
class MillTest {
    @ParameterizedTest
    @CsvSource({"0, 1e-3", "4, 0.3"})
    void theDrumGoesAsItsTeethSay(int substeps, double depth) {
        Mill model = new Mill(1);
        model.setSubsteps(substeps);
        model.start();
        for (int k = 0; k < 300; k++) {
            model.schedule.step(model);
            if (k % 50 == 0) {
                assertThat(model.physics.overlaps()).allSatisfy(overlap -> assertThat(overlap.depth()).isLessThan(depth));
            }
        }
        double start = 0.8 * Math.PI;
        double wheel = model.wheel.getAngle() - start - Math.PI;
        double drum = model.drum.getAngle() - start + Math.PI / Mill.DRUM;
        assertThat(wheel).isEqualTo(4 * 300 / 60.0, within(0.1));
        assertThat(drum).isEqualTo(-wheel * Mill.WHEEL / Mill.DRUM, within(0.5 * 2 * Math.PI / Mill.DRUM)); // teeth have some play
        for (Body body : model.physics.bodies()) {
            double from = Math.hypot(body.getX() - model.drum.getX(), body.getY() - model.drum.getY());
            assertThat(body == model.wheel || from < 61).as("%s", body).isTrue();
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aCheckpointContinuesBitForBit(int substeps) {
        Mill model = new Mill(2);
        model.setSubsteps(substeps);
        model.start();
        for (int k = 0; k < 100; k++) {
            model.schedule.step(model);
        }
        Mill restored = Checkpoint.copy(model);
        for (int k = 0; k < 50; k++) {
            model.schedule.step(model);
            restored.schedule.step(restored);
        }
        Checkpoint.assertSameBodies(model.physics, restored.physics);
    }
}
