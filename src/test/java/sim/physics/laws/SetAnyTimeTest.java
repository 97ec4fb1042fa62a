// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.collision.broad.SortAndSweep;
import sim.physics.constraint.DirectSolver;
import sim.physics.constraint.Joint;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.constraint.Stabilization;
import sim.physics.motion.Body;
import sim.physics.motion.Euler;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.response.ContactListener;
import sim.physics.response.LastingContact;
import sim.physics.response.PairRule;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Whatever is set in the middle of a run takes effect, between steps and by a listener within one; or it is refused. */
class SetAnyTimeTest {
    private static final double SLOPE = 0.3;
    private static final double SIN = StrictMath.sin(SLOPE);
    private static final double COS = StrictMath.cos(SLOPE);
    private static final double G = 10;
    private static final double STEP = 1.0 / 64;

    /** Where in the step the listener acts. */
    private static final double WHEN = 0.25;

    private final PhysicsEngine engine = new PhysicsEngine();

    /** What stands still on a slope: by a rest, in a heap, or as bodies that a pin ties. */
    private enum Lying {
        BOX,
        STACK,
        PINNED
    }

    /** How friction goes away. */
    private enum Ice {
        BODIES,
        GROUND,
        RULES
    }

    /** Does something at the first collision that it is told of. */
    private static final class AtCollision implements CollisionListener {
        private static final long serialVersionUID = 1L;

        private final transient Runnable action;
        private int told;

        AtCollision(Runnable action) {
            this.action = action;
        }

        @Override
        public void collided(Contact contact) {
            if (told++ == 0) {
                action.run();
            }
        }
    }

    /** Acts between steps, or within the next one as a listener of what happens far away. */
    private void act(boolean inStep, Runnable action) {
        if (!inStep) {
            action.run();
            return;
        }
        AtCollision listener = new AtCollision(action);
        engine.addListener(listener);
        long impacts = engine.getImpacts();
        Body ball = engine.add(new Body(new Circle(0.125)).at(500, 500).moving(1 / engine.getTimeStep(), 0));
        Body post = engine.add(Body.fixed(new Circle(0.125)).at(500.25 + WHEN, 500));
        engine.step();
        assertThat(listener.told).isEqualTo(1);
        assertThat(engine.getImpacts()).isEqualTo(impacts + 1);
        engine.removeListener(listener);
        engine.remove(ball);
        engine.remove(post);
    }

