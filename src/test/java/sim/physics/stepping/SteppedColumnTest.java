// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.KinematicBody;
import sim.physics.response.LastingContact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Columns by time stepping: solved in turns, those of unlike bodies sprang apart, and high ones fell. */
class SteppedColumnTest {
    private static final double G = Stepped.G;

    private void stands(PhysicsEngine engine, Body[] stack, double[] x, int steps) {
        Stepped.run(engine, steps);
        assertThat(Stepped.depth(engine)).isLessThan(3e-4);
        double above = 0;
        for (int k = stack.length - 1; k >= 0; k--) {
            above += stack[k].getMass();
            assertThat(stack[k].getX()).as("box %d", k).isCloseTo(x[k], within(5e-3));
            assertThat(stack[k].getAngle()).as("box %d", k).isCloseTo(0, within(1e-3));
            double borne = 0;
            for (LastingContact contact : engine.contacts(stack[k])) {
                borne += Math.max(0, contact.forceY(stack[k]));
            }
            assertThat(borne).as("what bears box %d", k).isCloseTo(above * G, within(1e-3 * above * G));
        }
        assertThat(Stepped.fastest(engine)).isLessThan(1e-5);
    }

    /** Unit squares on one another from a height on, each off by up to 0.01: their places are noted. */
    private static Body[] likeBoxes(PhysicsEngine engine, double ground, double[] x) {
        Random random = new Random(x.length);
        Body[] stack = new Body[x.length];
        for (int k = 0; k < x.length; k++) {
            x[k] = 0.02 * (random.nextDouble() - 0.5);
            stack[k] = Stepped.box(engine, 1, 1, 1, x[k], ground + k + 0.5);
        }
        return stack;
    }

    /** Boxes of many sizes, with masses over two decades: of two hundred such columns 43 fell, some with 27 m/s. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8})
    void unlikeBoxesStand(int seed) {
        PhysicsEngine engine = Stepped.onGround(1.0 / 60, 4);
        Random random = new Random(seed);
        double[] x = new double[8 + random.nextInt(16)];
        Body[] stack = new Body[x.length];
        double y = 0;
        for (int k = 0; k < stack.length; k++) {
            double height = 0.3 + 0.5 * random.nextDouble();
            x[k] = 0.1 * (random.nextDouble() - 0.5);
            stack[k] = Stepped.box(engine, 0.8 + 0.6 * random.nextDouble(), height, Math.pow(10, 2 * random.nextDouble() - 1), x[k], y + height / 2);
            y += height;
        }
        stands(engine, stack, x, 300);
    }

    /** Boxes of one kind, none quite above the other: solved in turns, forty fell, and without friction ten. */
    @ParameterizedTest
    @CsvSource({"5, 0.5", "10, 0", "40, 0.5", "40, 0", "100, 0.5"})
    void likeBoxesStand(int count, double friction) {
        PhysicsEngine engine = Stepped.onGround(1.0 / 60, 4);
        double[] x = new double[count];
        Body[] stack = likeBoxes(engine, 0, x);
        for (Body box : stack) {
            box.setFriction(friction);
        }
        stands(engine, stack, x, 600);
        assertThat(Stepped.depth(engine)).isLessThan(1e-6);
    }

    /** Columns beside one another, a thousandth apart, which touch now and then: they leant on one another, and fell. */
    @Test
    void columnsStandBesideOneAnother() {
        PhysicsEngine engine = Stepped.onGround(1.0 / 60, 4);
        Body[][] stacks = new Body[4][12];
        for (int c = 0; c < stacks.length; c++) {
            for (int k = 0; k < stacks[c].length; k++) {
                stacks[c][k] = Stepped.box(engine, 1, 1, 1, 1.001 * c, k + 0.5);
            }
        }
        Stepped.run(engine, 600);
        for (int c = 0; c < stacks.length; c++) {
            for (int k = 0; k < stacks[c].length; k++) {
                assertThat(stacks[c][k].getX()).as("box %d of %d", k, c).isCloseTo(1.001 * c, within(1e-4));
                assertThat(stacks[c][k].getY()).as("box %d of %d", k, c).isCloseTo(k + 0.5, within(1e-4));
            }
        }
    }

    /** Columns on a lift that goes up and down, and to and fro: within its acceleration they go with it. Twelve boxes leant by 0.15, and thirty fell. */
    @ParameterizedTest
    @ValueSource(ints = {3, 12, 30})
    void columnsGoWithALift(int count) {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        engine.add(new Gravity(0, -Stepped.G));
        KinematicBody lift = engine.add(new KinematicBody(new Rectangle(10, 1)));
        Stepped.rough(lift);
        double[] x = new double[count];
        Body[] stack = likeBoxes(engine, 0.5, x);
        for (int step = 0; step < 600; step++) {
            double time = engine.getTime() + 1.0 / 120;
            lift.setTargetVelocity(0.1 * StrictMath.sin(2 * time), 0.3 * StrictMath.sin(3 * time), 0);
            engine.step();
        }
        for (int k = 0; k < count; k++) {
            assertThat(stack[k].getX()).as("box %d", k).isCloseTo(x[k] + lift.getX(), within(1e-3));
            assertThat(stack[k].getY()).as("box %d", k).isCloseTo(k + 1 + lift.getY(), within(1e-4));
        }
    }

    /** A box that five times its mass lies on: it was pressed in by 0.5 mm, which is ten times as much. */
    @Test
    void whatIsSomeTimesAsHeavyPressesNothingIn() {
        PhysicsEngine engine = Stepped.onGround(1.0 / 60, 4);
        Stepped.box(engine, 1, 1, 1, 0, 0.5);
        Stepped.box(engine, 1, 1, 5, 0, 1.5);
        Stepped.run(engine, 200);
        assertThat(Stepped.depth(engine)).isLessThan(1e-4);
    }

    /** Friction of what rests is within Coulomb's bound, also where bodies are solved at once: what it held alone had some that nothing pressed for. */
    @ParameterizedTest
    @ValueSource(ints = {35, 38, 103, 251, 390})
    void frictionIsBoundByWhatPresses(int seed) {
        PhysicsEngine engine = Stepped.onGround(1.0 / 60, 4);
        Random random = new Random(seed);
        Stepped.rough(engine.add(Body.fixed(new Rectangle(0.4, 6)).at(-1.2, 3)));
        Stepped.rough(engine.add(Body.fixed(new Rectangle(0.4, 6)).at(1.2, 3)));
        for (int k = 0; k < 7; k++) {
            double size = 0.4 + 0.3 * random.nextDouble();
            Shape shape = k % 2 == 0 ? new Circle(size / 2) : new Rectangle(size, 0.8 * size);
            Body body = Stepped.rough(engine.add(new Body(shape).at(0.3 * random.nextGaussian(), 0.6 + 0.8 * k, random.nextDouble())));
            body.setMass(Math.pow(10, 1.5 * random.nextDouble()));
        }
        Stepped.run(engine, 200);
        for (int k = 0; k < 100; k++) {
            engine.step();
            for (LastingContact contact : engine.contacts()) {
                double most = 0.5 * contact.normalForce();
                assertThat(Math.abs(contact.tangentForce())).as("step %d: %s", k, contact).isLessThanOrEqualTo(most + 1e-3 * (1 + most));
            }
        }
    }
}
