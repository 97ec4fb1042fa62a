// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Time stepping: what authors change in mid-run is seen at once; units, steps and numbers that are none. */
class SteppedChangeTest {
    private static final double STEP = 1.0 / 60;

    @Test
    void connectedBodiesCollideFromWhenTheyAreTold() {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        Body a = engine.add(new Body(new Circle(0.5)));
        Body b = engine.add(new Body(new Circle(0.5)).at(0.8, 0));
        Limit rope = engine.add(Limit.rope(a, 0, 0, b, 0, 0, 3));
        Stepped.run(engine, 10);
        assertThat(b.getX() - a.getX()).as("let be").isCloseTo(0.8, within(1e-12));
        rope.setCollideConnected(true);
        Stepped.run(engine, 300);
        assertThat(b.getX() - a.getX()).as("parted").isCloseTo(1, within(1e-3));
        rope.setCollideConnected(false);
        b.setVelocity(a.getVelocityX() - 1, 0);
        Stepped.run(engine, 120);
        assertThat(b.getX() - a.getX()).as("passed through").isCloseTo(-1, within(1e-2));
    }

    @Test
    void filtersHoldFromTheNextStepOn() {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        engine.add(new Gravity(0, -Stepped.G));
        Body ground = Stepped.ground(engine);
        Body box = Stepped.rough(engine.add(new Body(new Rectangle(1, 1)).at(0, 0.5)));
        Stepped.run(engine, 60);
        for (boolean byGroup : new boolean[] {false, true}) {
            if (byGroup) {
                box.setCollisionGroup(2, 0);
            } else {
                engine.setCollisions(box, ground, false);
            }
            double from = box.getY();
            Stepped.run(engine, 30);
            assertThat(box.getY()).as("falls freely").isCloseTo(from - 0.5 * Stepped.G * 0.25, within(1e-3));
            assertThat(engine.contacts()).isEmpty();
            box.setCollisionGroup(1, -1);
            engine.setCollisions(box, ground, true);
            box.setPosition(0, 0.5);
            box.setVelocity(0, 0);
            Stepped.run(engine, 60);
            assertThat(box.getY()).as("lies").isCloseTo(0.5, within(1e-3));
        }
    }

    /** A drop from 1 reaches e², but for an error of first order in the step: v h / 2 of the way, v the speed of the impact. */
    @ParameterizedTest
    @ValueSource(doubles = {0.5, 0.8, 1})
    void bouncesReachTheirHeightToTheFirstOrder(double restitution) {
        for (int rate : new int[] {60, 120, 240, 480, 960}) {
            PhysicsEngine engine = Stepped.engine(1.0 / rate, 4);
            engine.add(new Gravity(0, -Stepped.G));
            Body ground = engine.add(Body.fixed(new Rectangle(10, 1)).at(0, -0.5));
            ground.setRestitution(restitution);
            Body ball = engine.add(new Body(new Circle(0.1)).at(0, 1.1));
            ball.setRestitution(restitution);
            double top = 0;
            boolean hasMet = false;
            for (int k = 0; k < 1.2 * rate; k++) {
                engine.step();
                hasMet |= ball.getVelocityY() > 0;
                top = hasMet ? Math.max(top, ball.getY() - 0.1) : 0;
            }
            double square = restitution * restitution;
            assertThat(top).isCloseTo(square, within(0.5 * Math.sqrt(2 * Stepped.G) / rate * square));
        }
    }

