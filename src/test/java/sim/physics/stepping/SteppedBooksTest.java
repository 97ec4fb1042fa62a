// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.GearJoint;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.Reaction;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.response.LastingContact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Time stepping: what contacts, listeners and joints say of forces and impulses is what changes the momentum of each body. */
class SteppedBooksTest {
    private static final double STEP = 1.0 / 60;

    private static final class Ears implements CollisionListener {
        private static final long serialVersionUID = 1L;
        final List<Contact> heard = new ArrayList<>();

        @Override
        public void collided(Contact contact) {
            heard.add(contact);
        }
    }

    private final PhysicsEngine engine = new PhysicsEngine();
    private final Ears ears = new Ears();
    private final List<Body> bodies = new ArrayList<>();
    private final List<Constraint> ties = new ArrayList<>();

    /** By body: the impulses that were told of, and the sum of their sizes. */
    private final Map<Body, double[]> told = new IdentityHashMap<>();

    private static double some(SplittableRandom random, double most) {
        return most * (2 * random.nextDouble() - 1);
    }

    /** Rectangles in a room, smooth: friction that nothing presses any more is not told of. */
    private void scene(SplittableRandom random, double restitution) {
        room(random, restitution);
        boxes(random, restitution);
    }

    private void room(SplittableRandom random, double restitution) {
        engine.setTimeStep(STEP);
        engine.setTimeStepping(1 + random.nextInt(5));
        engine.setSleepAllowed(false);
        engine.add(new Gravity(0, -Stepped.G));
        for (int side = 0; side < 4; side++) {
            double x = side == 0 ? -9 : side == 1 ? 9 : 0;
            double y = side == 2 ? -9 : side == 3 ? 9 : 0;
            engine.add(Body.fixed(side < 2 ? new Rectangle(2, 20) : new Rectangle(20, 2)).at(x, y)).setRestitution(restitution);
        }
    }

    private void boxes(SplittableRandom random, double restitution) {
        for (int k = 0; k < 12; k++) {
            Body body = new Body(new Rectangle(0.3 + random.nextDouble(), 0.3 + random.nextDouble()));
            body.at(4 * (k % 4) - 6 + some(random, 1), 4 * (k / 4) - 4 + some(random, 1), some(random, 3));
            body.moving(some(random, 4), some(random, 4), some(random, 2));
            body.setMass(random.nextInt(5) == 0 ? 20 * random.nextDouble() : 1);
            body.setRestitution(restitution);
            bodies.add(engine.add(body));
        }
    }

    /** Discs of masses to 1 : 100 that slide around one another in the room, plastic, and smooth for the reason above. */
    private void discs(SplittableRandom random) {
        for (int k = 0; k < 30; k++) {
            Body disc = new Body(new Circle(0.2 + 0.5 * random.nextDouble()));
            disc.at(2.6 * (k % 6) - 6.5 + some(random, 0.4), 2.6 * (k / 6) - 5 + some(random, 0.4));
            disc.moving(some(random, 5), some(random, 5), some(random, 20));
            disc.setMass(StrictMath.pow(100, random.nextDouble()));
            bodies.add(engine.add(disc));
        }
        for (Body body : engine.bodies()) {
            body.setRestitution(0);
        }
    }

    /** Normals of discs turn within a step: the force that is told of is all that acted, along whichever of them it did. */
    @ParameterizedTest
    @ValueSource(ints = {0, 10})
    void whatIsToldOfDiscsIsWhatChangesMomentum(int first) {
        for (int seed = first; seed < first + 10; seed++) {
            SteppedBooksTest test = new SteppedBooksTest();
            SplittableRandom random = new SplittableRandom(seed);
            test.room(random, 0);
            test.discs(random);
            test.keepBooks(seed);
        }
    }

