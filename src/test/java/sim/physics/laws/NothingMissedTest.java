// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.SymplecticEuler;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Bodies that fall, and strike one another on their way, never meet the ground too late. */
class NothingMissedTest {
    private final PhysicsEngine engine = new PhysicsEngine();

    private static Body add(PhysicsEngine engine, double restitution, Body body) {
        body.setRestitution(restitution);
        body.setFriction(0.1);
        return engine.add(body);
    }

    /** What was known of two bodies' distance was believed for a body that had been struck in the middle of a step. */
    @ParameterizedTest
    @CsvSource({"8, 12", "2, 25", "3, 12"})
    void aPourOfBodies(long seed, int count) {
        pour(engine, seed, count, 0.5);
        for (int k = 0; k < 200; k++) {
            engine.step();
            assertThat(engine.overlaps().stream().mapToDouble(one -> one.depth()).max().orElse(0))
                    .as("depth at %s", engine.getTime())
                    .isLessThan(1e-9);
        }
    }

    /** Nothing drives these bodies, so the method has no part in their motion: they have the same bits with all of them. */
    @ParameterizedTest
    @ValueSource(longs = {0, 1, 5, 6, 10})
    void aPourHasNoMethod(long seed) {
        PhysicsEngine other = new PhysicsEngine();
        other.setIntegrator(new SymplecticEuler());
        pour(engine, seed, 12, 0.5);
        pour(other, seed, 12, 0.5);
        engine.setTimeStep(1 / 20.0);
        other.setTimeStep(1 / 20.0);
        for (int k = 0; k < 120; k++) {
            engine.step();
            other.step();
            assertThat(Scenes.hash(other)).as("at %s", engine.getTime()).isEqualTo(Scenes.hash(engine));
        }
    }

    private static void pour(PhysicsEngine engine, long seed, int count, double restitution) {
        SplittableRandom random = new SplittableRandom(seed);
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -10));
        add(engine, restitution, Body.fixed(new Rectangle(16, 2)).at(0, -1));
        add(engine, restitution, Body.fixed(new Rectangle(2, 80)).at(-7, 40));
        add(engine, restitution, Body.fixed(new Rectangle(2, 80)).at(7, 40));
        for (int k = 0; k < count; k++) {
            double s = random.nextDouble(0.4, 1.5);
            Body body = add(engine, restitution, new Body(random.nextInt(2) == 0 ? new Circle(s / 2) : new Rectangle(s, s * 0.7))
                    .at(random.nextDouble(-5, 5), 1 + k * 0.9, random.nextDouble(6)));
            body.setMass(body.getMass() * random.nextDouble(0.1, 10));
        }
        engine.separate();
    }
}
