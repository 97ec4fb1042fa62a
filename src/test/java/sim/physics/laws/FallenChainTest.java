// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/** A straight chain falls flat on the floor, in a world that is turned by any angle: all links meet it at once but for rounding, and lie. */
class FallenChainTest {
    private static final double G = 9.81;
    private static final double THICKNESS = 0.2;

    /** One after the other these impacts threw links up: half of the chains of 12 and 20 links ended as arches of up to 0.2 m. */
    @ParameterizedTest
    @CsvSource({"8, 0.03, 0", "12, 0.1, 0", "20, 0.03, 0", "20, 0.1, 0", "12, 0.1, 0.5", "20, 0.1, 0.5"})
    void itLiesFlat(int links, double height, double restitution) {
        SplittableRandom random = new SplittableRandom(5);
        for (int k = 0; k < 12; k++) {
            double angle = 2 * Math.PI * random.nextDouble();
            PhysicsEngine engine = chain(links, height, restitution, angle);
            for (int n = 0; n < 150; n++) {
                engine.step();
            }
            for (int m = 1; m <= links; m++) {
                Body link = engine.bodies().get(m);
                double y = StrictMath.cos(angle) * link.getY() - StrictMath.sin(angle) * link.getX();
                assertThat(y).as("link %d at %s", m, angle).isEqualTo(THICKNESS / 2, within(1e-6));
                assertThat(link.getAngle()).as("link %d at %s", m, angle).isEqualTo(angle, within(1e-9));
            }
        }
    }

    private static PhysicsEngine chain(int links, double height, double restitution, double angle) {
        double cos = StrictMath.cos(angle);
        double sin = StrictMath.sin(angle);
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(G * sin, -G * cos));
        engine.add(Body.fixed(new Rectangle(links + 10, 1)).at(0.5 * sin, -0.5 * cos, angle));
        double y = height + THICKNESS / 2;
        for (int k = 0; k < links; k++) {
            double x = k - (links - 1) / 2.0;
            Body link = engine.add(new Body(new Rectangle(1, THICKNESS)).at(cos * x - sin * y, sin * x + cos * y, angle));
            if (k > 0) {
                engine.add(new PinJoint(engine.bodies().get(k), link, cos * (x - 0.5) - sin * y, sin * (x - 0.5) + cos * y));
            }
        }
        for (Body body : engine.bodies()) {
            body.setRestitution(restitution);
            body.setFriction(0.5);
        }
        return engine;
    }
}
