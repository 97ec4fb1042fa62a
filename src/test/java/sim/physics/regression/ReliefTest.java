// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** A step by events whose work is bounded is ended by time stepping, and events are found again when they cost less. */
class ReliefTest {
    /** A rope that lies over a cylinder and bears two weights: tens of thousands of events a step. */
    private static final class Rope {
        final PhysicsEngine engine = new PhysicsEngine();
        final List<PinJoint> pins = new ArrayList<>();
        final Body light;
        final Body heavy;

        Rope(int links, double linkMass, double weight) {
            engine.setTimeStep(1 / 60.0);
            engine.add(new Gravity(0, -9.81));
            Body cylinder = engine.add(Body.fixed(new Circle(1)));
            cylinder.setFriction(0.3);
            double length = 0.12;
            double radius = 1.08;
            int over = (int) Math.ceil(Math.PI * radius / length);
            int hanging = (links - over) / 2;
            Body last = null;
            double[] from = point(-hanging, over, length, radius);
            for (int k = 1 - hanging; k <= links - hanging; k++) {
                double[] to = point(k, over, length, radius);
                last = link(last, from, to, linkMass);
                from = to;
            }
            Body first = engine.bodies().get(1);
            double[] start = point(-hanging, over, length, radius);
            light = weigh(first, start, 1);
            heavy = weigh(last, from, weight);
        }

        private static double[] point(int k, int over, double length, double radius) {
            if (k < 0 || k > over) {
                return new double[] {k < 0 ? -radius : radius, k < 0 ? k * length : (over - k) * length};
            }
            double angle = Math.PI - Math.PI * k / over;
            return new double[] {radius * Math.cos(angle), radius * Math.sin(angle)};
        }

        private Body link(Body last, double[] from, double[] to, double mass) {
            double length = Math.hypot(to[0] - from[0], to[1] - from[1]);
            Body body = new Body(new Rectangle(0.9 * length, 0.04)).at((from[0] + to[0]) / 2, (from[1] + to[1]) / 2);
            body.setAngle(Math.atan2(to[1] - from[1], to[0] - from[0]));
            body.setMass(mass);
            body.setFriction(0.3);
            body.setRestitution(0);
            engine.add(body);
            if (last != null) {
                pins.add(engine.add(PinJoint.worldPoint(last, body, from[0], from[1])));
            }
            return body;
        }

        private Body weigh(Body end, double[] at, double mass) {
            Body weight = engine.add(new Body(new Circle(0.2)).at(at[0], at[1] - 0.2));
            weight.setMass(mass);
            weight.setRestitution(0);
            pins.add(engine.add(PinJoint.worldPoint(end, weight, at[0], at[1])));
            return weight;
        }

        void step(int times) {
            for (int k = 0; k < times; k++) {
                engine.step();
            }
        }
    }

    private static Rope limited() {
        Rope rope = new Rope(80, 0.02, 1.6);
        rope.engine.setWorkLimit(20_000);
        return rope;
    }

    /** The weights' ratio, 1.6, is below e^(0.3 π) = 2.6: friction of the cylinder holds the rope, by relieved steps too. */
    @Test
    void aStepCostsNoMoreThanItMay() {
        Rope rope = limited();
        for (int k = 0; k < 120; k++) {
            long before = rope.engine.getWork();
            rope.engine.step();
            assertThat(rope.engine.getWork() - before).as("step %d", k).isLessThan(150_000); // the last solution of a heap is not cut short
        }
        assertThat(rope.engine.getRelievedSteps()).isBetween(90L, 119L);
        assertThat(rope.engine.getSteps()).isEqualTo(120);
        assertThat(rope.engine.getTime()).isEqualTo(120 * (1 / 60.0));
        assertThat(rope.heavy.getY() - rope.light.getY()).isEqualTo(0, within(0.35)); // ten ropes of other masses: 0.18 to 0.3
        assertThat(rope.engine.kineticEnergy()).isLessThan(1);
    }

