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
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * Chains between two walls that are taut, or all but so: what moves them at first order, the second order forbids. Energy
 * never grows by more than the forces' work, joints stay closed, and every step ends.
 */
class TautChainTest {
    private static final double G = 9.81;

    private final PhysicsEngine engine = new PhysicsEngine();
    private Body[] rods;
    private double end;

    /** Rods of length 1 on an arc whose ends are nearer than its length by a part of it. */
    private void chain(int n, String masses, double slack) {
        engine.setTimeStep(0.01);
        double low = 0;
        double high = 1.5;
        for (int k = 0; k < 200 && slack > 0; k++) {
            double middle = 0.5 * (low + high);
            double lost = 0;
            for (int m = 0; m < n; m++) {
                double sine = StrictMath.sin(0.5 * angle(middle, m, n));
                lost += 2 * sine * sine;
            }
            low = lost < n * slack ? middle : low;
            high = lost < n * slack ? high : middle;
        }
        rods = new Body[n];
        double x = 0;
        double y = 0;
        for (int k = 0; k < n; k++) {
            double angle = angle(low, k, n);
            double cos = StrictMath.cos(angle);
            double sin = StrictMath.sin(angle);
            rods[k] = new Body(new Rectangle(1, 0.02)).at(x + 0.5 * cos, y + 0.5 * sin, angle);
            double mass = masses.equals("equal") ? 1 : masses.equals("unequal") ? 1 + 0.7 * (7 * k % 5) : k % 2 == 0 ? 1 : 1e4;
            rods[k].setMass(mass, mass / 12);
            rods[k].setCollisionGroup(1, 0);
            engine.add(rods[k]);
            x += cos;
            y += sin;
        }
        end = x;
        engine.add(new PinJoint(rods[0], -0.5, 0, null, 0, 0));
        for (int k = 0; k + 1 < n; k++) {
            engine.add(new PinJoint(rods[k], 0.5, 0, rods[k + 1], -0.5, 0));
        }
        engine.add(new PinJoint(rods[n - 1], 0.5, 0, null, x, y));
    }

    private static double angle(double width, int k, int n) {
        return -width * (1 - 2 * (k + 0.5) / n);
    }

    private double gap() {
        Body last = rods[rods.length - 1];
        double tip = last.getX() + 0.5 * StrictMath.cos(last.getAngle());
        return Math.max(ChainTest.gap(rods), Math.abs(end - tip));
    }

    private double energy(double g) {
        double sum = engine.kineticEnergy();
        for (Body rod : rods) {
            sum += rod.getMass() * g * rod.getY();
        }
        return sum;
    }

    private double mass() {
        double sum = 0;
        for (Body rod : rods) {
            sum += rod.getMass();
        }
        return sum;
    }

    @ParameterizedTest
    @CsvSource({
        "2, equal, 0", "3, equal, 0", "4, unequal, 0", "5, equal, 0", "5, unequal, 0", "10, equal, 0", "3, heavy, 0",
        "4, unequal, 1e-12", "5, equal, 1e-12", "10, equal, 1e-12", "4, equal, 1e-6", "5, unequal, 1e-6", "10, equal, 1e-6",
        "10, unequal, 1e-6", "10, heavy, 1e-6", "4, unequal, 1e-3", "10, equal, 1e-3"
    })
    void aStruckChainNeverGainsEnergy(int n, String masses, double slack) {
        chain(n, masses, slack);
        for (int k = 0; k < 3; k++) {
            engine.step();
        }
        rods[n / 2].setVelocity(0, 1);
        double most = 0.5 * rods[n / 2].getMass();
        for (int k = 0; k < 100; k++) {
            engine.step();
            double now = engine.kineticEnergy();
            assertThat(now).as("step %s", k).isLessThan(most * (1 + 1e-9));
            assertThat(gap()).isLessThan(400 * 0x1p-52 * n);
            most = Math.max(now, 1e-9);
            for (Body rod : rods) {
                assertThat(Math.abs(rod.getY())).isLessThan(2 * n * StrictMath.sqrt(slack) + 1e-5);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({
        "3, equal, 0", "4, equal, 0", "5, unequal, 0", "10, equal, 0", "3, equal, 1e-12", "5, equal, 1e-12", "3, equal, 1e-9",
        "10, unequal, 1e-9", "5, equal, 1e-6", "10, equal, 1e-6", "10, unequal, 1e-6", "10, unequal, 1e-3"
    })
    void weightAcrossAChainGivesItNoMoreThanItsFall(int n, String masses, double slack) {
        chain(n, masses, slack);
        engine.add(new Gravity(0, -G));
        double before = energy(G);
        double room = 2e-3 * Math.abs(before) + 1e-12 * mass() * G; // a part of its depth
        for (int k = 0; k < 200; k++) {
            engine.step();
            assertThat(energy(G)).as("step %s", k).isLessThan(before + room);
            assertThat(gap()).isLessThan(400 * 0x1p-52 * n);
        }
    }

    /** A bridge of planks that were laid straight from shore to shore: it cannot sag, which need not be found out again and again. */
    @ParameterizedTest
    @ValueSource(ints = {4, 20})
    void aChainThatStandsIsLetStand(int n) {
        chain(n, "equal", 0);
        int[] asked = {0};
        engine.add((ForceGenerator) (body, time, forces) -> {
            asked[0]++;
            forces.add(body, 0, -G * body.getMass());
        });
        for (int k = 0; k < 20; k++) {
            engine.step(); // what sag there is room for is less than rounding shows
        }
        asked[0] = 0;
        for (int k = 0; k < 100; k++) {
            engine.step();
        }
        assertThat(asked[0]).isLessThanOrEqualTo(300 * n);
        assertThat(engine.kineticEnergy()).isZero();
        engine.remove(engine.allConstraints().get(n)); // the pin of the other shore
        engine.step();
        assertThat(rods[n - 1].getVelocityY()).isLessThan(-0.01);
    }

    /** The pendulum is in one island with the chain, whose pose lets nothing pass; it swings nevertheless. */
    @Test
    void aPendulumOnATautChainSwings() {
        chain(4, "equal", 0);
        engine.add(new Gravity(0, -G));
        Body bob = engine.add(new Body(new Circle(0.05)).at(2.3, -0.4));
        bob.setMass(0.5);
        bob.setCollisionGroup(1, 0);
        engine.add(new PinJoint(rods[1], 0.5, 0, bob, -0.3, 0.4));
        double before = energy(G) + bob.getMass() * G * bob.getY();
        double least = bob.getX();
        for (int k = 0; k < 100; k++) {
            engine.step();
            least = Math.min(least, bob.getX());
            assertThat(energy(G) + bob.getMass() * G * bob.getY()).isLessThan(before + 1e-6);
            assertThat(StrictMath.hypot(bob.getX() - 2, bob.getY())).isCloseTo(0.5, within(1e-4));
        }
        assertThat(least).isLessThan(1.9);
    }

    /** What is struck in the middle moves as its mirror image. */
    @Test
    void aStruckChainStaysSymmetric() {
        chain(5, "equal", 1e-3);
        rods[2].setVelocity(0, 1);
        for (int k = 0; k < 100; k++) {
            engine.step();
            for (int m = 0; m < 5; m++) {
                assertThat(rods[m].getX()).isCloseTo(end - rods[4 - m].getX(), within(1e-9));
                assertThat(rods[m].getY()).isCloseTo(rods[4 - m].getY(), within(1e-9));
            }
        }
    }
}
