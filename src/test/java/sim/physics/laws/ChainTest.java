// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/** Chains of rods: their tips against references of 18 digits, the order of the method, gaps, long chains. */
class ChainTest {
    private static Body[] chain(PhysicsEngine engine, int n) {
        engine.add(new Gravity(0, -9.81));
        Body[] rods = new Body[n];
        for (int k = 0; k < n; k++) {
            rods[k] = engine.add(new Body(new Rectangle(1, 0.02)).at(k + 0.5, 0));
            rods[k].setMass(1, 1 / 12.0);
            rods[k].setCollisionGroup(1, 0);
            engine.add(k == 0 ? new PinJoint(rods[0], 0, 0) : new PinJoint(rods[k - 1], rods[k], k, 0));
        }
        return rods;
    }

    private static double[] tip(int n, double time, double step) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        Body[] rods = chain(engine, n);
        long steps = Math.round(time / step);
        for (long k = 0; k < steps; k++) {
            engine.step();
        }
        assertThat(gap(rods)).isLessThan(100 * 0x1p-52 * n);
        Body last = rods[n - 1];
        return new double[] {
            last.getX() + 0.5 * StrictMath.cos(last.getAngle()), last.getY() + 0.5 * StrictMath.sin(last.getAngle())
        };
    }

    /** The largest gap of a chain of rods of length 1 that begins at the origin. */
    static double gap(Body[] rods) {
        double x = 0;
        double y = 0;
        double worst = 0;
        for (Body rod : rods) {
            double cos = 0.5 * StrictMath.cos(rod.getAngle());
            double sin = 0.5 * StrictMath.sin(rod.getAngle());
            worst = Math.max(worst, StrictMath.hypot(rod.getX() - cos - x, rod.getY() - sin - y));
            x = rod.getX() + cos;
            y = rod.getY() + sin;
        }
        return worst;
    }

    private static double error(double[] tip, double x, double y) {
        return StrictMath.hypot(tip[0] - x, tip[1] - y);
    }

    @Test
    void tenRodsAfterOneSecond() {
        double[] tip = tip(10, 1, 1 / 1024.0);
        assertThat(error(tip, 7.5272290155603557074, -4.9062623197150037263)).isLessThan(1e-10);
    }

    @Test
    void twoRodsAfterOneSecond() {
        assertThat(error(tip(2, 1, 1 / 4096.0), -1.662115135816127581, -1.04146663719322474)).isLessThan(1e-11);
        assertThat(error(tip(2, 1, 1 / 240.0), -1.662115135816127581, -1.04146663719322474)).isLessThan(2e-7);
    }

    @ParameterizedTest
    @CsvSource({"10, 7.5272290155603557074, -4.9062623197150037263", "2, -1.662115135816127581, -1.04146663719322474"})
    void theOrderIsFour(int n, double x, double y) {
        double coarse = error(tip(n, 1, 1 / 128.0), x, y);
        double fine = error(tip(n, 1, 1 / 1024.0), x, y);
        assertThat(Math.log(coarse / fine) / Math.log(8)).isBetween(3.8, 4.25);
    }

    @ParameterizedTest
    @ValueSource(ints = {1000, 100_000})
    void longChainsStayClosed(int n) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.01);
        Body[] rods = chain(engine, n);
        for (int k = 0; k < 3; k++) {
            engine.step();
        }
        assertThat(gap(rods)).isLessThan(100 * 0x1p-52 * n);
    }
}