    private void tie(SplittableRandom random, Body a, Body b, double restitution) {
        double x = 0.5 * (a.getX() + b.getX());
        double y = 0.5 * (a.getY() + b.getY());
        SliderJoint rail = new SliderJoint(a, b, x, y, 1, some(random, 2));
        List<Constraint> those = switch (random.nextInt(7)) {
            case 0 -> List.of(new PinJoint(a, b, x, y), Motor.turning(a, b, some(random, 5), 20));
            case 1 -> List.of(new PinJoint(a, x, y), new PinJoint(b, x, y), new GearJoint(a, b, 2));
            case 2 -> List.of(new WeldJoint(a, b, x, y));
            case 3 -> List.of(new RodJoint(a, 0, 0, b, 0, 0, StrictMath.hypot(a.getX() - b.getX(), a.getY() - b.getY())));
            case 4 -> List.of(rail, Limit.travel(rail, -0.3, 0.2, restitution));
            case 5 -> List.of(rail, Motor.sliding(rail, some(random, 3), 10), Limit.travel(rail, -0.1, 2, restitution));
            default -> List.of(Limit.rope(a, 0, 0, b, 0, 0, 4.5));
        };
        for (Constraint tie : those) {
            ties.add(engine.add(tie));
        }
    }

    private void tell(Body body, double x, double y, double size) {
        double[] sum = told.get(body);
        if (sum != null) {
            sum[0] += x;
            sum[1] += y;
            sum[2] += size;
        }
    }

    /** Gathers what is said of the last step. */
    private void gather() {
        for (Body body : bodies) {
            double weight = body.getMass() * Stepped.G * STEP;
            told.put(body, new double[] {0, -weight, weight});
        }
        Set<List<Body>> lasting = new HashSet<>();
        for (LastingContact c : engine.contacts()) {
            lasting.add(List.of(c.a(), c.b()));
            tell(c.a(), STEP * c.forceX(c.a()), STEP * c.forceY(c.a()), STEP * c.normalForce());
            tell(c.b(), STEP * c.forceX(c.b()), STEP * c.forceY(c.b()), STEP * c.normalForce());
        }
        for (Contact c : ears.heard) {
            if (!lasting.contains(List.of(c.a(), c.b()))) {
                tell(c.a(), -c.impulse() * c.normalX(), -c.impulse() * c.normalY(), c.impulse());
                tell(c.b(), c.impulse() * c.normalX(), c.impulse() * c.normalY(), c.impulse());
            }
        }
        for (Constraint tie : ties) {
            Reaction force = engine.getReaction(tie);
            tell(tie.getBodyA(), STEP * force.forceX(), STEP * force.forceY(), STEP * force.force());
            if (tie.getBodyB() != null) {
                tell(tie.getBodyB(), -STEP * force.forceX(), -STEP * force.forceY(), STEP * force.force());
            }
        }
    }

    /** Jams, whose substeps are made again, bounces that are bounded, and such of bodies that lay: no more and no less is told of than acts. */
    @ParameterizedTest
    @CsvSource({"0, 0", "0, 20", "0, 30", "0, 40", "0.5, 40", "1, 60", "1, 80", "0, 90", "0, 110"}) // structures whose joints are closed while something presses on them, too
    void whatIsToldOfIsWhatChangesMomentum(double restitution, int first) {
        for (int seed = first; seed < first + 10; seed++) {
            new SteppedBooksTest().keepBooks(seed, restitution);
        }
    }

    private void keepBooks(int seed, double restitution) {
        SplittableRandom random = new SplittableRandom(seed);
        scene(random, restitution);
        for (int k = 0; k < 6; k++) {
            int a = random.nextInt(bodies.size());
            int b = (a + 1 + random.nextInt(bodies.size() - 1)) % bodies.size();
            tie(random, bodies.get(a), bodies.get(b), restitution);
        }
        keepBooks(seed);
    }

    private void keepBooks(int seed) {
        engine.addListener(ears);
        engine.step(); // velocities that joints do not allow have changed before it
        gather();
        for (int step = 1; step < 120; step++) {
            double[][] old = bodies.stream().map(b -> new double[] {b.getVelocityX(), b.getVelocityY()}).toArray(double[][]::new);
            ears.heard.clear();
            engine.step();
            gather();
            for (int k = 0; k < bodies.size(); k++) {
                Body body = bodies.get(k);
                double m = body.getMass();
                double[] sum = told.get(body);
                double off = Math.hypot(m * (body.getVelocityX() - old[k][0]) - sum[0], m * (body.getVelocityY() - old[k][1]) - sum[1]);
                double rounding = 1e-11 * (sum[2] + m * Math.hypot(old[k][0], old[k][1]));
                assertThat(off).as("seed %d, step %d, body %d", seed, step, k).isLessThan(rounding);
            }
        }
    }
}
