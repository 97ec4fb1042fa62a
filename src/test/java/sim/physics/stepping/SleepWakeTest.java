// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Joint;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.motion.Spring;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.response.PairRule;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Time stepping: whatever concerns a body that sleeps wakes it, with its island and no other; and what must not sleep does not. */
class SleepWakeTest {
    private static final double G = Stepped.G;

    /** Two boxes on a shelf, a door that hangs on a hinge with a motor that holds it, and a weight on a spring; and a box far off. */
    private static final class Scene {
        final PhysicsEngine engine = Stepped.engine(SleepScenes.STEP, 4);
        final Gravity gravity = new Gravity(0, -G);
        final Body shelf;
        final Body lower;
        final Body upper;
        final Body door;
        final PinJoint hinge;
        final Motor motor;
        final Body hook;
        final Body weight;
        final Spring spring;
        final Body farShelf;
        final Body far;

        Scene() {
            engine.add(gravity);
            shelf = Stepped.rough(engine.add(Body.fixed(new Rectangle(6, 1)).at(0, -0.5)));
            lower = Stepped.rough(engine.add(new Body(new Rectangle(1, 1)).at(0, 0.5)));
            upper = Stepped.rough(engine.add(new Body(new Rectangle(1, 1)).at(0.1, 1.5)));
            door = engine.add(new Body(new Rectangle(0.2, 2)).at(10, 0));
            hinge = engine.add(new PinJoint(door, 10, 1));
            motor = engine.add(Motor.turning(door, null, 0, 1));
            hook = engine.add(Body.fixed(new Circle(0.1)).at(20, 3));
            weight = engine.add(new Body(new Circle(0.5)).at(20, 1));
            spring = new Spring(weight, 0, 0, hook, 0, 0, 2, 100, 20);
            engine.add(spring);
            farShelf = Stepped.rough(engine.add(Body.fixed(new Rectangle(6, 1)).at(40, -0.5)));
            far = Stepped.rough(engine.add(new Body(new Rectangle(1, 1)).at(40, 0.5)));
            assertThat(SleepScenes.fallAsleep(engine)).isTrue();
        }

        List<Body> awake() {
            List<Body> all = new ArrayList<>(SleepScenes.movable(engine));
            all.removeIf(engine::isAsleep);
            return all;
        }
    }

    private static final Map<String, Consumer<Scene>> BOXES = new LinkedHashMap<>();
    private static final Map<String, Consumer<Scene>> OTHERS = new LinkedHashMap<>();
    private static final Map<String, Consumer<Scene>> ALL = new LinkedHashMap<>();

