// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static sim.physics.stepping.Frames.G;
import static sim.physics.stepping.Frames.bar;
import static sim.physics.stepping.Frames.falling;
import static sim.physics.stepping.Frames.pin;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.GearJoint;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Time stepping: joints with loops that nothing touches are solved at once, too. In turns, scissor lifts fell through, and bridges sagged by as much as they were high. */
class SteppedLoopTest {
    private static double energy(PhysicsEngine engine) {
        double energy = engine.kineticEnergy();
        for (Body body : engine.bodies()) {
            energy += body.getMass() * G * body.getY();
        }
        return energy;
    }

    private static double widest(List<PinJoint> pins) {
        double widest = 0;
        for (PinJoint pin : pins) {
            Body a = pin.getBodyA();
            Body b = pin.getBodyB();
            double x = b == null ? pin.getAnchorBX() : b.worldX(pin.getAnchorBX(), pin.getAnchorBY());
            double y = b == null ? pin.getAnchorBY() : b.worldY(pin.getAnchorBX(), pin.getAnchorBY());
            double ax = a.worldX(pin.getAnchorAX(), pin.getAnchorAY());
            double ay = a.worldY(pin.getAnchorAX(), pin.getAnchorAY());
            widest = Math.max(widest, Math.hypot(ax - x, ay - y));
        }
        return widest;
    }

    /** Pairs of crossed bars on one another, as flat as 0.2 rad, under a platform of 24 times their mass. In turns it came down within a second. */
    @ParameterizedTest
    @ValueSource(ints = {1, 3, 5})
    void aScissorLiftBearsItsLoad(int stages) {
        PhysicsEngine engine = falling();
        Body platform = Frames.lift(engine, stages, 24);
        platform.setCollisionGroup(1, 0);
        Stepped.run(engine, 300);
        assertThat(platform.getY()).isCloseTo(Frames.height(stages), within(1e-5));
        assertThat(platform.getAngle()).isCloseTo(0, within(1e-5));
    }

    /** A girder of triangles on two supports, with a load of 50 bars in its middle: statics says what it weighs on each. In turns it sagged by twice its height. */
    @Test
    void aGirderIsStraightAndWeighsOnItsSupports() {
        PhysicsEngine engine = falling();
        List<Body> deck = Frames.girder(engine);
        PinJoint support = (PinJoint) engine.allConstraints().get(0);
        Body load = bar(engine, 4, -1, 4, 0);
        load.setMass(50);
        pin(engine, load, deck.get(4), 4, 0);
        double weight = engine.bodies().stream().mapToDouble(Body::getMass).sum() * G;
        Stepped.run(engine, 300);
        for (Body chord : deck) {
            assertThat(chord.getY()).isCloseTo(0, within(1e-5));
        }
        assertThat(engine.getReaction(support).forceY()).isCloseTo(weight / 2, within(1e-3 * weight));
    }

    /** A crank that turns evenly, a rod and what slides: geometry says where that is. */
    @Test
    void aSliderGoesWhereItsCrankTakesIt() {
        PhysicsEngine engine = falling();
        Body crank = bar(engine, 0, 0, 1, 0);
        Body rod = bar(engine, 1, 0, 4, 0);
        Body slider = engine.add(new Body(new Rectangle(0.5, 0.5)).at(4, 0));
        slider.setCollisionGroup(1, 0);
        pin(engine, crank, null, 0, 0);
        pin(engine, crank, rod, 1, 0);
        pin(engine, rod, slider, 4, 0);
        engine.add(new SliderJoint(slider, null, 4, 0, 1, 0));
        engine.add(Motor.turning(crank, null, 3, 1e5));
        Stepped.run(engine, 60);
        for (int k = 0; k < 600; k++) {
            engine.step();
            double angle = crank.getAngle();
            double expected = Math.cos(angle) + Math.sqrt(9 - Math.pow(Math.sin(angle), 2));
            assertThat(slider.getX()).isCloseTo(expected, within(1e-5));
            assertThat(crank.getAngularVelocity()).isCloseTo(3, within(1e-9));
        }
    }

    /** A bridge of links that hangs between two points swings with the energy that it has. In turns it had lost 13 % of what it can fall by within 10 s. */
    @Test
    void aHangingBridgeKeepsItsEnergy() {
        PhysicsEngine engine = falling();
        List<PinJoint> pins = new ArrayList<>();
        int links = 10;
        Body last = null;
        for (int k = 0; k < links; k++) {
            double y0 = -0.5 * Math.sin(Math.PI * k / links);
            double y1 = -0.5 * Math.sin(Math.PI * (k + 1) / links);
            Body link = bar(engine, k, y0, k + 1, y1);
            pins.add(engine.add(new PinJoint(link, last, k, y0)));
            last = link;
        }
        pins.add(engine.add(new PinJoint(last, links, 0)));
        double before = energy(engine);
        for (int k = 0; k < 600; k++) {
            engine.step();
            assertThat(energy(engine)).isCloseTo(before, within(1e-4 * links * G));
        }
        assertThat(widest(pins)).isLessThan(1e-5);
    }

