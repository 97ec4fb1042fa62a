// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Time stepping does not depend on units, on what is left and right, or on how many there are. */
class SteppedScaleTest {
    /** Bodies that fall on the ground, some of them pinned together, with lengths and times in other units. */
    private static PhysicsEngine scene(double length, double time, int bodies, int hand) {
        PhysicsEngine engine = Stepped.engine(time / 64, 4);
        engine.add(new Gravity(0, -Stepped.G * length / time / time));
        engine.add(Body.fixed(new Rectangle(4096 * length, 2 * length)).at(0, -length)).setFriction(0.5);
        SplittableRandom random = new SplittableRandom(3);
        for (int k = 0; k < bodies; k++) {
            Body body = new Body(k % 2 == 0 ? new Circle(0.5 * length) : new Rectangle(length, 0.75 * length));
            body.at(hand * (k % 10 - 4.5) * 1.25 * length, (1 + k / 10 * 1.25) * length, hand * 6 * random.nextDouble());
            body.moving(
                    hand * (random.nextDouble() - 0.5) * length / time,
                    (random.nextDouble() - 0.5) * length / time,
                    hand * (random.nextDouble() - 0.5) / time);
            body.setFriction(0.5);
            body.setRestitution(0.25);
            engine.add(body);
            if (k % 7 == 3) {
                Body other = engine.bodies().get(k);
                engine.add(new PinJoint(body, other, (body.getX() + other.getX()) / 2, (body.getY() + other.getY()) / 2));
            }
        }
        return engine;
    }

    /** Units that differ by powers of two change no bit. */
    @ParameterizedTest
    @CsvSource({"1024, 1", "0.0009765625, 1", "1, 16", "8, 0.25"})
    void unitsChangeNothing(double length, double time) {
        PhysicsEngine engine = scene(1, 1, 70, 1);
        PhysicsEngine other = scene(length, time, 70, 1);
        Stepped.run(engine, 400);
        Stepped.run(other, 400);
        assertThat(engine.getImpacts()).isEqualTo(other.getImpacts()).isGreaterThan(100);
        for (int k = 0; k < engine.bodies().size(); k++) {
            assertThat(other.bodies().get(k).getX()).isEqualTo(length * engine.bodies().get(k).getX());
            assertThat(other.bodies().get(k).getY()).isEqualTo(length * engine.bodies().get(k).getY());
            assertThat(other.bodies().get(k).getAngle()).isEqualTo(engine.bodies().get(k).getAngle());
        }
    }

    /** How often joints are solved as something bounces depends on lengths and angles alike, whatever the unit of length is. */
    @ParameterizedTest
    @ValueSource(doubles = {0x1p-10, 0x1p10})
    void whatSlidesAndBouncesDoesSoInAnyUnit(double length) {
        PhysicsEngine engine = slides(1);
        PhysicsEngine other = slides(length);
        for (int k = 0; k < 60; k++) {
            engine.step();
            other.step();
            for (int m = 0; m < 4; m++) {
                assertThat(other.bodies().get(m).getY() / length).isCloseTo(engine.bodies().get(m).getY(), within(1e-11));
            }
        }
        assertThat(engine.getImpacts()).isGreaterThan(0);
    }

    private static PhysicsEngine slides(double length) {
        PhysicsEngine engine = Stepped.engine(1.0 / 64, 4);
        engine.add(new Gravity(0, -Stepped.G * length));
        engine.add(Body.fixed(new Rectangle(64 * length, 2 * length)).at(0, -length));
        Body[] boxes = new Body[3];
        for (int k = 0; k < boxes.length; k++) {
            boxes[k] = engine.add(new Body(new Rectangle(length, 0.5 * length)).at(1.5 * k * length, (1 + 0.5 * k) * length, 0.25 + k));
            boxes[k].setRestitution(0.75);
        }
        engine.add(new SliderJoint(boxes[0], boxes[1], 0.75 * length, length, 1, 0.5));
        engine.add(new WeldJoint(boxes[1], boxes[2], 2.25 * length, 1.75 * length));
        return engine;
    }

