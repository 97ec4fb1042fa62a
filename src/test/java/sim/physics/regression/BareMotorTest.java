// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Motor;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * A motor turns a disc against the world, and nothing else holds it: its pin was taken away, or never was. As it lay down,
 * the motor was let go for a look at what contacts have to do, and the island was a tree with no pins, which had no first one.
 */
class BareMotorTest {
    private static final double STEP = 1.0 / 60;
    private static final double GRAVITY = 9.81;
    private static final double RADIUS = 0.5;
    private static final double TORQUE = 0.3;
    private static final double SPEED = 4;

    private final PhysicsEngine engine = new PhysicsEngine();
    private final Body disc = new Body(new Circle(RADIUS)).at(0, RADIUS);

    BareMotorTest() {
        engine.setTimeStep(STEP);
        engine.add(new Gravity(0, -GRAVITY));
        Body ground = engine.add(Body.fixed(new Rectangle(100, 1)).at(0, -0.5));
        engine.add(disc);
        for (Body body : new Body[] {ground, disc}) {
            body.setFriction(0.8);
            body.setRestitution(0);
        }
    }

    @Test
    void rollsOffAndKeepsItsSpeed() {
        engine.add(Motor.turning(disc, null, -SPEED, TORQUE));
        double spinUp = TORQUE / (disc.getInertia() + disc.getMass() * RADIUS * RADIUS); // it rolls
        int steps = 40;
        run(steps);
        assertThat(disc.getAngularVelocity()).isCloseTo(-spinUp * steps * STEP, within(1e-9));
        assertThat(disc.getVelocityX()).isCloseTo(-RADIUS * disc.getAngularVelocity(), within(1e-9));
        run(1200);
        assertThat(disc.getAngularVelocity()).isCloseTo(-SPEED, within(1e-9));
        assertThat(disc.getVelocityX()).isCloseTo(SPEED * RADIUS, within(1e-9));
        assertThat(disc.getY()).isCloseTo(RADIUS, within(1e-4));
    }

    private void run(int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }
}
