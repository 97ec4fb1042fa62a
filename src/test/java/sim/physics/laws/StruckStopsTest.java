// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Limit;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/**
 * Chains with stops fall between walls. What strikes the ground gives their links speeds at once, with which they reach stops that were
 * far off before: these were passed by 0.06 rad in a step, as those within reach had been told by the speeds before it.
 */
class StruckStopsTest {
    private static final double BEND = 0.9;

    private final PhysicsEngine engine = new PhysicsEngine();
    private final List<Body[]> joints = new ArrayList<>();

    private void wall(double width, double height, double x, double y, double friction) {
        Body wall = engine.add(Body.fixed(new Rectangle(width, height)).at(x, y));
        wall.setFriction(friction);
        wall.setRestitution(friction == 0.8 ? 0 : 0.2);
    }

    private void chain(Random random, double x) {
        Body last = null;
        for (int k = 0; k < 10; k++) {
            Body link = engine.add(new Body(new Rectangle(0.2, 0.6)).at(x, 1.5 + 0.6 * k));
            link.setFriction(0.5);
            link.setRestitution(0);
            if (last != null) {
                engine.add(new PinJoint(last, link, x, 1.2 + 0.6 * k));
                engine.add(Limit.angle(link, last, -BEND, BEND));
                joints.add(new Body[] {link, last});
            }
            last = link;
            link.setVelocity(0.3 * random.nextGaussian(), 0);
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void stopsHoldWhatIsStruck(long seed) {
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -9.81));
        wall(60, 2, 0, -1, 0.8);
        wall(1, 20, -3, 10, 0.3);
        wall(1, 20, 3, 10, 0.3);
        Random random = new Random(seed);
        for (int k = 0; k < 3; k++) {
            chain(random, 1.5 * k - 1.5);
        }
        for (int k = 0; k < 100; k++) {
            engine.step();
            for (Body[] joint : joints) {
                double bend = Math.abs(joint[0].getAngle() - joint[1].getAngle());
                assertThat(bend).as("step %s", k).isLessThan(BEND + 0.02);
            }
        }
    }
}
