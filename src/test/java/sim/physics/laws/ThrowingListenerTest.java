// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.collision.Overlap;
import sim.physics.constraint.RodJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** A step that a listener has ended by an exception leaves an engine that goes on: nothing falls through the ground. */
class ThrowingListenerTest {
    private static final class Thrower implements CollisionListener {
        private static final long serialVersionUID = 1L;
        private final boolean asked;
        private int left;

        Thrower(boolean asked, int left) {
            this.asked = asked;
            this.left = left;
        }

        @Override
        public Decision colliding(Contact contact) {
            if (asked) {
                count();
            }
            return Decision.BOUNCE;
        }

        @Override
        public void collided(Contact contact) {
            if (!asked) {
                count();
            }
        }

        private void count() {
            left--;
            if (left == 0) {
                throw new UnsupportedOperationException("for once");
            }
        }
    }

    @ParameterizedTest
    @CsvSource({
        "true, 1, 0, false", "false, 1, 0.5, false", "true, 2, 0.5, false", "false, 2, 0, false", "true, 4, 1, false",
        "false, 5, 1, false", "true, 1, 0.5, true", "false, 1, 0.5, true", "true, 2, 0, true", "false, 3, 1, true"
    })
    void nothingPassesThroughTheGroundAfterwards(boolean asked, int calls, double restitution, boolean tied) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 60);
        engine.add(new Gravity(0, -10));
        for (int side = -1; side <= 1; side += 2) {
            engine.add(Body.fixed(new Rectangle(60, 1)).at(0, 4.5 * side)).setRestitution(restitution);
        }
        Body box = engine.add(new Body(new Rectangle(1, 0.7)).at(0, 0, 0.3).moving(0, -5));
        Body disc = engine.add(new Body(new Circle(0.5)).at(0.3, 2).moving(0, -5));
        box.setRestitution(restitution);
        disc.setRestitution(restitution);
        if (tied) {
            engine.add(new RodJoint(box, 0, 0, disc, 0, 0, Math.sqrt(0.3 * 0.3 + 2 * 2)));
        }
        engine.addListener(new Thrower(asked, calls));
        int thrown = 0;
        for (int k = 0; k < 300; k++) {
            long steps = engine.getSteps();
            try {
                engine.step();
            } catch (UnsupportedOperationException e) {
                thrown++;
                assertEquals(steps, engine.getSteps());
            }
            for (Overlap overlap : engine.overlaps()) {
                assertTrue(overlap.depth() < 1e-6, () -> "step " + steps + ": " + overlap);
            }
        }
        assertEquals(1, thrown);
        assertTrue(box.getY() > -4 && disc.getY() > -4);
    }
}
