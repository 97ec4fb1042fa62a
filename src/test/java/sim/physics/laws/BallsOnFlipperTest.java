// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.collision.Overlap;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * Two balls fall on a flipper that a motor presses against its stop, and roll down on it and over one another. Nothing happens there that costs much:
 * contacts that are as deep as they may be, and whose way leads out, were found 2,000 times at one instant.
 */
class BallsOnFlipperTest {
    private static final double TILT = 0.5;

    @ParameterizedTest
    @CsvSource({"0, 0, 3", "0, 0, 300", "0, 0.3, 3", "0, 0.3, 300", "0.3, 0, 3", "0.3, 0.3, 300", "0.3, 0.6, 300"})
    void noStepCostsMuch(double friction, double restitution, double torque) {
        for (int seed = 0; seed < 40; seed++) {
            PhysicsEngine physics = new PhysicsEngine();
            physics.setTimeStep(1.0 / 120);
            physics.add(new Gravity(0, -3));
            Body flipper = new Body(new Rectangle(1.5, 0.3)).at(0.75 * StrictMath.cos(TILT), 0.75 * StrictMath.sin(TILT), TILT);
            add(physics, flipper, 2, friction, restitution);
            physics.add(new PinJoint(flipper, 0, 0));
            physics.add(Motor.turning(flipper, null, -20, torque));
            physics.add(Limit.angle(flipper, null, 0, 1));
            Random random = new Random(seed);
            for (int k = 0; k < 2; k++) {
                double x = 0.3 + 0.9 * random.nextDouble();
                add(physics, new Body(new Circle(0.3)).at(x, 2 + 1.7 * k + random.nextDouble()), 0.08, friction, restitution);
            }
            for (int step = 0; step < 300; step++) {
                long before = physics.getWork();
                physics.step();
                assertThat(physics.getWork() - before).as("seed %s, step %s", seed, step).isLessThanOrEqualTo(10_000);
                double deepest = physics.overlaps().stream().mapToDouble(Overlap::depth).max().orElse(0);
                assertThat(deepest).as("seed %s, step %s", seed, step).isLessThanOrEqualTo(1.2e-7);
            }
            assertThat(physics.getRelievedSteps()).isZero();
        }
    }

    @ParameterizedTest
    @CsvSource({"0.2, 0.3", "0, 0", "0.3, 0"})
    void aFlipperThatThrowsBallsDoesNotPassItsStops(double friction, double restitution) {
        for (int seed = 0; seed < 20; seed++) {
            PhysicsEngine physics = new PhysicsEngine();
            physics.setTimeStep(1.0 / 120);
            physics.add(new Gravity(0, -3));
            Body wall = Body.fixed(new Rectangle(0.5, 8)).at(-0.25, 4);
            wall.setRestitution(restitution);
            wall.setFriction(friction);
            physics.add(wall);
            Body flipper = new Body(new Rectangle(1.5, 0.3)).at(0.75 * StrictMath.cos(TILT), -0.75 * StrictMath.sin(TILT), -TILT);
            flipper.setCollisionGroup(2, 4);
            add(physics, flipper, 2, friction, restitution);
            physics.add(new PinJoint(flipper, 0, 0));
            Motor motor = physics.add(Motor.turning(flipper, null, -20, 300));
            Limit stops = physics.add(Limit.angle(flipper, null, 0, 1));
            Random random = new Random(seed);
            for (int k = 0; k < 3; k++) {
                Body ball = new Body(new Circle(0.3)).at(0.35 + 0.7 * random.nextDouble(), 1 + 0.7 * k + 0.1 * random.nextDouble());
                ball.setCollisionGroup(4, -1);
                add(physics, ball, 0.08, friction, restitution);
            }
            for (int step = 0; step < 360; step++) {
                motor.setSpeed(step % 60 < 20 ? 20 : -20);
                physics.step();
                assertThat(stops.getValue()).as("seed %s, step %s", seed, step).isBetween(-1e-9, 1 + 1e-9);
            }
        }
    }

    private static void add(PhysicsEngine physics, Body body, double mass, double friction, double restitution) {
        body.setMass(mass);
        body.setFriction(friction);
        body.setRestitution(restitution);
        physics.add(body);
    }
}
