// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.HashSet;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.collision.narrow.Distance;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** What has left a heap falls freely, though those go on that have pressed on it, and turn so fast that they are solved for several times a step. */
class LeftHeapTest {
    private static final double G = 9.81;

    @ParameterizedTest
    @CsvSource({"60, 150", "240, 400"})
    void whatTouchesNothingFallsFreely(double stepsInASecond, int seeds) {
        int checked = 0;
        for (int seed = 0; seed < seeds; seed++) {
            PhysicsEngine engine = bin(new Random(seed), 1 / stepsInASecond);
            Set<Body> struck = new HashSet<>();
            engine.addListener(new CollisionListener() {
                private static final long serialVersionUID = 1L;

                @Override
                public void collided(Contact contact) {
                    struck.add(contact.a());
                    struck.add(contact.b());
                }
            });
            for (int k = 0; k < stepsInASecond; k++) {
                struck.clear();
                checked += step(engine, struck, "seed " + seed + ", step " + k);
            }
        }
        assertThat(checked).as("bodies that lay on something before").isPositive();
    }

    private static boolean lies(PhysicsEngine engine, Body body) {
        return !engine.contacts(body).isEmpty();
    }

    /** Makes a step; returns how many bodies have been checked that counted as lying on something when it began. */
    private static int step(PhysicsEngine engine, Set<Body> struck, String when) {
        Body[] bodies = engine.bodies().toArray(new Body[0]);
        double[] before = new double[bodies.length];
        boolean[] isFree = new boolean[bodies.length];
        boolean[] lies = new boolean[bodies.length];
        for (int k = 0; k < bodies.length; k++) {
            before[k] = bodies[k].getVelocityY();
            isFree[k] = !bodies[k].isFixed() && isAlone(bodies, bodies[k]);
            lies[k] = lies(engine, bodies[k]);
        }
        engine.step();
        int checked = 0;
        for (int k = 0; k < bodies.length; k++) {
            if (isFree[k] && !struck.contains(bodies[k]) && isAlone(bodies, bodies[k])) {
                checked += lies[k] ? 1 : 0;
                double fallen = G * engine.getTimeStep();
                assertThat(before[k] - bodies[k].getVelocityY()).as("%s, body %d", when, k).isCloseTo(fallen, within(1e-9));
            }
        }
        return checked;
    }

    /** Whether a body is so far from all others that it has parted from them. */
    private static boolean isAlone(Body[] bodies, Body body) {
        Distance distance = new Distance();
        boolean is = true;
        for (Body other : bodies) {
            is &= other == body || distance.between(body, other) > 0.02;
        }
        return is;
    }

    private static PhysicsEngine bin(Random random, double step) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(step);
        engine.add(new Gravity(0, -G));
        engine.add(Body.fixed(new Rectangle(40, 2)).at(0, -1));
        engine.add(Body.fixed(new Rectangle(1, 20)).at(-1.3, 10));
        engine.add(Body.fixed(new Rectangle(1, 20)).at(1.3, 10));
        double restitution = 0.3 * random.nextDouble();
        for (int k = 0; k < 5; k++) {
            double size = 0.15 + 0.25 * random.nextDouble();
            boolean isBox = random.nextInt(3) > 0;
            Body body = new Body(isBox ? new Rectangle(2 * size, 2 * size * (0.3 + 0.7 * random.nextDouble())) : new Circle(size));
            body.at(0.4 * (random.nextDouble() - 0.5), 0.55 + 0.85 * k, 6 * random.nextDouble());
            body.moving(0.7 * random.nextGaussian(), -2 * random.nextDouble(), 2 * random.nextGaussian());
            body.setMass(size * size * Math.pow(100, random.nextDouble()));
            engine.add(body);
        }
        for (Body body : engine.bodies()) {
            body.setRestitution(restitution);
            body.setFriction(0);
        }
        return engine;
    }
}
