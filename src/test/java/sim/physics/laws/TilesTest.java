// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Compound;
import sim.physics.shape.Polygon;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** What falls on a floor of tiles, comes to lie and slides on. The next tile held it: at the start of a step, it was taken for one that it lies on. */
class TilesTest {
    private static Body land(Shape shape, boolean isTiled, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 120);
        engine.add(new Gravity(0, -9.81));
        if (isTiled) {
            for (int k = -10; k < 10; k++) {
                engine.add(Body.fixed(new Rectangle(1, 1)).at(k + 0.5, -3.5));
            }
        } else {
            engine.add(Body.fixed(new Rectangle(20, 1)).at(0, -3.5));
        }
        Body body = engine.add(new Body(shape).at(-5 + 2 * random.nextDouble(), 2 * random.nextDouble() - 1, 3 * random.nextDouble()));
        body.setVelocity(3 * (0.5 + random.nextDouble()), 3 * (random.nextDouble() - 0.5));
        body.setAngularVelocity(2 * random.nextDouble() - 1);
        for (Body each : engine.bodies()) {
            each.setFriction(0);
            each.setRestitution(0);
        }
        for (int k = 0; k < 240; k++) {
            engine.step();
        }
        return body;
    }

    @ParameterizedTest
    @ValueSource(strings = {"box", "long box", "hexagon"})
    void whatFallsOnTilesSlidesOn(String name) {
        Shape shape = switch (name) {
            case "box" -> new Rectangle(0.7, 0.5);
            case "long box" -> new Rectangle(2.3, 0.4);
            default -> Polygon.regular(6, 0.4);
        };
        for (long seed = 0; seed < 20; seed++) {
            Body whole = land(shape, false, seed);
            Body tiled = land(shape, true, seed);
            assertThat(tiled.getX()).as("seed " + seed).isCloseTo(whole.getX(), within(2e-2));
            assertThat(tiled.getVelocityX()).as("seed " + seed).isCloseTo(whole.getVelocityX(), within(1e-2));
        }
    }

    /**
     * What is put on tiles falls by no more than rounding, which takes it long: it met one of them alone, turned by 10⁻⁷ rad/s, and struck the next one's
     * side. Boxes and what is made of two, at any place, and at any speed.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1})
    void whatIsPutOnTilesSlidesOn(double restitution) {
        SplittableRandom random = new SplittableRandom(3);
        Compound two = new Compound(Compound.box(0, 0, 1, 1), Compound.box(0, 0.75, 0.3, 0.5));
        for (int run = 0; run < 400; run++) {
            double width = new double[] {0.1, 0.25, 0.3, 0.5, 0.7, 1, 2}[random.nextInt(7)];
            double friction = 0.1 * random.nextInt(2);
            double speed = 2 + 3 * random.nextDouble();
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(1.0 / 60);
            engine.add(new Gravity(0, -10));
            for (int k = -4; k < 5 / width; k++) {
                engine.add(Body.fixed(new Rectangle(width, 0.5)).at(width * k, -0.25));
            }
            Body body = random.nextInt(2) == 0 ? new Body(new Rectangle(1, 1)).at(0, 0.5) : new Body(two).at(0, 0.5 + two.centroidY());
            body.setPosition(0.2 + random.nextDouble(), body.getY());
            engine.add(body).setVelocity(speed, 0);
            for (Body each : engine.bodies()) {
                each.setFriction(friction);
                each.setRestitution(restitution);
            }
            for (int k = 1; k <= 30; k++) {
                engine.step();
                assertThat(body.getVelocityX()).as("run " + run).isCloseTo(speed - 10 * friction * k / 60, within(1e-10));
            }
        }
    }

    /**
     * A box of the size of a tile that is put on one, edge on edge: its corners and those of the next tiles are one, but for rounding, and the sides of
     * these held it like walls, at 99 of 100 places.
     */
    @ParameterizedTest
    @ValueSource(strings = {"slope", "force", "belt"})
    void aBoxThatIsPutOnATileOfItsSizeIsSetOff(String by) {
        for (int run = 0; run < 30; run++) {
            double at = 0.1 * run;
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(1.0 / 60);
            engine.add(new Gravity(by.equals("slope") ? 7 : 0, -10));
            for (int k = -2; k < 5; k++) {
                engine.add(Body.fixed(new Rectangle(1, 1)).at(at + k, -0.5)).setBeltSpeed(by.equals("belt") ? -1.25 : 0);
            }
            Body box = engine.add(new Body(new Rectangle(1, 1)).at(at, 0.5));
            box.setMass(1);
            for (Body each : engine.bodies()) {
                each.setRestitution(0);
                each.setFriction(0.5);
            }
            for (int k = 0; k < 60; k++) {
                if (by.equals("force")) {
                    box.addForce(7, 0);
                }
                engine.step();
            }
            double way = by.equals("belt") ? 1.25 - 1.25 * 1.25 / 10 : 1; // 2 m/s² more than friction for a second; 5 m/s² up to the belt's speed
            assertThat(box.getX() - at).as("at " + at).isCloseTo(way, within(1e-6));
            assertThat(box.getY()).as("at " + at).isCloseTo(0.5, within(1e-9));
        }
    }

    /** What came to lie far from the origin is as deep as rounding is there, and feels no seam where it is less. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1})
    void whatComesFromFarSlidesOn(double restitution) {
        SplittableRandom random = new SplittableRandom(5);
        for (int run = 0; run < 20; run++) {
            double width = 0.5 + random.nextDouble();
            double speed = 5 + 4 * random.nextDouble();
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(1.0 / 60);
            engine.add(new Gravity(0, -10));
            for (int k = (int) (-300 / width) - 4; k < 10; k++) {
                engine.add(Body.fixed(new Rectangle(width, 0.5)).at(width * k, -0.25)).setRestitution(restitution);
            }
            Body box = engine.add(new Body(new Rectangle(1, 1)).at(-300 + random.nextDouble(), 0.5).moving(speed, 0));
            box.setRestitution(restitution);
            while (box.getX() < 1) {
                engine.step();
                assertThat(box.getVelocityX()).as("run " + run).isCloseTo(speed, within(1e-9));
            }
        }
    }
}
