// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Comparator;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.collision.Overlap;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.motion.Spring;
import sim.physics.motion.SurfaceFriction;
import sim.physics.response.LastingContact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Sleep under time stepping: what has come to rest stays to the bit and costs nothing, and is all that it was. */
class SleepTest {
    private static final double G = Stepped.G;

    @ParameterizedTest
    @ValueSource(strings = {"stack", "pyramid", "heap", "ragdoll", "bridge"})
    void whatHasComeToRestFallsAsleepAndStaysToTheBit(String name) {
        PhysicsEngine engine = SleepScenes.scene(name);
        assertThat(SleepScenes.fallAsleep(engine)).isTrue();
        double[] places = SleepScenes.places(engine);
        long looks = engine.getNarrowPhaseEvaluations();
        List<LastingContact> contacts = engine.contacts();
        for (int k = 0; k < 200; k++) {
            engine.step();
            assertThat(engine.kineticEnergy()).isZero();
            assertThat(SleepScenes.places(engine)).isEqualTo(places);
            assertThat(engine.contacts()).hasSameSizeAs(contacts);
        }
        assertThat(engine.getNarrowPhaseEvaluations()).as("looks at pairs").isEqualTo(looks);
        for (int k = 0; k < contacts.size(); k++) {
            assertThat(engine.contacts().get(k)).isEqualTo(contacts.get(k));
        }
        assertThat(Stepped.depth(engine)).isLessThan(0.02);
    }

    /** Falling asleep takes away velocities, and moves nothing. */
    @ParameterizedTest
    @ValueSource(strings = {"stack", "pyramid", "heap", "ragdoll"})
    void nothingMovesAndNoEnergyIsGainedWhereBodiesFallAsleep(String name) {
        PhysicsEngine engine = SleepScenes.scene(name);
        List<Body> bodies = SleepScenes.movable(engine);
        int fell = 0;
        for (int k = 0; k < 1200 || k < 5400 && fell < bodies.size(); k++) { // a ragdoll may rock on its head for a minute
            double[] before = SleepScenes.places(engine);
            double energy = SleepScenes.energy(engine);
            boolean[] slept = new boolean[bodies.size()];
            for (int m = 0; m < slept.length; m++) {
                slept[m] = engine.isAsleep(bodies.get(m));
            }
            engine.step();
            double[] after = SleepScenes.places(engine);
            for (int m = 0; m < slept.length; m++) {
                Body body = bodies.get(m);
                if (!engine.isAsleep(body)) {
                    continue;
                }
                fell += slept[m] ? 0 : 1;
                for (int r = 3 * body.index(); r < 3 * body.index() + 3; r++) {
                    assertThat(after[r]).isEqualTo(before[r]);
                }
            }
            if (SleepScenes.allSleep(engine)) {
                assertThat(SleepScenes.energy(engine)).isLessThanOrEqualTo(energy);
            }
        }
        assertThat(fell).isGreaterThanOrEqualTo(bodies.size());
    }

    @ParameterizedTest
    @ValueSource(strings = {"stack", "pyramid", "heap", "ragdoll"})
    void contactsBearTheWeightOfWhatSleeps(String name) {
        PhysicsEngine engine = SleepScenes.scene(name);
        assertThat(SleepScenes.fallAsleep(engine)).isTrue();
        Stepped.run(engine, 10);
        double weight = 0;
        double borne = 0;
        for (Body body : engine.bodies()) {
            weight += body.isFixed() ? 0 : G * body.getMass();
            for (LastingContact contact : engine.contacts(body)) {
                borne -= body.isFixed() ? contact.forceY(body) : 0;
            }
        }
        assertThat(borne).isCloseTo(weight, within(1e-2 * weight));
        for (Body body : SleepScenes.movable(engine)) {
            double up = 0;
            for (LastingContact contact : engine.contacts(body)) {
                up += contact.forceY(body);
            }
            if (!name.equals("ragdoll")) { // whose joints bear some
                assertThat(up).isCloseTo(G * body.getMass(), within(1e-2 * G * body.getMass() + 1e-2));
            }
        }
    }

