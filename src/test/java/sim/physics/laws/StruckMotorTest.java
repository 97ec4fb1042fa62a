// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;

/**
 * A lever that a motor turns lifts a stone, and a ball falls on it. About the pin the angular momentum of the three changes by what gravity and the
 * motor give, and the motor gives no more than its torque allows: it does not bring the lever back to its speed at once.
 */
class StruckMotorTest {
    private static final double WEIGHT = 9.81;
    private static final double TORQUE = 44;
    private static final double PIN_X = -2.367615519927481;
    private static final double PIN_Y = 1.1530455324218642;

    private static double momentum(PhysicsEngine physics) {
        double sum = 0;
        for (Body body : physics.bodies()) {
            double x = body.getX() - PIN_X;
            double y = body.getY() - PIN_Y;
            sum += body.getMass() * (x * body.getVelocityY() - y * body.getVelocityX()) + body.getInertia() * body.getAngularVelocity();
        }
        return sum;
    }

    private static double pull(PhysicsEngine physics) {
        return physics.bodies().stream().mapToDouble(body -> -WEIGHT * body.getMass() * (body.getX() - PIN_X)).sum();
    }

    private static Body body(PhysicsEngine physics, Body body, double mass) {
        body.setMass(mass);
        body.setRestitution(0);
        body.setFriction(0.22994203362804388);
        return physics.add(body);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4, 16})
    void aMotorGivesNoMoreThanItsTorqueWhenItsLeverIsStruck(int parts) {
        PhysicsEngine physics = new PhysicsEngine();
        double h = 1.0 / 120 / parts;
        physics.setTimeStep(h);
        physics.add(new Gravity(0, -WEIGHT));
        Body lever = body(physics, new Body(new Rectangle(1.0510830144181016, 0.15)).at(-1.9739548574761898, 0.8048714974365254, -0.7241584417790634)
                .moving(0.5420475837867883, 0.6128625040135857, 1.5568294281611585), 2.1496454180274336);
        physics.add(new PinJoint(lever, -0.5255415072090509, 0, null, PIN_X, PIN_Y));
        physics.add(Motor.turning(lever, null, 1.5568294281611585, TORQUE));
        body(physics, new Body(Polygon.regular(5, 0.25)).at(-1.2553837326757926, 0.509317312608722, 1.38607720538516)
                .moving(0.5429129269345387, 0.5094145707957858, 15.818306583524386), 0.27818801221673506);
        body(physics, new Body(new Circle(0.17502277609681635)).at(-1.518985869031833, 0.8017700477576929)
                .moving(-0.6083830992341471, -2.009146175645996, -6.198757628753997), 0.7907891531567811);
        for (int k = 0; k < 4 * parts; k++) {
            double before = momentum(physics);
            double pulled = pull(physics);
            physics.step();
            double given = momentum(physics) - before - 0.5 * h * (pulled + pull(physics));
            assertThat(Math.abs(given)).as("step %s", k).isLessThanOrEqualTo(TORQUE * h + 0.01);
        }
    }
}
