// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.collision.Overlap;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Spring;
import sim.physics.motion.SurfaceFriction;
import sim.physics.shape.Circle;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;

/** Time stepping in the life of an engine: switched on and off, saved, refused, with bodies that come and go. */
class SteppedLifeTest {
    private static final double STEP = 1.0 / 60;

    /** A bin with a heap, a chain, a wheel with a motor, a rail with stops and a spring; on a plane, or under gravity. */
    private static PhysicsEngine scene(boolean isPlane) {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        if (isPlane) {
            engine.add(new SurfaceFriction(Stepped.G));
        } else {
            engine.add(new Gravity(0, -Stepped.G));
        }
        SteppedHeapTest.bin(engine, 10);
        SplittableRandom random = new SplittableRandom(3);
        for (int k = 0; k < 40; k++) {
            Body body = engine.add(new Body(k % 2 == 0 ? new Circle(0.4) : Polygon.regular(3 + k % 5, 0.5)));
            body.at(1.2 * (k % 8) - 8, 1.2 * (k / 8) - 9, 6 * random.nextDouble());
            body.moving(4 * random.nextDouble() - 2, 4 * random.nextDouble() - 2);
            Stepped.rough(body).setSurfaceFriction(0.1);
        }
        Body last = null;
        for (int k = 0; k < 6; k++) {
            Body link = engine.add(new Body(new Rectangle(1, 0.2)).at(k, 6));
            engine.add(last == null ? new PinJoint(link, -0.5, 6) : new PinJoint(last, link, k - 0.5, 6));
            last = link;
        }
        Body wheel = engine.add(new Body(new Circle(0.8)).at(-5, 6));
        engine.add(new PinJoint(wheel, -5, 6));
        engine.add(Motor.turning(wheel, null, 3, 100));
        Body cart = engine.add(new Body(new Rectangle(1, 0.5)).at(-2, 8.5));
        SliderJoint rail = engine.add(new SliderJoint(cart, null, -2, 8.5, 1, 0));
        engine.add(Limit.travel(rail, -3, 3));
        engine.add(new Spring(cart, 0, 0, wheel, 0, 0, 2, 5, 0.5));
        cart.setVelocity(2, 0);
        return engine;
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aRestoredEngineGoesOnToTheLastBit(boolean isPlane) {
        PhysicsEngine engine = scene(isPlane);
        for (int k = 0; k < 5; k++) {
            Stepped.run(engine, 37);
            PhysicsEngine restored = Checkpoint.copy(engine);
            PhysicsEngine further = Checkpoint.copy(engine);
            for (int m = 0; m < 40; m++) {
                further.step();
                restored.step();
                assertThat(Scenes.hash(restored)).isEqualTo(Scenes.hash(further));
            }
            Stepped.run(engine, 40);
            assertThat(Scenes.hash(restored)).isEqualTo(Scenes.hash(engine));
        }
    }

    @Test
    void equalScenesGiveEqualBits() {
        PhysicsEngine one = scene(false);
        PhysicsEngine other = scene(false);
        Stepped.run(one, 500);
        Stepped.run(other, 500);
        assertThat(Scenes.hash(other)).isEqualTo(Scenes.hash(one));
    }

    /** From one way to the other and back: bodies go on from where they are, nothing gets out, and events are found as ever. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theTwoWaysMayTakeTurns(boolean isPlane) {
        PhysicsEngine engine = scene(isPlane);
        for (int turn = 0; turn < 8; turn++) {
            engine.bodies().get(10).addForce(3, 1);
            Stepped.run(engine, 60);
            engine.bodies().get(11).addForce(3, 1);
            engine.setTimeStepping(0);
            assertThat(engine.getTimeStepping()).isZero();
            double before = Stepped.depth(engine);
            for (int k = 0; k < 30; k++) {
                engine.step();
                for (Overlap overlap : engine.overlaps()) {
                    assertThat(overlap.depth()).as("%s, turn %d, step %d", overlap, turn, k).isLessThan(before + 0.005);
                }
            }
            engine.setTimeStepping(1 + turn);
        }
        for (Body body : engine.bodies()) {
            assertThat(Math.max(Math.abs(body.getX()), Math.abs(body.getY()))).isLessThan(12);
        }
    }

    /** What bears nothing has a force of 0, not of a rounding below it, whoever finds it and whoever did so before. */
    @Test
    void noContactPulls() {
        for (int seed = 24; seed < 28; seed++) {
            SplittableRandom random = new SplittableRandom(seed);
            PhysicsEngine engine = Stepped.engine(STEP, 4);
            engine.add(new Gravity(0, -Stepped.G));
            double restitution = 0.3 * random.nextInt(3);
            double friction = 0.3 * random.nextInt(3);
            Body[] walls = {null, Body.fixed(new Rectangle(22, 1)).at(0, -0.5),
                Body.fixed(new Rectangle(1, 22)).at(-4.5, 10), Body.fixed(new Rectangle(1, 22)).at(4.5, 10)};
            for (int k = 1; k < 24; k++) {
                Body body = k < 4 ? walls[k]
                        : new Body(k % 2 == 0 ? new Circle(0.2 + 0.4 * random.nextDouble()) : new Rectangle(0.3 + random.nextDouble(), 0.5))
                                .at(1.3 * (k % 5) - 2.6, 1 + 1.3 * (k / 5), 6 * random.nextDouble());
                body.setRestitution(restitution);
                body.setFriction(friction);
                engine.add(body);
            }
            for (int k = 1; k < 240; k++) {
                if (k % 40 == 0) {
                    engine.setTimeStepping(4 - engine.getTimeStepping());
                }
                engine.step();
                assertThat(engine.contacts()).as("seed %d, step %d", seed, k).allMatch(contact -> contact.normalForce() >= 0);
            }
        }
    }

    @Test
    void nothingOfAnEarlierTimeIsRemembered() {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        Body[] stack = Stepped.stack(engine, 2);
        PinJoint pin = engine.add(new PinJoint(engine.add(new Body(new Circle(1)).at(20, 20)), 20, 21));
        Stepped.run(engine, 100);
        engine.setTimeStepping(0);
        stack[1].setPosition(50, 50);
        Stepped.run(engine, 2);
        engine.setTimeStepping(4);
        assertThat(engine.contacts()).isEmpty();
        assertThat(engine.getReaction(pin).forceY()).isCloseTo(Math.PI * Stepped.G, within(1e-6));
    }

    @Test
    void aForceActsOnceAlsoIfTheWayIsChanged() {
        for (boolean isStepped : new boolean[] {true, false}) {
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(0.5);
            engine.setTimeStepping(isStepped ? 3 : 0);
            Body body = engine.add(new Body(new Circle(1)));
            body.setMass(1);
            engine.step();
            body.addForce(2, 0);
            engine.setTimeStepping(isStepped ? 0 : 3);
            for (int k = 0; k < 3; k++) {
                engine.step();
                assertThat(body.getVelocityX()).isCloseTo(1, within(1e-15));
                engine.setTimeStepping(engine.getTimeStepping() == 0 ? 2 : 0);
            }
        }
    }

    @Test
    void whatCannotBeIsRefusedAndChangesNothing() {
        PhysicsEngine engine = scene(false);
        Stepped.run(engine, 10);
        PhysicsEngine twin = Checkpoint.copy(engine);
        assertThatThrownBy(() -> engine.setTimeStepping(-1))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("-1");
        assertThatThrownBy(() -> engine.setTimeStep(-1)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> engine.setAudited(true))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("setTimeStepping(0)");
        assertThat(engine.getTimeStepping()).isEqualTo(4);
        Stepped.run(engine, 50);
        Stepped.run(twin, 50);
        assertThat(Scenes.hash(engine)).isEqualTo(Scenes.hash(twin));
        engine.setTimeStepping(0);
        engine.setAudited(true);
        assertThatThrownBy(() -> engine.setTimeStepping(4))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("setAudited(false)");
        assertThat(engine.getTimeStepping()).isZero();
        engine.step();
    }

    @Test
    void aTimeStepOfZeroChangesNothing() {
        PhysicsEngine engine = scene(false);
        Stepped.run(engine, 30);
        long before = Scenes.hash(engine);
        long steps = engine.getSteps();
        engine.setTimeStep(0);
        Stepped.run(engine, 3);
        assertThat(Scenes.hash(engine)).isEqualTo(before);
        assertThat(engine.getSteps()).isEqualTo(steps);
    }

    @Test
    void aBodyThatTakesTheBlockOfOneThatLeftHasNoneOfItsContacts() {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        Body[] stack = Stepped.stack(engine, 2);
        Stepped.run(engine, 60);
        engine.remove(stack[1]);
        Body other = engine.add(new Body(new Circle(1)).at(50, 50));
        assertThat(other.index()).isEqualTo(2);
        assertThat(engine.contacts(other)).isEmpty();
        assertThat(engine.contacts()).hasSize(1);
        engine.step();
        assertThat(engine.contacts(stack[0])).hasSize(1);
    }

    /** A grid takes over from brute force on the way; a step costs no memory either way. */
    @ParameterizedTest
    @ValueSource(ints = {30, 200})
    void aSteadyStepAllocatesNothing(int bodies) {
        for (boolean isPlane : new boolean[] {false, true}) {
            PhysicsEngine engine = scene(isPlane);
            for (int k = 0; k < bodies; k++) {
                Stepped.rough(engine.add(new Body(new Circle(0.2)).at(0.5 * (k % 36) - 9, 0.5 * (k / 36) + 1))).setSurfaceFriction(0.1);
            }
            Stepped.run(engine, 600);
            ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
            long least = Long.MAX_VALUE;
            for (int window = 0; window < 25; window++) {
                long before = threads.getCurrentThreadAllocatedBytes();
                Stepped.run(engine, 20);
                least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
            }
            assertThat(least).as("bytes in 20 steps").isZero();
        }
    }

    /** The same bodies, added one by one beyond the number from which a grid finds the pairs, or in another order of pairs. */
    @Test
    void noPairIsFoundTwiceWhenTheGridTakesOver() {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        engine.add(new Gravity(0, -Stepped.G));
        Stepped.ground(engine);
        for (int k = 0; k < 120; k++) {
            Stepped.rough(engine.add(new Body(new Rectangle(1, 1)).at(0.999 * 2 * (k / 2), 0.5 + k % 2)));
            if (k % 10 == 0) {
                engine.step();
            }
        }
        Stepped.run(engine, 300);
        assertThat(engine.contacts()).hasSize(120);
        for (Body body : engine.bodies()) {
            double up = 0;
            for (var contact : engine.contacts(body)) {
                up += contact.forceY(body);
            }
            assertThat(body.isFixed() ? up / 120 : up).isCloseTo(body.isFixed() ? -10 : 10, within(1e-2));
        }
    }

    /** Bodies that share a place are parted, and nothing of them is no number. */
    @Test
    void bodiesThatWerePutIntoOneAnotherPart() {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        for (int k = 0; k < 3; k++) {
            Stepped.rough(engine.add(new Body(new Circle(1)).at(0, 0)));
            Stepped.rough(engine.add(new Body(new Rectangle(1, 1)).at(10, 0)));
            Stepped.rough(engine.add(new Body(k == 0 ? new Rectangle(4, 4) : Polygon.regular(3, 0.3)).at(20, 0.1 * k)));
        }
        double size = 4;
        for (int k = 0; k < 600; k++) {
            engine.step();
            for (Body body : engine.bodies()) {
                assertThat(Double.isFinite(body.getX() + body.getY() + body.getAngle())).isTrue();
                assertThat(Math.hypot(body.getVelocityX(), body.getVelocityY())).isLessThan(20 * size);
            }
        }
        assertThat(Stepped.depth(engine)).isLessThan(0.02);
        double[] p = Stepped.momentum(engine);
        assertThat(Math.hypot(p[0], p[1])).isLessThan(1e-9);
    }

    /** What bounces off a fixed body met the velocity of what had moved in its place. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aFixedBodyThatComesInThePlaceOfAMovingOneStands(boolean hasTurned) {
        double[] heights = new double[2];
        for (int run = 0; run < 2; run++) {
            PhysicsEngine engine = Stepped.engine(1.0 / 64, 4);
            engine.add(new Gravity(0, -10));
            engine.add(Body.fixed(new Rectangle(20, 1)).at(0, -100.5));
            Body before = engine.add(new Body(new Rectangle(0.5, 1)).at(0, run == 0 ? 50 : -98));
            before.setVelocity(0, run == 0 ? 0 : -30);
            before.setAngularVelocity(run == 1 && hasTurned ? 5 : 0);
            Stepped.run(engine, 4);
            engine.remove(before);
            engine.add(Body.fixed(new Rectangle(20, 1)).at(0, -0.5));
            Body ball = engine.add(new Body(new Circle(0.5)).at(0.1, 1.5));
            Stepped.run(engine, 60);
            heights[run] = ball.getY();
        }
        assertThat(heights[1]).isEqualTo(heights[0]);
    }

    /** Forces on what was there pulled at a fixed body that came in its place, and friction with a plane that has been taken away still rubbed. */
    @ParameterizedTest
    @ValueSource(ints = {1, 3})
    void nothingIsLeftOfASceneThatHasBeenRemoved(int substeps) {
        double[][] places = new double[2][];
        for (int run = 0; run < 2; run++) {
            PhysicsEngine engine = Stepped.engine(1.0 / 64, substeps);
            Gravity old = engine.add(new Gravity(3, -7));
            SurfaceFriction plane = engine.add(new SurfaceFriction(5));
            Body[] before = new Body[4];
            for (int k = 0; k < 4; k++) {
                Circle disc = new Circle(0.5);
                before[k] = run == 0 ? Body.fixed(disc) : new Body(disc);
                before[k].setSurfaceFriction(0.2);
                engine.add(before[k].at(50 + 3 * k, 0));
            }
            Stepped.run(engine, 10);
            for (int k = 3; k >= 0; k--) {
                engine.remove(before[k]);
            }
            engine.remove(plane);
            engine.remove(old);
            engine.add(new Gravity(0.3, -5));
            Body floor = engine.add(Body.fixed(new Rectangle(24, 2)).at(0, -9));
            Body far = engine.add(new Body(new Rectangle(0.9, 1.3)).at(-7, -6, 2));
            far.setVelocity(2, -1);
            Body ball = engine.add(new Body(new Circle(0.5)).at(5, -7));
            engine.add(Limit.rope(far, 0, 0, floor, 0, 0, 4)); // it is too long already, and brought back
            Stepped.run(engine, 60);
            places[run] = new double[] {far.getX(), far.getY(), far.getAngle(), ball.getX(), ball.getY(), ball.getVelocityX()};
        }
        assertThat(places[1]).containsExactly(places[0]);
    }
}