    private void run(int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    private static Stream<Arguments> allWays() {
        List<Arguments> all = new ArrayList<>();
        for (Lying lying : Lying.values()) {
            for (Ice ice : Ice.values()) {
                all.add(Arguments.of(lying, ice, false));
                all.add(Arguments.of(lying, ice, true));
            }
        }
        return all.stream();
    }

    /** What stands still without friction slides down as on ice. */
    @ParameterizedTest
    @MethodSource("allWays")
    void frictionIsSetOfWhatStandsStill(Lying lying, Ice ice, boolean inStep) {
        engine.setTimeStep(STEP);
        engine.add(new Gravity(0, -G));
        engine.setPairRules(PairRule.MINIMUM, ice == Ice.RULES ? PairRule.MAXIMUM : PairRule.GEOMETRIC_MEAN);
        Body ground = engine.add(Body.fixed(new Rectangle(100, 2)).at(SIN, -COS, SLOPE));
        ground.setFriction(ice == Ice.RULES ? 0 : 0.9);
        List<Body> boxes = boxes(lying);
        boxes.forEach(box -> box.setFriction(0.9));
        run(60);
        double x = boxes.get(0).getX();
        run(1);
        assertThat(boxes.get(0).getX()).isEqualTo(x);
        act(inStep, () -> {
            switch (ice) {
                case BODIES -> boxes.forEach(box -> box.setFriction(0));
                case GROUND -> ground.setFriction(0);
                default -> engine.setPairRules(PairRule.MINIMUM, PairRule.MINIMUM);
            }
        });
        run(32);
        double time = STEP * (32 + (inStep ? 1 - WHEN : 0));
        for (Body box : boxes) {
            assertThat(-box.getVelocityX() * COS - box.getVelocityY() * SIN)
                    .isCloseTo(G * SIN * time, within(0.01 * G * SIN * time)); // of first order where something closes again
            assertThat(box.getVelocityX() * SIN - box.getVelocityY() * COS).isCloseTo(0, within(1e-4));
        }
    }

    private List<Body> boxes(Lying lying) {
        List<Body> boxes = new ArrayList<>();
        for (int k = 0; k < (lying == Lying.BOX ? 1 : 2); k++) {
            double up = lying == Lying.STACK ? 0.5 + k : 0.5;
            double along = lying == Lying.PINNED ? 1.2 * k : 0;
            Body box = engine.add(new Body(new Rectangle(1, 1)).at(COS * along - SIN * up, SIN * along + COS * up, SLOPE));
            box.setRestitution(0);
            boxes.add(box);
        }
        if (lying == Lying.PINNED) {
            engine.add(new PinJoint(boxes.get(0), boxes.get(1), 0.6 * COS - 0.5 * SIN, 0.6 * SIN + 0.5 * COS));
        }
        return boxes;
    }

    /** Two balls that come together on a rail or with a rope between them, at the time 1.5. */
    private Body[] twoBalls(boolean isRope) {
        engine.setTimeStep(0.25);
        Body left = engine.add(new Body(new Circle(1)).moving(1, 0));
        Body right = engine.add(new Body(new Circle(1)).at(5, 0).moving(-1, 0));
        if (isRope) {
            engine.add(Limit.rope(left, 0, 0, right, 0, 0, 100));
        } else {
            engine.add(new SliderJoint(left, right, 0, 0, 1, 0));
        }
        return new Body[] {left, right};
    }

    private void setCollide(boolean yes) {
        if (engine.allConstraints().get(0) instanceof Joint joint) {
            joint.setCollideConnected(yes);
        } else {
            ((Limit) engine.allConstraints().get(0)).setCollideConnected(yes);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3})
    void jointedBodiesBeginToCollide(int how) {
        Body[] balls = twoBalls(how % 2 == 0);
        run(4);
        act(how >= 2, () -> setCollide(true));
        run(4);
        assertThat(balls[0].getVelocityX()).isCloseTo(-1, within(1e-14));
        assertThat(balls[0].getX()).isCloseTo(1.5 - (engine.getTime() - 1.5), within(1e-13));
        assertThat(engine.getImpacts()).isEqualTo(how >= 2 ? 2 : 1);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3})
    void jointedBodiesCollideNoMore(int how) {
        Body[] balls = twoBalls(how % 2 == 0);
        setCollide(true);
        run(4);
        act(how >= 2, () -> setCollide(false));
        run(8);
        assertThat(balls[0].getX()).isCloseTo(engine.getTime(), within(1e-13));
    }

    /** Motors and stops beside a joint leave it to the joint, and where there is none they say it themselves. */
    @Test
    void stopsBesideAJointLeaveItToTheJoint() {
        Body[] balls = twoBalls(false);
        engine.add(Limit.travel((SliderJoint) engine.allConstraints().get(0), -50, 50));
        engine.add(Limit.rope(balls[0], 0, 0, balls[1], 0, 0, 100));
        setCollide(true);
        run(8);
        assertThat(balls[0].getVelocityX()).isCloseTo(-1, within(1e-14));
    }

    /** Bodies that are in one another when they begin to collide pass, part, and bounce when they meet again. */
    @Test
    void whatIsInOneAnotherPassesFirst() {
        Body[] balls = twoBalls(false);
        engine.add(Limit.travel((SliderJoint) engine.allConstraints().get(0), -50, 40, 1));
        run(9);
        assertThat(engine.overlaps()).isEmpty();
        setCollide(true);
        assertThat(engine.overlaps()).hasSize(1);
        run(60); // apart at 3.5
        assertThat(balls[0].getVelocityX()).isCloseTo(1, within(1e-13));
        assertThat(engine.getImpacts()).isZero();
        run(20); // at the stop at 20
        assertThat(balls[0].getVelocityX()).isCloseTo(-1, within(1e-13));
        run(59); // they meet at 36.5
        assertThat(balls[0].getVelocityX()).isCloseTo(1, within(1e-13));
        assertThat(engine.getImpacts()).isEqualTo(1);
    }