    @Test
    void aLimitThatIsNotMetChangesNoBit() {
        for (long seed = 1; seed <= 3; seed++) {
            RandomMachine usual = new RandomMachine(seed);
            RandomMachine free = new RandomMachine(seed);
            free.engine.setWorkLimit(Long.MAX_VALUE);
            for (int k = 0; k < 120; k++) {
                usual.step();
                free.step();
            }
            assertThat(usual.engine.getRelievedSteps()).isZero();
            assertThat(usual.engine.getWork()).isEqualTo(free.engine.getWork()).isPositive();
            Checkpoint.assertSameBodies(usual.engine, free.engine);
        }
    }

    /** What flies beside a jam is on its parabola at the end of each step: the parts of a relieved step add up to a step. */
    @Test
    void timeGoesOnForAll() {
        Rope rope = limited();
        Body ball = rope.engine.add(new Body(new Circle(0.1)).at(50, 0).moving(3, 40, 2));
        for (int k = 1; k <= 100; k++) {
            rope.engine.step();
            double t = k / 60.0;
            assertThat(ball.getX()).isEqualTo(50 + 3 * t, within(1e-11));
            assertThat(ball.getY()).isEqualTo(40 * t - 0.5 * 9.81 * t * t, within(1e-11));
            assertThat(ball.getAngle()).isEqualTo(2 * t, within(1e-11));
        }
        assertThat(rope.engine.getRelievedSteps()).isPositive();
    }

    @Test
    void eventsAreFoundAgainWhenTheJamIsOver() {
        Rope rope = limited();
        Body floor = rope.engine.add(Body.fixed(new Rectangle(10, 1)).at(100, -0.5));
        Body ball = rope.engine.add(new Body(new Circle(0.5)).at(100, 2));
        rope.step(30);
        assertThat(rope.engine.getRelievedSteps()).isPositive();
        for (Body body : rope.engine.bodies()) {
            if (body != floor && body != ball) {
                rope.engine.remove(body);
            }
        }
        rope.step(300); // at most as many as it has been relieved for
        long relieved = rope.engine.getRelievedSteps();
        double energy = ball.kineticEnergy() + ball.getMass() * 9.81 * ball.getY();
        rope.step(600);
        assertThat(rope.engine.getRelievedSteps()).isEqualTo(relieved);
        assertThat(ball.kineticEnergy() + ball.getMass() * 9.81 * ball.getY()).isEqualTo(energy, within(1e-11 * energy));
    }

    @ParameterizedTest
    @ValueSource(longs = {50, 2_000, 20_000})
    void threadsGiveTheSameBits(long limit) {
        Rope one = new Rope(80, 0.02, 1.6);
        Rope two = new Rope(80, 0.02, 1.6);
        two.engine.setThreads(2);
        one.engine.setWorkLimit(limit);
        two.engine.setWorkLimit(limit);
        for (int k = 0; k < 60; k++) {
            one.engine.step();
            two.engine.step();
            assertThat(two.engine.getWork()).as("step %d", k).isEqualTo(one.engine.getWork());
            assertThat(two.engine.getRelievedSteps()).isEqualTo(one.engine.getRelievedSteps());
            Checkpoint.assertSameBodies(one.engine, two.engine);
        }
        assertThat(one.engine.getRelievedSteps()).isPositive();
    }

    @Test
    void aCheckpointGoesOnBitForBit() {
        Rope rope = limited();
        for (int k = 0; k < 40; k += 4) {
            rope.step(4);
            PhysicsEngine copy = Checkpoint.copy(rope.engine);
            PhysicsEngine original = Checkpoint.copy(rope.engine);
            for (int m = 0; m < 12; m++) {
                copy.step();
                original.step();
            }
            Checkpoint.assertSameBodies(original, copy);
            Rope other = rope;
            PhysicsEngine again = Checkpoint.copy(other.engine);
            for (int m = 0; m < 4; m++) {
                again.step();
            }
            rope.step(4);
            Checkpoint.assertSameBodies(rope.engine, again);
            assertThat(again.getWork()).isEqualTo(rope.engine.getWork());
            assertThat(again.getRelievedSteps()).isEqualTo(rope.engine.getRelievedSteps());
        }
        assertThat(rope.engine.getRelievedSteps()).isPositive();
    }

