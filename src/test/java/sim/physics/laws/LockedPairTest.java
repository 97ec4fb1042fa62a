// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import java.util.function.Consumer;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;

/**
 * A pin and a slider between the same two bodies lock them, with an equation to spare. Whatever a motor asks for, and wherever
 * a hand moves one of them, the other goes along, and stays there.
 */
class LockedPairTest {
    private static final double NEAR = 1e-9;

    private final PhysicsEngine engine = new PhysicsEngine();
    private final Body base = engine.add(Body.fixed(new Circle(0.5)).at(0, 0));
    private Body locked;
    private double far;

    private void lock(long seed, String motor) {
        SplittableRandom random = new SplittableRandom(seed);
        engine.setTimeStep(0.01);
        engine.add(new Gravity(0, -10));
        far = Math.pow(10, 2 * random.nextDouble() - 0.5);
        locked = engine.add(new Body(new Circle(0.5)).at(
                far * (2 * random.nextDouble() - 1), far * (2 * random.nextDouble() - 1), 3 * random.nextDouble()));
        locked.setMass(1);
        double x = locked.getX();
        double y = locked.getY();
        engine.add(new PinJoint(locked, base, x / 2, y / 2));
        SliderJoint slider = engine.add(new SliderJoint(base, locked, x / 2, y / 2, x, y));
        switch (motor) {
            case "slides" -> engine.add(Motor.sliding(slider, 1, 3));
            case "turns" -> engine.add(Motor.turning(locked, base, 1, 3));
            default -> engine.add(Motor.turning(locked, base, 0, 3));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"slides", "turns", "brakes"})
    void goesWhereTheOtherIsMoved(String motor) {
        move(motor, one -> one.base.setPosition(0.2, -0.1), 0.2, -0.1);
    }

    @ParameterizedTest
    @ValueSource(strings = {"slides", "turns", "brakes"})
    void goesBackWhenItIsMovedItself(String motor) {
        move(motor, one -> one.locked.setPosition(one.locked.getX() + 0.1, one.locked.getY() - 0.1), 0, 0);
    }

    private static void move(String motor, Consumer<LockedPairTest> hand, double dx, double dy) {
        for (long seed = 0; seed < 40; seed++) {
            LockedPairTest one = new LockedPairTest();
            one.lock(seed, motor);
            double x = one.locked.getX() + dx;
            double y = one.locked.getY() + dy;
            one.engine.step();
            hand.accept(one);
            for (int k = 0; k < 3; k++) {
                one.engine.step();
            }
            one.expect(x, y, seed);
        }
    }

    private void expect(double x, double y, long seed) {
        assertThat(Math.hypot(locked.getX() - x, locked.getY() - y)).as("way off, seed %d", seed).isLessThan(NEAR * far);
        assertThat(Math.hypot(locked.getVelocityX(), locked.getVelocityY())).as("speed, seed %d", seed).isLessThan(NEAR * far);
        assertThat(Math.abs(locked.getAngularVelocity())).as("turning, seed %d", seed).isLessThan(NEAR);
    }
}
