// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.Equations;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.Stabilization;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.response.LastingContact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** What groups of thousands of bodies cost that do have to do with each other: towers, chains, nets and hubs. */
class LargeGroupsTest {
    private static final double G = 10;

    /** Room for calls, in bytes: some hundreds of them. */
    private static final int SMALL_STACK = 1 << 18;

    private static int questions;

    /** Weight, which counts how often it is asked for. */
    private static final class Weight implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            questions++;
            forces.add(body, 0, -G * body.getMass());
        }

        @Override
        public boolean isAutonomous() {
            return true;
        }
    }

    /** Keeps a body at the height of another one; counts who asks whose it is, and whether it is another one. */
    private static final class Level implements Constraint {
        private static final long serialVersionUID = 1L;

        private final Body body;
        private final Body hub;
        private final double height;

        Level(Body body, Body hub) {
            this.body = body;
            this.hub = hub;
            height = body.getY() - hub.getY();
        }

        @Override
        public Body getBodyA() {
            questions++;
            return body;
        }

        @Override
        public Body getBodyB() {
            questions++;
            return hub;
        }

        @Override
        public int getRows() {
            return 1;
        }

        @Override
        public void evaluate(Equations equations) {
            equations.set(0, body.getY() - hub.getY() - height, 0);
            equations.setA(0, 0, 1, 0);
            equations.setB(0, 0, -1, 0);
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

    private static long allocated() {
        return ((ThreadMXBean) ManagementFactory.getThreadMXBean()).getCurrentThreadAllocatedBytes();
    }

    private static PhysicsEngine engine(int substeps) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 64);
        engine.setTimeStepping(substeps);
        return engine;
    }

    /** Runs something where calls cannot be nested deep. */
    private static void withSmallStack(Runnable what) {
        AtomicReference<Throwable> thrown = new AtomicReference<>();
        Thread thread = new Thread(null, what, "small stack", SMALL_STACK);
        thread.setUncaughtExceptionHandler((t, e) -> thrown.set(e));
        thread.start();
        try {
            thread.join();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
        assertThat(thrown.get()).isNull();
    }

    @Test
    void aTowerOfAThousandBoxesStandsOnItsGround() {
        int n = 1000;
        PhysicsEngine engine = engine(0);
        engine.add(new Gravity(0, -G));
        Body ground = engine.add(Body.fixed(new Rectangle(16, 2)).at(0, -1));
        List<Body> tower = new ArrayList<>();
        for (int k = 0; k < n; k++) {
            tower.add(engine.add(new Body(new Rectangle(1, 1)).at(0, k + 0.5)));
        }
        engine.bodies().forEach(body -> body.setRestitution(0));
        withSmallStack(() -> {
            engine.step();
            engine.step();
        });
        List<LastingContact> below = engine.contacts(ground);
        assertThat(below).hasSize(1);
        assertThat(below.get(0).normalForce()).isCloseTo(n * G, within(1e-6 * n * G));
        for (int k = 0; k < n; k++) {
            assertThat(tower.get(k).getY()).isCloseTo(k + 0.5, within(1e-7));
            assertThat(tower.get(k).getVelocityY()).isCloseTo(0, within(1e-6));
        }
    }

    /** A chain that hangs down from the origin; its links have mass 1. */
    private static List<PinJoint> chain(PhysicsEngine engine, int links) {
        List<PinJoint> pins = new ArrayList<>();
        Body last = null;
        for (int k = 0; k < links; k++) {
            Body link = engine.add(new Body(new Rectangle(0.25, 1)).at(0, -k - 0.5));
            link.setMass(1);
            pins.add(engine.add(last == null ? new PinJoint(link, 0, 0) : new PinJoint(last, link, 0, -k)));
            last = link;
        }
        return pins;
    }

    @Test
    void theForcesOfAllJointsOfAChainAreFoundAtOnce() {
        int n = 2000;
        PhysicsEngine engine = engine(0);
        engine.add(new Weight());
        List<PinJoint> pins = chain(engine, n);
        engine.step();
        questions = 0;
        for (int k = 0; k < n; k++) {
            double below = (n - k) * G;
            assertThat(Math.abs(engine.getReaction(pins.get(k)).forceY())).isCloseTo(below, within(1e-9 * n * G));
        }
        assertThat(questions).isLessThan(10 * n);
    }

    @Test
    void whatIsWrittenBetweenQuestionsIsInTheAnswers() {
        PhysicsEngine engine = engine(0);
        engine.add(new Weight());
        List<PinJoint> pins = chain(engine, 3);
        PinJoint top = pins.get(0);
        Body tip = pins.get(2).getBodyB();
        assertThat(pull(engine, top)).isCloseTo(3 * G, within(1e-10));
        tip.addForce(0, -7);
        assertThat(pull(engine, top)).isCloseTo(3 * G + 7, within(1e-10));
        tip.addForce(0, 7);
        tip.setMass(2);
        assertThat(pull(engine, top)).isCloseTo(4 * G, within(1e-10));
        Gravity more = engine.add(new Gravity(0, -1));
        assertThat(pull(engine, top)).isCloseTo(4 * G + 4, within(1e-10));
        engine.remove(more);
        top.getBodyA().setAngularVelocity(1);
        top.getBodyA().setVelocity(0.5, 0);
        tip.setVelocity(1, 0);
        pins.get(1).getBodyB().setVelocity(1, 0);
        assertThat(pull(engine, top)).as("a turn about the top").isCloseTo(4 * G + 0.5 + 1 + 2, within(1e-9));
        engine.setStabilization(Stabilization.feedback(0, 0));
        assertThat(pull(engine, top)).isCloseTo(4 * G + 0.5 + 1 + 2, within(1e-9));
        engine.remove(pins.get(2));
        engine.bodies().forEach(body -> body.setVelocity(0, 0));
        engine.bodies().forEach(body -> body.setAngularVelocity(0));
        assertThat(pull(engine, top)).isCloseTo(2 * G, within(1e-10));
    }

    private static double pull(PhysicsEngine engine, PinJoint pin) {
        double first = engine.getReaction(pin).forceY();
        assertThat(engine.getReaction(pin).forceY()).isEqualTo(first);
        return Math.abs(first);
    }

    @Test
    void timeSteppingKnowsEachConstraintAndEachContactByItself() {
        int n = 2000;
        PhysicsEngine engine = engine(4);
        engine.add(new Gravity(0, -G));
        engine.setSleepAllowed(false);
        Body ground = engine.add(Body.fixed(new Rectangle(4 * n, 2)).at(2 * n, -1));
        List<Level> levels = new ArrayList<>();
        List<Body> boxes = new ArrayList<>();
        for (int k = 0; k < n; k++) {
            Body box = engine.add(new Body(new Rectangle(1, 1)).at(4 * k, 0.5));
            boxes.add(box);
            levels.add(engine.add(new Level(engine.add(new Body(new Circle(0.25)).at(4 * k + 2, 5)), box)));
        }
        engine.bodies().forEach(body -> body.setRestitution(0));
        for (int k = 0; k < 20; k++) {
            engine.step();
        }
        questions = 0;
        double sum = 0;
        for (Level level : levels) {
            sum += engine.getReaction(level).forceY();
        }
        assertThat(questions).isLessThan(20 * n);
        double weight = G * levels.get(0).body.getMass();
        assertThat(sum).isCloseTo(n * weight, within(0.01 * n * weight));
        List<LastingContact> all = engine.contacts();
        assertThat(all).hasSize(n);
        assertThat(engine.contacts(ground)).isEqualTo(all);
        for (int k = 0; k < n; k++) {
            Body box = boxes.get(k);
            assertThat(engine.contacts(box)).hasSize(1);
            assertThat(engine.contacts(box).get(0).normalForce()).isCloseTo(weight + G, within(0.01 * G));
        }
    }

    @Test
    void spokesOfAHubAreKnownByThemselves() {
        int n = 1000;
        PhysicsEngine engine = engine(4);
        Body hub = engine.add(new Body(new Rectangle(2 * n, 1)).at(n, 0));
        for (int k = 0; k < n; k++) {
            engine.add(new Level(engine.add(new Body(new Circle(0.25)).at(2 * k + 1, 0.9)), hub));
        }
        questions = 0;
        engine.step();
        assertThat(questions).isLessThan(200 * n);
    }

    @Test
    void aHubOfAThousandWheelsTakesRoomAsTheirNumberAndKeepsItsMomentum() {
        int n = 1000;
        PhysicsEngine engine = engine(4);
        Body hub = engine.add(new Body(new Circle(10)));
        hub.setMass(n);
        List<Body> wheels = new ArrayList<>();
        List<PinJoint> pins = new ArrayList<>();
        for (int k = 0; k < n; k++) {
            Body wheel = engine.add(new Body(new Circle(0.25)).at(0.25 * (k % 32) - 4, 0.25 * (k / 32) - 4));
            wheel.setMass(1);
            wheel.setCollisionGroup(1, 0);
            wheels.add(wheel);
            pins.add(engine.add(new PinJoint(hub, wheel, wheel.getX(), wheel.getY())));
        }
        hub.setVelocity(2, 0);
        long before = allocated();
        engine.step();
        assertThat((allocated() - before) / n).as("bytes a wheel").isLessThan(20_000);
        for (int k = 0; k < 128; k++) {
            engine.step();
        }
        double sum = hub.getMass() * hub.getVelocityX();
        for (Body wheel : wheels) {
            sum += wheel.getMass() * wheel.getVelocityX();
        }
        assertThat(sum).isCloseTo(2 * n, within(1e-9 * n));
        assertThat(hub.getVelocityX()).isCloseTo(1, within(0.01));
        for (int k = 0; k < n; k++) {
            PinJoint pin = pins.get(k);
            double x = hub.worldX(pin.getAnchorAX(), pin.getAnchorAY());
            double y = hub.worldY(pin.getAnchorAX(), pin.getAnchorAY());
            assertThat(wheels.get(k).getX()).isCloseTo(x, within(1e-2));
            assertThat(wheels.get(k).getY()).isCloseTo(y, within(1e-2));
        }
    }

    @Test
    void aRingThatTurnsOnFiveHundredRodsPullsAtItsHub() {
        int n = 500;
        double r = 20;
        PhysicsEngine engine = engine(0);
        Body hub = engine.add(new Body(new Circle(1)));
        List<RodJoint> rods = new ArrayList<>();
        for (int k = 0; k < n; k++) {
            double c = StrictMath.cos(2 * Math.PI * k / n);
            double s = StrictMath.sin(2 * Math.PI * k / n);
            Body weight = engine.add(new Body(new Circle(0.1)).at(r * c, r * s).moving(-r * s, r * c));
            weight.setMass(2);
            rods.add(engine.add(RodJoint.worldPoints(hub, c, s, weight, r * c, r * s)));
        }
        hub.setAngularVelocity(1);
        long before = allocated();
        for (RodJoint rod : rods) {
            assertThat(engine.getReaction(rod).force()).isCloseTo(2 * r, within(1e-7 * r));
        }
        assertThat((allocated() - before) / n).as("bytes a rod: the matrix is dense").isLessThan(80_000);
    }

    @Test
    void aNetTakesRoomAsTheNumberOfItsRods() {
        int side = 40;
        PhysicsEngine engine = engine(0);
        Body[] knots = new Body[side * side];
        int rods = 0;
        for (int k = 0; k < knots.length; k++) {
            knots[k] = engine.add(new Body(new Circle(0.2)).at(k % side, k / side));
            if (k % side > 0) {
                engine.add(RodJoint.bodyPoints(knots[k - 1], 0, 0, knots[k], 0, 0));
                rods++;
            }
            if (k >= side) {
                engine.add(RodJoint.bodyPoints(knots[k - side], 0, 0, knots[k], 0, 0));
                rods++;
            }
        }
        long before = allocated();
        engine.step();
        assertThat((allocated() - before) / rods).as("bytes a rod").isLessThan(20_000);
        assertThat(engine.kineticEnergy()).isZero();
    }
}
