// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/**
 * Bridges that sag by a hundredth of their length, thrown about under gravity: they swing much faster than a step can follow, but pins do no work. Some
 * had millions of times their energy after 2 s.
 */
class SlackBridgeTest {
    private static final double G = 9.81;
    private static final double LENGTH = 0.8;

    private final PhysicsEngine engine = new PhysicsEngine();
    private double start;
    private double most;
    private double least;
    private double scale;

    /** Between the first two planks, if there is one. */
    private Motor motor;

    private void swing(int planks, double slack, double step, long seed) {
        swing(planks, slack, step, seed, 0, 0);
    }

    /** Lets a bridge swing for 2 s, with a motor if it has a limit, and notes the largest energy, without what that can have given, and the least. */
    private void swing(int planks, double slack, double step, long seed, double speed, double limit) {
        Random random = new Random(seed);
        engine.setTimeStep(step);
        engine.add(new Gravity(0, -G));
        double x = 0;
        double y = 0;
        Body last = null;
        for (int k = 0; k < planks; k++) {
            double angle = -StrictMath.asin(slack * 2 * (1 - 2 * (k + 0.5) / planks));
            double dx = LENGTH * StrictMath.cos(angle);
            double dy = LENGTH * StrictMath.sin(angle);
            Body plank = engine.add(new Body(new Rectangle(LENGTH - 0.05, 0.15)).at(x + dx / 2, y + dy / 2, angle));
            engine.add(last == null ? new PinJoint(plank, x, y) : new PinJoint(last, plank, x, y));
            plank.moving(0, 2 * random.nextGaussian(), 3 * random.nextGaussian());
            if (k == 1 && limit > 0) {
                motor = engine.add(Motor.turning(plank, last, speed, limit));
            }
            last = plank;
            x += dx;
            y += dy;
        }
        engine.add(new PinJoint(last, x, y));
        run(slack, step, planks * last.getMass());
    }

    private void run(double slack, double step, double mass) {
        engine.step(); // which closes the velocities
        start = energy();
        most = start;
        least = start;
        scale = engine.kineticEnergy() + mass * G * slack * LENGTH;
        double given = 0;
        for (int k = 1; k < 2 / step; k++) {
            double before = motor == null ? 0 : motor.getValue();
            engine.step();
            given += motor == null || motor.getSpeed() == 0 ? 0 : motor.getLimit() * Math.abs(motor.getValue() - before);
            most = Math.max(most, energy() - given);
            least = Math.min(least, energy());
        }
    }

    private double energy() {
        double sum = engine.kineticEnergy();
        for (Body body : engine.bodies()) {
            sum += body.getMass() * G * body.getY();
        }
        return sum;
    }

    @ParameterizedTest
    @CsvSource({
        "4, 0.003, 240, 0", "4, 0.003, 60, 2", "4, 0.01, 240, 1", "4, 0.01, 60, 0", "4, 0.01, 60, 1", "4, 0.03, 60, 0", "4, 0.03, 60, 3",
        "8, 0.003, 240, 0", "8, 0.01, 240, 0", "8, 0.01, 240, 1", "8, 0.01, 60, 0", "8, 0.01, 60, 2", "8, 0.03, 60, 0", "8, 0.03, 60, 1",
    })
    void itGainsNoEnergy(int planks, double slack, int rate, long seed) {
        swing(planks, slack, 1.0 / rate, seed);
        assertThat(most - start).isLessThan(0.01 * scale);
    }

    /** A motor gives no more than its limit along its way, and a brake nothing: what is more was got from steps too long for the bridge. */
    @ParameterizedTest
    @CsvSource({"4, 0.003, 240, 0, 0, 1", "4, 0.003, 60, 0, 0, 1", "8, 0.003, 240, 0, 0, 1", "4, 0.01, 240, 0, 0, 30", "8, 0.003, 60, 0, 0, 30"})
    void itGainsNoMoreThanItsMotorGives(int planks, double slack, int rate, long seed, double speed, double limit) {
        swing(planks, slack, 1.0 / rate, seed, speed, limit);
        assertThat(most - start).isLessThan(0.01 * scale);
    }

    /** Where steps are not far from what it takes to follow it, it loses none either. */
    @ParameterizedTest
    @CsvSource({"4, 0.03, 240, 0", "4, 0.03, 240, 1", "8, 0.03, 240, 0", "8, 0.03, 240, 1", "4, 0.1, 60, 0", "4, 0.1, 60, 1", "8, 0.1, 60, 0"})
    void itKeepsItsEnergy(int planks, double slack, int rate, long seed) {
        swing(planks, slack, 1.0 / rate, seed);
        assertThat(most - start).isLessThan(0.01 * scale);
        assertThat(start - least).isLessThan(0.02 * scale);
    }
}
