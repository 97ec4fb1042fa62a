// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Spring;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;

/** Springs leave with the bodies at their ends, as joints do: a body that is gone pulls nothing. */
class SpringEndTest {
    private static final class Remover implements CollisionListener {
        private static final long serialVersionUID = 1L;
        private final PhysicsEngine engine;
        private final Body victim;

        Remover(PhysicsEngine engine, Body victim) {
            this.engine = engine;
            this.victim = victim;
        }

        @Override
        public void collided(Contact contact) {
            if (engine.contains(victim)) {
                engine.remove(victim);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void removedBodyDoesNotPull(boolean isFixed) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.01);
        Body end = engine.add((isFixed ? Body.fixed(new Circle(1)) : new Body(new Circle(1))).at(0, 0));
        Body body = engine.add(new Body(new Circle(1)).at(5, 0));
        Spring spring = new Spring(body, 0, 0, end, 0, 0, 3, 10, 0);
        engine.add(spring);
        for (int k = 0; k < 10; k++) {
            engine.step();
        }
        engine.remove(end);
        double speed = body.getVelocityX();
        assertTrue(speed < -0.1);
        for (int k = 0; k < 10; k++) {
            engine.step();
            assertEquals(speed, body.getVelocityX());
        }
        assertThrows(IllegalStateException.class, () -> engine.remove(spring));
    }

    /** In the middle of a step: from that instant on. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void bodyRemovedByListenerPullsUpToThen(boolean isFixed) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1);
        Body end = engine.add((isFixed ? Body.fixed(new Circle(1)) : new Body(new Circle(1)).moving(0, 1)).at(0, 0));
        Body body = engine.add(new Body(new Circle(1)).at(5, 0));
        body.setMass(1);
        if (!isFixed) {
            end.setMass(1);
        }
        engine.add(new Spring(body, 0, 0, end, 0, 0, 0, 1e-3, 0));
        engine.add(new Body(new Circle(1)).at(0, 52.25));
        engine.add(new Body(new Circle(1)).at(0, 50).moving(0, 0.5)); // they meet at 0.5
        engine.addListener(new Remover(engine, end));
        engine.step();
        double pull = 1e-3 * 5;
        assertEquals(-0.5 * pull, body.getVelocityX(), 1e-2 * pull);
        double speed = body.getVelocityX();
        engine.step();
        assertEquals(speed, body.getVelocityX());
    }

    @Test
    void otherSpringsStay() {
        PhysicsEngine engine = new PhysicsEngine();
        Body a = engine.add(new Body(new Circle(1)).at(0, 0));
        Body b = engine.add(new Body(new Circle(1)).at(5, 0));
        Body c = engine.add(new Body(new Circle(1)).at(10, 0));
        engine.add(new Spring(a, 0, 0, b, 0, 0, 5, 1, 0));
        Spring other = new Spring(b, 0, 0, c, 0, 0, 5, 1, 0);
        engine.add(other);
        engine.remove(a);
        c.setVelocity(1, 0);
        engine.step();
        assertTrue(b.getVelocityX() > 0);
        engine.remove(other);
    }
}
