// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/** What nothing opposes is kept, however bodies land on one another: on a smooth floor that is the momentum along it. */
class LandedMomentumTest {
    private static final double G = 9.81;

    @ParameterizedTest
    @CsvSource({
        "60, 2, 0, 40", "60, 3, 0, 20", "240, 2, 0, 60", "240, 3, 0, 30", "240, 2, 0.3, 30", "960, 2, 0, 15", "960, 3, 0, 8", "3840, 2, 0, 4"
    })
    void onASmoothFloorItIsKept(double stepsInASecond, int bodies, double restitution, int seeds) {
        for (int seed = 0; seed < seeds; seed++) {
            Random random = new Random(seed);
            PhysicsEngine engine = overFloor(1 / stepsInASecond, restitution);
            for (int k = 0; k < bodies; k++) {
                Rectangle box = new Rectangle(0.4 + 0.4 * random.nextDouble(), 0.3 + 0.4 * random.nextDouble());
                Body body = put(engine, new Body(box).at(0.2 * random.nextGaussian(), 0.75 + k, 6 * random.nextDouble()), restitution);
                body.moving(3 + random.nextGaussian(), -2 - k, 2 * random.nextGaussian());
            }
            double before = momentum(engine);
            for (int k = 0; k < stepsInASecond; k++) {
                engine.step();
                assertThat(momentum(engine)).as("seed %d, step %d", seed, k).isCloseTo(before, within(1e-12 * Math.abs(before)));
            }
        }
    }

    private static double momentum(PhysicsEngine engine) {
        double sum = 0;
        for (Body body : engine.bodies()) {
            sum += body.isFixed() ? 0 : body.getMass() * body.getVelocityX();
        }
        return sum;
    }

    private static Body put(PhysicsEngine engine, Body body, double restitution) {
        body.setFriction(0);
        body.setRestitution(restitution);
        return engine.add(body);
    }

    private static PhysicsEngine overFloor(double step, double restitution) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        engine.add(new Gravity(0, -G));
        put(engine, Body.fixed(new Rectangle(200, 2)).at(0, -1), restitution);
        return engine;
    }
}