    /** Contacts, reactions and loads that break are those of the steps that were made. */
    @Test
    void whatIsReadAndWhatBreaksIsThatOfRelievedSteps() {
        Rope rope = limited();
        rope.step(60);
        assertThat(rope.engine.contacts()).hasSizeGreaterThan(10);
        PinJoint last = rope.pins.get(rope.pins.size() - 1);
        assertThat(rope.engine.getReaction(last).forceY()).isNotZero();
        last.setBreakingLoad(1, 1e9);
        rope.step(2);
        assertThat(rope.engine.contains(last)).isFalse();
    }

    @Test
    void whatAnAuthorSetsMeanwhileHolds() {
        Rope rope = limited();
        rope.step(20);
        assertThat(rope.engine.getRelievedSteps()).isPositive();
        assertThat(rope.engine.getTimeStepping()).isZero();
        assertThat(rope.engine.isAsleep(rope.light)).isFalse();
        rope.engine.setTimeStepping(4);
        long relieved = rope.engine.getRelievedSteps();
        rope.step(20);
        assertThat(rope.engine.getTimeStepping()).isEqualTo(4);
        assertThat(rope.engine.getRelievedSteps()).isEqualTo(relieved);
        rope.engine.setTimeStepping(0); // few substeps have left the rope open and in the cylinder: more of them close it first
        assertThat(rope.engine.getTimeStepping()).isZero();
        rope.step(10);
        assertThat(rope.engine.getRelievedSteps()).isGreaterThan(relieved);
    }

    @Test
    void auditedStepsAreByEventsWhateverTheyCost() {
        Rope rope = limited();
        rope.step(8);
        long relieved = rope.engine.getRelievedSteps();
        assertThat(relieved).isPositive();
        rope.engine.setAudited(true);
        rope.step(2);
        assertThat(rope.engine.getRelievedSteps()).isEqualTo(relieved);
    }

    @Test
    void theLimitIsSetBetweenStepsAndPositive() {
        PhysicsEngine engine = new PhysicsEngine();
        assertThat(engine.getWorkLimit()).isEqualTo(10_000_000);
        assertThatThrownBy(() -> engine.setWorkLimit(0)).isInstanceOf(IllegalArgumentException.class).hasMessageContaining("0");
        engine.add(new Body(new Circle(1)).moving(1, 0));
        engine.add(new Body(new Circle(1)).at(3, 0));
        List<RuntimeException> refused = new ArrayList<>();
        engine.addListener(new CollisionListener() {
            private static final long serialVersionUID = 1L;

            @Override
            public void collided(Contact contact) {
                try {
                    engine.setWorkLimit(5);
                } catch (IllegalStateException e) {
                    refused.add(e);
                }
            }
        });
        engine.step();
        engine.step();
        assertThat(refused).hasSize(1);
        assertThat(engine.getWorkLimit()).isEqualTo(10_000_400);
        assertThat(engine.getWork()).isPositive();
    }

    @Test
    void anyLimitIsBorne() {
        run(1, 12);
    }

    @Tag("soak")
    @Test
    void anyLimitIsBorneByFourHundred() {
        run(12, 400);
    }

    /** Random worlds that are relieved in a third of their steps, at any instant in them: nothing throws, leaves, or gets energy from nothing. */
    private static void run(int from, int to) {
        long relieved = 0;
        for (int seed = from; seed < to; seed++) {
            long limit = new long[] {5, 50, 500, 5000}[seed % 4];
            RandomMachine machine = new RandomMachine(seed);
            RandomScene scene = new RandomScene(seed, true);
            machine.engine.setWorkLimit(limit);
            scene.engine.setWorkLimit(limit);
            double energy = scene.engine.kineticEnergy();
            for (int k = 0; k < 200; k++) {
                machine.step();
                scene.impactsInStep = 0;
                scene.engine.step();
                for (Body body : machine.engine.bodies()) {
                    double speed = Math.hypot(body.getVelocityX(), body.getVelocityY());
                    boolean isIn = Math.abs(body.getX()) <= 11 && Math.abs(body.getY() - 9) <= 12 && speed < 60;
                    assertThat(isIn).as("seed %d, step %d, %s", seed, k, body).isTrue();
                }
                if (scene.passive) {
                    assertThat(scene.engine.kineticEnergy()).as("seed %d, step %d", seed, k).isLessThanOrEqualTo(1.02 * energy);
                }
            }
            relieved += machine.engine.getRelievedSteps() + scene.engine.getRelievedSteps();
        }
        assertThat(relieved).isGreaterThan(100 * (to - from));
    }

