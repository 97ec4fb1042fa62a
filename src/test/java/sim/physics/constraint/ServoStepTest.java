// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Spring;
import sim.physics.motion.ViscousFriction;
import sim.physics.shape.Rectangle;

/** Trees of pins with motors and stops move in their angles, as the equations of all their constraints say. */
class ServoStepTest {
    private static final int LEGS = 4;

    /** A body with four legs of two links and a tail, which may hang in the world, with a motor in each joint and stops in the knees. */
    private static final class Creature {
        final PhysicsEngine engine = new PhysicsEngine();
        final List<Body> links = new ArrayList<>();
        final List<Motor> motors = new ArrayList<>();
        private final SplittableRandom random;

        Creature(boolean isHeld, boolean hasGravity, boolean hasForces, double torque, long seed) {
            random = new SplittableRandom(seed);
            engine.setTimeStep(1.0 / 240);
            if (hasGravity) {
                engine.add(new Gravity(0, -9.81));
            }
            Body trunk = link(2, 0.4, 0, 0);
            if (isHeld) {
                engine.add(new PinJoint(trunk, 0.3, 0.1));
                drive(trunk, null, torque);
            }
            for (int k = 0; k < LEGS; k++) {
                double x = -0.9 + 0.6 * k;
                Body thigh = link(0.1, 0.5, x, -0.4);
                engine.add(new PinJoint(trunk, thigh, x, -0.15));
                drive(k % 2 == 0 ? thigh : trunk, k % 2 == 0 ? trunk : thigh, torque);
                Body shin = link(0.1, 0.5, x + 0.05, -0.9);
                engine.add(new PinJoint(shin, thigh, x, -0.65));
                drive(shin, thigh, torque);
                engine.add(Limit.angle(shin, thigh, -0.02, 0.05, 0.5 * (k % 2)));
            }
            Body tail = link(0.6, 0.1, 1.3, 0);
            engine.add(new PinJoint(trunk, tail, 1, 0));
            drive(tail, trunk, torque);
            if (hasForces) {
                engine.add(new Spring(trunk, 0, 0, tail, 0.2, 0, 1, 20, 1));
                engine.add(new ViscousFriction(0.1));
            }
        }

        private Body link(double width, double height, double x, double y) {
            Body body = engine.add(new Body(new Rectangle(width, height)).at(x, y));
            body.setMass(0.5 + width);
            body.setCollisionGroup(1, 0);
            links.add(body);
            return body;
        }

        private void drive(Body a, Body b, double torque) {
            motors.add(engine.add(Motor.turning(a, b, 0, torque)));
        }

        void step() {
            for (Motor motor : motors) {
                motor.setSpeed(random.nextDouble() - 0.5);
            }
            engine.step();
        }
    }

    /** Those are solved by conjugate gradients, for which there is no quick way. */
    @ParameterizedTest
    @CsvSource({"true, true, false", "false, true, false", "false, false, false", "true, true, true", "false, false, true"})
    void aTreeWithMotorsMovesAsItsEquationsSay(boolean isHeld, boolean hasGravity, boolean hasForces) {
        for (double torque : new double[] {1, 10, 100}) {
            Creature quick = new Creature(isHeld, hasGravity, hasForces, torque, 1);
            Creature general = new Creature(isHeld, hasGravity, hasForces, torque, 1);
            general.engine.setConstraintSolver(new GlobalSolver());
            for (int k = 0; k < 24; k++) {
                quick.step();
                general.step();
            }
            for (int k = 0; k < quick.links.size(); k++) {
                Body a = quick.links.get(k);
                Body b = general.links.get(k);
                assertThat(a.getX()).as("x of %d, torque %g", k, torque).isCloseTo(b.getX(), within(1e-6));
                assertThat(a.getY()).as("y of %d, torque %g", k, torque).isCloseTo(b.getY(), within(1e-6));
                assertThat(a.getAngle()).as("angle of %d, torque %g", k, torque).isCloseTo(b.getAngle(), within(1e-6));
            }
        }
    }

