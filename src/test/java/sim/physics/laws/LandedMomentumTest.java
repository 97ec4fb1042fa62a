// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * What nothing opposes is kept, however bodies land on one another: on a smooth floor that is the momentum along it, and in free flight all
 * momenta. And a heap that moves along is struck as one that stands.
 */
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

    /** Two boxes that meet in free flight: one of them turns fast, and its long side comes round onto the other as they slide. */
    @ParameterizedTest
    @ValueSource(doubles = {30, 60, 240})
    void inFlightAllMomentaAreKept(double stepsInASecond) {
        for (int seed = 0; seed < 30; seed++) {
            Random random = new Random(seed);
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(1 / stepsInASecond);
            Body first = put(engine, new Body(new Rectangle(1.5, 0.2)).at(0, 0, random.nextDouble()), 0.3);
            first.moving(0, 0, 1 + random.nextDouble());
            Body other = put(engine, new Body(new Rectangle(0.4, 0.3)).at(0.3 * random.nextGaussian(), 1.2, 6 * random.nextDouble()), 0.3);
            other.moving(2 * random.nextGaussian(), -3, random.nextGaussian());
            double x = momentum(engine);
            double y = first.getMass() * first.getVelocityY() + other.getMass() * other.getVelocityY();
            double spin = spin(first) + spin(other);
            for (int k = 0; k < stepsInASecond; k++) {
                engine.step();
                assertThat(momentum(engine)).as("seed %d", seed).isCloseTo(x, within(1e-12));
                double yNow = first.getMass() * first.getVelocityY() + other.getMass() * other.getVelocityY();
                assertThat(yNow).as("seed %d", seed).isCloseTo(y, within(1e-12));
                assertThat(spin(first) + spin(other)).as("seed %d", seed).isCloseTo(spin, within(1e-4 * Math.abs(spin) + 1e-6));
            }
        }
    }

    private static double spin(Body b) {
        return b.getInertia() * b.getAngularVelocity()
                + b.getMass() * (b.getX() * b.getVelocityY() - b.getY() * b.getVelocityX());
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