    /** Boxes that are welded to a ring, which has three rows more than it needs, turn as one body. */
    @Test
    void aRingOfWeldedBoxesIsOneBody() {
        PhysicsEngine engine = Stepped.engine(1.0 / 60, 4);
        int n = 8;
        List<Body> boxes = new ArrayList<>();
        for (int k = 0; k < n; k++) {
            double t = 2 * Math.PI * k / n;
            Body box = engine.add(new Body(new Rectangle(0.3, 1.4)).at(2 * Math.cos(t), 2 * Math.sin(t), t).moving(-6 * Math.sin(t), 6 * Math.cos(t), 3));
            box.setCollisionGroup(1, 0);
            boxes.add(box);
        }
        for (int k = 0; k < n; k++) {
            double t = 2 * Math.PI * (k + 0.5) / n;
            engine.add(new WeldJoint(boxes.get(k), boxes.get((k + 1) % n), 2 * Math.cos(t), 2 * Math.sin(t)));
        }
        double before = engine.kineticEnergy();
        Stepped.run(engine, 1200);
        assertThat(engine.kineticEnergy()).isCloseTo(before, within(1e-3 * before));
        for (int k = 0; k < n; k++) {
            assertThat(boxes.get(k).getAngle()).isCloseTo(boxes.get(0).getAngle() + 2 * Math.PI * k / n, within(1e-5));
        }
    }

    /** Wheels that mesh turn against one another, and those on the ends of a train of five alike; a bar on the first swings as the pendulum of all that turns with it. */
    @Test
    void aTrainOfWheelsMeshes() {
        PhysicsEngine engine = falling();
        List<Body> wheels = new ArrayList<>();
        for (int k = 0; k < 5; k++) {
            Body wheel = engine.add(new Body(new Circle(0.5)).at(k, 0));
            wheel.setMass(1);
            wheel.setCollisionGroup(1, 0);
            pin(engine, wheel, null, k, 0);
            if (k > 0) {
                engine.add(new GearJoint(wheel, wheels.get(k - 1), 1));
            }
            wheels.add(wheel);
        }
        Body bar = bar(engine, 0, 0, 1, 0);
        pin(engine, bar, null, 0, 0);
        engine.add(new WeldJoint(bar, wheels.get(0), 0, 0));
        double before = energy(engine);
        Stepped.run(engine, 600);
        assertThat(energy(engine)).isCloseTo(before, within(1e-4 * G));
        for (int k = 0; k < 5; k++) {
            assertThat(wheels.get(k).getAngle()).isCloseTo((1 - 2 * (k % 2)) * bar.getAngle(), within(1e-6));
        }
    }

    /** Random mechanisms with loops, some of them beyond where these let them go: none gets energy, and in the median they keep their joints closed as no turns do. */
    @Test
    void randomMechanismsDoNotExplode() {
        double[] gaps = new double[60];
        for (int seed = 0; seed < gaps.length; seed++) {
            SplittableRandom random = new SplittableRandom(seed);
            PhysicsEngine engine = falling();
            List<PinJoint> pins = new ArrayList<>();
            List<Body> bars = new ArrayList<>();
            int n = 3 + random.nextInt(6);
            for (int k = 0; k < n; k++) {
                Body on = k == 0 ? null : bars.get(random.nextInt(k));
                double x = on == null ? 0 : on.getX() + random.nextDouble() - 0.5;
                double y = on == null ? 0 : on.getY() + random.nextDouble() - 0.5;
                Body bar = bar(engine, x, y, x + 0.5 + random.nextDouble(), y + random.nextDouble() - 0.5);
                bar.setMass(Math.pow(10, 2 * random.nextDouble() - 1));
                pins.add(engine.add(new PinJoint(bar, on, x, y)));
                bars.add(bar);
            }
            for (int k = 0; k < 1 + n / 3; k++) {
                Body a = bars.get(random.nextInt(n));
                Body b = bars.get(random.nextInt(n));
                if (a != b) {
                    pins.add(engine.add(new PinJoint(a, b, (a.getX() + b.getX()) / 2, (a.getY() + b.getY()) / 2)));
                }
            }
            double fall = bars.stream().mapToDouble(Body::getMass).sum() * G;
            double before = energy(engine);
            for (int k = 0; k < 180; k++) {
                engine.step();
                assertThat(energy(engine) - before).describedAs("seed %d, step %d", seed, k).isLessThan(0.01 * fall);
                gaps[seed] = Math.max(gaps[seed], widest(pins));
            }
        }
        Arrays.sort(gaps);
        assertThat(gaps[gaps.length / 2]).isLessThan(2e-4);
    }
}
