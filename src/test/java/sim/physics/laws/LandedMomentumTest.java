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
import sim.physics.shape.Circle;
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

    /** A disc falls on a box that lies on a cart, and leaves it as fast if all of that moves, but for what gravity gives in a step. */
    @ParameterizedTest
    @CsvSource({"60, 0.8, 2.8", "240, 0.8, 2.8", "960, 0.8, 2.8", "60, 0.5, 0.88", "960, 0.5, 0.97"})
    void whatMovesIsStruckAsWhatStands(double stepsInASecond, double restitution, double least) {
        double still = rebound(0, stepsInASecond, restitution);
        double slow = rebound(1e-5, stepsInASecond, restitution);
        assertThat(still).isGreaterThan(least);
        assertThat(slow).isCloseTo(still, within(G / stepsInASecond));
        for (double speed : new double[] {1e-4, 1e-2, 1}) {
            assertThat(rebound(speed, stepsInASecond, restitution)).as("speed %s", speed).isCloseTo(slow, within(1e-6));
        }
    }

    private static double rebound(double speed, double stepsInASecond, double restitution) {
        PhysicsEngine engine = overFloor(1 / stepsInASecond, restitution);
        Body cart = put(engine, new Body(new Rectangle(4, 0.5)).at(0, 0.25), restitution).moving(speed, 0);
        cart.setMass(30);
        Body box = put(engine, new Body(new Rectangle(1, 1)).at(0, 1), restitution).moving(speed, 0);
        box.setMass(1);
        Body disc = put(engine, new Body(new Circle(0.2)).at(0.05, 2.7), restitution).moving(speed, -1);
        disc.setMass(1);
        double before = 0;
        while (disc.getVelocityY() < before + 0.5 && engine.getTime() < 1) {
            before = disc.getVelocityY();
            engine.step();
        }
        assertThat(engine.getDeepestPenetration()).isLessThan(1e-9);
        return disc.getVelocityY();
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