    static {
        BOXES.put("force", s -> s.lower.addForce(1, 0));
        BOXES.put("force at a point", s -> s.upper.addForceAt(1, 0, 0, 2));
        BOXES.put("torque", s -> s.upper.addTorque(0.1));
        BOXES.put("impulse", s -> s.lower.addImpulseAt(0.1, 0, 0, 0.5));
        BOXES.put("velocity", s -> s.upper.setVelocity(0.1, 0));
        BOXES.put("spin", s -> s.lower.setAngularVelocity(0.1));
        BOXES.put("place", s -> s.upper.setPosition(0.2, 1.5));
        BOXES.put("angle", s -> s.upper.setAngle(0.1));
        BOXES.put("mass", s -> s.upper.setMass(5));
        BOXES.put("friction", s -> s.lower.setFriction(0.1));
        BOXES.put("friction of the shelf", s -> s.shelf.setFriction(0.1));
        BOXES.put("friction with a plane", s -> s.lower.setSurfaceFriction(0.1));
        BOXES.put("no collisions", s -> s.engine.setCollisions(s.lower, s.shelf, false));
        BOXES.put("no collisions, the other way", s -> s.engine.setCollisions(s.shelf, s.lower, false));
        BOXES.put("collision group", s -> s.lower.setCollisionGroup(2, 2));
        BOXES.put("collision group of the shelf", s -> s.shelf.setCollisionGroup(2, 2));
        BOXES.put("shelf moved away", s -> s.shelf.setPosition(0, -5));
        BOXES.put("shelf moved a little", s -> s.shelf.setPosition(0, -0.51));
        BOXES.put("shelf turned", s -> s.shelf.setAngle(0.01));
        BOXES.put("shelf removed", s -> s.engine.remove(s.shelf));
        BOXES.put("lower box removed", s -> s.engine.remove(s.lower));
        BOXES.put("upper box removed", s -> s.engine.remove(s.upper));
        BOXES.put("joint with the world", s -> s.engine.add(new PinJoint(s.lower, 0, 0.5)));
        BOXES.put("joint between", s -> s.engine.add(new PinJoint(s.lower, s.upper, 0, 1)));
        BOXES.put("spring to the world", s -> s.engine.add(new Spring(s.upper, 0, 0, null, 0, 3, 1, 10, 1)));
        BOXES.put("another box beside", s -> s.engine.add(new Body(new Rectangle(1, 1)).at(1.001, 0.5)));
        BOXES.put("another box above", s -> s.engine.add(new Body(new Rectangle(1, 1)).at(0, 2.51).moving(0, -1)));
        BOXES.put("a wall put beside", s -> s.engine.add(Body.fixed(new Rectangle(1, 1)).at(0.99, 0.5)));
        BOXES.put("a force between steps of an author", s -> s.engine.add(new Wind(List.of(s.lower))));

        OTHERS.put("speed of a motor", s -> s.motor.setSpeed(1));
        OTHERS.put("strength of a motor", s -> s.motor.setLimit(0.5));
        OTHERS.put("joint removed", s -> s.engine.remove(s.hinge));
        OTHERS.put("motor removed", s -> s.engine.remove(s.motor));
        OTHERS.put("breaking load", s -> s.hinge.setBreakingLoad(1e9, 1e9));
        OTHERS.put("hook of the spring", s -> s.hook.setPosition(20, 3.1));
        OTHERS.put("length of the spring", s -> s.spring.setLength(2.1));
        OTHERS.put("stiffness of the spring", s -> s.spring.setStiffness(90));
        OTHERS.put("damping of the spring", s -> s.spring.setDamping(10));
        OTHERS.put("spring removed", s -> s.engine.remove(s.spring));
        OTHERS.put("hook removed", s -> s.engine.remove(s.hook));

        ALL.put("more gravity", s -> s.engine.add(new Gravity(0, -1)));
        ALL.put("no gravity", s -> s.engine.remove(s.gravity));
        ALL.put("time step", s -> s.engine.setTimeStep(SleepScenes.STEP / 2));
        ALL.put("substeps", s -> s.engine.setTimeStepping(8));
        ALL.put("rules of pairs", s -> s.engine.setPairRules(PairRule.MAXIMUM, PairRule.MAXIMUM));
        ALL.put("listener", s -> s.engine.addListener(new Listener()));
        ALL.put("no sleep", s -> s.engine.setSleepAllowed(false));
        ALL.put("force of an author on all", s -> s.engine.add(new Wind(null)));
    }

    static Stream<String> ofBoxes() {
        return BOXES.keySet().stream();
    }

    static Stream<String> ofOthers() {
        return OTHERS.keySet().stream();
    }

    static Stream<String> ofAll() {
        return ALL.keySet().stream();
    }

    @ParameterizedTest
    @MethodSource("ofBoxes")
    void wakesTheIslandOfTheBoxes(String what) {
        Scene scene = new Scene();
        BOXES.get(what).accept(scene);
        scene.engine.step();
        for (Body body : List.of(scene.lower, scene.upper)) {
            assertThat(!scene.engine.contains(body) || !scene.engine.isAsleep(body)).isTrue();
        }
        for (Body body : List.of(scene.door, scene.weight, scene.far)) {
            assertThat(scene.engine.isAsleep(body)).isTrue();
        }
    }

    @ParameterizedTest
    @MethodSource("ofOthers")
    void wakesTheBodyThatItConcerns(String what) {
        Scene scene = new Scene();
        OTHERS.get(what).accept(scene);
        scene.engine.step();
        boolean isSpring = what.contains("spring") || what.contains("hook");
        assertThat(scene.awake()).containsExactly(isSpring ? scene.weight : scene.door);
    }

    @ParameterizedTest
    @MethodSource("ofAll")
    void wakesAll(String what) {
        Scene scene = new Scene();
        ALL.get(what).accept(scene);
        scene.engine.step();
        assertThat(scene.awake()).containsExactly(scene.lower, scene.upper, scene.door, scene.weight, scene.far);
    }

