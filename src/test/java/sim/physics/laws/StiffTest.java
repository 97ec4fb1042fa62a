// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.AdaptiveIntegrator;
import sim.physics.motion.Automatic;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.motion.Integrator;
import sim.physics.motion.RadauIIA;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** What is stiff costs no more than what is not, and is as right. */
class StiffTest {
    /** Counts evaluations of forces. */
    private static final class Count implements ForceGenerator {
        private static final long serialVersionUID = 1L;
        private long evaluations;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            evaluations++;
        }
    }

    private final PhysicsEngine engine = new PhysicsEngine();

    private static AdaptiveIntegrator method(String name, double tolerance) {
        return name.equals("Radau") ? new RadauIIA(tolerance) : new Automatic(tolerance);
    }

    /** m x″ + c x′ + k x = 0 from x = 0.1 at rest. */
    private static double vibration(double omega, double ratio, double t) {
        double root = StrictMath.sqrt(Math.abs(1 - ratio * ratio));
        if (ratio < 1) {
            double phase = omega * root * t;
            double swing = StrictMath.cos(phase) + ratio / root * StrictMath.sin(phase);
            return 0.1 * StrictMath.exp(-ratio * omega * t) * swing;
        }
        if (ratio == 1) {
            return 0.1 * (1 + omega * t) * StrictMath.exp(-omega * t);
        }
        double slow = -omega / (ratio + root);
        double fast = -omega * (ratio + root);
        return 0.1 * (fast * StrictMath.exp(slow * t) - slow * StrictMath.exp(fast * t)) / (fast - slow);
    }

    @ParameterizedTest
    @CsvSource({
        "Radau, 1e2, 0", "Radau, 1e2, 1", "Radau, 1e4, 100", "Radau, 1e6, 0.1", "Radau, 1e12, 1", "Radau, 1e12, 100",
        "Automatic, 1e2, 0", "Automatic, 1e4, 1", "Automatic, 1e4, 100", "Automatic, 1e8, 0.1", "Automatic, 1e12, 1",
        "Automatic, 1e12, 100"
    })
    void aSpringOfAnyStiffnessIsRight(String name, double stiffness, double ratio) {
        engine.setTimeStep(0.25);
        engine.setIntegrator(method(name, 1e-8));
        Body wall = engine.add(Body.fixed(new Circle(0.01)));
        Body body = engine.add(new Body(new Circle(0.1)).at(1.1, 0));
        body.setCollisionGroup(1, 0);
        body.setMass(1);
        double omega = StrictMath.sqrt(stiffness);
        engine.add(new Spring(body, 0, 0, wall, 0, 0, 1, stiffness, 2 * ratio * omega));
        Count count = new Count();
        engine.add(count);
        for (int k = 1; k <= 4; k++) {
            engine.step();
            assertThat(body.getX() - 1).isCloseTo(vibration(omega, ratio, 0.25 * k), within(2e-7));
        }
        assertThat(count.evaluations).isLessThan(20_000);
    }

    /** Where the masses of the rods do not matter, the tip is a pendulum of the chain's length. */
    @ParameterizedTest
    @CsvSource({"Radau, 1e6", "Radau, 1e9", "Automatic, 1e9"})
    void aHeavyTipSwingsAsAPendulum(String name, double mass) {
        Body tip = swing(engine, method(name, 1e-8), mass);
        assertThat(StrictMath.hypot(tip.getX(), tip.getY())).isCloseTo(10, within(1e-6));
        // the pendulum of point mass at t = 2, and what rods of weight 10 / mass change
        assertThat(tip.getX()).isCloseTo(pendulumX(2), within(1e-6 + 30 / mass));
    }

    /** Hard case J02 against a method of order 8 whose steps are as short as the waves: it and GBS agree to 10⁻¹³. */
    @ParameterizedTest
    @ValueSource(doubles = {1e3, 1e6})
    void aHeavyTipIsWhereAMethodOfHighOrderHasIt(double mass) {
        Body exact = swing(new PhysicsEngine(), new DormandPrince853(1e-12), mass);
        for (double tolerance : new double[] {1e-6, 1e-8}) {
            for (String name : new String[] {"Radau", "Automatic"}) {
                Body tip = swing(new PhysicsEngine(), method(name, tolerance), mass);
                double error = StrictMath.hypot(tip.getX() - exact.getX(), tip.getY() - exact.getY());
                assertThat(error).as("%s at %s", name, tolerance).isLessThan(tolerance);
            }
        }
    }

    /** A chain of ten rods of mass 1 with a heavy tip, two seconds after it was let go at 45°; the joints must be closed. */
    private static Body swing(PhysicsEngine engine, Integrator method, double mass) {
        engine.setIntegrator(method);
        engine.setTimeStep(0.5);
        engine.add(new Gravity(0, -9.81));
        double part = StrictMath.sqrt(0.5);
        Body last = null;
        for (int k = 0; k < 10; k++) {
            Body rod = engine.add(new Body(new Rectangle(1, 0.01)).at((k + 0.5) * part, -(k + 0.5) * part));
            rod.setAngle(-StrictMath.PI / 4);
            rod.setMass(1, 1 / 12.0);
            rod.setCollisionGroup(1, 0);
            engine.add(new PinJoint(last == null ? rod : last, last == null ? null : rod, k * part, -k * part));
            last = rod;
        }
        Body tip = engine.add(new Body(new Circle(0.1)).at(10 * part, -10 * part));
        tip.setMass(mass);
        tip.setCollisionGroup(1, 0);
        engine.add(new PinJoint(last, tip, 10 * part, -10 * part));
        Body[] rods = engine.bodies().subList(0, 10).toArray(new Body[0]);
        for (int k = 0; k < 4; k++) {
            engine.step();
            assertThat(ChainTest.gap(rods)).isLessThan(100 * 0x1p-52 * 10);
        }
        return tip;
    }

    /** A pendulum of length 10 let go at 45°, by many small steps of a fourth-order method. */
    private static double pendulumX(double t) {
        int steps = 20_000;
        double h = t / steps;
        double angle = StrictMath.PI / 4;
        double rate = 0;
        for (int k = 0; k < steps; k++) {
            double a1 = -0.981 * StrictMath.sin(angle);
            double a2 = -0.981 * StrictMath.sin(angle + h / 2 * rate);
            double a3 = -0.981 * StrictMath.sin(angle + h / 2 * (rate + h / 2 * a1));
            double a4 = -0.981 * StrictMath.sin(angle + h * (rate + h / 2 * a2));
            angle += h * rate + h * h / 6 * (a1 + a2 + a3);
            rate += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
        }
        return 10 * StrictMath.sin(angle);
    }
}
