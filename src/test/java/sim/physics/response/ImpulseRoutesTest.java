// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;

/** The write-up's bordered system and the closed form give the same impulse. */
class ImpulseRoutesTest {
    static Impact random(SplittableRandom random, double decades) {
        Impact c = new Impact();
        c.wA = StrictMath.pow(10, decades * (random.nextDouble() - 0.5));
        c.wB = StrictMath.pow(10, decades * (random.nextDouble() - 0.5));
        c.iA = c.wA * (0.5 + random.nextDouble());
        c.iB = c.wB * (0.5 + random.nextDouble());
        double angle = 7 * random.nextDouble();
        c.nx = StrictMath.cos(angle);
        c.ny = StrictMath.sin(angle);
        c.rAx = random.nextDouble() - 0.5;
        c.rAy = random.nextDouble() - 0.5;
        c.rBx = random.nextDouble() - 0.5;
        c.rBy = random.nextDouble() - 0.5;
        c.vAx = random.nextDouble() - 0.5;
        c.vAy = random.nextDouble() - 0.5;
        c.omegaA = random.nextDouble() - 0.5;
        c.vBx = random.nextDouble() - 0.5;
        c.vBy = random.nextDouble() - 0.5;
        c.omegaB = random.nextDouble() - 0.5;
        c.restitution = random.nextDouble();
        c.setLevers(false, false);
        return c;
    }

    @Test
    void bothAgreeOnRandomImpacts() {
        SplittableRandom random = new SplittableRandom(3);
        TwoBodyImpulse closed = new TwoBodyImpulse();
        BorderedImpulse bordered = new BorderedImpulse();
        for (int k = 0; k < 10_000; k++) {
            Impact c = random(random, 4);
            closed.solve(c);
            double expected = c.jn;
            bordered.solve(c);
            assertThat(c.jn).as("impact %d", k).isCloseTo(expected, within(1e-10 * Math.abs(expected)));
        }
    }

    /** Moreau's law: friction opposes what slides after the impact, and reaches μ where something does, also where nothing slid before. */
    @Test
    void frictionOpposesWhatSlidesAfterTheImpact() {
        SplittableRandom random = new SplittableRandom(5);
        TwoBodyImpulse closed = new TwoBodyImpulse();
        int sliding = 0;
        for (int k = 0; k < 20_000; k++) {
            Impact c = random(random, 4);
            c.restitution = 0;
            c.friction = 0.01 + random.nextDouble();
            double slide = c.tangentVelocity() * (k % 4) / 3;
            c.vBx += (c.tangentVelocity() - slide) * c.ny;
            c.vBy -= (c.tangentVelocity() - slide) * c.nx;
            if (k % 4 == 0) {
                c.belt = -c.tangentVelocity(); // none at all, not even by rounding
            }
            if (c.normalVelocity() >= 0) {
                continue;
            }
            closed.solve(c);
            double most = c.friction * c.jn;
            assertThat(Math.abs(c.jt)).as("impact %d", k).isLessThanOrEqualTo(most * (1 + 1e-12));
            c.apply();
            assertThat(c.normalVelocity()).as("impact %d", k).isCloseTo(0, within(1e-11));
            double after = c.tangentVelocity();
            if (Math.abs(after) > 1e-10) {
                sliding++;
                assertThat(c.jt).as("impact %d", k).isCloseTo(-Math.signum(after) * most, within(1e-12 * most));
            }
        }
        assertThat(sliding).isGreaterThan(2000);
    }

    @Test
    void aGasRunsOnTheBorderedSystemToo() {
        PhysicsEngine engine = Scenes.gas(Scenes.Kind.FIGURE_1, 30, 4);
        engine.setImpulseSolver(new BorderedImpulse());
        double energy = engine.kineticEnergy();
        for (int k = 0; k < 200; k++) {
            engine.step();
        }
        assertThat(engine.getImpacts()).isGreaterThan(100);
        assertThat(engine.kineticEnergy() / energy).isCloseTo(1, within(1e-11));
    }
}
