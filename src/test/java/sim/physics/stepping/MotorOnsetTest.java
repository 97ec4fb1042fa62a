// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.motion.Body;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Time stepping: what a motor that has just been set moves within the step meets what is in its way, and does not jump over it. */
class MotorOnsetTest {
    private static PhysicsEngine engine(int substeps) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 60);
        engine.setTimeStepping(substeps);
        return engine;
    }

    private static Body put(PhysicsEngine engine, Body body) {
        body.setRestitution(0);
        body.setFriction(0.1);
        return engine.add(body);
    }

    /** A pinball's flipper, which turns by a third of a radian in its first step. A ball of a tenth of its mass is not slowed much. */
    @ParameterizedTest
    @ValueSource(ints = {4, 16})
    void aFlipperThrowsTheBall(int substeps) {
        for (int k = 0; k < 24; k++) {
            PhysicsEngine engine = engine(substeps);
            Body flipper = put(engine, new Body(new Rectangle(1.75, 0.2)).at(0.875, 0));
            engine.add(new PinJoint(flipper, 0, 0));
            engine.add(Limit.angle(flipper, null, 0, 0.7));
            Motor motor = engine.add(Motor.turning(flipper, null, -20, 1000));
            Body ball = put(engine, new Body(new Circle(0.1)).at(1.3, 0.2 + 0.01 * k));
            for (int step = 0; step < 8; step++) {
                if (step == 2) {
                    motor.setSpeed(20);
                }
                engine.step();
                double height = flipper.localY(ball.getX(), ball.getY());
                assertThat(height).as("its centre is above the flipper, ball %d, step %d", k, step).isGreaterThan(0.1);
            }
            assertThat(ball.getVelocityY()).as("ball %d", k).isGreaterThan(15);
        }
    }

    /** A plate on a rail, which goes by half a metre in its first step. */
    @ParameterizedTest
    @CsvSource({"4, 0.02", "4, 0.2", "4, 0.4", "16, 0.2", "1, 0.2"})
    void aPlatePushesTheBall(int substeps, double gap) {
        PhysicsEngine engine = engine(substeps);
        Body plate = put(engine, new Body(new Rectangle(0.1, 1)).at(0, 0));
        SliderJoint rail = engine.add(new SliderJoint(plate, null, 0, 0, 1, 0));
        Motor motor = engine.add(Motor.sliding(rail, 0, 1e5));
        Body ball = put(engine, new Body(new Circle(0.1)).at(0.15 + gap, 0));
        for (int step = 0; step < 8; step++) {
            if (step == 2) {
                motor.setSpeed(30);
            }
            engine.step();
            assertThat(ball.getX() - plate.getX()).as("step %d", step).isGreaterThan(0.14);
        }
        assertThat(ball.getVelocityX()).isGreaterThan(29);
    }
}