    @Test
    void jointsTellWhatTheyBearWhileTheySleep() {
        PhysicsEngine engine = Stepped.engine(SleepScenes.STEP, 4);
        engine.add(new Gravity(0, -G));
        Body bob = engine.add(new Body(new Circle(0.5)).at(0, -2));
        bob.setMass(3);
        PinJoint pin = engine.add(new PinJoint(bob, 0, 0));
        Body load = engine.add(new Body(new Circle(0.5)).at(5, -2));
        load.setMass(2);
        RodJoint rod = engine.add(new RodJoint(load, 5, -2, null, 5, 0));
        assertThat(SleepScenes.fallAsleep(engine)).isTrue();
        Body other = engine.add(new Body(new Rectangle(1, 1)).at(20, 0).moving(1, 1, 1));
        PinJoint running = engine.add(new PinJoint(other, 19.5, 0.5));
        for (int k = 0; k < 10; k++) {
            engine.step();
            assertThat(engine.isAsleep(bob)).isTrue();
            assertThat(engine.getReaction(pin).forceY()).isCloseTo(3 * G, within(1e-9));
            assertThat(engine.getReaction(rod).forceY()).isCloseTo(2 * G, within(1e-9));
            assertThat(engine.getReaction(running).force()).isGreaterThan(0.1);
        }
        engine.setTimeStep(SleepScenes.STEP / 2);
        engine.step();
        assertThat(engine.isAsleep(bob)).isFalse();
        assertThat(engine.getReaction(pin).forceY()).isCloseTo(3 * G, within(1e-9));
    }

    /** Impulses are kept while bodies sleep: who wakes stays where it is, and bears what it bore from the first step on. */
    @ParameterizedTest
    @ValueSource(strings = {"pyramid", "heap", "ragdoll", "bridge"})
    void wakingDisturbsNothing(String name) {
        PhysicsEngine engine = SleepScenes.scene(name);
        assertThat(SleepScenes.fallAsleep(engine)).isTrue();
        for (int turn = 0; turn < 20; turn++) {
            double[] before = SleepScenes.places(engine);
            double[] forces = forces(engine);
            for (Body body : SleepScenes.movable(engine)) {
                body.addForce(0, 0);
            }
            engine.step();
            assertThat(SleepScenes.movable(engine)).noneMatch(engine::isAsleep);
            assertThat(Stepped.fastest(engine)).isLessThan(0.01);
            double[] after = forces(engine);
            assertThat(after).hasSameSizeAs(forces);
            for (int k = 0; k < forces.length; k++) {
                assertThat(after[k]).isCloseTo(forces[k], within(0.02 * G));
            }
            assertThat(SleepScenes.fallAsleep(engine)).isTrue();
            for (int k = 0; k < before.length; k++) {
                assertThat(SleepScenes.places(engine)[k]).isCloseTo(before[k], within(turn == 0 ? 5e-3 : 1e-3));
            }
        }
    }

    /** Of all contacts, by the bodies, and of all joints. */
    private static double[] forces(PhysicsEngine engine) {
        return DoubleStream.concat(
                        engine.contacts().stream()
                                .sorted(Comparator.comparing((LastingContact c) -> c.a().index()).thenComparing(c -> c.b().index()))
                                .mapToDouble(LastingContact::normalForce),
                        engine.allConstraints().stream().mapToDouble(joint -> engine.getReaction(joint).force()))
                .toArray();
    }

    /** A ball meets a pile that sleeps as it meets one that stands awake. */
    @Test
    void aBallMeetsASleepingPileAsOneThatStands() {
        assertThat(differenceAfterABall(SleepScenes.scene("pyramid"), -2, 0)).isLessThan(2e-3);
    }

    /** A heap that is awake creeps by 10⁻⁵, and in some a body goes another way after that. */
    @Test
    void aBallMeetsASleepingHeapAsOneThatStands() {
        double[] far = IntStream.rangeClosed(1, 20)
                .mapToObj(SleepScenes::heap)
                .filter(SleepScenes::fallAsleep)
                .limit(11)
                .mapToDouble(heap -> differenceAfterABall(heap, -1, 1))
                .sorted()
                .toArray();
        assertThat(far).hasSize(11);
        assertThat(far[5]).isLessThan(1e-3);
        assertThat(far[8]).isLessThan(5e-3);
        assertThat(far[10]).isLessThan(0.5);
    }

