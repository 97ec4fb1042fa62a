// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.shape.Rectangle;

/** Where a point of a body is in the world. */
class BodyPointTest {
    @Test
    void turnsWithTheBody() {
        Body body = new Body(new Rectangle(4, 2)).at(10, 20, 0.5 * StrictMath.PI);
        assertThat(body.worldX(2, 1)).isCloseTo(10 - 1, within(1e-14));
        assertThat(body.worldY(2, 1)).isCloseTo(20 + 2, within(1e-14));
    }

    @Test
    void goesInACircleAboutAMovingCentre() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.25);
        Body body = engine.add(new Body(new Rectangle(4, 2)).at(1, 2).moving(3, -1, 2));
        engine.step();
        assertThat(body.worldX(2, 0)).isCloseTo(1 + 0.75 + 2 * StrictMath.cos(0.5), within(1e-14));
        assertThat(body.worldY(2, 0)).isCloseTo(2 - 0.25 + 2 * StrictMath.sin(0.5), within(1e-14));
    }

    @Test
    void refusesWhatIsNoPoint() {
        Body body = new Body(new Rectangle(4, 2));
        assertThatThrownBy(() -> body.worldX(Double.NaN, 0)).hasMessageContaining("px is NaN");
        assertThatThrownBy(() -> body.worldY(0, Double.POSITIVE_INFINITY)).hasMessageContaining("py is Infinity");
    }
}
