// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.State;
import sim.physics.shape.Rectangle;

/** What is solved for joints is work: by their number, and as often as it is done. */
class EffortTest {
    private static final int LINKS = 40;

    private final State state = new State();
    private final Constraints constraints = new Constraints(state);
    private final double[] a = new double[State.BLOCK * LINKS + 1000];

    private IntList chain() {
        Body last = null;
        for (int k = 0; k < LINKS; k++) {
            Body link = new Body(new Rectangle(1, 0.1)).at(k + 0.5, 0.1 * (k % 3)).moving(0, 0.01 * (k % 5), 0);
            state.add(link);
            constraints.add(new PinJoint(link, last, k, 0));
            last = link;
        }
        constraints.regroup();
        return constraints.island(0);
    }

    @Test
    void eachSolutionCounts() {
        IntList bodies = chain();
        constraints.takeEffort(bodies);
        constraints.accelerate(bodies, a, true);
        long one = constraints.takeEffort(bodies);
        assertThat(one).isBetween(LINKS / 4L, 8L * LINKS);
        for (int k = 0; k < 10; k++) {
            constraints.accelerate(bodies, a, true);
        }
        assertThat(constraints.takeEffort(bodies)).isBetween(10 * one, 10 * one + 10);
        assertThat(constraints.takeEffort(bodies)).isZero();
        for (int k = 0; k < 10; k++) {
            state.x()[1] += 1e-3;
            constraints.project(bodies);
        }
        assertThat(constraints.takeEffort(bodies)).isGreaterThan(10 * one);
    }

    @Test
    void whatIsAskedBetweenStepsDoesNot() {
        IntList bodies = chain();
        constraints.accelerate(bodies, a, true);
        long one = constraints.takeEffort(bodies);
        constraints.accelerate(bodies, a, false);
        assertThat(one).isPositive();
        assertThat(constraints.takeEffort(bodies)).isZero();
    }
}
