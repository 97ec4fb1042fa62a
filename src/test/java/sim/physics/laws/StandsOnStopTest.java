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
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.motion.RungeKutta4;
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
            forces.add(body, 0, -WEIGHT * body.getMass());
        }

        @Override
        public boolean isAutonomous() {
            return true;
        }
    }

    private static final double WEIGHT = 9.81;
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

    /** A light arm on a pin with a heavy sledge on it, that goes to and fro between its stops. */
    @ParameterizedTest
    @ValueSource(doubles = {-2, -0.5, -0.1, 0.3, 1.5})
    void aStopLetsGoAtItsInstant(double slope) {
        double[] right = sledge(slope, 1.0 / 120, new DormandPrince853(1e-12));
        double[] place = sledge(slope, 1.0 / 120, new RungeKutta4());
        assertThat(Math.hypot(place[0] - right[0], place[1] - right[1])).isLessThanOrEqualTo(1e-6);
        assertThat(place[2]).as("evaluations of a step").isLessThanOrEqualTo(1000);
    }

    private static double[] sledge(double slope, double h, Integrator method) {
        PhysicsEngine physics = new PhysicsEngine();
        physics.setTimeStep(h);
        physics.setIntegrator(method);
        Counted weight = physics.add(new Counted());
        Body arm = physics.add(new Body(new Rectangle(0.64, 0.1)).at(-0.16, 1.28, 2.1));
        arm.setMass(0.22);
        physics.add(new PinJoint(arm, 0, 1));
        Body sledge = physics.add(new Body(new Rectangle(1, 0.1)).at(0.04, 1.2, 5.5));
        sledge.setMass(7.3);
        SliderJoint rail = physics.add(new SliderJoint(sledge, arm, -0.3, 1.55, slope, 1));
        physics.add(Limit.travel(rail, -0.08, 0.016));
        int most = 0;
        for (double t = 0; t < 2.5 - h / 2; t += h) {
            int before = weight.calls;
            physics.step();
            most = Math.max(most, weight.calls - before);
        }
        return new double[] {sledge.getX(), sledge.getY(), most};
    }

    private static void place(Body bar, double angle) {
        bar.setAngle(angle);
        bar.setPosition(ARM * StrictMath.cos(angle), ARM * StrictMath.sin(angle));
    }
}
