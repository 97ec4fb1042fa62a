// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.SlotJoint;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.Gravity;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** A pin in a slot, against solutions in closed form. */
class SlotTest {
    private static final double STEP = 1.0 / 64;
    private static final double DISTANCE = 2;

    private final PhysicsEngine engine = new PhysicsEngine();

    private PhysicsEngine prepared(int substeps) {
        engine.setTimeStep(STEP);
        engine.setTimeStepping(substeps);
        if (substeps == 0) {
            engine.setIntegrator(new DormandPrince853(1e-12));
        }
        return engine;
    }

    private void run(int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    /** The trammel of Archimedes: its kinetic energy is (I + m L² / 4) θ̇² / 2 at any angle, so it turns evenly, and its centre goes round. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aTrammelTurnsEvenly(int substeps) {
        prepared(substeps);
        double c = 0.5 * DISTANCE * Math.cos(0.3);
        double s = 0.5 * DISTANCE * Math.sin(0.3);
        Body rod = engine.add(new Body(new Rectangle(DISTANCE, 0.1)).at(c, -s, 0.3));
        rod.setAngularVelocity(1.3);
        rod.setVelocity(-1.3 * s, -1.3 * c);
        engine.add(new SlotJoint(rod, null, 2 * c, 0, 1, 0));  // the end at +L/2 is on the x axis
        engine.add(new SlotJoint(rod, null, 0, -2 * s, 0, 1)); // the other one on the y axis
        run(320);
        double error = substeps == 0 ? 1e-9 : 2e-2;
        assertThat(rod.getAngle()).isCloseTo(0.3 + 1.3 * 5, within(error));
        assertThat(rod.getX()).isCloseTo(0.5 * DISTANCE * Math.cos(0.3 + 6.5), within(error));
        assertThat(rod.getY()).isCloseTo(-0.5 * DISTANCE * Math.sin(0.3 + 6.5), within(error));
    }

    /** A wheel on a spring goes up and down with ω = √(k (1/m + 1/M)), and spins as it likes; the other way of the two is none. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aWheelHangsOnItsSpring(int substeps) {
        prepared(substeps);
        Body chassis = engine.add(new Body(new Rectangle(3, 0.5)).at(0, 2));
        Body wheel = engine.add(new Body(new Circle(0.4)).at(0, 1));
        chassis.setMass(5);
        wheel.setMass(2);
        wheel.setVelocity(0, 1);
        wheel.setAngularVelocity(7);
        SlotJoint slot = engine.add(new SlotJoint(wheel, chassis, 0, 1, 0, 1));
        engine.add(new Spring(chassis, 0, 0, wheel, 0, 0, 1, 30, 0));
        double omega = StrictMath.sqrt(30 * (1.0 / 5 + 1.0 / 2));
        run(100);
        double t = 100 * STEP;
        assertThat(slot.getTravel()).isCloseTo(StrictMath.sin(omega * t) / omega, within(substeps == 0 ? 1e-9 : 2e-3));
        assertThat(wheel.getAngle()).isCloseTo(7 * t, within(1e-9));
        assertThat(chassis.getAngle()).isCloseTo(0, within(1e-9));
        assertThat(5 * chassis.getVelocityY() + 2 * wheel.getVelocityY()).isCloseTo(2, within(1e-12));
    }

    /** A bead on an arm that a motor turns goes out as cosh ω t, and keeps its own turning; a slider's bead is turned along. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aBeadOnAnArmGoesOut(int substeps) {
        prepared(substeps);
        Body arm = engine.add(new Body(new Rectangle(0.2, 0.2)));
        arm.setMass(1, 1e9);
        arm.setAngularVelocity(1.5);
        engine.add(new PinJoint(arm, 0, 0));
        Body bead = engine.add(new Body(new Circle(0.1)).at(0.5, 0));
        bead.setVelocity(0, 0.75);
        bead.setAngularVelocity(-2);
        SlotJoint slot = engine.add(new SlotJoint(bead, arm, 0.5, 0, 1, 0));
        run(64);
        assertThat(slot.getTravel() + 0.5).isCloseTo(0.5 * StrictMath.cosh(1.5), within(substeps == 0 ? 1e-8 : 1e-2));
        assertThat(bead.getAngle()).isCloseTo(-2, within(1e-12));
    }

    /** A motor along a slot lifts, a stop ends the way, and reactions are weights. */
    @Test
    void motorsAndStopsWorkAlongIt() {
        prepared(0);
        engine.add(new Gravity(0, -9.81));
        Body load = engine.add(new Body(new Circle(0.3)).at(0, 0));
        load.setMass(2);
        load.setVelocity(0, 0.5);
        SlotJoint slot = engine.add(new SlotJoint(load, null, 0, 0, 0, 1));
        Motor motor = engine.add(Motor.sliding(slot, 0.5, 100));
        Limit end = engine.add(Limit.travel(slot, -1, 1));
        run(64);
        assertThat(slot.getTravel()).isCloseTo(0.5, within(1e-9));
        assertThat(engine.getReaction(motor).force()).isCloseTo(2 * 9.81, within(1e-8));
        motor.setLimit(10);
        run(256);
        assertThat(slot.getTravel()).isCloseTo(-1, within(1e-9));
        assertThat(engine.getReaction(end).force()).isCloseTo(2 * 9.81 - 10, within(1e-8));
    }

    @Test
    void itsOneRowIsNoCoordinate() {
        Body load = engine.add(new Body(new Circle(0.3)));
        SlotJoint slot = new SlotJoint(load, null, 0, 0, 0, 1);
        assertThatThrownBy(() -> new Motor(slot, 1, 1)).isInstanceOf(IllegalArgumentException.class).hasMessageContaining("Motor.sliding");
        assertThatThrownBy(() -> new SlotJoint(load, null, 0, 0, 0, 0)).isInstanceOf(IllegalArgumentException.class).hasMessageContaining("direction");
    }
}