    /** What is asked, or changes nothing of theirs, lets bodies sleep. */
    @Test
    void questionsWakeNobody() {
        Scene scene = new Scene();
        scene.engine.contacts();
        scene.engine.getReaction(scene.hinge);
        scene.engine.overlaps();
        scene.engine.queries().nearest(0, 0, 3, null);
        scene.lower.getX();
        scene.engine.setTimeStepping(4);
        scene.engine.add(new Body(new Circle(1)).at(-20, 0));
        scene.engine.add(Body.fixed(new Circle(1)).at(0, 4));
        scene.engine.step();
        assertThat(scene.awake()).hasSize(1);
    }

    /** A breaking load holds from the next step on, for what sleeps, too: what bears more than that now is cut when that step begins. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aJointThatSleepsBreaksWhenItIsMadeTooWeak(boolean isPin) {
        PhysicsEngine engine = Stepped.engine(SleepScenes.STEP, 4);
        engine.add(new Gravity(0, -G));
        Body bob = engine.add(new Body(new Circle(0.5)).at(0, -2));
        bob.setMass(3);
        Joint tie = engine.add(isPin ? new PinJoint(bob, 0, 0) : new RodJoint(bob, 0, -2, null, 0, 0));
        assertThat(SleepScenes.fallAsleep(engine)).isTrue();
        tie.setBreakingLoad(1.01 * 3 * G, Double.POSITIVE_INFINITY);
        engine.step();
        assertThat(engine.contains(tie)).isTrue();
        assertThat(SleepScenes.fallAsleep(engine)).isTrue();
        tie.setBreakingLoad(0.99 * 3 * G, Double.POSITIVE_INFINITY);
        engine.step();
        assertThat(engine.contains(tie)).isFalse();
        assertThat(bob.getVelocityY()).isCloseTo(-G * SleepScenes.STEP, within(1e-12));
    }

    /** Free fall from the instant at which the support goes: s = g t²/2, of all that it bore. */
    @Test
    void whatLosesItsSupportFalls() {
        double error = 0.6 * G * 0.4 * SleepScenes.STEP / 4; // half a substep's way, as the two touch one another
        for (String what : List.of("shelf removed", "shelf moved away", "no collisions, the other way", "collision group of the shelf")) {
            Scene scene = new Scene();
            double lower = scene.lower.getY();
            double upper = scene.upper.getY();
            BOXES.get(what).accept(scene);
            Stepped.run(scene.engine, 24);
            assertThat(scene.lower.getY()).isCloseTo(lower - G * 0.4 * 0.4 / 2, within(error));
            assertThat(scene.upper.getY()).isCloseTo(upper - G * 0.4 * 0.4 / 2, within(error));
        }
    }

    /** A row of boxes a hair's breadth apart is struck at one end: all move on, as if they had been awake. */
    @Test
    void whatIsStruckStrikesOthersThatSleep() {
        double[] ends = new double[2];
        for (int turn = 0; turn < 2; turn++) {
            PhysicsEngine engine = Stepped.engine(SleepScenes.STEP, 4);
            engine.setSleepAllowed(turn == 0);
            engine.add(new Gravity(0, -G));
            Stepped.ground(engine);
            Body[] row = new Body[6];
            for (int k = 0; k < row.length; k++) {
                row[k] = Stepped.rough(engine.add(new Body(new Rectangle(1, 1)).at(1.005 * k, 0.5)));
            }
            Stepped.run(engine, 240);
            assertThat(SleepScenes.allSleep(engine)).isEqualTo(turn == 0);
            Stepped.rough(engine.add(new Body(new Rectangle(1, 1)).at(-3, 0.5).moving(12, 0)));
            for (int k = 0; k < 60; k++) {
                engine.step();
                assertThat(Stepped.depth(engine)).isLessThan(0.03);
            }
            ends[turn] = row[5].getX();
        }
        assertThat(ends[1]).isGreaterThan(5.2);
        assertThat(ends[0]).isCloseTo(ends[1], within(1e-3));
    }

    @Test
    void aPlatformThatMovesInPlacesKeepsAwakeWhatIsOnIt() {
        Scene scene = new Scene();
        for (int k = 1; k < 120; k++) {
            scene.shelf.setPosition(0, -0.5 - 1e-4 * k);
            scene.engine.step();
            assertThat(scene.awake()).containsExactly(scene.lower, scene.upper);
        }
        Stepped.run(scene.engine, 120);
        assertThat(scene.awake()).isEmpty();
    }

