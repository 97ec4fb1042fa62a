// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.function.DoubleFunction;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.AdaptiveIntegrator;
import sim.physics.motion.Automatic;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.GraggBulirschStoer;
import sim.physics.motion.Gravity;
import sim.physics.motion.RadauIIA;
import sim.physics.motion.Spring;
import sim.physics.references.ElasticPendulum;
import sim.physics.shape.Circle;

/** A mass that swings on a spring of ω = 10,000/s, critically damped: every method's tolerance holds, whatever bounds its steps. */
class StiffSpringTest {
    private static final double G = 9.81;

    /** Counts evaluations. */
    private static final class Counter implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private long evaluations;

        @Override
        public boolean actsOn(Body body) {
            return !body.isFixed();
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            evaluations++;
        }
    }

    static Stream<Arguments> methods() {
        return Stream.of(
                Arguments.of((DoubleFunction<AdaptiveIntegrator>) DormandPrince853::new, 150_000),
                Arguments.of((DoubleFunction<AdaptiveIntegrator>) GraggBulirschStoer::new, 400_000),
                Arguments.of((DoubleFunction<AdaptiveIntegrator>) RadauIIA::new, 8_000),
                Arguments.of((DoubleFunction<AdaptiveIntegrator>) Automatic::new, 8_000));
    }

    /** Small errors grow to 3.8 times their size; extrapolation was off by 1,500 times that before it looked at its stability. */
    @ParameterizedTest
    @MethodSource("methods")
    void theToleranceHolds(DoubleFunction<AdaptiveIntegrator> method, long most) {
        ElasticPendulum exact = new ElasticPendulum(10_000, 1, G);
        double[] start = exact.start(1);
        double[][] states = exact.states(start, new double[] {0.5, 1, 1.5, 2, 2.5, 3}, false, 1e-12);
        for (double tolerance = 1e-3; tolerance > 0.5e-6; tolerance *= 0.1) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(0.5);
            engine.setIntegrator(method.apply(tolerance));
            engine.add(new Gravity(0, -G));
            double x = start[0] * StrictMath.sin(start[1]);
            double y = -start[0] * StrictMath.cos(start[1]);
            Body body = engine.add(new Body(new Circle(0.1)).at(x, y));
            body.setMass(1, 0.005);
            engine.add(new Spring(body, 0, 0, null, 0, 0, 1, 1e8, 2e4));
            Counter counter = new Counter();
            engine.add(counter);
            double worst = 0;
            for (int k = 0; k < 6; k++) {
                engine.step();
                double[] place = ElasticPendulum.place(states[k]);
                worst = Math.max(worst, StrictMath.hypot(body.getX() - place[0], body.getY() - place[1]));
            }
            assertThat(worst).as("%s", engine.getIntegrator()).isLessThan(10 * 3.8 * tolerance);
            assertThat(counter.evaluations).as("%s", engine.getIntegrator()).isLessThan(most);
        }
    }
}