    /** A machine that jams, and a pile, in units of length and time that are powers of two: the same bits. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4})
    void unitsThatArePowersOfTwoChangeNoBit(int seed) {
        assertThat(scaled(seed, 4, 2)).isEqualTo(scaled(seed, 1, 1));
    }

    private static List<Double> scaled(int seed, double length, double time) {
        SplittableRandom random = new SplittableRandom(seed);
        PhysicsEngine engine = Stepped.engine(time / 32, 1 + seed);
        engine.add(new Gravity(0, -Stepped.G * length / (time * time)));
        Stepped.rough(engine.add(Body.fixed(new Rectangle(20 * length, length)).at(0, -0.5 * length)));
        List<Body> bodies = new ArrayList<>();
        for (int k = 0; k < 16; k++) {
            double size = 0.2 + 0.3 * random.nextDouble();
            Body body = engine.add(new Body(k % 2 == 0 ? new Circle(size * length) : new Rectangle(size * length, size * length))
                    .at(length * (4 * random.nextDouble() - 2), length * (1 + 0.6 * k), random.nextDouble()));
            body.setMass(k % 3 == 0 ? 100 : size);
            body.setFriction(0.5);
            body.setRestitution(seed % 2 == 0 ? 0 : 0.7);
            bodies.add(body);
        }
        for (int k = 0; k < 6; k++) {
            Body a = bodies.get(k);
            Body b = bodies.get(k + 1 + random.nextInt(4));
            switch (k % 3) {
                case 0 -> engine.add(new PinJoint(a, b, a.getX(), a.getY()));
                case 1 -> engine.add(new WeldJoint(a, b, b.getX(), b.getY()));
                default -> {
                    SliderJoint rail = engine.add(new SliderJoint(a, b, a.getX(), a.getY(), 1, 0.5));
                    engine.add(Motor.sliding(rail, length / time, 5 * length / (time * time)));
                }
            }
        }
        Stepped.run(engine, 300);
        List<Double> all = new ArrayList<>();
        for (Body body : bodies) {
            all.addAll(List.of(body.getX() / length, body.getY() / length, body.getAngle()));
            all.addAll(List.of(body.getVelocityX() / length * time, body.getAngularVelocity() * time));
        }
        return all;
    }

    @Test
    void numbersThatAreNoneAreRefused() {
        PhysicsEngine engine = Stepped.engine(STEP, 4);
        Body body = engine.add(new Body(new Circle(1)));
        assertThatThrownBy(() -> body.setVelocity(Double.NaN, 0)).isInstanceOf(IllegalArgumentException.class);
        engine.add((ForceGenerator) (b, time, forces) -> forces.add(b, time > 0.1 ? Double.NaN : 1, 0));
        assertThatThrownBy(() -> Stepped.run(engine, 30)).hasMessageContaining("NaN");
        assertThat(body.getX()).isFinite();
    }

    /** Events go on after any number of steps. From 64 steps on, what bounced fell through the floor for ever. */
    @ParameterizedTest
    @ValueSource(ints = {1, 63, 64, 65, 128, 150, 1000})
    void eventsGoOnAfterwards(int steps) {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        engine.add(new Gravity(0, -Stepped.G));
        engine.add(Body.fixed(new Rectangle(100, 1)).at(0, -0.5));
        Body ball = engine.add(new Body(new Circle(0.2)).at(0, 1));
        Body other = engine.add(new Body(new Circle(0.2)).at(0.1, 2));
        Stepped.run(engine, steps);
        engine.setTimeStepping(0);
        for (int k = 0; k < 300; k++) {
            engine.step();
            assertThat(ball.getY()).isGreaterThan(0.19);
            assertThat(other.getY()).isGreaterThan(0.19);
        }
    }

    /** A stack stands in steps that are sixteen times as long and as short by turns. It flew apart at 8 m/s. */
    @Test
    void aStackStandsInStepsOfAnyLength() {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        engine.setSleepAllowed(false);
        engine.add(new Gravity(0, -Stepped.G));
        Stepped.rough(engine.add(Body.fixed(new Rectangle(100, 1)).at(0, -0.5)));
        Body top = null;
        for (int k = 0; k < 6; k++) {
            top = engine.add(Stepped.rough(new Body(new Rectangle(0.5, 0.5)).at(0, 0.25 + 0.5 * k)));
        }
        Stepped.run(engine, 240);
        for (int k = 0; k < 400; k++) {
            engine.setTimeStep(k % 2 == 0 ? 1.0 / 480 : 1.0 / 30);
            engine.step();
            assertThat(Stepped.fastest(engine)).as("step %d", k).isLessThan(0.6);
        }
        assertThat(top.getY()).isCloseTo(2.75, within(0.05));
        assertThat(top.getX()).isCloseTo(0, within(0.05));
    }
}
