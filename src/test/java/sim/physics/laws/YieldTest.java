// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.AdaptiveIntegrator;
import sim.physics.motion.Automatic;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.GraggBulirschStoer;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.motion.RadauIIA;
import sim.physics.motion.RungeKutta4;
import sim.physics.shape.Rectangle;

/**
 * A step in which a motor begins to yield, or a stop lets go, is divided there: methods keep their order and their
 * tolerance, which they would lose to the bend that the acceleration has there.
 */
class YieldTest {
    /** A torque that grows with time. */
    private static final class Lift implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        @Override
        public boolean actsOn(Body body) {
            return true;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            forces.addTorque(body, 7 * time);
        }
    }

    /** A place and a speed at the end: of a rod that a motor cannot hold, or of one that is lifted from its stop. */
    private static double end(Integrator method, double step, boolean isMotor) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        engine.setIntegrator(method);
        engine.add(new Gravity(0, -9.81));
        Body rod = engine.add(new Body(new Rectangle(1, 0.02)).at(0.5, 0));
        rod.setMass(1, 1 / 12.0);
        engine.add(new PinJoint(rod, null, 0, 0));
        if (isMotor) {
            engine.add(Motor.turning(rod, null, 3, 2));
        } else {
            engine.add(Limit.angle(rod, null, 0, 3));
            engine.add(new Lift());
        }
        long steps = Math.round((isMotor ? 2 : 1) / step);
        for (long k = 0; k < steps; k++) {
            engine.step();
        }
        return rod.getX() + 0.1 * rod.getAngularVelocity();
    }

    /** Steps of 1/64 differ from short ones by 7e-6 and 6e-6 if they are not divided. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aFixedStepKeepsItsOrder(boolean isMotor) {
        double exact = end(new DormandPrince853(1e-13), 1 / 64.0, isMotor);
        double coarse = Math.abs(end(new RungeKutta4(), 1 / 32.0, isMotor) - exact);
        double fine = Math.abs(end(new RungeKutta4(), 1 / 256.0, isMotor) - exact);
        assertThat(Math.log(coarse / fine) / Math.log(8)).isGreaterThan(3.8);
        assertThat(fine).isLessThan(1e-9);
    }

    @ParameterizedTest
    @CsvSource({"1, true", "0.0625, true", "0.015625, true", "1, false", "0.25, false", "0.015625, false"})
    void aToleranceIsKept(double step, boolean isMotor) {
        double exact = end(new RungeKutta4(), 1 / 4096.0, isMotor);
        for (double tolerance = 1e-5; tolerance > 0.5e-12; tolerance *= 0.1) {
            for (AdaptiveIntegrator method : new AdaptiveIntegrator[] {
                new DormandPrince853(tolerance), new GraggBulirschStoer(tolerance), new RadauIIA(tolerance),
                new Automatic(tolerance)
            }) {
                assertThat(end(method, step, isMotor)).as("%s", method)
                        .isCloseTo(exact, within(10 * tolerance + 1e-14));
            }
        }
    }
}
