// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.collision.narrow.Distance;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Rectangle;

/** Small bodies that turn thousands of times in a step: the search for their impact takes more steps than others do. */
class FastSpinnerTest {
    /** Notes how deep a body was in a wall when it met it. */
    private static final class Depths implements CollisionListener {
        private static final long serialVersionUID = 1L;
        private final transient Distance distance = new Distance();
        private double deepest;
        private int count;

        @Override
        public void collided(Contact contact) {
            count++;
            deepest = Math.max(deepest, -distance.between(contact.a(), contact.b()));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {100, 3000, 22_873, 100_000})
    void meetsThinWallsWhereTheyAre(double spin) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.add(new Gravity(2, -10));
        double half = 5;
        for (int side = -1; side <= 1; side += 2) {
            engine.add(Body.fixed(new Rectangle(2 * half, 1e-3)).at(0, side * half));
            engine.add(Body.fixed(new Rectangle(1e-3, 2 * half)).at(side * half, 0));
        }
        Body body = engine.add(new Body(new Rectangle(3e-3, 2.4e-3)).moving(-30, 26, spin));
        Depths depths = new Depths();
        engine.addListener(depths);
        double energy = body.kineticEnergy();
        for (int step = 0; step < 5; step++) {
            engine.step();
            assertTrue(Math.abs(body.getX()) < half && Math.abs(body.getY()) < half, () -> "it has left: " + body);
        }
        assertTrue(depths.count > 10, depths.count + " impacts");
        assertEquals(0, depths.deepest, 1e-12);
        double after = body.kineticEnergy() - body.getMass() * (2 * body.getX() - 10 * body.getY());
        assertEquals(energy, after, 1e-9 * energy);
    }
}
