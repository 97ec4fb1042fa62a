// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.Stabilization;
import sim.physics.motion.Body;
import sim.physics.motion.Euler;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** The write-up's pendulum: energy, joint gap, and what Figure 3 shows of Euler's method. */
class PendulumTest {
    private static final double DEPTH = 100;

    private final PhysicsEngine engine = new PhysicsEngine();
    private final Body bar;

    PendulumTest() {
        Body anchor = engine.add(Body.fixed(new Circle(5)).at(100, 50));
        bar = engine.add(new Body(new Rectangle(20, 5)).at(80, 50));
        bar.setMass(100);
        engine.add(new Gravity(0, 5 / 100.0));
        engine.add(new PinJoint(anchor, bar, 100, 50));
    }

    private double energyError() {
        return (bar.kineticEnergy() - 5 * (bar.getY() - 50)) / DEPTH;
    }

    private double gap() {
        double x = bar.getX() + StrictMath.cos(bar.getAngle()) * 20 - 100;
        double y = bar.getY() + StrictMath.sin(bar.getAngle()) * 20 - 50;
        return StrictMath.hypot(x, y);
    }

    /** Worst energy error and gap over some steps of RK4. */
    private double[] worst(double step, int steps) {
        engine.setTimeStep(step);
        double[] worst = new double[2];
        for (int k = 0; k < steps; k++) {
            engine.step();
            worst[0] = Math.max(worst[0], Math.abs(energyError()));
            worst[1] = Math.max(worst[1], gap());
        }
        return worst;
    }

    @ParameterizedTest
    @CsvSource({"1, 1000, 3.5e-5", "1, 100000, 3.5e-3", "0.25, 400000, 1e-5"})
    void energyIsKeptAtLeastAsWellAsInTheOriginal(double step, int steps, double bar) {
        double[] worst = worst(step, steps);
        assertThat(worst[0]).isLessThanOrEqualTo(bar);
        assertThat(worst[1]).isLessThanOrEqualTo(100 * 0x1p-52 * 100);
    }

    @Test
    void halfTheStepLosesASixteenthOfTheEnergyAtMost() {
        double coarse = worst(2, 5000)[0];
        double fine = new PendulumTest().worst(1, 10_000)[0];
        double finer = new PendulumTest().worst(0.5, 20_000)[0];
        assertThat(coarse / fine).isGreaterThan(16);
        assertThat(fine / finer).isGreaterThan(16);
    }

    @ParameterizedTest
    @CsvSource({"1, 28.0", "0.5, 11.4", "0.1, 2.0", "0.01, 0.2"})
    void eulersMethodGainsWhatFigureThreeShows(double step, double degrees) {
        engine.setIntegrator(new Euler());
        engine.setTimeStep(step);
        engine.setStabilization(Stabilization.feedback(0.3, 0.3));
        double highest = 0;
        while (engine.getTime() < 120) {
            engine.step();
            if (bar.getX() > 100) {
                double angle = StrictMath.toDegrees(StrictMath.atan2(50 - bar.getY(), bar.getX() - 100));
                highest = Math.max(highest, angle);
            }
        }
        assertThat(highest).isCloseTo(degrees, within(0.05));
    }

    @Test
    void rungeKuttaEndsItsSwingWhereItBegan() {
        double highest = -90;
        while (engine.getTime() < 120) {
            engine.step();
            if (bar.getX() > 100) {
                double angle = StrictMath.toDegrees(StrictMath.atan2(50 - bar.getY(), bar.getX() - 100));
                highest = Math.max(highest, angle);
            }
        }
        assertThat(highest).isBetween(-0.1, 0.0);
    }

    @Test
    void bouncingOffAWallItKeepsItsEnergyAsWell() {
        Body wall = engine.add(Body.fixed(new Rectangle(6, 200)).at(110, 100));
        assertThat(wall.isFixed()).isTrue();
        for (int k = 0; k < 20_000; k++) {
            engine.step();
        }
        assertThat(engine.getImpacts()).isGreaterThan(200);
        assertThat(energyError()).isCloseTo(0, within(1e-5));
        assertThat(gap()).isLessThan(100 * 0x1p-52 * 100);
    }
}