    /** The upper one of two boxes that stand on one another falls through the lower one, whichever of them is told; and that bears nothing from then on. */
    @ParameterizedTest
    @CsvSource({"0, false", "1, false", "2, false", "3, false", "0, true", "1, true", "2, true", "3, true"})
    void whatStandsOnAnotherFallsThrough(int how, boolean inStep) {
        engine.setTimeStep(STEP);
        engine.add(new Gravity(0, -G));
        engine.add(Body.fixed(new Rectangle(4, 1)).at(0, -0.5)).setCollisionGroup(1 | 4, -1);
        Body low = engine.add(new Body(new Rectangle(1, 1)).at(0, 0.5));
        Body high = engine.add(new Body(new Rectangle(1, 1)).at(0, 1.5));
        low.setRestitution(0);
        high.setRestitution(0);
        run(30);
        assertThat(high.getVelocityY()).isZero();
        act(inStep, () -> {
            switch (how) {
                case 0 -> engine.setCollisions(low, high, false);
                case 1 -> engine.setCollisions(high, low, false);
                case 2 -> low.setCollisionGroup(2, 4);
                default -> high.setCollisionGroup(2, 4);
            }
        });
        run(16);
        double time = STEP * (16 + (inStep ? 1 - WHEN : 0));
        assertThat(high.getVelocityY()).isCloseTo(-G * time, within(1e-8)); // as exact as what lies
        assertThat(high.getY()).isCloseTo(1.5 - G * time * time / 2, within(1e-8));
        assertThat(low.getY()).isCloseTo(0.5, within(1e-9));
        assertThat(engine.contacts(low)).hasSize(1);
        assertThat(engine.contacts(low).get(0).forceY(low)).isCloseTo(G, within(1e-8));
    }

    /** A block that lies on another one, which guides it on a rail, falls through when the two collide no more. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void whatLiesFallsThrough(boolean inStep) {
        engine.setTimeStep(STEP);
        engine.add(new Gravity(0, -G));
        Body table = engine.add(Body.fixed(new Rectangle(4, 1)));
        Body block = engine.add(new Body(new Rectangle(1, 1)).at(0, 1));
        block.setRestitution(0);
        SliderJoint rail = new SliderJoint(block, table, 0, 1, 0, 1);
        rail.setCollideConnected(true);
        engine.add(rail);
        run(30);
        assertThat(block.getY()).isCloseTo(1, within(1e-6));
        act(inStep, () -> rail.setCollideConnected(false));
        run(32);
        double time = STEP * (32 + (inStep ? 1 - WHEN : 0));
        assertThat(block.getVelocityY()).isCloseTo(-G * time, within(1e-7)); // as exact as what lies
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aBreakingLoadIsSetLater(boolean inStep) {
        engine.setTimeStep(STEP);
        engine.add(new Gravity(0, -G));
        Body bob = engine.add(new Body(new Circle(1)).at(0, -3));
        PinJoint pin = engine.add(new PinJoint(bob, 0, 0));
        double weight = bob.getMass() * G;
        pin.setBreakingLoad(1.01 * weight, 1);
        run(4);
        assertThat(engine.contains(pin)).isTrue();
        act(inStep, () -> pin.setBreakingLoad(0.99 * weight, 1));
        assertThat(engine.contains(pin)).isTrue();
        run(1);
        assertThat(engine.contains(pin)).isFalse();
        run(31);
        assertThat(bob.getVelocityY()).isCloseTo(-G * 32 * STEP, within(1e-12));
    }

    @Test
    void aJointThatNothingBreaksCanBeMadeOneThatBreaks() {
        engine.setTimeStep(STEP);
        engine.add(new Gravity(0, -G));
        Body bob = engine.add(new Body(new Circle(1)).at(0, -3));
        PinJoint pin = engine.add(new PinJoint(bob, 0, 0));
        run(4);
        pin.setBreakingLoad(1, 1);
        pin.setBreakingLoad(Double.POSITIVE_INFINITY, 1);
        run(1);
        assertThat(engine.contains(pin)).isTrue();
        pin.setBreakingLoad(1, 1);
        run(1);
        assertThat(engine.contains(pin)).isFalse();
    }

    /** The angular velocity grows by torque / I from the instant at which the listener says so. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void motorsAreSetAtOnce(boolean inStep) {
        engine.setTimeStep(STEP);
        Body arm = engine.add(new Body(new Rectangle(2, 0.2)));
        engine.add(new PinJoint(arm, 0, 0));
        Motor motor = engine.add(Motor.turning(arm, null, 0, 1));
        run(4);
        act(inStep, () -> motor.setSpeed(1000));
        run(10);
        double time = STEP * (10 + (inStep ? 1 - WHEN : 0));
        assertThat(arm.getAngularVelocity()).isCloseTo(time / arm.getInertia(), within(1e-12));
        double before = arm.getAngularVelocity() + (inStep ? WHEN * STEP / arm.getInertia() : 0);
        act(inStep, () -> motor.setLimit(3));
        run(10);
        assertThat(arm.getAngularVelocity()).isCloseTo(before + 3 * time / arm.getInertia(), within(1e-12));
    }

    /** How a step is made is not changed in the middle of it. */
    @Test
    void whatCannotBeSetWithinAStepIsRefused() {
        List<Runnable> settings = List.of(
                () -> engine.setIntegrator(new Euler()),
                () -> engine.setConstraintSolver(new DirectSolver()),
                () -> engine.setStabilization(Stabilization.projection()),
                () -> engine.setBroadPhase(new SortAndSweep()),
                () -> engine.setContinuousDetection(false),
                () -> engine.setTimeStep(2),
                () -> engine.setThreads(2),
                () -> engine.setAudited(true),
                () -> engine.separate(),
                () -> engine.step());
        for (Runnable setting : settings) {
            act(true, () -> assertThatThrownBy(setting::run)
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessageContaining("within"));
        }
        assertThat(engine.getIntegrator()).isNotInstanceOf(Euler.class);
        assertThat(engine.getSteps()).isEqualTo(settings.size());
    }

