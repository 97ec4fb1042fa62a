// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Impacts at one instant: mirror images are treated alike, to the bit, and the energy stays. */
class SymmetryTest {
    @Test
    void aBallHitsTwoBallsAtOnce() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.1);
        Body ball = engine.add(new Body(new Circle(1)).at(0, 0).moving(0, 1));
        Body left = engine.add(new Body(new Circle(1)).at(-1.1, 3));
        Body right = engine.add(new Body(new Circle(1)).at(1.1, 3));
        double energy = engine.kineticEnergy();
        for (int k = 0; k < 50; k++) {
            engine.step();
        }
        assertThat(engine.kineticEnergy() / energy).isCloseTo(1, within(1e-15));
        assertThat(left.getX()).isEqualTo(-right.getX());
        assertThat(left.getY()).isEqualTo(right.getY());
        assertThat(left.getVelocityX()).isEqualTo(-right.getVelocityX()).isNotZero();
        assertThat(left.getVelocityY()).isEqualTo(right.getVelocityY());
        assertThat(ball.getVelocityX()).isZero();
        assertThat(ball.getX()).isZero();
    }

    @Test
    void aPlankLandsFlatOnTwoBoxes() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.1);
        Body plank = engine.add(new Body(new Rectangle(10, 1)).at(0, 2).moving(0, -1));
        Body left = engine.add(new Body(new Rectangle(1, 1)).at(-4, 0));
        Body right = engine.add(new Body(new Rectangle(1, 1)).at(4, 0));
        double energy = engine.kineticEnergy();
        for (int k = 0; k < 50; k++) {
            engine.step();
        }
        assertThat(engine.kineticEnergy() / energy).isCloseTo(1, within(1e-15));
        assertThat(plank.getAngularVelocity()).isZero();
        assertThat(plank.getVelocityX()).isZero();
        assertThat(left.getVelocityY()).isEqualTo(right.getVelocityY()).isNegative();
        assertThat(left.getX()).isEqualTo(-right.getX());
        assertThat(left.getAngle()).isEqualTo(-right.getAngle());
    }

    @Test
    void aCradleWithoutGapsPassesTheMomentumOn() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.1);
        Body[] balls = new Body[6];
        balls[0] = engine.add(new Body(new Circle(0.5)).at(-3, 0).moving(5, 0));
        for (int k = 1; k < 6; k++) {
            balls[k] = engine.add(new Body(new Circle(0.5)).at(k, 0));
        }
        for (int k = 0; k < 20; k++) {
            engine.step();
        }
        for (int k = 0; k < 5; k++) {
            assertThat(balls[k].getVelocityX()).isCloseTo(0, within(1e-15));
        }
        assertThat(balls[5].getVelocityX()).isCloseTo(5, within(1e-14));
        assertThat(engine.getImpacts()).isEqualTo(5);
    }
}
