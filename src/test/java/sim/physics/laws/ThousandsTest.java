// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.Equations;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * What thousands of bodies, joints and forces cost that have nothing to do with each other grows as their number, and each of
 * them does what it does alone. Counted is what authors' own objects are asked, or what is allocated; else the numbers are such
 * that pairs of them would not be done with before the tests' time is over, or would not fit into memory.
 */
class ThousandsTest {
    private static final int MANY = 3000;

    private static int questions;

    /** Keeps a body on the level of where it is. */
    private static final class Level implements Constraint {
        private static final long serialVersionUID = 1L;

        private final Body body;
        private final Body ground;
        private final double height;

        Level(Body body, Body ground) {
            this.body = body;
            this.ground = ground;
            height = body.getY();
        }

        @Override
        public Body getBodyA() {
            questions++;
            return body;
        }

        @Override
        public Body getBodyB() {
            questions++;
            return ground;
        }

        @Override
        public int getRows() {
            return 1;
        }

        @Override
        public void evaluate(Equations equations) {
            equations.set(0, body.getY() - height, 0);
            equations.setA(0, 0, 1, 0);
        }
    }

    /** Two of these are never the same, but that is to be asked. */
    private static final class Push implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private final Body body;

        Push(Body body) {
            this.body = body;
        }

        @Override
        public void addForce(Body on, double time, Forces forces) {
            forces.add(on, 1, 0);
        }

        @Override
        public List<Body> getBodies() {
            return List.of(body);
        }

        @Override
        public boolean isConcurrent() {
            questions++;
            return true;
        }

        @Override
        public boolean equals(Object other) {
            questions++;
            return this == other;
        }

