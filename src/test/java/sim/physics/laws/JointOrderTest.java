// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.function.DoubleUnaryOperator;
import org.hipparchus.special.elliptic.jacobi.JacobiEllipticBuilder;
import org.hipparchus.special.elliptic.legendre.LegendreEllipticIntegral;
import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Curve;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.WireJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * RK4 keeps its fourth order through joints, wires and elastic impacts: slopes over four halvings, against the pendulum's
 * elliptic functions.
 */
class JointOrderTest {
    private static final double G = 9.81;
    private static final double END = 1.5;

    /** Deviation from straight down of a pendulum let go from the horizontal, ω0² = weight · arm / inertia about the pin. */
    private static double swing(double omega0, double t) {
        double k = StrictMath.sqrt(0.5);
        double quarter = LegendreEllipticIntegral.bigK(k * k);
        double sn = JacobiEllipticBuilder.build(k * k).valuesN(quarter - omega0 * t).sn();
        return 2 * StrictMath.asin(k * sn);
    }

    private static void assertFourthOrder(int coarsest, DoubleUnaryOperator error) {
        double[] slope = new double[4];
        double last = Math.abs(error.applyAsDouble(END / coarsest));
        for (int k = 0; k < 4; k++) {
            double next = Math.abs(error.applyAsDouble(END / (coarsest << k + 1)));
            slope[k] = StrictMath.log(last / next) / StrictMath.log(2);
            last = next;
        }
        double mean = (slope[0] + slope[1] + slope[2] + slope[3]) / 4;
        assertThat(mean).as("slopes %s", java.util.Arrays.toString(slope)).isBetween(3.8, 4.2);
    }

    private static PhysicsEngine engine(double step) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        engine.add(new Gravity(0, -G));
        return engine;
    }

    private static void run(PhysicsEngine engine, double step) {
        long steps = Math.round(END / step);
        for (long k = 0; k < steps; k++) {
            engine.step();
        }
    }

    @Test
    void aPendulum() {
        assertFourthOrder(48, step -> {
            PhysicsEngine engine = engine(step);
            Body rod = engine.add(new Body(new Rectangle(1, 0.01)).at(0.5, 0));
            rod.setMass(1, 1 / 12.0);
            engine.add(new PinJoint(rod, 0, 0));
            run(engine, step);
            return rod.getAngle() + StrictMath.PI / 2 - swing(StrictMath.sqrt(1.5 * G), END);
        });
    }

    @Test
    void aBeadOnARoundWire() {
        assertFourthOrder(192, step -> {
            PhysicsEngine engine = engine(step);
            Body bead = engine.add(new Body(new Circle(0.1)).at(1, 0));
            engine.add(new WireJoint(bead, Curve.circle(0, 0, 1)));
            run(engine, step);
            return StrictMath.atan2(bead.getX(), -bead.getY()) - swing(StrictMath.sqrt(G), END);
        });
    }

    @Test
    void aPendulumThatHitsAWallElastically() {
        double radius = 0.1;
        double omega0 = StrictMath.sqrt(G / (1 + radius * radius / 2));
        double hit = LegendreEllipticIntegral.bigK(0.5) / omega0;
        assertThat(hit).isLessThan(END);
        assertFourthOrder(48, step -> {
            PhysicsEngine engine = engine(step);
            Body bob = engine.add(new Body(new Circle(radius)).at(1, 0));
            engine.add(new PinJoint(bob, 0, 0));
            engine.add(Body.fixed(new Rectangle(1, 4)).at(-0.5 - radius, -1));
            run(engine, step);
            assertThat(engine.getImpacts()).isEqualTo(1);
            return StrictMath.atan2(bob.getX(), -bob.getY()) - swing(omega0, 2 * hit - END);
        });
    }
}