    /** How far places in a pile that slept are from those in one that was awake, a second after a ball was thrown at them. */
    private static double differenceAfterABall(PhysicsEngine asleep, double x, double above) {
        assertThat(SleepScenes.fallAsleep(asleep)).isTrue();
        PhysicsEngine awake = Checkpoint.copy(asleep);
        awake.setSleepAllowed(false);
        Stepped.run(awake, 60);
        Stepped.run(asleep, 60);
        assertThat(SleepScenes.allSleep(asleep)).isTrue();
        for (PhysicsEngine engine : List.of(asleep, awake)) {
            double top = engine.bodies().stream().filter(body -> !body.isFixed()).mapToDouble(Body::getY).max().orElseThrow();
            Stepped.rough(engine.add(new Body(new Circle(0.5)).at(x, top + above).moving(4, -2)));
        }
        double met = 0;
        for (int k = 0; k < 60; k++) {
            asleep.step();
            awake.step();
            met = Math.max(met, 1 - asleep.bodies().get(asleep.bodies().size() - 1).getVelocityX() / 4);
        }
        assertThat(met).as("the ball has met something").isGreaterThan(0.1);
        double most = 0;
        for (int k = 0; k < awake.bodies().size(); k++) {
            most = Math.max(most, Math.abs(asleep.bodies().get(k).getX() - awake.bodies().get(k).getX()));
            most = Math.max(most, Math.abs(asleep.bodies().get(k).getY() - awake.bodies().get(k).getY()));
        }
        return most;
    }

    @ParameterizedTest
    @ValueSource(strings = {"stack", "heap", "ragdoll"})
    void aRestoredEngineSleepsAndWakesToTheLastBit(String name) {
        PhysicsEngine engine = SleepScenes.scene(name);
        for (int k = 0; k < 6; k++) {
            Stepped.run(engine, 101);
            if (k == 3) {
                assertThat(SleepScenes.fallAsleep(engine)).isTrue();
            }
            if (k == 4) {
                SleepScenes.movable(engine).get(3).setVelocity(0.5, 3);
            }
            PhysicsEngine restored = Checkpoint.copy(engine);
            PhysicsEngine further = Checkpoint.copy(engine);
            Stepped.run(engine, 60);
            for (int m = 0; m < 60; m++) {
                restored.step();
                further.step();
                assertThat(Scenes.hash(restored)).isEqualTo(Scenes.hash(further));
            }
            assertThat(Scenes.hash(restored)).isEqualTo(Scenes.hash(engine));
            assertThat(restored.contacts()).hasSameSizeAs(engine.contacts());
            for (Body body : engine.bodies()) {
                assertThat(restored.isAsleep(restored.bodies().get(body.index()))).isEqualTo(engine.isAsleep(body));
            }
        }
    }

    /** Units that differ by powers of two change neither who sleeps nor any bit. */
    @ParameterizedTest
    @ValueSource(doubles = {1024, 0.0009765625})
    void unitsDoNotMatter(double length) {
        for (double time : new double[] {1, 0.25}) {
            PhysicsEngine one = pile(1, 1);
            PhysicsEngine other = pile(length, time);
            int asleep = 0;
            for (int k = 0; k < 600; k++) {
                one.step();
                other.step();
                for (int m = 0; m < one.bodies().size(); m++) {
                    asleep += one.isAsleep(one.bodies().get(m)) ? 1 : 0;
                    assertThat(other.isAsleep(other.bodies().get(m))).isEqualTo(one.isAsleep(one.bodies().get(m)));
                    assertThat(other.bodies().get(m).getX()).isEqualTo(length * one.bodies().get(m).getX());
                    assertThat(other.bodies().get(m).getAngle()).isEqualTo(one.bodies().get(m).getAngle());
                }
            }
            assertThat(asleep).isGreaterThan(1000);
        }
    }

