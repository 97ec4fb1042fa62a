// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.response.LastingContact;
import sim.physics.shape.Circle;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;

/**
 * Bodies that fall into a V between two walls. Where friction is more than the slope, the walls lock them: any force may act across, and what contacts bear is
 * not unique. They bear no more than what stops the bodies asks for.
 */
class WedgedTest {
    private static final double G = 9.81;
    private static final double STEP = 1 / 60.0;
    private static final int STEPS = 240;

    /** How many times what stops them may be borne, at the angle of the wedge: there may be several impacts in a step. */
    private static final double TIMES = 10;

    private PhysicsEngine engine;
    private final List<Body> bodies = new ArrayList<>();
    private double half;

    private void build(int seed) {
        SplittableRandom random = new SplittableRandom(seed);
        engine = new PhysicsEngine();
        engine.setTimeStep(STEP);
        engine.add(new Gravity(0, -G));
        half = 0.1 + 0.5 * random.nextDouble();
        for (int side = -1; side <= 1; side += 2) {
            double angle = 0.5 * Math.PI + side * half;
            double across = angle + side * 0.5 * Math.PI;
            double x = 8 * Math.cos(angle) + 0.5 * Math.cos(across);
            double y = 8 * Math.sin(angle) + 0.5 * Math.sin(across);
            engine.add(Body.fixed(new Rectangle(16, 1)).at(x, y, angle));
        }
        int count = 1 + random.nextInt(3);
        for (int k = 0; k < count; k++) {
            double radius = 0.3 + 0.2 * random.nextDouble();
            Body body = new Body(random.nextInt(3) == 0 ? new Circle(radius) : Polygon.regular(3 + random.nextInt(4), radius));
            body.at(0, 0.62 / Math.sin(half) + 1.1 * k, 6 * random.nextDouble()).moving(0, -1 - 4 * random.nextDouble(), 3 * random.nextDouble());
            bodies.add(engine.add(body));
        }
        double friction = 0.3 + 0.9 * random.nextDouble();
        double restitution = 0.3 * random.nextInt(2);
        for (Body body : engine.bodies()) {
            body.setFriction(friction);
            body.setRestitution(restitution);
        }
    }

    /** What stops all of them within a step, and bears them. */
    private double load() {
        double load = 0;
        for (Body body : bodies) {
            load += body.getMass() * (G + (Math.hypot(body.getVelocityX(), body.getVelocityY()) + 0.5 * Math.abs(body.getAngularVelocity())) / STEP);
        }
        return load;
    }

    @Test
    void bearWhatStopsThem() {
        for (int seed = 0; seed < 60; seed++) {
            bodies.clear();
            build(seed);
            double load = load();
            for (int k = 0; k < STEPS; k++) {
                engine.step();
                double most = TIMES * (load + load()) / Math.sin(half);
                load = load();
                for (LastingContact contact : engine.contacts()) {
                    assertThat(contact.normalForce()).as("seed %d, step %d", seed, k).isLessThan(most);
                }
                assertThat(engine.overlaps()).as("seed %d, step %d", seed, k).allSatisfy(overlap -> assertThat(overlap.depth()).isLessThan(1e-4));
            }
            assertAreHeld(seed);
        }
    }

    /** What lies there is held against its weight. */
    private void assertAreHeld(int seed) {
        for (Body body : bodies) {
            double x = 0;
            double y = -body.getMass() * G;
            for (LastingContact contact : engine.contacts(body)) {
                double side = contact.a() == body ? -1 : 1;
                x += side * (contact.normalX() * contact.normalForce() - contact.normalY() * contact.tangentForce());
                y += side * (contact.normalY() * contact.normalForce() + contact.normalX() * contact.tangentForce());
            }
            assertThat(body.getVelocityX()).as("seed %d", seed).isCloseTo(0, within(1e-6));
            assertThat(x).as("seed %d", seed).isCloseTo(0, within(1e-6));
            assertThat(y).as("seed %d", seed).isCloseTo(0, within(1e-6));
        }
    }
}
