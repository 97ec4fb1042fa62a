// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.shape.Rectangle;

/**
 * A bar on a pin stands on its stop, a little beyond it, by no more than counts as reached. That gap is closed, against the weight or a motor; it is
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

    private static void place(Body bar, double angle) {
        bar.setAngle(angle);
        bar.setPosition(ARM * StrictMath.cos(angle), ARM * StrictMath.sin(angle));
    }
}