    private static PhysicsEngine pile(double length, double time) {
        PhysicsEngine engine = Stepped.engine(time / 64, 4);
        engine.add(new Gravity(0, -8 * length / time / time));
        engine.add(Body.fixed(new Rectangle(64 * length, 2 * length)).at(0, -length)).setFriction(0.5);
        for (int k = 0; k < 12; k++) {
            Stepped.rough(engine.add(new Body(new Rectangle(length, 0.75 * length)).at((k % 4) * 1.25 * length, (0.5 + k / 4) * length)));
        }
        return engine;
    }

    /** Whatever is asked of a sleeper's forces is counted: nobody asks. */
    @Test
    void forcesOfSleepersAreNotAskedFor() {
        PhysicsEngine engine = Stepped.engine(SleepScenes.STEP, 4);
        Pull pull = new Pull();
        engine.add(pull);
        Stepped.ground(engine);
        Body box = Stepped.rough(engine.add(new Body(new Rectangle(1, 1)).at(0, 0.5)));
        assertThat(SleepScenes.fallAsleep(engine)).isTrue();
        long before = pull.calls;
        Stepped.run(engine, 50);
        assertThat(pull.calls).isEqualTo(before);
        assertThat(engine.contacts(box).get(0).forceY(box)).isCloseTo(G * box.getMass(), within(1e-3));
        box.setVelocity(0, 1);
        Stepped.run(engine, 5);
        assertThat(pull.calls).isGreaterThan(before);
    }

    /** Weight by a force of an author that depends on nothing but the body. */
    private static final class Pull implements ForceGenerator {
        private static final long serialVersionUID = 1L;
        private transient long calls;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            calls++;
            forces.add(body, 0, -G * body.getMass());
        }