        @Override
        public int hashCode() {
            return System.identityHashCode(this);
        }
    }

    private static PhysicsEngine engine(int substeps) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 64);
        engine.setTimeStepping(substeps);
        return engine;
    }

    private static Body place(PhysicsEngine engine, int k) {
        return engine.add(new Body(new Rectangle(2, 0.5)).at(8 * (k % 64), 8 * (k / 64)));
    }

    private static void run(PhysicsEngine engine, int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    private static List<Body> drop(int n, PhysicsEngine engine) {
        engine.add(new Gravity(0, -10));
        engine.add(Body.fixed(new Rectangle(8 * n + 8, 2)).at(4 * n, -1)).setFriction(0.25);
        List<Body> balls = new ArrayList<>();
        for (int k = 0; k < n; k++) {
            Body ball = engine.add(new Body(new Circle(0.5)).at(4 * k, 1).moving(0.5, 0, 1));
            ball.setRestitution(0.5);
            ball.setFriction(0.25);
            balls.add(ball);
        }
        return balls;
    }

    @Test
    void ballsThatLandAtOneInstantDoWhatTwoOfThemDo() {
        PhysicsEngine two = engine(0);
        Body first = drop(2, two).get(0);
        PhysicsEngine many = engine(0);
        List<Body> balls = drop(10_000, many); // as one problem, a matrix of 800 MB
        for (int step = 0; step < 40; step++) {
            two.step();
            many.step();
            for (Body ball : balls) {
                assertThat(ball.getY()).isEqualTo(first.getY());
                assertThat(ball.getVelocityX()).isEqualTo(first.getVelocityX());
                assertThat(ball.getVelocityY()).isEqualTo(first.getVelocityY());
                assertThat(ball.getAngularVelocity()).isEqualTo(first.getAngularVelocity());
            }
        }
        assertThat(many.getImpacts()).isEqualTo(5000 * two.getImpacts());
    }

    @Test
    void pendulumsThatAreStruckAtOneInstantDoWhatOneDoesAlone() {
        double[] alone = struck(1);
        double[] many = struck(800);
        for (int k = 0; k < many.length; k++) {
            assertThat(many[k]).isEqualTo(alone[k % alone.length]);
        }
    }

    /** Angles and speeds of arms on hinges that balls strike. */
    private static double[] struck(int n) {
        PhysicsEngine engine = engine(0);
        List<Body> arms = new ArrayList<>();
        for (int k = 0; k < n; k++) {
            Body arm = engine.add(new Body(new Rectangle(2, 0.5)).at(8 * k + 1, 0));
            engine.add(new PinJoint(arm, 8 * k, 0));
            Body ball = engine.add(new Body(new Circle(0.25)).at(8 * k + 1.5, 1).moving(0, -2));
            ball.setRestitution(0.75);
            arms.add(arm);
        }
        run(engine, 64);
        double[] found = new double[2 * n];
        for (int k = 0; k < n; k++) {
            found[2 * k] = arms.get(k).getAngle();
            found[2 * k + 1] = arms.get(k).getAngularVelocity();
        }
        assertThat(found[1]).isNotZero();
        return found;
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void removingTiedBodiesAsksAboutTheirOwnConstraints(int substeps) {
        PhysicsEngine engine = engine(substeps);
        List<Body> bodies = new ArrayList<>();
        for (int k = 0; k < MANY; k++) {
            bodies.add(place(engine, k));
            engine.add(new Level(bodies.get(k), null));
        }
        engine.step();
        questions = 0;
        bodies.forEach(engine::remove);
        engine.step();
        assertThat(questions).isLessThan(100 * MANY);
        assertThat(engine.allConstraints()).isEmpty();
        assertThat(engine.getRedundantEquations()).isZero();
    }

    @Test
    void writingFixedBodiesAsksAboutTheirOwnConstraints() {
        PhysicsEngine engine = engine(0);
        List<Body> grounds = new ArrayList<>();
        for (int k = 0; k < MANY; k++) {
            grounds.add(engine.add(Body.fixed(new Rectangle(1, 1)).at(8 * (k % 64), 8 * (k / 64) + 4)));
            engine.add(new Level(place(engine, k), grounds.get(k)));
        }
        questions = 0;
        engine.step();
        grounds.forEach(ground -> ground.setPosition(ground.getX() + 0.25, ground.getY()));
        engine.step();
        assertThat(questions).isLessThan(500 * MANY);
    }

    @Test
    void removingForcesAsksNoOthers() {
        PhysicsEngine engine = engine(0);
        List<Push> pushes = new ArrayList<>();
        for (int k = 0; k < MANY; k++) {
            pushes.add(engine.add(new Push(place(engine, k))));
        }
        engine.step();
        questions = 0;
        for (int k = MANY - 1; k >= 0; k--) {
            engine.remove(pushes.get(k));
        }
        assertThat(questions).isLessThan(20 * MANY);
        assertThat(engine.allForceGenerators()).isEmpty();
    }

    @Test
    void forcesAreRemovedInAnyOrder() {
        PhysicsEngine engine = engine(0);
        List<ForceGenerator> left = new ArrayList<>();
        for (int k = 0; k < 64; k++) {
            left.add(engine.add(k % 5 == 0 ? new Gravity(k, -1) : new Push(place(engine, k))));
        }
        for (int k = 0; k < 48; k++) {
            engine.remove(left.remove(k * 37 % left.size()));
            assertThat(engine.allForceGenerators()).containsExactlyElementsOf(left);
        }
    }

    @Test
    void aReactionAndAnAssemblyCostWhatTheirIslandDoes() {
        PhysicsEngine engine = engine(0);
        engine.add(new Gravity(0, -10));
        List<PinJoint> pins = new ArrayList<>();
        for (int k = 0; k < MANY; k++) {
            Body body = place(engine, k);
            pins.add(PinJoint.bodyPoints(body, -1, 0, null, body.getX() - 1.125, body.getY()));
        }
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = threads.getCurrentThreadAllocatedBytes();
        pins.forEach(engine::assemble);
        long assembled = threads.getCurrentThreadAllocatedBytes();
        assertThat((assembled - before) / MANY).as("bytes to close a joint").isLessThan(40_000);
        engine.step();
        long stepped = threads.getCurrentThreadAllocatedBytes();
        for (PinJoint pin : pins) {
            assertThat(engine.getReaction(pin).forceY()).isPositive();
        }
        long asked = threads.getCurrentThreadAllocatedBytes();
        assertThat((asked - stepped) / MANY).as("bytes to ask a joint").isLessThan(4000);
    }

    @Test
    void excludedPairsAreFoundAmongManyOthers() {
        int n = 200_000;
        PhysicsEngine engine = engine(0);
        List<Body> bodies = new ArrayList<>();
        for (int k = 0; k < n; k++) {
            bodies.add(engine.add(new Body(new Circle(0.5)).at(3 * (k % 512), 3 * (k / 512))));
        }
        for (int k = 0; k + 1 < n; k++) {
            engine.setCollisions(bodies.get(k), bodies.get(k + 1), false);
            engine.setCollisions(bodies.get(0), bodies.get(k + 1), false);
        }
        Body one = bodies.get(n / 2);
        Body next = bodies.get(n / 2 + 1);
        one.setVelocity(2, 0);
        engine.step();
        run(engine, 127);
        assertThat(engine.getImpacts()).isZero();           // two to the right, through one half of the next one
        engine.setCollisions(next, one, true);
        one.setPosition(next.getX() - 1.5, next.getY());
        run(engine, 64);
        assertThat(engine.getImpacts()).isEqualTo(1);
        assertThat(next.getVelocityX()).isCloseTo(2, within(1e-12));
        bodies.forEach(engine::remove);
        assertThat(engine.bodies()).isEmpty();
    }

    /** Counts what it is told; at the first collision it lets another one listen and listens no more. */
    private static final class Relay implements CollisionListener {
        private static final long serialVersionUID = 1L;

        private final PhysicsEngine engine;
        private final Relay next;
        private int told;

        Relay(PhysicsEngine engine, Relay next) {
            this.engine = engine;
            this.next = next;
        }

        @Override
        public void collided(Contact contact) {
            told++;
            if (next != null) {
                engine.removeListener(this);
                engine.addListener(next);
            }
        }
    }

    @Test
    void listenersAreAddedAndRemovedByThemselvesAndWhileTheyAreTold() {
        PhysicsEngine engine = engine(0);
        for (int wall = 0; wall < 2; wall++) {
            engine.add(Body.fixed(new Rectangle(1, 4)).at(4 * wall, 0));
        }
        engine.add(new Body(new Circle(0.5)).at(2, 0).moving(8, 0));
        List<Relay> some = new ArrayList<>();
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = threads.getCurrentThreadAllocatedBytes();
        for (int k = 0; k < MANY; k++) {
            some.add(new Relay(engine, null));
            engine.addListener(some.get(k));
        }
        assertThat((threads.getCurrentThreadAllocatedBytes() - before) / MANY).as("bytes a listener").isLessThan(1000);
        Relay second = new Relay(engine, null);
        Relay first = new Relay(engine, second);
        engine.addListener(first);
        run(engine, 64);
        assertThat(engine.getImpacts()).isEqualTo(4);
        assertThat(first.told).isEqualTo(1);
        assertThat(second.told).isEqualTo(3);
        assertThat(some).allMatch(one -> one.told == 4);
        some.forEach(engine::removeListener);
        run(engine, 64);
        assertThat(some).allMatch(one -> one.told == 4);
        assertThat(second.told).isEqualTo(7);
    }

    /** Removes all bodies at the first collision. */
    private static final class Sweeper implements CollisionListener {
        private static final long serialVersionUID = 1L;

        private final PhysicsEngine engine;
        private final List<Body> bodies;

        Sweeper(PhysicsEngine engine, List<Body> bodies) {
            this.engine = engine;
            this.bodies = bodies;
        }

        @Override
        public Decision colliding(Contact contact) {
            return Decision.BOUNCE;
        }

        @Override
        public void collided(Contact contact) {
            bodies.forEach(engine::remove);
            bodies.forEach(engine::remove); // twice is as well
        }
    }

    @Test
    void aListenerRemovesAllBodiesInAStep() {
        PhysicsEngine engine = engine(0);
        List<Body> bodies = new ArrayList<>();
        for (int k = 0; k < MANY; k++) {
            bodies.add(place(engine, k));
            engine.add(new Level(bodies.get(k), null));
        }
        Body striker = engine.add(new Body(new Circle(0.25)).at(-2, 0).moving(4, 0));
        engine.addListener(new Sweeper(engine, bodies));
        questions = 0;
        run(engine, 32);
        assertThat(engine.bodies()).containsExactly(striker);
        assertThat(engine.allConstraints()).isEmpty();
        assertThat(questions).isLessThan(1000 * MANY);
    }
}
