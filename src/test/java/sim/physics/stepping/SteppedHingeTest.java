// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** What presses on a body near its hinge is borne by the hinge, nearly all of it. A body on a hinge has one way to go, and what it does is known. */
class SteppedHingeTest {
    private static final double LENGTH = 2;

    /** A bar from a hinge at the origin to the right. */
    private static Body bar(PhysicsEngine engine, double thickness, double friction, double restitution) {
        Body bar = engine.add(new Body(new Rectangle(LENGTH, thickness)).at(0.5 * LENGTH, 0));
        bar.setFriction(friction);
        bar.setRestitution(restitution);
        engine.add(new PinJoint(bar, 0, 0));
        return bar;
    }

    private static Body post(PhysicsEngine engine, Body bar, double radius, double x, double y) {
        Body post = engine.add(Body.fixed(new Circle(radius)).at(x, y));
        post.setFriction(bar.getFriction());
        post.setRestitution(bar.getRestitution());
        return post;
    }

    /** How far the end of the bar is from its hinge. */
    private static double gap(Body bar) {
        double x = bar.getX() - 0.5 * LENGTH * StrictMath.cos(bar.getAngle());
        double y = bar.getY() - 0.5 * LENGTH * StrictMath.sin(bar.getAngle());
        return Math.hypot(x, y);
    }

    /** A gate that swings against a post at a distance from its hinge parts from it as fast as restitution says, whatever it rubs. */
    @ParameterizedTest
    @CsvSource({"0.05, 0, 0", "0.05, 0.5, 0", "0.05, 1, 0", "0.05, 0, 0.5", "0.05, 0.5, 0.5", "0.05, 1, 0.5", "0.2, 0.5, 0.5", "0.2, 1, 0", "0.5, 0.5, 0.5"})
    void aGateSwingsBackFromAPostNearItsHinge(double distance, double restitution, double friction) {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        Body gate = bar(engine, 0.04, friction, restitution);
        post(engine, gate, 0.02, distance, -0.1);
        gate.moving(0, -0.42, -0.42);
        double most = 0;
        int steps = 0;
        while (steps++ < 200) {
            engine.step();
            most = Math.max(most, gap(gate));
        }
        assertThat(gate.getAngularVelocity()).isCloseTo(0.42 * restitution, within(2e-4));
        assertThat(most).isLessThan(2e-6); // of the size of (h ω)²
    }

    /** A trapdoor that falls onto a post near its hinge lies on it, and its hinge is closed all the time. */
    @Test
    void aTrapdoorFallsOntoAPost() {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        engine.add(new Gravity(0, -9.81));
        Body door = bar(engine, 0.1, 0.5, 0);
        post(engine, door, 0.05, 0.3, -0.5);
        double lies = StrictMath.atan2(-0.5, 0.3) + StrictMath.asin(0.1 / StrictMath.hypot(0.3, 0.5));
        double most = 0;
        for (int k = 0; k < 120; k++) {
            engine.step();
            most = Math.max(most, gap(door));
        }
        assertThat(door.getAngle()).isCloseTo(lies, within(1e-5));
        assertThat(most).isLessThan(2e-4); // it was open by 3 mm at the impact while hinge and post were solved in turns
        assertThat(engine.getDeepestPenetration()).isLessThan(1e-6);
    }

    /** A bar that rests on a post near its hinge: the post bears its weight times the levers, and the hinge pulls down what is too much. */
    @Test
    void aLeverRestsOnAPostNearItsHinge() {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        engine.add(new Gravity(0, -9.81));
        Body lever = bar(engine, 0.1, 0.5, 0);
        post(engine, lever, 0.05, 0.1, -0.1);
        Stepped.run(engine, 60);
        double weight = 9.81 * lever.getMass();
        assertThat(engine.contacts(lever).get(0).normalForce()).isCloseTo(10 * weight, within(1e-3 * weight));
        assertThat(lever.getAngle()).isCloseTo(0, within(1e-4));
        assertThat(gap(lever)).isLessThan(1e-6);
    }

    /** A motor that has not reached its speed gives its torque: a car whose light wheels roll gains speed evenly, however heavy it is, and does not sink. */
    @ParameterizedTest
    @ValueSource(doubles = {5, 15, 75, 500})
    void aHeavyCarRollsOnLightWheels(double mass) {
        PhysicsEngine engine = Stepped.onGround(1.0 / 60, 4);
        Body chassis = Stepped.box(engine, 3, 0.5, mass, 0, 0.8);
        double inert = mass;
        for (int x = -1; x <= 1; x += 2) {
            Body wheel = Stepped.rough(engine.add(new Body(new Circle(0.4)).at(x, 0.4)));
            engine.add(new PinJoint(chassis, wheel, x, 0.4));
            inert += wheel.getMass() + wheel.getInertia() / 0.16;
            if (x < 0) {
                engine.add(Motor.turning(wheel, chassis, -8, 2));
            }
        }
        Stepped.run(engine, 60);
        assertThat(chassis.getX()).isCloseTo(0.5 * (2 / 0.4) / inert, within(1e-5));
        assertThat(chassis.getY()).isCloseTo(0.8, within(1e-6));
        assertThat(chassis.getAngle()).isCloseTo(0, within(1e-6));
    }
}
