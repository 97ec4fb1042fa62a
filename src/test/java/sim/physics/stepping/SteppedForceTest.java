// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Time stepping: forces of authors between bodies that collide. */
class SteppedForceTest {
    /** Bar magnets: poles of ±1 at both ends pull and push one another, the steeper the nearer they are. */
    private static final class Magnets implements ForceGenerator {
        private static final long serialVersionUID = 1L;
        private static final double REACH = 0.4;
        final List<Body> bodies = new ArrayList<>();

        @Override
        public void addForce(Body body, double time, Forces forces) {
            for (int i = -1; i <= 1; i += 2) {
                double x = body.worldX(i * REACH, 0);
                double y = body.worldY(i * REACH, 0);
                for (Body other : bodies) {
                    for (int k = -1; other != body && k <= 1; k += 2) {
                        double dx = x - other.worldX(k * REACH, 0);
                        double dy = y - other.worldY(k * REACH, 0);
                        double square = dx * dx + dy * dy + 0.04;
                        double f = 0.5 * i * k / (square * Math.sqrt(square));
                        forces.addAt(body, f * dx, f * dy, x, y);
                    }
                }
            }
        }

        @Override
        public boolean isCoupled() {
            return true;
        }
    }

    @ParameterizedTest
    @CsvSource({"true, 0", "true, 0.3", "false, 0", "false, 0.3"})
    void magnetsThatClingAndBounceKeepTheirMomentum(boolean areRound, double friction) {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        Magnets magnets = new Magnets();
        SplittableRandom random = new SplittableRandom(3);
        for (int k = 0; k < 8; k++) {
            Body body = new Body(areRound ? new Circle(0.4) : new Rectangle(1, 0.4)).at(2 * (k % 4), 2 * (k / 4), 6 * random.nextDouble());
            body.setFriction(friction); // elastic
            magnets.bodies.add(engine.add(body));
        }
        engine.add(magnets);

        double most = 0;
        for (int k = 0; k < 900; k++) {
            engine.step();
            double x = magnets.bodies.stream().mapToDouble(body -> body.getMass() * body.getVelocityX()).sum();
            double y = magnets.bodies.stream().mapToDouble(body -> body.getMass() * body.getVelocityY()).sum();
            most = Math.max(most, Math.hypot(x, y));
        }

        assertThat(engine.getImpacts()).as("impacts").isGreaterThan(10);
        assertThat(most).as("momentum").isLessThan(1e-12);
    }
}
