// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Time stepping: an elastic ball on a spring that is thrown against a wall again and again, half its amplitude beyond the middle. */
class SpringAtWallTest {
    private static final double AMPLITUDE = 0.5;
    private static final double RADIUS = 0.1;

    /** Each swing to the wall and back takes two thirds of a period, and nothing takes or gives energy. */
    @ParameterizedTest
    @CsvSource({"60, 4, 100, 0.001", "60, 4, 1000, 0.02", "240, 4, 1000, 0.002", "240, 1, 1000, 0.02", "240, 4, 10000, 0.03"})
    void keepsItsEnergy(double rate, int substeps, double stiffness, double bound) {
        PhysicsEngine engine = Stepped.engine(1 / rate, substeps);
        Body ball = engine.add(new Body(new Circle(RADIUS)).at(-AMPLITUDE, 0));
        ball.setMass(1);
        engine.add(new Spring(ball, 0, 0, null, -5, 0, 5, stiffness, 0));
        engine.add(Body.fixed(new Rectangle(1, 4)).at(0.5 * AMPLITUDE + RADIUS + 0.5, 0));
        double before = 0.5 * stiffness * AMPLITUDE * AMPLITUDE;
        for (int k = 0; k < 10 * rate; k++) {
            engine.step();
        }
        double hits = 10 * StrictMath.sqrt(stiffness) / (StrictMath.PI * 4 / 3);
        assertThat((double) engine.getImpacts()).isCloseTo(hits, within(1 + 0.02 * hits));
        assertThat((ball.kineticEnergy() + 0.5 * stiffness * ball.getX() * ball.getX()) / before).isCloseTo(1, within(bound));
    }
}
