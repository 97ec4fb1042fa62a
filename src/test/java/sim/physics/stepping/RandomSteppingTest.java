// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Spring;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.response.ContactListener;
import sim.physics.response.LastingContact;
import sim.physics.shape.Circle;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Time stepping under whatever authors may do between steps and while they are asked and told: what is told adds up, and nothing is thrown. */
class RandomSteppingTest {
    private static final int MOST = 70;

    /** Does something at random when it is called, and keeps the roll of who lies on whom. */
    private static final class Author implements CollisionListener, ContactListener {
        private static final long serialVersionUID = 1L;
        private final PhysicsEngine engine;
        private final Set<List<Body>> roll = new HashSet<>();
        private long seed;

        Author(PhysicsEngine engine, long seed) {
            this.engine = engine;
            this.seed = seed;
        }

        private SplittableRandom random() {
            return new SplittableRandom(seed++); // no part of what is saved, but its seeds are
        }

        private void check(Contact contact) {
            assertThat(engine.contains(contact.a()) && engine.contains(contact.b())).isTrue();
            assertThat(Math.hypot(contact.normalX(), contact.normalY())).isBetween(1 - 1e-9, 1 + 1e-9);
            assertThat(contact.approachSpeed()).isNotNegative();
            if (random().nextInt(5) == 0) {
                act(engine, random());
            }
        }

        @Override
        public Decision colliding(Contact contact) {
            check(contact);
            int k = random().nextInt(10);
            return k == 0 ? Decision.STICK : k == 1 ? Decision.IGNORE : Decision.BOUNCE;
        }

        @Override
        public void collided(Contact contact) {
            check(contact);
            assertThat(contact.impulse()).isPositive();
        }

        @Override
        public void began(LastingContact contact) {
            assertThat(roll.add(List.of(contact.a(), contact.b()))).isTrue();
            assertThat(contact.normalForce()).isPositive();
        }

        @Override
        public void lasts(LastingContact contact) {
            assertThat(roll).contains(List.of(contact.a(), contact.b()));
        }

        @Override
        public void ended(Body a, Body b) {
            assertThat(roll.remove(List.of(a, b))).isTrue();
        }
    }

    private static double some(SplittableRandom random) {
        return 4 * random.nextDouble() - 2;
    }

    private static void add(PhysicsEngine engine, SplittableRandom random) {
        Shape shape = switch (random.nextInt(3)) {
            case 0 -> new Circle(0.2 + 0.4 * random.nextDouble());
            case 1 -> new Rectangle(0.3 + random.nextDouble(), 0.3 + random.nextDouble());
            default -> Polygon.regular(3 + random.nextInt(5), 0.3 + 0.4 * random.nextDouble());
        };
        Body body = engine.add(new Body(shape).at(2 * some(random), 2 * some(random), some(random)));
        body.moving(some(random), some(random), some(random));
        body.setFriction(random.nextDouble());
        body.setRestitution(Math.max(0, random.nextDouble() - 0.4));
    }

    private static Body pick(PhysicsEngine engine, SplittableRandom random) {
        List<Body> all = engine.bodies();
        return all.get(4 + random.nextInt(all.size() - 4)); // behind the walls
    }

    private static void act(PhysicsEngine engine, SplittableRandom random) {
        Body body = pick(engine, random);
        Body other = pick(engine, random);
        List<Constraint> constraints = engine.allConstraints();
        switch (random.nextInt(12)) {
            case 0, 1 -> {
                if (engine.bodies().size() < MOST) {
                    add(engine, random);
                }
            }
            case 2 -> {
                if (engine.bodies().size() > 8) {
                    engine.remove(body);
                }
            }
            case 3 -> body.setVelocity(some(random), some(random));
            case 4 -> body.setPosition(2 * some(random), 2 * some(random));
            case 5 -> body.addForce(10 * some(random), 10 * some(random));
            case 6 -> body.setMass(0.2 + random.nextDouble());
            case 7 -> body.setCollisionGroup(1L << random.nextInt(3), random.nextInt(8));
            case 8 -> {
                if (body != other) {
                    engine.setCollisions(body, other, random.nextBoolean());
                }
            }
            case 9 -> tie(engine, random, body, other);
            case 10 -> {
                if (!constraints.isEmpty()) {
                    engine.remove(constraints.get(random.nextInt(constraints.size())));
                }
            }
            default -> body.addImpulseAt(0.1 * some(random), 0.1 * some(random), body.getX(), body.getY());
        }
    }

    private static void tie(PhysicsEngine engine, SplittableRandom random, Body body, Body other) {
        if (engine.allConstraints().size() > 5 || body == other) {
            return;
        }
        switch (random.nextInt(4)) {
            case 0 -> engine.add(new PinJoint(body, body.getX() + 0.2, body.getY()));
            case 1 -> engine.add(Motor.turning(body, other, some(random), 1));
            case 2 -> engine.add(Limit.angle(body, other, -0.5, 0.5));
            default -> engine.add(new Spring(body, 0, 0, other, 0, 0, 1, 5, 0.5));
        }
    }

    private static void between(PhysicsEngine engine, SplittableRandom random) {
        switch (random.nextInt(6)) {
            case 0 -> engine.setTimeStep((1 + 3 * random.nextDouble()) / 120);
            case 1 -> engine.setTimeStepping(1 + random.nextInt(8));
            case 2 -> engine.contacts().forEach(contact -> assertThat(engine.contains(contact.a()) && engine.contains(contact.b())).isTrue());
            case 3 -> engine.allConstraints().forEach(c -> assertThat(Double.isFinite(engine.getReaction(c).forceX())).isTrue());
            default -> act(engine, random);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 1573, 3781, 4070, 4495}) // of the last four, compression has thrown bodies about
    void authorsMayDoWhatTheyWant(int seed) {
        SplittableRandom random = new SplittableRandom(seed);
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 1 + random.nextInt(8));
        SteppedHeapTest.bin(engine, 5);
        engine.add(new Gravity(0, seed % 3 == 0 ? 0 : -5));
        for (int k = 3 + random.nextInt(55); k > 0; k--) {
            add(engine, random);
        }
        Author author = new Author(engine, 1000L * seed);
        if (seed % 4 != 0) {
            engine.addListener(author);
            engine.addContactListener(author);
        }
        for (int k = 0; k < 250; k++) {
            between(engine, random);
            PhysicsEngine twin = k % 25 == 0 ? Checkpoint.copy(engine) : null;
            engine.step();
            if (twin != null) {
                twin.step();
                assertThat(Scenes.hash(twin)).as("the restored one after step %d", k).isEqualTo(Scenes.hash(engine));
            }
            assertThat(Stepped.fastest(engine)).as("step %d", k).isLessThan(300);
            assertThat(author.roll).hasSize(seed % 4 == 0 ? 0 : engine.contacts().size());
        }
    }
}