    /** A cart with two driven wheels, one of which is stopped: motors drive it against joints that are solved once more. */
    private static PhysicsEngine cart() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -9.81));
        engine.add(Body.fixed(new Rectangle(40, 1)).at(0, -0.5)).setFriction(1);
        Body trunk = engine.add(new Body(new Rectangle(1.5, 0.25)).at(0, 1));
        trunk.setFriction(1);
        for (int side = -1; side <= 1; side += 2) {
            Body wheel = engine.add(new Body(new Circle(0.3)).at(0.75 * side, 0.6));
            wheel.setMass(side < 0 ? 0.2 : 3);
            wheel.setFriction(1);
            engine.add(PinJoint.worldPoint(trunk, wheel, 0.75 * side, 1));
            engine.add(Motor.turning(trunk, wheel, 30 * side, 20));
            if (side > 0) {
                engine.add(Limit.angle(trunk, wheel, -0.5, 0.7));
            }
        }
        engine.setWorkLimit(1); // relieved from the start of the first step on
        return engine;
    }

    /** The engine that was saved goes on, too: it has what is made anew of what is saved in its copies. */
    @Test
    void whatWasSavedGoesOnAsItsCopy() {
        PhysicsEngine engine = cart();
        for (int k = 0; k < 200; k++) {
            PhysicsEngine copy = Checkpoint.copy(engine);
            engine.step();
            copy.step();
            assertThat(copy.getRelievedSteps()).isEqualTo(k + 1);
            Checkpoint.assertSameBodies(engine, copy);
        }
    }

    /** Joints are drawn together from the first relieved step on: else the cart would lose 1 cm of its wheels. */
    @Test
    void jointsAreRegained() {
        PhysicsEngine engine = cart();
        Body trunk = engine.bodies().get(1);
        for (int k = 0; k < 200; k++) {
            engine.step();
            for (int side = -1; side <= 1; side += 2) {
                Body wheel = engine.bodies().get(side < 0 ? 2 : 3);
                double c = Math.cos(trunk.getAngle());
                double s = Math.sin(trunk.getAngle());
                double hubX = wheel.getX() - Math.sin(wheel.getAngle()) * 0.4;
                double hubY = wheel.getY() + Math.cos(wheel.getAngle()) * 0.4;
                double gap = Math.hypot(trunk.getX() + 0.75 * side * c - hubX, trunk.getY() + 0.75 * side * s - hubY);
                assertThat(gap).as("step %d", k).isLessThan(4e-3); // 2.2 mm; 9.9 mm without
            }
        }
    }

    /** What lies under something ten times as heavy, in relieved steps of 0.9 s: with eight substeps in a part it was pressed in by 1.4 cm. */
    @Test
    void aHeavyBodyDoesNotPressALightOneIn() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.9);
        engine.setWorkLimit(1);
        engine.add(new Gravity(5, -10));
        engine.add(Body.fixed(new Rectangle(40, 2)).at(0, -1));
        engine.add(Body.fixed(new Rectangle(2, 40)).at(11, 10));
        engine.add(new Body(new Rectangle(1, 1)).at(9, 0.5)).setMass(1);
        engine.add(new Body(new Circle(0.5)).at(9, 1.52)).setMass(10);
        for (int k = 0; k < 30; k++) {
            engine.step();
        }
        assertThat(engine.getRelievedSteps()).isEqualTo(30);
        assertThat(engine.overlaps()).allMatch(overlap -> overlap.depth() < 5e-3);
    }
}
