// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * What falls from rest, or is driven, meets what lies below, however far forces move it in a step: pairs were looked for along the way that the velocity
 * of the step's start gives.
 */
class SteppedFallTest {
    /** An author's field. */
    private static final class Pull implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            forces.add(body, 0, -body.getMass() * Stepped.G);
        }
    }

    private static double leastHeight(double step, int substeps, double radius, double height, boolean isField) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        engine.setTimeStepping(substeps);
        if (isField) {
            engine.add(new Gravity(0, -Stepped.G));
        } else {
            engine.add(new Pull());
        }
        Body plate = engine.add(Body.fixed(new Rectangle(20 * radius, radius)).at(0, -0.5 * radius));
        Body disc = engine.add(new Body(new Circle(radius)).at(0, radius + height));
        plate.setRestitution(0);
        double least = height;
        for (int k = 0; k < 40; k++) {
            engine.step();
            least = Math.min(least, disc.getY() - radius);
        }
        return least;
    }

    /** How far a contact gives way under the weight of what lies on it: 0.4 g h², for a substep h. */
    private static double sag(double step, int substeps) {
        return 0.5 * Stepped.G * (step / substeps) * (step / substeps);
    }

    @ParameterizedTest
    @CsvSource({"1, 4, 0.25", "2, 4, 0.25", "2, 32, 0.25", "0.0166666666666667, 1, 0.0003", "0.0166666666666667, 4, 0.0003", "0.5, 4, 0.05"})
    void whatFallsFromRestMeetsTheGround(double step, int substeps, double radius) {
        double nearly = 1e-9 * Stepped.G * step * step;
        for (int k = 1; k <= 40; k++) {
            double height = k * 0.1 * Stepped.G * step * step;
            assertThat(leastHeight(step, substeps, radius, height, true)).as("field, %s above", height).isGreaterThan(-nearly);
            assertThat(leastHeight(step, substeps, radius, height, false)).as("force, %s above", height).isGreaterThan(-sag(step, substeps));
        }
    }

    /** Where it meets the ground as a substep ends, but for rounding or for a little more. */
    @ParameterizedTest
    @CsvSource({"1, 4, 0.25", "2, 4, 0.25", "2, 32, 0.25", "0.0166666666666667, 1, 0.0003", "0.0166666666666667, 4, 0.0003", "0.5, 4, 0.05"})
    void whatMeetsTheGroundAsASubstepEnds(double step, int substeps, double radius) {
        double nearly = 1e-9 * Stepped.G * step * step;
        double part = 0.5 * Stepped.G * (step / substeps) * (step / substeps);
        for (int n = 1; n <= 40; n++) {
            for (double off : new double[] {-0.02, -1e-3, -1e-12, 0, 1e-12, 1e-3, 0.02}) {
                double height = part * n * n * (1 + off);
                assertThat(leastHeight(step, substeps, radius, height, true)).as("%s above", height).isGreaterThan(-nearly);
            }
        }
    }

    /** What is so small that a contact gives way by a part of its size, and is a little deep, sank for ever, by up to its own size in each step. */
    @ParameterizedTest
    @CsvSource({"1, 0.0003", "2, 0.0003", "4, 0.0003", "1, 0.001", "8, 0.0001"})
    void whatIsSmallDoesNotSink(int substeps, double radius) {
        double step = 1.0 / 60;
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        engine.setTimeStepping(substeps);
        engine.add(new Gravity(0, -Stepped.G));
        Body ground = engine.add(Body.fixed(new Rectangle(1, 1)).at(0, -0.5));
        Body disc = engine.add(new Body(new Circle(radius)).at(0, 0.99 * radius));
        ground.setRestitution(0);
        Stepped.run(engine, 300);
        assertThat(disc.getY() - radius).isBetween(-sag(step, substeps), 0.0);
    }
}
