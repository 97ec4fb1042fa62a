// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import sim.physics.motion.Body;
import sim.physics.motion.State;
import sim.physics.shape.Circle;

/** What got lost within a step is told from what moves fast, and goes back. */
class StepStartTest {
    private final State state = new State();
    private final StepStart start = new StepStart();
    private final Body body = new Body(new Circle(0.5)).at(1, 2).moving(3, 4, 5);

    @Test
    void aBodyThatGotLostGoesBack() {
        state.add(body);
        start.keep(state);
        assertThat(start.hasLost(body.index(), state, 0.1)).isFalse();
        state.v()[0] = 100;
        assertThat(start.hasLost(body.index(), state, 0.1)).isFalse();
        state.v()[0] = 200;
        assertThat(start.hasLost(body.index(), state, 0.1)).isTrue();
        state.v()[0] = Double.NaN;
        state.x()[0] = Double.NaN;
        assertThat(start.hasLost(body.index(), state, 0.1)).isTrue();
        start.restore(body.index(), state);
        assertThat(body.getX()).isEqualTo(1);
        assertThat(body.getVelocityX()).isEqualTo(3);
        assertThat(start.hasLost(body.index(), state, 0.1)).isFalse();
    }
}
