// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.collision.Overlap;
import sim.physics.motion.Body;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;

/** What spins by a radian and more in a step does not go into walls: other corners come to them within the step than at its start. */
class SteppedSpinTest {
    private static final int SCENES = 60;

    /** How deep a bar or a polygon is in the thick walls of its box in three seconds. */
    private static double depth(long seed, double turn, double restitution, double friction) {
        SplittableRandom random = new SplittableRandom(seed);
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 60);
        engine.setTimeStepping(4);
        for (int k = 0; k < 2; k++) {
            engine.add(Body.fixed(new Rectangle(3, 12)).at(k * 7 - 3.5, 0));
            engine.add(Body.fixed(new Rectangle(12, 3)).at(0, k * 7 - 3.5));
        }
        Body body = new Body(random.nextBoolean() ? new Rectangle(1, 0.3) : Polygon.regular(3 + random.nextInt(3), 0.5));
        body.at(random.nextDouble() - 0.5, random.nextDouble() - 0.5, 6 * random.nextDouble());
        engine.add(body.moving(4 * random.nextDouble() - 2, 4 * random.nextDouble() - 2, 60 * turn));
        for (Body one : engine.bodies()) {
            one.setRestitution(restitution);
            one.setFriction(friction);
        }
        double before = engine.kineticEnergy();
        double deepest = 0;
        for (int k = 0; k < 180; k++) {
            engine.step();
            for (Overlap overlap : engine.overlaps()) {
                deepest = Math.max(deepest, overlap.depth());
            }
            assertThat(engine.kineticEnergy()).isLessThan((1 + 1e-9) * before);
        }
        return deepest;
    }

    /** In the mean they were 0.02 to 0.11 and 0.05 to 0.4 deep, at worst 0.3 and 1.4: through the wall. */
    @ParameterizedTest
    @CsvSource({
        "2, 0, 0, 0.02, 0.003", "2, 0, 0.3, 0.02, 0.003", "2, 0.5, 0.3, 0.05, 0.003", "2, 1, 0, 0.2, 0.02",
        "5, 0, 0, 0.02, 0.003", "5, 0, 0.3, 0.02, 0.003", "5, 0.5, 0.3, 0.05, 0.003", "5, 1, 0, 0.3, 0.04"
    })
    void whatSpinsStaysInItsBox(double turn, double restitution, double friction, double most, double mean) {
        double sum = 0;
        for (int seed = 0; seed < SCENES; seed++) {
            double depth = depth(seed, turn, restitution, friction);
            assertThat(depth).as("scene %s", seed).isLessThan(most);
            sum += depth;
        }
        assertThat(sum / SCENES).isLessThan(mean);
    }
}
