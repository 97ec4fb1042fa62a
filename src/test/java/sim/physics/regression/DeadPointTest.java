// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.ConstraintException;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * Two bars in line, a rod along them whose ends are in line with their pin, and a motor at it: a pose that lets nothing pass to
 * second order. A motor's torque led anywhere there, and the step was refused as if its author had set what cannot be.
 */
class DeadPointTest {
    private static final double G = 9.81;

    private final PhysicsEngine engine = new PhysicsEngine();

    private Body machine(double length, double speed, double torque) {
        engine.setWorkLimit(200_000);
        engine.add(new Gravity(0, -G * length));
        Body low = engine.add(new Body(new Rectangle(0.08 * length, 0.5 * length)).at(0, 0.25 * length));
        Body high = engine.add(new Body(new Rectangle(0.08 * length, 0.5 * length)).at(0, 0.75 * length));
        engine.add(new PinJoint(low, high, 0, 0.5 * length));
        engine.add(Motor.turning(high, low, speed, torque * low.getMass() * G * length * length));
        engine.add(new RodJoint(low, 0, 0.15 * length, high, 0, 0.9 * length));
        return high;
    }

    /** The whole falls freely, whatever acts within it; and time goes on. */
    @ParameterizedTest
    @CsvSource({"1, 0.5, 0.1, 60", "1, 10, 10, 60", "0.01, 2, 1, 60", "100, 10, 0.1, 60", "1, 2, 0.1, 10", "100, 10, 10, 10"})
    void aMachineAtADeadPointIsNotRefused(double length, double speed, double torque, int steps) {
        engine.setTimeStep(1.0 / steps);
        Body high = machine(length, speed, torque);
        for (int k = 1; k <= steps / 2; k++) {
            engine.step();
            assertThat(Math.abs(high.getVelocityY() + G * length * engine.getTime())).as("step %d", k).isLessThan(1.1 * length * speed);
        }
        assertThat(engine.getSteps()).isEqualTo(steps / 2);
        assertThat(engine.getTimeStepping()).isZero();
    }

    /** What its author has put where it cannot be closed is refused beside such a machine, too. */
    @Test
    void aJointThatCannotBeClosedIsRefusedAllTheSame() {
        engine.setTimeStep(1 / 60.0);
        machine(1, 0.5, 0.001);
        Body ball = engine.add(new Body(new Circle(1)).at(30, 0));
        engine.add(new SliderJoint(ball, null, 30, 0, 1, 1));
        ball.setAngle(Double.MAX_VALUE);
        assertThatThrownBy(engine::step).isInstanceOf(ConstraintException.class);
        assertThat(engine.getSteps()).isZero();
    }
}
