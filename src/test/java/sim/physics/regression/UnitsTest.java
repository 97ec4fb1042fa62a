// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

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

/** What a scene does does not depend on the units it is measured in: no bit of it, where units differ by powers of two. */
class UnitsTest {
    private static final int STEPS = 60;

    private static void follow(long seed, double length, double time, double mass) {
        WorldInUnits plain = new WorldInUnits(seed, 1, 1, 1);
        WorldInUnits other = new WorldInUnits(seed, length, time, mass);
        for (int step = 0; step < STEPS; step++) {
            plain.engine.step();
            other.engine.step();
            double[] a = plain.plain();
            double[] b = other.plain();
            for (int k = 0; k < a.length; k++) {
                assertThat(a[k]).as("seed %s, step %s, coordinate %s", seed, step, k).isFinite();
                assertThat(b[k]).as("seed %s, step %s, coordinate %s", seed, step, k).isEqualTo(a[k]);
            }
        }
    }

    /** Masses by powers of four, since roots of what they move are taken. */
    @ParameterizedTest
    @CsvSource({"20, 0, 0", "-20, 0, 0", "0, 10, 0", "0, -10, 0", "0, 0, 20", "0, 0, -20", "-33, 13, 8", "40, -7, -12"})
    void powersOfTwoChangeNoBit(int length, int time, int mass) {
        for (long seed = 0; seed < 60; seed++) {
            follow(seed, StrictMath.scalb(1.0, length), StrictMath.scalb(1.0, time), StrictMath.scalb(1.0, mass));
        }
    }

    /** The stronger of two motors brings a plate to its speed, whatever a metre is. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 1e6, 1e-6, 1e9})
    void motorsThatPullAgainstOneAnother(double length) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 64.0);
        Body plate = engine.add(new Body(new Rectangle(length, 0.5 * length)).at(0, 0));
        plate.setMass(1);
        for (int k = 0; k < 2; k++) {
            engine.add(new PinJoint(plate, 0, 0));
            engine.add(Motor.turning(plate, null, 1, 3 * plate.getInertia()));
            engine.add(Motor.turning(plate, null, -2, 1 * plate.getInertia()));
        }
        for (int k = 0; k < 16; k++) {
            engine.step();
        }
        assertThat(plate.getAngularVelocity()).isCloseTo((2 * 3 - 2 * 1) * 0.25, within(1e-12));
        for (int k = 0; k < 48; k++) {
            engine.step();
        }
        assertThat(plate.getAngularVelocity()).isCloseTo(1, within(1e-12));
    }

    /** A disc that comes down rolls on without slipping, also one of micrometres. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 1e-6, 1e-12, 1e6})
    void discsRoll(double length) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 50.0);
        engine.add(new Gravity(0.6 * length, -10 * length));
        Body ground = engine.add(Body.fixed(new Rectangle(40 * length, length)).at(0, -0.5 * length));
        Body disc = engine.add(new Body(new Circle(0.5 * length)).at(0, 0.6 * length));
        ground.setFriction(0.9);
        disc.setFriction(0.9);
        disc.setRestitution(0);
        double fall = Math.sqrt(2 * 0.1 / 10);
        for (int k = 0; k < 50; k++) {
            engine.step();
        }
        double rolling = 2 * 0.6 / 3;
        assertThat(disc.getVelocityX() / length).isCloseTo(rolling, within(1e-12)); // the impact leaves it two thirds, too
        assertThat(disc.getAngularVelocity()).isCloseTo(-2 * rolling, within(1e-12));
        double rest = 1 - fall;
        double way = 0.5 * 0.6 * fall * fall + rolling * fall * rest + 0.5 * rolling * rest * rest;
        assertThat(disc.getX() / length).isCloseTo(way, within(1e-12));
    }

    /** Velocities that rounding left on the plane, and whose squares are zero, had made a heap's places no numbers. */
    @Test
    void whatHardlyMovesOnThePlaneStaysANumber() {
        follow(2436, 1, 1, 1);
    }
}
