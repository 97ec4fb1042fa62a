// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** What is put down on a floor lies there, whatever its restitution: what it falls by rounding of its place makes no bounces. */
class PutDownTest {
    @ParameterizedTest
    @CsvSource({"0, 0", "0.3, 0.5", "0.9, 0", "1, 0", "1, 0.5"})
    void itCollidesOnceAndLies(double restitution, double friction) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 60);
        engine.add(new Gravity(0, -9.81));
        engine.add(Body.fixed(new Rectangle(200, 1)).at(0, 0.1 + 0.2)); // no number that halves exactly
        List<Body> bodies = new ArrayList<>();
        for (int k = 0; k < 40; k++) {
            Body body = new Body(k % 2 == 0 ? new Rectangle(1, 0.7) : new Circle(0.35));
            bodies.add(engine.add(body.at(2.1 * k - 40, 0.3 + 0.5 + 0.35)));
        }
        for (Body body : engine.bodies()) {
            body.setRestitution(restitution);
            body.setFriction(friction);
        }
        engine.step();
        assertThat(engine.getImpacts()).isEqualTo(bodies.size());
        for (int k = 0; k < 100; k++) {
            engine.step();
        }
        assertThat(engine.getImpacts()).isEqualTo(bodies.size());
        for (Body body : bodies) {
            assertThat(body.getY()).isCloseTo(1.15, within(1e-13));
            assertThat(body.getVelocityY()).isZero();
        }
    }

    /** One that falls a little further than that bounces as high as it should: to a quarter each time, or as often as it likes. */
    @ParameterizedTest
    @CsvSource({"0.5, 1e-6", "1, 1e-6", "0.5, 1e-9", "1, 1e-9"})
    void whatFallsFurtherBounces(double restitution, double height) {
        PhysicsEngine engine = new PhysicsEngine();
        double g = 10;
        double fall = Math.sqrt(2 * height / g);
        engine.setTimeStep(fall); // it lands at the end of the first step
        engine.add(new Gravity(0, -g));
        engine.add(Body.fixed(new Rectangle(10, 1)).at(0, -0.5)).setRestitution(restitution);
        Body ball = engine.add(new Body(new Circle(0.5)).at(0, 0.5 + height));
        ball.setRestitution(restitution);
        engine.step();
        engine.setTimeStep(restitution * fall); // the top of its first bounce
        engine.step();
        assertThat(ball.getY() - 0.5).isCloseTo(restitution * restitution * height, within(1e-4 * height + 1e-13));
    }
}
