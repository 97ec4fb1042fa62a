// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.KinematicBody;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * A listener adds a body each time a ball bounces, while a press squeezes another one, so that steps are made anew from their beginning by time stepping. What
 * is new was nowhere then, and stays where it was put: it was where nobody had put it, or the step ended with an index out of bounds.
 */
class AddedInRemadeStepTest {
    private static final double GRAVITY = 9.81;
    private static final double STEP = 1.0 / 60;
    private static final double HEIGHT = 3;

    @Test
    void isWhereItWasPut() {
        int added = 0;
        for (int seed = 180; seed < 200; seed++) {
            added += run(new Random(seed), seed);
        }
        assertThat(added).isPositive();
    }

    private static int run(Random random, int seed) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(STEP);
        engine.add(new Gravity(0, -GRAVITY));
        put(engine, Body.fixed(new Rectangle(20, 1)).at(0, -0.5), 0.6, 0);
        put(engine, new Body(new Circle(0.3)).at(0.1 * random.nextDouble(), 0.3), 0.6, 0);
        Body ball = put(engine, new Body(new Circle(0.1)).at(5, 0.1 + random.nextDouble()), 0.2, 0.9);
        Body press = new KinematicBody(new Rectangle(2, 0.5)).at(0, 0.86 + 0.3 * random.nextDouble());
        put(engine, press.moving(0, -1 - 2 * random.nextDouble()), 0.6, 0);
        List<Body> added = new ArrayList<>();
        engine.addListener(new CollisionListener() {
            @Override
            public void collided(Contact contact) {
                if ((contact.a() == ball || contact.b() == ball) && added.size() < 40) {
                    added.add(put(engine, new Body(new Circle(0.2)).at(place(added.size()), HEIGHT), 0.3, 0.3));
                }
            }
        });
        for (int step = 0; step < 60; step++) {
            int before = added.size();
            engine.step();
            for (int k = before; k < added.size(); k++) {
                assertThat(added.get(k).getX()).as("seed %d", seed).isCloseTo(place(k), within(1e-9));
                assertThat(added.get(k).getY()).as("seed %d", seed).isCloseTo(HEIGHT, within(2 * GRAVITY * STEP * STEP)); // it falls for two steps at most
            }
        }
        return added.size();
    }

    private static double place(int k) {
        return 7 + 0.7 * k;
    }

    private static Body put(PhysicsEngine engine, Body body, double friction, double restitution) {
        body.setFriction(friction);
        body.setRestitution(restitution);
        return engine.add(body);
    }
}
