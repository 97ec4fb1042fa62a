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
import sim.physics.constraint.Wheel;
import sim.physics.motion.Body;
import sim.physics.motion.Integrator;
import sim.physics.motion.Rattle;
import sim.physics.motion.RungeKutta4;
import sim.physics.shape.Rectangle;

/**
 * Chaplygin's sleigh (1911): a body with one wheel at a distance a behind its centre, and no force. With u the speed of the wheel and
 * b² = a² + I / m, u′ = a ω² and ω′ = −(a / b²) u ω. As u² + b² ω² = c² is kept, u = c tanh z and b ω = c / cosh z with
 * z = a c (t − t₀) / b²: however it starts, it ends up with its centre ahead of the wheel.
 */
class SleighTest {
    private static final double A = 0.1;
    private static final double U = -0.5;
    private static final double OMEGA = 1.3;

    private final PhysicsEngine engine = new PhysicsEngine();
    private final Body sleigh = engine.add(new Body(new Rectangle(0.4, 0.2)).at(0, 0));
    private final Wheel wheel = new Wheel(sleigh, -A, 0);

    private void begin(double step) {
        engine.setTimeStep(step);
        sleigh.setVelocity(U, A * OMEGA);
        sleigh.setAngularVelocity(OMEGA);
        engine.add(wheel);
    }

    private void run(double time) {
        int steps = (int) Math.round(time / engine.getTimeStep());
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    /** By how much speed, spin or angle are off at a time. */
    private double error(double time) {
        double square = A * A + sleigh.getInertia() / sleigh.getMass();
        double c = Math.sqrt(U * U + square * OMEGA * OMEGA);
        double start = 0.5 * StrictMath.log((1 + U / c) / (1 - U / c));
        double z = start + A * c * time / square;
        double turned = 2 * (StrictMath.atan(StrictMath.tanh(0.5 * z)) - StrictMath.atan(StrictMath.tanh(0.5 * start)));
        double u = wheel.getRollingSpeed() - c * StrictMath.tanh(z);
        double omega = sleigh.getAngularVelocity() - c / Math.sqrt(square) / StrictMath.cosh(z);
        double angle = sleigh.getAngle() - Math.sqrt(square) / A * turned;
        return Math.max(Math.abs(u), Math.max(Math.abs(omega), Math.abs(angle)));
    }

    private double energy() {
        double square = sleigh.getVelocityX() * sleigh.getVelocityX() + sleigh.getVelocityY() * sleigh.getVelocityY();
        return 0.5 * (sleigh.getMass() * square + sleigh.getInertia() * sleigh.getAngularVelocity() * sleigh.getAngularVelocity());
    }

    private double errorAfter(Integrator method, double step, double time) {
        begin(step);
        engine.setIntegrator(method);
        double before = energy();
        run(time);
        assertThat(energy()).isCloseTo(before, within(1e-12 * before));
        assertThat(wheel.getSlip()).isCloseTo(0, within(1e-15));
        return error(time);
    }

    @Test
    void rungeKuttaKeepsItsOrder() {
        double coarse = errorAfter(new RungeKutta4(), 0.04, 2);
        SleighTest other = new SleighTest();
        double fine = other.errorAfter(new RungeKutta4(), 0.02, 2);
        assertThat(fine).isLessThan(1e-7).isBetween(coarse / 20, coarse / 12);
    }

    /** A wheel closes no place, in which a symplectic method would do it: all orders are 2. */
    @ParameterizedTest
    @ValueSource(ints = {2, 4, 6})
    void rattleIsOfOrderTwo(int order) {
        double coarse = errorAfter(new Rattle(order), 0.02, 2);
        SleighTest other = new SleighTest();
        double fine = other.errorAfter(new Rattle(order), 0.01, 2);
        assertThat(fine).isLessThan(1e-4).isBetween(coarse / 5, coarse / 3.5);
    }

    @ParameterizedTest
    @CsvSource({"DOP853, 0.01", "DOP853, 2", "GBS, 0.01", "GBS, 2", "Radau, 0.01", "Radau, 2", "Automatic, 0.01", "Automatic, 2"})
    void methodsWithAToleranceKeepIt(String name, double step) {
        assertThat(errorAfter(Methods.method(name, 1e-9), step, 2)).isLessThan(3e-8);
    }

    @Test
    void timeSteppingIsOfOrderTwo() {
        engine.setTimeStepping(4);
        begin(0.02);
        double before = energy();
        run(2);
        assertThat(wheel.getSlip()).isCloseTo(0, within(1e-15));
        assertThat(energy()).isCloseTo(before, within(2e-5 * before));
        SleighTest other = new SleighTest();
        other.engine.setTimeStepping(4);
        other.begin(0.01);
        other.run(2);
        assertThat(other.error(2)).isLessThan(1e-5).isBetween(error(2) / 5, error(2) / 3.5);
    }
}
