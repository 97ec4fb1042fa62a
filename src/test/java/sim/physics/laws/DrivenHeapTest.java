// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Bodies that fall on one another by a force of the author's, of which nobody knows that it is gravity. */
class DrivenHeapTest {
    private static final double G = 9.81;

    private static final class Weight implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            forces.add(body, 0, -G * body.getMass());
        }
    }

    private static Body put(PhysicsEngine engine, Body body, double restitution) {
        body.setFriction(0.5);
        body.setRestitution(restitution);
        return engine.add(body);
    }

    private static PhysicsEngine bin(long seed, int rate) {
        SplittableRandom random = new SplittableRandom(seed);
        double restitution = random.nextBoolean() ? 0 : random.nextDouble();
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / rate);
        engine.add(new Weight());
        put(engine, Body.fixed(new Rectangle(60, 2)).at(0, -1), restitution);
        put(engine, Body.fixed(new Rectangle(1, 20)).at(6, 5), restitution);
        put(engine, Body.fixed(new Rectangle(1, 20)).at(-6, 5), restitution);
        for (int k = 3 + random.nextInt(6); k > 0; k--) {
            Body body = new Body(random.nextBoolean() ? new Circle(0.5) : new Rectangle(1, 0.6));
            put(engine, body.at(1.2 * (k % 4) - 2, 0.51 + 1.1 * (k / 4)), restitution);
        }
        return engine;
    }

    private static double energy(PhysicsEngine engine) {
        double sum = engine.kineticEnergy();
        for (Body body : engine.bodies()) {
            sum += body.isFixed() ? 0 : G * body.getMass() * body.getY();
        }
        return sum;
    }

    /** What is pressed together hops by the forces that there are, at any step; it flew up at up to 400 m/s. */
    @ParameterizedTest
    @CsvSource({"240, 1", "1000, 1", "1000, 21", "4000, 1", "4000, 21", "20000, 1"})
    void nothingIsThrownUp(int rate, long from) {
        for (long seed = from; seed < from + 8; seed++) {
            PhysicsEngine engine = bin(seed, rate);
            double most = energy(engine) + 0.05 * engine.bodies().size();
            for (int k = 0; k < Math.min(rate, 1000); k++) {
                engine.step();
                assertThat(energy(engine)).as("seed " + seed + ", step " + k).isLessThan(most);
            }
        }
    }
}