    /** Left and right: the same where no pair has two points, which are solved one after the other. */
    @Test
    void theMirrorImageOfDiscsMovesLikeThem() {
        PhysicsEngine engine = discs(1);
        PhysicsEngine mirrored = discs(-1);
        Stepped.run(engine, 200);
        Stepped.run(mirrored, 200);
        assertThat(engine.getImpacts()).isGreaterThan(50);
        for (int k = 0; k < engine.bodies().size(); k++) {
            assertThat(mirrored.bodies().get(k).getX()).isCloseTo(-engine.bodies().get(k).getX(), within(1e-9));
            assertThat(mirrored.bodies().get(k).getY()).isCloseTo(engine.bodies().get(k).getY(), within(1e-9));
        }
    }

    private static PhysicsEngine discs(int side) {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        engine.add(new Gravity(0, -9.81));
        engine.add(Body.fixed(new Rectangle(40, 2)).at(0, -1)).setFriction(0.5);
        for (int k = 0; k < 20; k++) {
            Body disc = engine.add(new Body(new Circle(0.3 + 0.02 * (k % 7))));
            disc.at(side * (1.1 * (k % 5) + 0.1 * k), 1 + 1.1 * (k / 5), 0).moving(side * (k % 3 - 0.7), 0, side * 0.1 * k);
            disc.setFriction(0.5);
            disc.setRestitution(0.3);
        }
        return engine;
    }

    /** What is too heavy for one solution a substep sinks into what bears it; it gets no more energy than its fall gives. */
    @Test
    void aMillionTimesTheMassMakesNoNonsense() {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        Body[] stack = Stepped.stack(engine, 3);
        stack[2].setMass(1e6);
        for (int k = 0; k < 600; k++) {
            engine.step();
            assertThat(Math.hypot(stack[2].getVelocityX(), stack[2].getVelocityY())).isLessThan(Math.sqrt(2 * Stepped.G * 2.5));
            for (Body body : stack) {
                assertThat(body.getY()).isBetween(-1.0, 4.0);
            }
        }
    }

    @Test
    void aLightBodyRestsOnAHeavyOne() {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        Body[] stack = Stepped.stack(engine, 2);
        stack[0].setMass(1e6);
        Stepped.run(engine, 300);
        assertThat(stack[1].getY()).isCloseTo(1.5, within(1e-3));
        assertThat(engine.contacts(stack[1]).get(0).forceY(stack[1])).isCloseTo(Stepped.G, within(1e-3));
    }

    @Test
    void threeThousandBodiesComeToLie() {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 2);
        engine.add(new Gravity(0, -Stepped.G));
        Stepped.ground(engine);
        for (int k = 0; k < 3000; k++) {
            Stepped.rough(engine.add(new Body(new Rectangle(0.4, 0.3)).at(0.5 * (k % 1000) - 250, 0.16 + 0.35 * (k / 1000))));
        }
        Stepped.run(engine, 120);
        assertThat(engine.contacts()).hasSize(3000);
        assertThat(Stepped.fastest(engine)).isLessThan(0.01);
        assertThat(engine.queries().nearest(0, 0.2, 3, null)).hasSize(3);
    }

    /** Questions that are put after a step are about where the bodies are then. */
    @Test
    void questionsAreAboutWhereBodiesAre() {
        PhysicsEngine engine = Stepped.engine(0.1, 4);
        Body body = engine.add(new Body(new Circle(0.5)).moving(10, 0));
        for (int k = 1; k < 20; k++) {
            engine.step();
            List<Body> there = engine.queries().within(k, 0, 0.1, null);
            assertThat(there).containsExactly(body);
            assertThat(engine.queries().within(k + 1, 0, 0.1, null)).isEmpty();
        }
    }
}
