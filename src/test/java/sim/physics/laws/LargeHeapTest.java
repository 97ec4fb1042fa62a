// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.response.LastingContact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Many bodies that fall on one another in a bin: while they move they are solved for a step at once, and not to rounding. */
class LargeHeapTest {
    private static final double G = 9.81;

    private static PhysicsEngine bin(int n, double restitution, long seed) {
        int row = (int) Math.ceil(Math.sqrt(n));
        double side = 1.3 * row;
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -G));
        put(engine, Body.fixed(new Rectangle(side + 20, 5)).at(side / 2, -2.5), restitution);
        put(engine, Body.fixed(new Rectangle(5, 4 * side)).at(-2.5, 2 * side), restitution);
        put(engine, Body.fixed(new Rectangle(5, 4 * side)).at(side + 2.5, 2 * side), restitution);
        SplittableRandom random = new SplittableRandom(seed);
        for (int k = 0; k < n; k++) {
            Body body = new Body(k % 2 == 0 ? new Circle(0.5) : new Rectangle(1, 1));
            double x = (k % row + 0.5) * 1.3 + random.nextDouble(-0.05, 0.05);
            put(engine, body.at(x, (k / row + 0.5) * 1.5).moving(random.nextDouble(-2, 2), 0), restitution);
        }
        return engine;
    }

    private static void put(PhysicsEngine engine, Body body, double restitution) {
        body.setFriction(0.5);
        body.setRestitution(restitution);
        engine.add(body);
    }

    private static double energy(PhysicsEngine engine) {
        double sum = engine.kineticEnergy();
        for (Body body : engine.bodies()) {
            sum += body.isFixed() ? 0 : body.getMass() * G * body.getY();
        }
        return sum;
    }

    private static double deepest(PhysicsEngine engine) {
        return engine.overlaps().stream().mapToDouble(o -> o.depth()).max().orElse(0);
    }

    /** What bodies are in one another is regained, and lifts them by as much; nothing else may add energy. */
    @ParameterizedTest
    @CsvSource({"60, 0, 1", "60, 0.3, 2", "100, 0.2, 3"})
    void theyFallWithoutGainOfEnergyAndHardlyIntoOneAnother(int n, double restitution, long seed) {
        PhysicsEngine engine = bin(n, restitution, seed);
        double weight = G * engine.bodies().stream().filter(b -> !b.isFixed()).mapToDouble(Body::getMass).sum();
        double least = energy(engine);
        double deepest = 0;
        for (int step = 0; step < 400; step++) {
            engine.step();
            double now = energy(engine);
            assertThat(now).as("energy after step %d", step).isLessThan(least + 1e-3 * weight);
            least = Math.min(least, now);
            deepest = Math.max(deepest, deepest(engine));
        }
        assertThat(deepest).as("radii are 0.5, speeds 10").isLessThan(0.04);
        assertThat(deepest(engine)).as("in the end").isLessThan(5e-4);
        assertThat(engine.kineticEnergy()).isLessThan(1e-4 * weight);
    }

    /** What is near when a step begins may be solved with a heap before it touches: it is no contact unless it bears something. */
    @Test
    void onlyWhatTouchesIsAContact() {
        PhysicsEngine engine = bin(60, 0, 4);
        for (int step = 0; step < 200; step++) {
            engine.step();
            for (LastingContact contact : engine.contacts()) {
                boolean bears = contact.normalForce() > 0;
                double apart = Math.hypot(contact.a().getX() - contact.b().getX(), contact.a().getY() - contact.b().getY());
                double reach = contact.a().getShape().boundingRadius() + contact.b().getShape().boundingRadius();
                assertThat(bears || apart < 1.02 * reach).as("step %d: %s", step, contact).isTrue();
            }
        }
    }

    /** Those who want to be asked are asked before anything touches: a ghost falls through all that lies in the bin. */
    @Test
    void aGhostFallsThroughALargeHeap() {
        PhysicsEngine engine = bin(80, 0, 5);
        Body ghost = new Body(new Circle(0.5)).at(6.05, 30);
        put(engine, ghost, 0);
        engine.addListener(new CollisionListener() {
            @Override
            public Decision colliding(Contact contact) {
                return contact.a() == ghost || contact.b() == ghost ? Decision.IGNORE : Decision.BOUNCE;
            }
        });
        double y = ghost.getY();
        for (int step = 1; step <= 150; step++) {
            engine.step();
            double t = engine.getTime();
            assertThat(ghost.getY()).as("free fall").isCloseTo(y - 0.5 * G * t * t, within(1e-9));
        }
    }

    @Test
    void aRunThatIsRestoredGoesOnBitForBit() {
        PhysicsEngine engine = bin(60, 0.2, 6);
        for (int step = 0; step < 70; step++) {
            engine.step();
        }
        PhysicsEngine restored = Checkpoint.copy(engine);
        for (int step = 0; step < 60; step++) {
            engine.step();
            restored.step();
        }
        Checkpoint.assertSameBodies(engine, restored);
    }
}
