// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.GearJoint;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/**
 * Hard case J17: angles are not wrapped, so stops, motors and gears work after a million turns as they do at once, to the
 * digits that such an angle has.
 */
class ManyTurnsTest {
    private static final double TURN = 2 * StrictMath.PI;
    private static final double MILLION = 1e6 * TURN;
    private static final double SPIN = 1e4;

    private final PhysicsEngine engine = new PhysicsEngine();

    private Body wheel(double x, double angle, double spin) {
        Body wheel = engine.add(new Body(new Rectangle(1, 1)).at(x, 0, angle).moving(0, 0, spin));
        wheel.setMass(1, 3);
        wheel.setCollisionGroup(1, 0);
        engine.add(new PinJoint(wheel, x, 0));
        return wheel;
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 1})
    void aStopIsHitAfterAMillionTurns(double restitution) {
        engine.setTimeStep(0.37);
        Body wheel = wheel(0, 0, SPIN);
        double bound = MILLION + 0.123;
        engine.add(new Limit(new GearJoint(wheel, null, -1), Double.NEGATIVE_INFINITY, bound, restitution));
        while (wheel.getAngularVelocity() == SPIN) {
            engine.step();
        }
        double after = engine.getTime() - bound / SPIN;
        assertThat(after).isBetween(0.0, 0.37);
        assertThat(wheel.getAngularVelocity()).isCloseTo(-restitution * SPIN, within(1e-9));
        assertThat(wheel.getAngle()).isCloseTo(bound - restitution * SPIN * after, within(8 * Math.ulp(bound)));
    }

    @ParameterizedTest
    @ValueSource(doubles = {-1e6, -1, 1, 1e6})
    void aStopHoldsAnArmThatStandsManyTurnsOn(double turns) {
        engine.setTimeStep(1 / 64.0);
        engine.add(new Gravity(0, -10));
        double start = turns * TURN;
        Body arm = engine.add(new Body(new Rectangle(2, 0.1)).at(1, 0, start));
        arm.setMass(1, 1 / 3.0);
        engine.add(new PinJoint(arm, 0, 0));
        engine.add(Limit.angle(arm, null, -0.5, 0.5)); // from where it is
        for (int k = 0; k < 640; k++) {
            engine.step();
        }
        assertThat(arm.getAngle()).isCloseTo(start - 0.5, within(1e-10 + 8 * Math.ulp(start)));
        assertThat(arm.getAngularVelocity()).isCloseTo(0, within(1e-8));
    }

    /** The angle of a joint goes through ±π as through any other. */
    @ParameterizedTest
    @ValueSource(doubles = {3.141592653589793, -3.141592653589793, 3.2, 9.5, 100})
    void stopsOfAnySizeAreHit(double bound) {
        engine.setTimeStep(0.1);
        Body wheel = wheel(0, 0, Math.copySign(1, bound));
        engine.add(new Limit(new GearJoint(wheel, null, -1), Math.min(bound, 0), Math.max(bound, 0), 0));
        for (int k = 0; k < 10 * Math.abs(bound) - 1; k++) {
            engine.step();
            assertThat(wheel.getAngle()).isCloseTo(Math.copySign(engine.getTime(), bound), within(1e-12 * Math.abs(bound)));
        }
        for (int k = 0; k < 20; k++) {
            engine.step();
        }
        assertThat(wheel.getAngle()).isCloseTo(bound, within(1e-13 * Math.abs(bound)));
        assertThat(wheel.getAngularVelocity()).isCloseTo(0, within(1e-13));
    }

    @Test
    void aMotorBrakesAfterAMillionTurns() {
        engine.setTimeStep(0.25);
        Body wheel = wheel(0, MILLION, -4);
        engine.add(Motor.turning(wheel, null, 0, 6));
        for (int k = 0; k < 20; k++) {
            engine.step();
        }
        assertThat(wheel.getAngularVelocity()).isZero();
        assertThat(wheel.getAngle()).isCloseTo(MILLION - 0.5 * 16 * 3 / 6, within(8 * Math.ulp(MILLION)));
    }

    @Test
    void aMotorDrivesAWheelThroughAMillionTurns() {
        engine.setTimeStep(0.5);
        Body wheel = wheel(0, 0, 0);
        engine.add(Motor.turning(wheel, null, SPIN, 3e6)); // 10⁶ rad/s², for 0.01 s
        for (int k = 0; k < 1300; k++) {
            engine.step();
        }
        double angle = 0.5 * SPIN * 0.01 + SPIN * (engine.getTime() - 0.01);
        assertThat(angle).isGreaterThan(MILLION);
        assertThat(wheel.getAngularVelocity()).isCloseTo(SPIN, within(1e-9));
        assertThat(wheel.getAngle()).isCloseTo(angle, within(100 * Math.ulp(angle)));
    }

    /** Two wheels of gear 3, the first of them struck by a stop after a million turns. */
    @Test
    void aGearIsTrueAfterAMillionTurns() {
        engine.setTimeStep(0.37);
        Body first = wheel(0, 0, 3 * SPIN);
        Body second = wheel(5, 0, -SPIN);
        engine.add(new GearJoint(first, second, 3));
        engine.add(new Limit(new GearJoint(first, null, -1), Double.NEGATIVE_INFINITY, 3 * MILLION, 1));
        boolean isBack = false;
        while (!isBack || first.getAngle() > 2.9 * MILLION) {
            engine.step();
            isBack |= first.getAngularVelocity() < 0;
            assertThat(first.getAngle() + 3 * second.getAngle()).isCloseTo(0, within(8 * Math.ulp(3 * MILLION)));
        }
        assertThat(first.getAngularVelocity()).isCloseTo(-3 * SPIN, within(1e-8));
        assertThat(second.getAngularVelocity()).isCloseTo(SPIN, within(1e-8));
    }
}