    /** A force that writes bodies in place of adding to the forces, four times a step with RK4. */
    private static final class Writes implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private final transient Runnable action;
        private boolean isOn = true;

        Writes(Runnable action) {
            this.action = action;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            if (isOn) {
                action.run();
            }
        }
    }

    @Test
    void forcesChangeNothing() {
        Body body = engine.add(new Body(new Circle(1)).moving(1, 0));
        Body other = new Body(new Circle(1)).at(100, 0);
        Gravity gravity = new Gravity(0, 1);
        engine.add(gravity);
        List<Runnable> actions = List.of(
                () -> body.addForce(1, 0),
                () -> body.addTorque(1),
                () -> body.setVelocity(0, 0),
                () -> body.setPosition(0, 0),
                () -> body.setFriction(0.5),
                () -> body.setCollisionGroup(2, 0),
                () -> engine.add(other),
                () -> engine.remove(body),
                () -> engine.add(new Gravity(1, 0)),
                () -> engine.remove(gravity),
                () -> engine.add(new PinJoint(body, 0, 0)),
                () -> engine.setPairRules(PairRule.MINIMUM, PairRule.MINIMUM));
        double time = 0;
        for (Runnable action : actions) {
            Writes writes = new Writes(action);
            engine.add(writes);
            assertThatThrownBy(engine::step)
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessageContaining("only listeners");
            writes.isOn = false;
            engine.step();
            time += 1;
            assertThat(body.getX()).isCloseTo(time, within(1e-12));
            assertThat(body.getY()).isCloseTo(time * time / 2, within(1e-10));
            engine.remove(writes);
        }
        body.addForce(body.getMass(), 0); // between steps all is as ever
        engine.step();
        assertThat(body.getVelocityX()).isCloseTo(2, within(1e-12));
    }

    /** Listeners that come and go while they are told hide nothing from one another. */
    @Test
    void listenersComeAndGo() {
        AtCollision third = new AtCollision(() -> {});
        List<AtCollision> leaving = new ArrayList<>();
        leaving.add(new AtCollision(() -> {
            engine.removeListener(leaving.get(0));
            engine.addListener(third);
        }));
        AtCollision second = new AtCollision(() -> {});
        engine.addListener(leaving.get(0));
        engine.addListener(second);
        Body ball = engine.add(new Body(new Circle(1)).moving(1, 0));
        engine.add(Body.fixed(new Circle(1)).at(2.5, 0));
        engine.step();
        assertThat(List.of(leaving.get(0).told, second.told, third.told)).containsExactly(1, 1, 0);
        ball.setVelocity(1, 0);
        engine.step();
        assertThat(List.of(leaving.get(0).told, second.told, third.told)).containsExactly(1, 2, 1);
    }

    /** Steps the engine when a contact begins. */
    private static final class Steps implements ContactListener {
        private static final long serialVersionUID = 1L;

        private final PhysicsEngine engine;

        Steps(PhysicsEngine engine) {
            this.engine = engine;
        }

        @Override
        public void began(LastingContact contact) {
            engine.step();
        }
    }

    @Test
    void aContactListenerDoesNotStepTheEngine() {
        engine.add(new Gravity(0, -G));
        engine.setTimeStep(STEP);
        engine.add(Body.fixed(new Rectangle(4, 1)));
        Body box = engine.add(new Body(new Rectangle(1, 1)).at(0, 1));
        box.setRestitution(0);
        engine.addContactListener(new Steps(engine));
        assertThatThrownBy(() -> run(10)).isInstanceOf(IllegalStateException.class).hasMessageContaining("by a listener");
        run(10);
        assertThat(box.getY()).isCloseTo(1, within(1e-9));
    }
}
