// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** Two ways to the time of impact, which share no arithmetic, agree; and nothing overlaps before it. */
class SeparatingLineTest extends MovingPair {
    private static final double END = 1;

    private final TimeOfImpact reference = new TimeOfImpact(pose, features);

    SeparatingLineTest() {
        super(77);
    }

    @Test
    void agreesWithConservativeAdvancement() {
        trajectories.begin(0, END);
        trajectories.ensure(2);
        int contacts = 0;
        int decided = 0;
        int forGood = 0;
        for (int k = 0; k < 6000; k++) {
            int kind = k % 5;
            double spin = k % 7 == 0 ? 0 : k % 3 == 0 ? 30 : 3;
            place(0, shape(kind % 3), 0, 0, spin);
            place(1, shape(kind < 3 ? 1 : 2), between(-5, 5), between(-5, 5), spin);
            if (gap(0) <= 0) {
                continue;
            }
            double found = line.search(0, shapes.base(0), 1, shapes.base(1), 0, END, ClosestFeatures.NO_FEATURES);
            boolean touching = line.touching;
            decided += line.undecided ? 0 : 1;
            double until = Math.min(10 * END, found);
            forGood += !line.undecided && found == Double.POSITIVE_INFINITY ? 1 : 0;
            for (int i = 0; i < 200; i++) {
                assertThat(gap(until * i / 200)).as("pair %d at %d", k, i).isGreaterThan(-1e-13);
            }
            pose.load(0, 1);
            double expected = reference.search(0, END, ClosestFeatures.NO_FEATURES);
            if (line.undecided) {
                continue;
            }
            assertThat(touching).as("pair %d", k).isEqualTo(reference.touching);
            if (touching) {
                contacts++;
                assertThat(found).as("pair %d", k).isCloseTo(expected, within(1e-11));
                assertThat(gap(found)).as("pair %d", k).isCloseTo(0, within(1e-13));
            }
        }
        assertThat(contacts).isGreaterThan(500);
        assertThat(decided).isGreaterThan(4000);
        assertThat(forGood).isGreaterThan(1000);
    }
}
