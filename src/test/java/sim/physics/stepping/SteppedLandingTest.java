// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Limit;
import sim.physics.constraint.SliderJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/**
 * Plastic boxes that fall one over the other, at one speed and with gaps between them. Those above are stopped in the step in which the lowest one is:
 * else they are as deep in one another as they go in a step.
 */
class SteppedLandingTest {
    private static final double HEIGHT = 0.4;

    private static void drop(PhysicsEngine engine, double from, double gap, double speed) {
        double y = from;
        for (int k = 0; k < 5; k++) {
            Stepped.rough(engine.add(new Body(new Rectangle(0.6, HEIGHT)).at(0, y + HEIGHT / 2).moving(0, -speed)));
            y += HEIGHT + gap;
        }
    }

    private static double deepest(PhysicsEngine engine, int steps) {
        double deepest = 0;
        for (int k = 0; k < steps; k++) {
            engine.step();
            deepest = Math.max(deepest, Stepped.depth(engine));
        }
        return deepest;
    }

    @ParameterizedTest
    @CsvSource({"60, 0.005, 3", "60, 0.005, 8", "60, 0.02, 3", "60, 0.02, 8", "60, 0.05, 8", "25, 0.005, 3", "25, 0.005, 8"})
    void onTheGround(int rate, double gap, double speed) {
        for (int phase = 0; phase < 10; phase++) {
            PhysicsEngine engine = Stepped.engine(1.0 / rate, 4);
            engine.add(new Gravity(0, -Stepped.G));
            Stepped.ground(engine);
            drop(engine, 1 + 0.01 * phase, gap, speed);
            assertThat(deepest(engine, 60)).as("phase %d", phase).isLessThan(0.06);
        }
    }

    @ParameterizedTest
    @CsvSource({"60, 0.005, 3", "60, 0.02, 3", "60, 0.02, 8"})
    void inACabinThatComesToItsStop(int rate, double gap, double speed) {
        for (int phase = 0; phase < 10; phase++) {
            PhysicsEngine engine = Stepped.engine(1.0 / rate, 4);
            engine.add(new Gravity(0, -Stepped.G));
            Body cabin = Stepped.rough(engine.add(new Body(new Rectangle(2, 0.3)).at(0, 5).moving(0, -speed)));
            SliderJoint rail = engine.add(new SliderJoint(cabin, null, 0, 5, 0, 1));
            engine.add(Limit.travel(rail, -1 - 0.01 * phase, 1));
            drop(engine, 5.15 + gap, gap, speed);
            assertThat(deepest(engine, 60)).as("phase %d", phase).isLessThan(0.06);
        }
    }
}
