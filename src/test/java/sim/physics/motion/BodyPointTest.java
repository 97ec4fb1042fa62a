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
    void thereAndBackIsThePointItself() {
        Body body = new Body(new Rectangle(4, 2)).at(10, 20, 0.7);
        assertThat(body.localX(body.worldX(2, 1), body.worldY(2, 1))).isCloseTo(2, within(1e-14));
        assertThat(body.localY(body.worldX(2, 1), body.worldY(2, 1))).isCloseTo(1, within(1e-14));
        body.at(10, 20, 0.5 * StrictMath.PI);
        assertThat(body.localX(10, 23)).isCloseTo(3, within(1e-14)); // ahead
        assertThat(body.localY(9, 20)).isCloseTo(1, within(1e-14)); // to the left
    }

    @Test
    void aPointHasTheVelocityOfThePlacesThatItGoesThrough() {
        Body body = new Body(new Rectangle(4, 2)).at(1, 2, 0.3).moving(3, -1, 2);
        double h = 1e-6;
        double x = body.worldX(2, -1);
        double y = body.worldY(2, -1);
        double vx = body.velocityX(2, -1);
        double vy = body.velocityY(2, -1);
        body.at(1 + 3 * h, 2 - h, 0.3 + 2 * h);
        assertThat(vx).isCloseTo((body.worldX(2, -1) - x) / h, within(1e-5));
        assertThat(vy).isCloseTo((body.worldY(2, -1) - y) / h, within(1e-5));
        assertThat(body.velocityX(0, 0)).isEqualTo(3);
    }

    @Test
    void aKickAtTheCentreDoesNotTurnAndATwistDoesNotPush() {
        Body body = new Body(new Rectangle(4, 2)).at(1, 2, 0.3).moving(3, -1, 2);
        body.setMass(2, 5);
        body.addImpulse(4, 6);
        body.addAngularImpulse(-15);
        assertThat(body.getVelocityX()).isEqualTo(5);
        assertThat(body.getVelocityY()).isEqualTo(2);
        assertThat(body.getAngularVelocity()).isEqualTo(-1);
        Body wall = Body.fixed(new Rectangle(1, 1));
        assertThatThrownBy(() -> wall.addImpulse(1, 0)).hasMessageContaining("fixed");
        assertThatThrownBy(() -> wall.addAngularImpulse(1)).hasMessageContaining("fixed");
        assertThatThrownBy(() -> body.addImpulse(1, Double.NaN)).hasMessageContaining("ry is NaN");
        assertThatThrownBy(() -> body.addAngularImpulse(Double.NaN)).hasMessageContaining("turn is NaN");
        assertThatThrownBy(() -> body.localX(1, Double.NaN)).hasMessageContaining("y is NaN");
        assertThatThrownBy(() -> body.velocityX(Double.NaN, 0)).hasMessageContaining("px is NaN");
        assertThat(body.getAngularVelocity()).isEqualTo(-1);
    }

    @Test
    void refusesWhatIsNoPoint() {
        Body body = new Body(new Rectangle(4, 2));
        assertThatThrownBy(() -> body.worldX(Double.NaN, 0)).hasMessageContaining("px is NaN");
        assertThatThrownBy(() -> body.worldY(0, Double.POSITIVE_INFINITY)).hasMessageContaining("py is Infinity");
    }
}
