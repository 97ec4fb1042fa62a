// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/** Motors give their torque and no more, until the very instant of their speed; stops stop at the very angle. */
class MotorLimitTest {
    private static final double INERTIA = 3;

    private static Body wheel(PhysicsEngine engine, double spin) {
        Body wheel = engine.add(new Body(new Rectangle(2, 2)).moving(0, 0, spin));
        wheel.setMass(1, INERTIA);
        engine.add(new PinJoint(wheel, 0, 0));
        return wheel;
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 0.3, 0.1})
    void aMotorReachesItsSpeedWhenItsTorqueSays(double step) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        Body wheel = wheel(engine, 0);
        engine.add(Motor.turning(wheel, null, 2, 1.7));
        double reached = INERTIA * 2 / 1.7;
        while (engine.getTime() < 6) {
            engine.step();
            double t = engine.getTime();
            double angle = t < reached
                    ? 0.5 * 1.7 / INERTIA * t * t
                    : 0.5 * 1.7 / INERTIA * reached * reached + 2 * (t - reached);
            assertThat(wheel.getAngularVelocity()).isCloseTo(Math.min(2, 1.7 / INERTIA * t), within(1e-11));
            assertThat(wheel.getAngle()).isCloseTo(angle, within(1e-11));
        }
    }

    @Test
    void aBrakeStopsAWheelAndHoldsIt() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.25);
        Body wheel = wheel(engine, -4);
        engine.add(Motor.turning(wheel, null, 0, 6));
        for (int k = 0; k < 20; k++) {
            engine.step();
        }
        assertThat(wheel.getAngularVelocity()).isZero();
        assertThat(wheel.getAngle()).isCloseTo(-0.5 * 16 * INERTIA / 6, within(1e-11));
    }

    @Test
    void aMotorThatIsTooWeakFallsWithItsTorque() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 64.0);
        engine.add(new Gravity(0, -10));
        Body arm = engine.add(new Body(new Rectangle(2, 0.1)).at(1, 0));
        arm.setMass(1, 1 / 3.0);
        engine.add(new PinJoint(arm, 0, 0));
        engine.add(Motor.turning(arm, null, 0, 4)); // it would need 10
        for (int k = 0; k < 40; k++) {
            engine.step();
        }
        double work = 10 * -arm.getY() + 4 * arm.getAngle();
        assertThat(arm.getAngle()).isLessThan(-0.2);
        assertThat(arm.kineticEnergy()).isCloseTo(work, within(1e-7 * work));
    }

    @Test
    void aMotorThatIsStrongHoldsAnArm() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 64.0);
        engine.add(new Gravity(0, -10));
        Body arm = engine.add(new Body(new Rectangle(2, 0.1)).at(1, 0));
        engine.add(new PinJoint(arm, 0, 0));
        engine.add(Motor.turning(arm, null, 0, 20));
        for (int k = 0; k < 1000; k++) {
            engine.step();
        }
        assertThat(arm.getAngle()).isCloseTo(0, within(1e-13));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 1})
    void aStopIsHitAtItsAngleAfterManyTurns(double restitution) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.7);
        Body wheel = wheel(engine, 3);
        double bound = 1e3 + 0.123;
        engine.add(new Limit(
                new sim.physics.constraint.GearJoint(wheel, null, -1), Double.NEGATIVE_INFINITY, bound, restitution));
        for (int k = 0; k < 600; k++) {
            engine.step();
        }
        double after = engine.getTime() - bound / 3;
        assertThat(wheel.getAngle()).isCloseTo(bound - restitution * 3 * after, within(1e-7));
        assertThat(wheel.getAngularVelocity()).isCloseTo(-3 * restitution, within(1e-12));
    }

    @Test
    void aStopBearsAnArm() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -10));
        Body arm = engine.add(new Body(new Rectangle(2, 0.1)).at(1, 0));
        engine.add(new PinJoint(arm, 0, 0));
        engine.add(Limit.angle(arm, null, -0.5, 0.5));
        for (int k = 0; k < 600; k++) {
            engine.step();
            assertThat(arm.getAngle()).isGreaterThan(-0.5 - 1e-10);
        }
        assertThat(arm.getAngle()).isCloseTo(-0.5, within(1e-10));
        assertThat(arm.getAngularVelocity()).isCloseTo(0, within(1e-12));
    }

    @Test
    void aRopeHangsSlackUntilItIsTaut() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -10));
        Body weight = engine.add(new Body(new Rectangle(0.2, 0.2)).at(0, 0));
        engine.add(Limit.rope(weight, 0, 0, null, 0, 0.000001, 2));
        for (int k = 0; k < 30; k++) {
            engine.step();
        }
        assertThat(weight.getY()).isCloseTo(-0.5 * 10 * 0.25, within(1e-12));
        for (int k = 0; k < 200; k++) {
            engine.step();
        }
        assertThat(weight.getY()).isCloseTo(-2 + 1e-6, within(1e-9));
    }
}
