// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** However low a disc bounces on a round body or a corner, its first impacts in a step have their restitution: none is faster than it was. */
class ShortBounceTest {
    /** Impacts of a pair in one step after which it may lie. */
    private static final int EXACT = 8;

    /** Speed, for the steps here, of bounces that are so short beside the step that the disc may rest. */
    private static final double REST = 1e-5;

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void everyImpactHasItsRestitution(boolean isCorner) {
        int checked = 0;
        Random random = new Random(2);
        for (int run = 0; run < 100; run++) {
            double restitution = 0.3 + 0.5 * random.nextDouble();
            double friction = run % 2 == 0 ? 0.2 : 0;
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(0.02 + 0.1 * random.nextDouble());
            engine.add(new Gravity(0, -9.81));
            Body peg = engine.add(Body.fixed(isCorner ? new Rectangle(0.2, 0.2) : new Circle(0.1)).at(0, 0, Math.PI / 4));
            Body disc = engine.add(new Body(new Circle(0.22)).at(0.002 + 0.05 * random.nextDouble(), 0.8));
            peg.setFriction(friction);
            peg.setRestitution(restitution);
            disc.setFriction(friction);
            disc.setRestitution(restitution);
            Rebounds rebounds = new Rebounds(engine, restitution);
            engine.addListener(rebounds);
            while (engine.getTime() < 2) {
                engine.step();
            }
            checked += rebounds.shortOnes;
        }
        assertThat(checked).as("impacts at less than a hundredth of the first one's speed").isGreaterThan(100);
    }

    /** Compares speeds along the normal before and after. */
    private static final class Rebounds implements CollisionListener {
        private static final long serialVersionUID = 1L;

        private final PhysicsEngine engine;
        private final double restitution;
        private double before;
        private long step = -1;
        private int inStep;
        int shortOnes;

        Rebounds(PhysicsEngine engine, double restitution) {
            this.engine = engine;
            this.restitution = restitution;
        }

        @Override
        public Decision colliding(Contact contact) {
            before = parting(contact);
            inStep = engine.getSteps() == step ? inStep + 1 : 1;
            step = engine.getSteps();
            return Decision.BOUNCE;
        }

        @Override
        public void collided(Contact contact) {
            if (inStep <= EXACT && contact.approachSpeed() > REST) {
                assertThat(parting(contact)).as("rebound " + inStep).isCloseTo(-restitution * before, within(1e-12));
                shortOnes += contact.approachSpeed() < 0.03 ? 1 : 0;
            }
        }

        private static double parting(Contact contact) {
            Body a = contact.a();
            Body b = contact.b();
            return (b.getVelocityX() - a.getVelocityX()) * contact.normalX() + (b.getVelocityY() - a.getVelocityY()) * contact.normalY();
        }
    }
}
