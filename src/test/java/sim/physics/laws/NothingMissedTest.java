// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Bodies that fall, and strike one another on their way, never meet the ground too late. */
class NothingMissedTest {
    private final PhysicsEngine engine = new PhysicsEngine();

    private Body add(Body body) {
        body.setRestitution(0.5);
        body.setFriction(0.1);
        return engine.add(body);
    }

    /** What was known of two bodies' distance was believed for a body that had been struck in the middle of a step. */
    @ParameterizedTest
    @CsvSource({"8, 12", "2, 25", "3, 12"})
    void aPourOfBodies(long seed, int count) {
        SplittableRandom random = new SplittableRandom(seed);
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -10));
        add(Body.fixed(new Rectangle(16, 2)).at(0, -1));
        add(Body.fixed(new Rectangle(2, 80)).at(-7, 40));
        add(Body.fixed(new Rectangle(2, 80)).at(7, 40));
        for (int k = 0; k < count; k++) {
            double s = random.nextDouble(0.4, 1.5);
            Body body = add(new Body(random.nextInt(2) == 0 ? new Circle(s / 2) : new Rectangle(s, s * 0.7))
                    .at(random.nextDouble(-5, 5), 1 + k * 0.9, random.nextDouble(6)));
            body.setMass(body.getMass() * random.nextDouble(0.1, 10));
        }
        engine.separate();
        for (int k = 0; k < 200; k++) {
            engine.step();
            assertThat(engine.overlaps().stream().mapToDouble(one -> one.depth()).max().orElse(0))
                    .as("depth at %s", engine.getTime())
                    .isLessThan(1e-9);
        }
    }
}
