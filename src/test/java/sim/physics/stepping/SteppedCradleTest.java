// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.RodJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;

/** Time stepping: elastic balls that hang from rods and touch. Nothing drives them, and nothing takes energy, however the blows go through the row. */
class SteppedCradleTest {
    private static final double G = 9.81;
    private static final double RADIUS = 0.05;

    private static Body[] cradle(PhysicsEngine engine, int balls) {
        engine.add(new Gravity(0, -G));
        Body[] all = new Body[balls];
        for (int k = 0; k < balls; k++) {
            double x = 2 * RADIUS * k;
            double angle = k == 0 ? -0.5 : 0;
            all[k] = engine.add(new Body(new Circle(RADIUS)).at(x + StrictMath.sin(angle), 1 - StrictMath.cos(angle)));
            all[k].setMass(1);
            engine.add(RodJoint.bodyPoints(all[k], 0, 0, null, x, 1, 1));
        }
        return all;
    }

    /** Above that of all balls at rest. */
    private static double energy(Body[] balls) {
        double sum = 0;
        for (Body ball : balls) {
            sum += ball.kineticEnergy() + G * ball.getMass() * ball.getY();
        }
        return sum;
    }

    /** What is slower than forces make it in two steps does not bounce: in long steps a long row loses energy, but never gets any. */
    @ParameterizedTest
    @CsvSource({"5, 60, 4, 0.97, 1.005", "5, 240, 4, 0.99, 1.005", "20, 240, 4, 0.98, 1.01", "20, 60, 4, 0, 1.01", "20, 60, 1, 0, 1.02"})
    void energyDoesNotGrow(int balls, double rate, int substeps, double least, double most) {
        PhysicsEngine engine = Stepped.engine(1 / rate, substeps);
        Body[] all = cradle(engine, balls);
        double before = energy(all);
        double highest = 0;
        for (int k = 0; k < 20 * rate; k++) {
            engine.step();
            highest = StrictMath.max(highest, energy(all));
        }
        assertThat(highest / before).isLessThan(most);
        assertThat(energy(all) / before).isGreaterThan(least);
    }
}
