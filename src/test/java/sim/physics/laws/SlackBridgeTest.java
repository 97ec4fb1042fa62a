// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
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

    /** Lets a bridge swing for 2 s, and notes the largest and the least energy. */
    private void swing(int planks, double slack, double step, long seed) {
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
            last = plank;
            x += dx;
            y += dy;
        }
        engine.add(new PinJoint(last, x, y));
        engine.step(); // which closes the velocities
        start = energy();
        most = start;
        least = start;
        scale = engine.kineticEnergy() + planks * last.getMass() * G * slack * LENGTH;
        for (int k = 1; k < 2 / step; k++) {
            engine.step();
            most = Math.max(most, energy());
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

    /** Where steps are not far from what it takes to follow it, it loses none either. */
    @ParameterizedTest
    @CsvSource({"4, 0.03, 240, 0", "4, 0.03, 240, 1", "8, 0.03, 240, 0", "8, 0.03, 240, 1", "4, 0.1, 60, 0", "4, 0.1, 60, 1", "8, 0.1, 60, 0"})
    void itKeepsItsEnergy(int planks, double slack, int rate, long seed) {
        swing(planks, slack, 1.0 / rate, seed);
        assertThat(most - start).isLessThan(0.01 * scale);
        assertThat(start - least).isLessThan(0.02 * scale);
    }
}