    /** Two rods on a pin in the world, the second of which swings between stops of the first. */
    private static final class Rods {
        final PhysicsEngine engine = new PhysicsEngine();
        final Body first = engine.add(new Body(new Rectangle(1, 0.1)).at(0.5, 0));
        final Body second = engine.add(new Body(new Rectangle(1, 0.1)).at(1.5, 0).moving(0, 1, 2));
        final Limit stops;

        Rods(double restitution) {
            engine.setTimeStep(1.0 / 240);
            engine.add(new PinJoint(first, 0, 0));
            engine.add(new PinJoint(second, first, 1, 0));
            stops = engine.add(Limit.angle(second, first, -0.1, 0.1, restitution));
        }

        double angularMomentum() {
            double sum = 0;
            for (Body b : List.of(first, second)) {
                sum += b.getMass() * (b.getX() * b.getVelocityY() - b.getY() * b.getVelocityX()) + b.getInertia() * b.getAngularVelocity();
            }
            return sum;
        }
    }

    /** A stop turns the rate by its restitution, the pin in the world takes no angular momentum, and energy goes by 1 − e² of what the rate has. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 1})
    void aStopThatIsHitTurnsTheRate(double restitution) {
        Rods rods = new Rods(restitution);
        double momentum = rods.angularMomentum();
        double rate = rods.stops.getRate();
        double energy = rods.engine.kineticEnergy();
        int hits = 0;
        while (hits == 0) {
            rate = rods.stops.getRate();
            energy = rods.engine.kineticEnergy();
            rods.engine.step();
            hits += rods.stops.getRate() < 0.99 * rate ? 1 : 0;
        }
        assertThat(rods.stops.getRate()).isCloseTo(-restitution * rate, within(0.02)); // as it turns within the step
        assertThat(rods.angularMomentum()).isCloseTo(momentum, within(1e-9));
        // of the energy of two inertias that turn against one another, at fixed angular momentum about the pin
        double c = 1 / 3.0 * rods.second.getMass() + 0.1 * 0.1 / 12 * rods.second.getMass();
        double b = c + rods.second.getMass() * 0.5 * Math.cos(0.1);
        double a = 2 * c + rods.second.getMass() * (1 + Math.cos(0.1));
        double lost = 0.5 * (c - b * b / a) * rate * rate * (1 - restitution * restitution);
        assertThat(energy - rods.engine.kineticEnergy()).isCloseTo(lost, within(0.002 * energy));
    }

    /** What is within a free creature gives it no momentum. */
    @Test
    void motorsGiveNoMomentum() {
        Creature free = new Creature(false, false, false, 100, 2);
        for (int k = 0; k < 100; k++) {
            free.step();
        }
        double px = 0;
        double py = 0;
        double turn = 0;
        double sum = 0;
        for (Body b : free.links) {
            px += b.getMass() * b.getVelocityX();
            py += b.getMass() * b.getVelocityY();
            turn += b.getMass() * (b.getX() * b.getVelocityY() - b.getY() * b.getVelocityX()) + b.getInertia() * b.getAngularVelocity();
            sum += b.getMass() * Math.hypot(b.getVelocityX(), b.getVelocityY());
        }
        assertThat(px).isCloseTo(0, within(1e-13 * sum));
        assertThat(py).isCloseTo(0, within(1e-13 * sum));
        assertThat(turn).isCloseTo(0, within(1e-8 * sum));
    }

    /** Motors that are strong enough have their speeds at the end of each step, joints are closed, and no stop is passed. */
    @Test
    void motorsHaveTheirSpeedsAndJointsAreClosed() {
        Creature held = new Creature(true, true, false, 1e5, 3);
        held.engine.allConstraints().stream().filter(Limit.class::isInstance).forEach(held.engine::remove);
        for (int k = 0; k < 100; k++) {
            held.step();
            for (Motor motor : held.motors) {
                assertThat(motor.getRate()).isCloseTo(motor.getSpeed(), within(1e-11));
            }
            for (Constraint joint : held.engine.allConstraints()) {
                if (joint instanceof PinJoint) {
                    Equations now = new Equations();
                    joint.evaluate(now);
                    assertThat(Math.hypot(now.c[0], now.c[1])).isLessThan(1e-14);
                }
            }
        }
    }
}