    /** Newton's first law, however slow: no force, no rest. */
    @Test
    void whatDriftsFreelyDriftsOn() {
        PhysicsEngine engine = Stepped.engine(0.5, 4);
        Body slow = engine.add(new Body(new Circle(1)).moving(1e-9, 0));
        Body still = engine.add(new Body(new Circle(1)).at(10, 0));
        Stepped.run(engine, 1000);
        assertThat(slow.getX()).isCloseTo(500e-9, within(1e-18));
        assertThat(engine.isAsleep(slow)).isFalse();
        assertThat(engine.isAsleep(still)).isTrue();
        still.addForce(1, 0);
        engine.step();
        assertThat(still.getVelocityX()).isCloseTo(0.5 / Math.PI, within(1e-12));
    }

    /** A rod that stands on its pivot tips over as θ = θ₀ cosh ωt says, though it is slower at first than what rests. */
    @Test
    void whatTipsOverIsNotAtRest() {
        PhysicsEngine engine = Stepped.engine(SleepScenes.STEP, 4);
        engine.add(new Gravity(0, -G));
        double tilt = 1e-5;
        Body rod = engine.add(new Body(new Rectangle(0.02, 2)).at(-Math.sin(tilt), Math.cos(tilt), tilt));
        engine.add(new PinJoint(rod, 0, 0));
        double omega = Math.sqrt(rod.getMass() * G / (rod.getInertia() + rod.getMass()));
        Stepped.run(engine, 120);
        assertThat(rod.getAngle()).isCloseTo(tilt * Math.cosh(2 * omega), within(0.05 * tilt * Math.cosh(2 * omega)));
    }

    @Test
    void whatIsDrivenOrPulledByChangingForcesStaysAwake() {
        PhysicsEngine engine = Stepped.engine(SleepScenes.STEP, 4);
        engine.add(new Gravity(0, -G));
        Stepped.ground(engine);
        Body blown = Stepped.rough(engine.add(new Body(new Rectangle(1, 1)).at(0, 0.5)));
        engine.add(new Wind(List.of(blown)));
        Body hand = engine.add(new Body(new Rectangle(0.1, 1)).at(5, 5));
        engine.add(new PinJoint(hand, 5, 5));
        engine.add(Motor.turning(hand, null, 1e-6, 10));
        Body calm = Stepped.rough(engine.add(new Body(new Rectangle(1, 1)).at(10, 0.5)));
        Body tied = Stepped.rough(engine.add(new Body(new Rectangle(1, 1)).at(12, 0.5)));
        engine.add(new RodJoint(calm, 10, 0.5, tied, 12, 0.5));
        Stepped.run(engine, 600);
        assertThat(engine.isAsleep(blown)).isFalse();
        assertThat(engine.isAsleep(hand)).isFalse();
        assertThat(hand.getAngle()).isCloseTo(1e-5, within(1e-9));
        assertThat(engine.isAsleep(calm)).isTrue();
        assertThat(engine.isAsleep(tied)).isTrue();
    }

    /** One that is asked about sleepers when it comes is asked as it would be about bodies that are awake. */
    @Test
    void aListenerIsAskedAboutWhatSleeps() {
        Scene scene = new Scene();
        Listener listener = new Listener();
        scene.engine.addListener(listener);
        scene.engine.step();
        assertThat(listener.asked).isEqualTo(3);
        assertThat(SleepScenes.fallAsleep(scene.engine)).isTrue();
        Stepped.run(scene.engine, 100);
        assertThat(listener.asked).isEqualTo(3);
    }

    private static final class Listener implements CollisionListener {
        private static final long serialVersionUID = 1L;
        private int asked;

        @Override
        public Decision colliding(Contact contact) {
            asked++;
            return Decision.BOUNCE;
        }
    }

    /** A force that does not say that it is the same as long as bodies are where they are. */
    private static final class Wind implements ForceGenerator {
        private static final long serialVersionUID = 1L;
        private final List<Body> bodies;

        Wind(List<Body> bodies) {
            this.bodies = bodies;
        }

        @Override
        public List<Body> getBodies() {
            return bodies;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            forces.add(body, 1e-3, 0);
        }
    }
}