        @Override
        public boolean isAutonomous() {
            return true;
        }
    }

    /** A weight that hangs from a spring sleeps where k d = m g, soft or stiff; and one that is held between two of them. */
    @ParameterizedTest
    @ValueSource(doubles = {100, 1e6})
    void aWeightSleepsOnItsSpring(double stiffness) {
        PhysicsEngine engine = Stepped.engine(SleepScenes.STEP, 4);
        engine.add(new Gravity(0, -G));
        Body hook = engine.add(Body.fixed(new Circle(0.1)).at(0, 3));
        Body weight = engine.add(new Body(new Circle(0.5)).at(0, 1));
        weight.setMass(1);
        engine.add(new Spring(weight, 0, 0, hook, 0, 0, 2, stiffness, 0.1 * stiffness));
        assertThat(SleepScenes.fallAsleep(engine)).isTrue();
        assertThat(weight.getY()).isCloseTo(1 - G / stiffness, within(1e-3));
        double y = weight.getY();
        Stepped.run(engine, 100);
        assertThat(weight.getY()).isEqualTo(y);
        assertThat(engine.kineticEnergy()).isZero();
        hook.setPosition(0, 4);
        engine.step();
        assertThat(engine.isAsleep(weight)).isFalse();
        assertThat(SleepScenes.fallAsleep(engine)).isTrue();
        assertThat(weight.getY()).isCloseTo(2 - G / stiffness, within(1e-3));
    }

    /** Two boxes with a spring between: who pushes one pushes both. */
    @ParameterizedTest
    @ValueSource(doubles = {20, 1e6})
    void whatPullsAtOneAnotherSleepsAndWakesTogether(double stiffness) {
        PhysicsEngine engine = Stepped.engine(SleepScenes.STEP, 4);
        engine.add(new Gravity(0, -G));
        Stepped.ground(engine);
        Body left = Stepped.rough(engine.add(new Body(new Rectangle(1, 1)).at(0, 0.5)));
        Body right = Stepped.rough(engine.add(new Body(new Rectangle(1, 1)).at(3, 0.5)));
        engine.add(new Spring(left, 0, 0, right, 0, 0, 3, stiffness, 1));
        assertThat(SleepScenes.fallAsleep(engine)).isTrue();
        left.setVelocity(-6, 0);
        engine.step();
        assertThat(engine.isAsleep(right)).isFalse();
        assertThat(SleepScenes.fallAsleep(engine)).isTrue();
        assertThat(right.getX() - left.getX()).isCloseTo(3, within(0.5 * G / stiffness + 0.01)); // what friction holds
    }

    @Test
    void whatFrictionWithThePlaneHasStoppedSleeps() {
        PhysicsEngine engine = Stepped.engine(SleepScenes.STEP, 4);
        engine.add(new SurfaceFriction(G));
        SteppedHeapTest.bin(engine, 3); // so narrow that they press on one another in the end
        for (int k = 0; k < 36; k++) {
            Body puck = engine.add(new Body(k % 2 == 0 ? new Circle(0.5) : new Rectangle(0.95, 0.95)).at(k % 6 - 2.5, k / 6 - 2.5));
            puck.moving(3 - k % 3, k % 5 - 2, 1);
            Stepped.rough(puck).setSurfaceFriction(0.3);
        }
        assertThat(SleepScenes.fallAsleep(engine)).isTrue();
        double[] places = SleepScenes.places(engine);
        Stepped.run(engine, 100);
        assertThat(SleepScenes.places(engine)).isEqualTo(places);
        engine.bodies().get(9).addForce(1, 0); // less than what holds it
        engine.step();
        assertThat(engine.isAsleep(engine.bodies().get(9))).isFalse();
        assertThat(SleepScenes.fallAsleep(engine)).isTrue();
    }

    /** Also if another body takes its number, or another pair that of its contact. */
    @Test
    void aSleeperThatLeavesTakesItsContactsAlong() {
        PhysicsEngine engine = Stepped.engine(SleepScenes.STEP, 4);
        Body[] stack = Stepped.stack(engine, 1);
        assertThat(SleepScenes.fallAsleep(engine)).isTrue();
        Body box = Stepped.rough(engine.add(new Body(new Rectangle(1, 1)).at(5, 4)));
        engine.step();
        assertThat(engine.contacts()).hasSize(1);
        engine.remove(stack[0]);
        assertThat(engine.contacts()).isEmpty();
        Stepped.run(engine, 120);
        assertThat(engine.contacts()).hasSize(1);
        assertThat(engine.contacts(box)).hasSize(1);
        Body other = Stepped.rough(engine.add(new Body(new Rectangle(1, 1)).at(0, 0.5)));
        assertThat(other.index()).isLessThan(box.index());
        assertThat(engine.isAsleep(other)).isFalse();
        engine.step();
        assertThat(engine.contacts()).hasSize(2);
    }

    /** A pile that sleeps is no concern of another one that is struck. */
    @Test
    void onlyTheIslandThatIsStruckWakes() {
        PhysicsEngine engine = Stepped.engine(SleepScenes.STEP, 4);
        Body[] stack = Stepped.stack(engine, 3);
        Body[] other = new Body[3];
        for (int k = 0; k < 3; k++) {
            other[k] = Stepped.rough(engine.add(new Body(new Rectangle(1, 1)).at(1.2, 0.5 + k)));
        }
        assertThat(SleepScenes.fallAsleep(engine)).isTrue();
        Body box = Stepped.rough(engine.add(new Body(new Rectangle(0.5, 0.5)).at(0.1, 5, 0.3)));
        long looks = engine.getNarrowPhaseEvaluations();
        while (!engine.isAsleep(box) && engine.getTime() < 60) {
            engine.step();
            for (Body body : other) {
                assertThat(engine.isAsleep(body)).isTrue();
            }
        }
        assertThat(engine.isAsleep(stack[0])).isTrue();
        assertThat(engine.getNarrowPhaseEvaluations()).isGreaterThan(looks);
    }

    @Test
    void whoDoesNotWantSleepHasNone() {
        PhysicsEngine engine = SleepScenes.scene("pyramid");
        assertThat(engine.isSleepAllowed()).isTrue();
        assertThat(SleepScenes.fallAsleep(engine)).isTrue();
        engine.setSleepAllowed(false);
        assertThat(engine.isSleepAllowed()).isFalse();
        for (int k = 0; k < 200; k++) {
            engine.step();
            assertThat(SleepScenes.movable(engine)).noneMatch(engine::isAsleep);
        }
        engine.setSleepAllowed(true);
        assertThat(SleepScenes.fallAsleep(engine)).isTrue();
        engine.setTimeStepping(0);
        assertThat(SleepScenes.movable(engine)).noneMatch(engine::isAsleep);
        engine.setSleepAllowed(false);
        PhysicsEngine fresh = Stepped.engine(SleepScenes.STEP, 4);
        fresh.setSleepAllowed(false);
        assertThatThrownBy(() -> fresh.isAsleep(engine.bodies().get(1))).isInstanceOf(IllegalStateException.class);
    }

    /** What forces have pressed bodies into one another by. By events they rise by that, and sink in again: in 30 heaps to an eighth at most. */
    private static double pressedIn(PhysicsEngine engine) {
        double sum = 0;
        for (Overlap overlap : engine.overlaps()) {
            for (LastingContact contact : engine.contacts(overlap.a())) {
                boolean isIt = contact.other(overlap.a()) == overlap.b();
                sum += isIt ? overlap.depth() * StrictMath.hypot(contact.forceX(overlap.a()), contact.forceY(overlap.a())) : 0;
            }
        }
        return sum;
    }

    /** Lets what sleeps go on by events, and back again, for half a second each; how far its coordinates go. Nothing rises by more than that. */
    private static double[] goOnByEvents(PhysicsEngine engine, double rise) {
        double[] places = SleepScenes.places(engine);
        double energy = SleepScenes.energy(engine);
        engine.setTimeStepping(0);
        Stepped.run(engine, 30);
        engine.setTimeStepping(4);
        Stepped.run(engine, 30);
        double[] ways = SleepScenes.places(engine);
        assertThat(SleepScenes.energy(engine)).isLessThan(energy + rise);
        for (int k = 0; k < ways.length; k++) {
            ways[k] = Math.abs(ways[k] - places[k]);
        }
        return ways;
    }

    /**
     * From sleep to events and back: bodies lie as they lay, and sleep again. A limb that just did not slip may fall to another rest, and turn over
     * on its pin; but nothing rises.
     */
    @ParameterizedTest
    @ValueSource(strings = {"stack", "ragdoll"})
    void sleepersMayGoOnByEvents(String name) {
        PhysicsEngine engine = SleepScenes.scene(name);
        boolean mayFall = name.equals("ragdoll");
        for (int turn = 0; turn < 2; turn++) {
            boolean sleeps = SleepScenes.fallAsleep(engine);
            // limbs on pins without friction may rock on, one ragdoll in four: with no more than what a fall by a centimetre gives
            assertThat(sleeps || mayFall && turn > 0 && engine.kineticEnergy() < 0.1).isTrue();
            double[] ways = goOnByEvents(engine, 0.02);
            for (int k = 0; k < ways.length; k++) {
                boolean mayTurnOver = mayFall && k % 3 == 2;
                assertThat(ways[k]).isLessThanOrEqualTo(mayTurnOver ? 2 * Math.PI : mayFall ? 0.5 : 0.05);
            }
        }
    }

    /** What leans in a heap may fall to another rest, and what lies on that: one heap in ten, by no more than the size of a body, and few bodies. */
    @Test
    void heapsThatSleepMayGoOnByEvents() {
        int rests = 0;
        int changed = 0;
        for (int seed = 1; seed <= 8; seed++) {
            PhysicsEngine engine = SleepScenes.heap(seed);
            for (int turn = 0; turn < 2 && SleepScenes.fallAsleep(engine); turn++) {
                double[] ways = goOnByEvents(engine, 0.2 * pressedIn(engine));
                int fell = 0;
                for (double way : ways) {
                    assertThat(way).as("heap %s", seed).isLessThan(1);
                    fell += way > 0.05 ? 1 : 0;
                }
                assertThat(fell).as("heap %s", seed).isLessThanOrEqualTo(3 * 4); // of four bodies
                changed += fell > 0 ? 1 : 0;
                rests++;
            }
        }
        assertThat(rests).isGreaterThan(12);
        assertThat(changed).as("of %s rests", rests).isLessThanOrEqualTo(4);
    }
}
