// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Elastic bodies, as all are unless told otherwise, that are put on the ground: they would bounce a million times in a step. */
class ElasticRestTest {
    private static final double STEP = 1.0 / 60;

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.3, 1})
    void boxPutOnTheGroundLiesThere(double friction) {
        assertRests(new Rectangle(1, 1), friction);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.3, 1})
    void discPutOnTheGroundLiesThere(double friction) {
        assertRests(new Circle(0.5), friction);
    }

    /** On one another too, where each impact moves what lies below: some dozens of impacts, and then a stack that stays. */
    @ParameterizedTest
    @ValueSource(ints = {2, 5})
    void discsPutOnOneAnotherLieThere(int count) {
        PhysicsEngine engine = ground(0);
        for (int k = 0; k < count; k++) {
            engine.add(new Body(new Circle(0.5)).at(0, 0.5 + k));
        }
        for (int step = 0; step < 10; step++) {
            engine.step();
        }
        assertTrue(engine.getImpacts() < 2000, engine.getImpacts() + " impacts");
        for (int k = 0; k < count; k++) {
            assertEquals(0.5 + k, engine.bodies().get(k + 1).getY(), 1e-6);
        }
    }

    private static void assertRests(Shape shape, double friction) {
        PhysicsEngine engine = ground(friction);
        Body body = engine.add(new Body(shape).at(0, 0.5));
        body.setFriction(friction);
        for (int step = 0; step < 10; step++) {
            engine.step();
        }
        assertTrue(engine.getImpacts() < 100, engine.getImpacts() + " impacts");
        assertEquals(0.5, body.getY(), 1e-12);
        assertEquals(0, body.kineticEnergy());
        assertEquals(1, engine.contacts(body).size());
    }

    /** Without friction it slides on at rest, and by the gravity along the ground. */
    @Test
    void restingBoxGoesOnAlongTheGround() {
        PhysicsEngine engine = ground(0);
        engine.add(new Gravity(2, 0));
        Body body = engine.add(new Body(new Rectangle(1, 1)).at(0, 0.5).moving(3, 0));
        for (int step = 0; step < 60; step++) {
            engine.step();
        }
        assertTrue(engine.getImpacts() < 100, engine.getImpacts() + " impacts");
        assertEquals(4, body.getX(), 1e-9);
        assertEquals(5, body.getVelocityX(), 1e-9);
    }

    /** A bounce of a thousandth of a step is one: nothing comes to rest that can be followed. */
    @Test
    void lowBouncesGoOn() {
        PhysicsEngine engine = ground(0);
        double speed = 0.5 * 10 * 1e-3 * STEP;
        Body body = engine.add(new Body(new Circle(0.5)).at(0, 0.5).moving(0, speed));
        for (int step = 0; step < 10; step++) {
            engine.step();
        }
        assertEquals(10_000, engine.getImpacts(), 10);
        double energy = body.kineticEnergy() + body.getMass() * 10 * (body.getY() - 0.5);
        assertEquals(0.5 * body.getMass() * speed * speed, energy, 1e-4 * speed * speed);
    }

    /** Without a force that presses, a disc between two walls meets them as often as it does. */
    @Test
    void fastDiscBetweenNearWallsKeepsItsSpeed() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1);
        engine.add(new Gravity(0, -1)); // along the walls
        engine.add(Body.fixed(new Rectangle(1, 100)).at(-1.0001, 0));
        engine.add(Body.fixed(new Rectangle(1, 100)).at(1.0001, 0));
        Body body = engine.add(new Body(new Circle(0.5)).moving(5, 0));
        engine.step();
        assertTrue(engine.getImpacts() > 24_000, engine.getImpacts() + " impacts");
        assertEquals(5, Math.abs(body.getVelocityX()), 1e-9);
    }

    private static PhysicsEngine ground(double friction) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(STEP);
        engine.add(new Gravity(0, -10));
        engine.add(Body.fixed(new Rectangle(60, 1)).at(0, -0.5)).setFriction(friction);
        return engine;
    }
}
