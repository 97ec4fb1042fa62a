// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
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

/** Motors whose coordinate, or another one of their machine, hits a stop within a step. */
class MotorAtStopTest {
    private static final double STEP = 0.1;
    private static final double WAY = 0.05;

    private final PhysicsEngine engine = new PhysicsEngine();

    MotorAtStopTest() {
        engine.setTimeStep(STEP);
    }

    /** A wheel that is faster than its motor wants bounces off a stop, and is driven to the motor's speed from then on, and not away from it. */
    @ParameterizedTest
    @ValueSource(doubles = {0.25, 0.5, 1})
    void aMotorDrivesToItsSpeedAfterAnImpact(double restitution) {
        Body wheel = engine.add(new Body(new Circle(1)).at(0, 0).moving(0, 0, 2));
        engine.add(new PinJoint(wheel, 0, 0));
        double push = 3;
        engine.add(Motor.turning(wheel, null, 1, push * wheel.getInertia()));
        engine.add(Limit.angle(wheel, null, -1, WAY, restitution));
        engine.step();
        double hit = (2 - Math.sqrt(4 - 2 * push * WAY)) / push; // 2 t − push t² / 2 = WAY
        double rate = -restitution * (2 - push * hit) + push * (STEP - hit);
        assertThat(wheel.getAngularVelocity()).isCloseTo(rate, within(1e-10));
    }

    /** A motor that has its speed drives its coordinate into a stop: that turns the rate by its restitution, as no motor is as strong as an impact. */
    @ParameterizedTest
    @CsvSource({"0.25, false", "0.5, false", "1, false", "0.25, true", "0.5, true", "1, true"})
    void aMotorDoesNotChangeTheRestitutionOfItsStop(double restitution, boolean slides) {
        Body body = engine.add(new Body(new Circle(1)).at(0, 0));
        double push = 5;
        if (slides) {
            SliderJoint rail = engine.add(new SliderJoint(body, null, 0, 0, 1, 0));
            engine.add(Motor.sliding(rail, 1, push * body.getMass()));
            engine.add(Limit.travel(rail, -1, WAY, restitution));
            body.setVelocity(1, 0);
        } else {
            engine.add(new PinJoint(body, 0, 0));
            engine.add(Motor.turning(body, null, 1, push * body.getInertia()));
            engine.add(Limit.angle(body, null, -1, WAY, restitution));
            body.setAngularVelocity(1);
        }
        engine.step();
        double rate = -restitution + push * (STEP - WAY);
        assertThat(slides ? body.getVelocityX() : body.getAngularVelocity()).isCloseTo(rate, within(1e-10));
    }

    /** A rod that its motor turns round within a step has met its stop in between. */
    @Test
    void aStopIsMetThatIsLeftAgainBeforeTheMotorHasItsSpeed() {
        Body rod = engine.add(new Body(new Rectangle(1, 0.1)).at(0.5, 0).moving(0, 0.5, 1));
        engine.add(new PinJoint(rod, 0, 0));
        double inertia = rod.getInertia() + 0.25 * rod.getMass();
        double push = 40;
        engine.add(Motor.turning(rod, null, -2, push * inertia));
        double deepest = 1 / (2 * push);
        double bound = 0.8 * deepest;
        engine.add(Limit.angle(rod, null, -1, bound, 0));
        engine.step();
        double hit = (1 - Math.sqrt(1 - 2 * push * bound)) / push; // at which it stops, and goes back
        double turned = 2 / push;
        double angle = bound - push * turned * turned / 2 - 2 * (STEP - hit - turned);
        assertThat(rod.getAngle()).isCloseTo(angle, within(1e-10));
        assertThat(rod.getAngularVelocity()).isCloseTo(-2, within(1e-12));
    }
}
