// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.response.LastingContact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** What slides over the ground to and fro between walls, off which it bounces, is borne by the ground in each step: m g is what contacts and impacts give. */
class BorneBesideAWallTest {
    /** What the ground gives in impacts of a step. */
    private static final class Impulses implements CollisionListener {
        private static final long serialVersionUID = 1L;
        private double sum;

        @Override
        public void collided(Contact contact) {
            boolean isOnB = contact.b().isDynamic();
            sum += contact.impulse() * contact.normalY() * (isOnB ? 1 : -1);
        }
    }

    @ParameterizedTest
    @CsvSource({"false, 0.5", "false, 0.9", "true, 0.5", "true, 0.9"})
    void theGroundBearsTheWeightInEachStep(boolean isRound, double restitution) {
        double h = 1 / 60.0;
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(h);
        engine.add(new Gravity(0, -10));
        engine.add(Body.fixed(new Rectangle(20, 2)).at(0, -1));
        engine.add(Body.fixed(new Rectangle(1, 4)).at(2.5, 2));
        engine.add(Body.fixed(new Rectangle(1, 4)).at(-2.5, 2));
        Shape shape = isRound ? new Circle(0.3) : new Rectangle(1, 0.6);
        Body body = engine.add(new Body(shape).at(0, 0.3).moving(7, 0));
        for (Body one : engine.bodies()) {
            one.setRestitution(restitution);
        }
        Impulses impacts = new Impulses();
        engine.addListener(impacts);
        for (int k = 1; k <= 200; k++) {
            impacts.sum = 0;
            double before = body.getVelocityY();
            engine.step();
            double given = impacts.sum;
            for (LastingContact contact : engine.contacts(body)) {
                given += h * contact.forceY(body);
            }
            double gained = body.getMass() * (body.getVelocityY() - before + 10 * h);
            assertThat(given).as("step " + k).isCloseTo(gained, within(1e-9));
        }
        assertThat(engine.getImpacts()).isGreaterThan(4);
    }
}
