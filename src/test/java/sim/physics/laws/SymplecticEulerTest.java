// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Spring;
import sim.physics.motion.SymplecticEuler;
import sim.physics.shape.Circle;

/** Symplectic Euler is of order 1, keeps momenta, and its energy stays near where it was for ever. */
class SymplecticEulerTest {
    private static final double G = 9.81;

    private static PhysicsEngine engine(double step) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        engine.setIntegrator(new SymplecticEuler());
        return engine;
    }

    private static Body rods(PhysicsEngine engine, int count) {
        engine.add(new Gravity(0, -G));
        return Scenes.rods(engine, count, -1);
    }

    private static double error(int steps) {
        PhysicsEngine engine = engine(1.0 / steps);
        Body last = rods(engine, 2);
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
        double tipX = last.getX() + 0.5 * StrictMath.cos(last.getAngle());
        double tipY = last.getY() + 0.5 * StrictMath.sin(last.getAngle());
        return StrictMath.hypot(tipX + 1.662115135816127581, tipY + 1.04146663719322474);
    }

    @Test
    void itIsOfOrderOne() {
        assertThat(error(1000) / error(4000)).isBetween(3.8, 4.2);
    }

    /** The map of an oscillator keeps v²/2 + ω² x²/2 − h ω² x v/2: an invariant of the method, and no other has it. */
    @Test
    void anOscillatorKeepsTheInvariantOfTheMethod() {
        double h = 0.02;
        PhysicsEngine engine = engine(h);
        Body bob = engine.add(new Body(new Circle(0.1)).at(1.5, 0));
        bob.setMass(1, 1);
        engine.add(new Spring(bob, 0, 0, null, 0, 0, 1, 100, 0));
        double most = 0;
        for (int k = 0; k < 1_000_000; k++) {
            engine.step();
            double x = bob.getX() - 1;
            double v = bob.getVelocityX();
            most = Math.max(most, Math.abs(0.5 * v * v + 50 * x * x - 50 * h * x * v - 12.5));
        }
        assertThat(most).isLessThan(12.5 * 1e-12);
    }

    /** Bounds are those of the first thousand steps. */
    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.0025})
    void thePendulumsEnergyStaysWithinItsFirstBounds(double step) {
        PhysicsEngine engine = engine(step);
        Body rod = rods(engine, 1);
        double first = 0;
        double all = 0;
        for (int k = 0; k < 300_000; k++) {
            engine.step();
            double off = Math.abs(rod.kineticEnergy() + G * rod.getY());
            first = k < 1000 ? Math.max(first, off) : first;
            all = Math.max(all, off);
        }
        assertThat(first).isBetween(5 * step, 10 * step);
        assertThat(all).isLessThan(1.001 * first);
    }

    @Test
    void momentaAreKept() {
        PhysicsEngine engine = engine(0.01);
        Body a = engine.add(new Body(new Circle(0.1)).at(0, 0).moving(1, 2));
        Body b = engine.add(new Body(new Circle(0.1)).at(1, 0).moving(-2, 0.5));
        a.setMass(1, 1);
        b.setMass(3, 1);
        engine.add(new Spring(a, 0, 0, b, 0, 0, 0.5, 100, 0));
        for (int k = 0; k < 10_000; k++) {
            engine.step();
        }
        assertThat(a.getVelocityX() + 3 * b.getVelocityX()).isCloseTo(-5, within(1e-11));
        assertThat(a.getVelocityY() + 3 * b.getVelocityY()).isCloseTo(3.5, within(1e-11));
        double turn = a.getX() * a.getVelocityY() - a.getY() * a.getVelocityX()
                + 3 * (b.getX() * b.getVelocityY() - b.getY() * b.getVelocityX());
        assertThat(turn).isCloseTo(1.5, within(1e-9));
    }

    @Test
    void jointsStayClosed() {
        PhysicsEngine engine = engine(0.01);
        rods(engine, 3);
        for (int k = 0; k < 10_000; k++) {
            engine.step();
        }
        Body a = engine.bodies().get(0);
        Body b = engine.bodies().get(1);
        double gapX = a.getX() + 0.5 * StrictMath.cos(a.getAngle()) - b.getX() + 0.5 * StrictMath.cos(b.getAngle());
        double gapY = a.getY() + 0.5 * StrictMath.sin(a.getAngle()) - b.getY() + 0.5 * StrictMath.sin(b.getAngle());
        assertThat(StrictMath.hypot(gapX, gapY)).isLessThan(1e-14);
    }
}
