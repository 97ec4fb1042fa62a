// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/**
 * What stands on a stop. A bar on a pin, a little beyond it by no more than counts as reached: that gap is closed, against the weight or a motor, and is
 * no error of the step, which is not made in parts for it.
 */
class StandsOnStopTest {
    /** Gravity, that counts how often it is asked. */
    private static final class Counted implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private int calls;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            calls++;
            forces.add(body, 0, -3 * body.getMass());
        }

        @Override
        public boolean isAutonomous() {
            return true;
        }
    }

    private static final double STOP = 0.5;
    private static final double ARM = 0.75;

    @ParameterizedTest
    @CsvSource({"0, 1e-12", "0, 9e-12", "3, 1e-13", "3, 5e-12", "300, 1e-12", "300, 9e-12", "300, -5e-12"})
    void aBarOnItsStopIsMovedInOneStepOnce(double torque, double beyond) {
        PhysicsEngine physics = new PhysicsEngine();
        physics.setTimeStep(1.0 / 120);
        Counted weight = physics.add(new Counted());
        Body bar = physics.add(new Body(new Rectangle(2 * ARM, 0.3)));
        place(bar, STOP);
        bar.setMass(2);
        physics.add(new PinJoint(bar, 0, 0));
        if (torque > 0) {
            physics.add(Motor.turning(bar, null, -20, torque));
        }
        physics.add(Limit.angle(bar, null, 0, 1));
        physics.step();
        place(bar, STOP - beyond);
        weight.calls = 0;
        physics.step();
        assertThat(weight.calls).isLessThanOrEqualTo(100);
        assertThat(Math.abs(bar.getAngle() - STOP)).isLessThanOrEqualTo(1e-11);
        assertThat(Math.abs(bar.getAngularVelocity())).isLessThanOrEqualTo(1e-20);
    }

    /** A sledge lies on its stop, which would bounce, and another one runs across it to a stop of its own. */
    @Test
    void whatBouncesOffOneStopIsNotHeldBecauseAnotherOneIsPressed() {
        for (int k = 0; k < 40; k++) {
            double angle = 0.1 + 0.15 * k;
            double c = StrictMath.cos(angle);
            double s = StrictMath.sin(angle);
            PhysicsEngine physics = new PhysicsEngine();
            physics.setTimeStep(1.0 / 60);
            physics.add(new Gravity(-10 * c, -10 * s));
            Body sledge = physics.add(new Body(new Rectangle(2, 1)));
            SliderJoint down = physics.add(new SliderJoint(sledge, null, 0, 0, c, s));
            physics.add(Limit.travel(down, 0, 5, 0.5));
            Body runner = physics.add(new Body(new Rectangle(0.5, 0.5)).at(0.3, 1).moving(s, -c));
            SliderJoint across = physics.add(new SliderJoint(runner, sledge, 0.3, 1, -s, c));
            physics.add(Limit.travel(across, -0.5, 5, 0.5));
            for (int step = 0; step < 60; step++) {
                physics.step();
            }
            assertThat(across.getTravelSpeed()).as("angle %s", angle).isCloseTo(0.5, within(1e-9));
            assertThat(across.getTravel()).as("angle %s", angle).isCloseTo(-0.25, within(1e-9));
            assertThat(down.getTravel()).as("angle %s", angle).isCloseTo(0, within(1e-10));
        }
    }

    private static void place(Body bar, double angle) {
        bar.setAngle(angle);
        bar.setPosition(ARM * StrictMath.cos(angle), ARM * StrictMath.sin(angle));
    }
}
