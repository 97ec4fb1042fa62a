// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Elastic bodies that fall between four walls keep their energy, and miss none. */
class FallingGasTest {
    private static final int BODIES = 200;

    @ParameterizedTest
    @CsvSource({"0, 1, 0", "0.3, -1, 4", "0, 10, 0", "-7, 7, 4"})
    void itKeepsItsEnergy(double gx, double gy, int boxes) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 60);
        engine.add(new Gravity(gx, gy));
        double size = 30;
        for (int side = 0; side < 2; side++) {
            engine.add(Body.fixed(new Rectangle(size + 2, 1)).at(0.5 * size, -0.5 + side * (size + 1)));
            engine.add(Body.fixed(new Rectangle(1, size + 2)).at(-0.5 + side * (size + 1), 0.5 * size));
        }
        SplittableRandom random = new SplittableRandom(4);
        Body[] bodies = new Body[BODIES];
        for (int k = 0; k < BODIES; k++) {
            Body body = new Body(k % 5 < boxes ? new Rectangle(0.6, 1.1) : new Circle(0.3 + 0.4 * random.nextDouble()));
            bodies[k] = engine.add(body.at(2 * (k % 15) + 1, 2 * (k / 15) + 1));
            body.setVelocity(random.nextDouble(-4, 4), random.nextDouble(-4, 4));
        }
        double energy = energy(bodies, gx, gy);
        double kinetic = engine.kineticEnergy();
        for (int k = 0; k < 600; k++) {
            engine.step();
            if (k % 50 == 0) {
                assertThat(engine.overlaps()).allSatisfy(one -> assertThat(one.depth()).isLessThan(1e-9));
            }
        }
        assertThat(energy(bodies, gx, gy)).isCloseTo(energy, within(1e-10 * kinetic));
        assertThat(engine.getImpacts()).isGreaterThan(1000);
    }

    private static double energy(Body[] bodies, double gx, double gy) {
        double sum = 0;
        for (Body body : bodies) {
            sum += body.kineticEnergy() - body.getMass() * (gx * body.getX() + gy * body.getY());
        }
        return sum;
    }
}
