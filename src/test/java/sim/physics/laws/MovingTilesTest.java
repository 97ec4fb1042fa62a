// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.KinematicBody;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** Tiles that move alike are a floor as fixed ones are: Galilei's law. The corner of the next plate stopped what slid over it, by time stepping. */
class MovingTilesTest {
    /** A floor of tiles, or one body, in a world that is turned, with a body on it or above it. */
    private record Scene(int substeps, double angle, double friction, Shape shape, double height, double drop, double x, double speed) {
        PhysicsEngine build(boolean isMoving, double u, double v) {
            double cos = StrictMath.cos(angle);
            double sin = StrictMath.sin(angle);
            PhysicsEngine engine = new PhysicsEngine();
            engine.setTimeStep(1 / 60.0);
            engine.setSleepAllowed(false);
            engine.setTimeStepping(substeps);
            engine.add(new Gravity(10 * sin, -10 * cos));
            for (int k = -6; k < 12; k++) {
                Rectangle tile = new Rectangle(1, 0.5);
                Body body = isMoving ? new KinematicBody(tile).moving(u, v) : Body.fixed(tile);
                engine.add(body.at(cos * k + 0.25 * sin, sin * k - 0.25 * cos, angle));
            }
            double y = height + drop;
            Body body = new Body(shape).at(cos * x - sin * y, sin * x + cos * y, angle + drop / 2);
            engine.add(body.moving(cos * speed + (isMoving ? u : 0), sin * speed + (isMoving ? v : 0)));
            for (Body each : engine.bodies()) {
                each.setFriction(friction);
                each.setRestitution(0);
            }
            return engine;
        }

        /** The greatest distance within a second between where the body is on the tiles that move, and on those that are fixed. */
        double off(double u, double v) {
            PhysicsEngine still = build(false, 0, 0);
            PhysicsEngine moving = build(true, u, v);
            Body there = still.bodies().get(18);
            Body here = moving.bodies().get(18);
            double startX = still.bodies().get(0).getX();
            double startY = still.bodies().get(0).getY();
            double most = 0;
            for (int k = 1; k <= 60; k++) {
                still.step();
                moving.step();
                double x = here.getX() - moving.bodies().get(0).getX() - (there.getX() - startX);
                double y = here.getY() - moving.bodies().get(0).getY() - (there.getY() - startY);
                most = Math.max(most, Math.abs(x) + Math.abs(y));
            }
            return most;
        }
    }

    @ParameterizedTest
    @CsvSource({"0.1, 0", "3, -2", "0, 1", "-100, 30"})
    void whatSlidesOrFallsFeelsNoSeamByTimeStepping(double u, double v) {
        for (Shape shape : List.of(new Circle(0.4), new Rectangle(0.7, 0.5), new Rectangle(1, 0.5), new Rectangle(1.7, 0.5))) {
            double height = shape.vertexCount() == 1 ? 0.4 : 0.25;
            for (int run = 0; run < 16; run++) {
                double angle = run % 2 == 0 ? 0 : 0.3;
                double drop = run % 4 < 2 ? 0 : 0.3;
                double friction = run % 8 < 4 ? 0 : 0.3;
                Scene scene = new Scene(4, angle, friction, shape, height, drop, 0.5 + 0.0625 * run, run % 3 == 0 ? 0.5 : 4);
                assertThat(scene.off(u, v)).as(scene.toString()).isLessThan(5e-4);
            }
        }
    }

    /** Boxes that are joined or pushed slide over tiles that move as over fixed ones, by events: seams turned them, and one corner or another was stopped. */
    @ParameterizedTest
    @CsvSource({"hinge, 0, 1e-7", "weld, 0, 1e-7", "spring, 0, 1e-7", "hinge, 0.3, 5e-4", "weld, 0.3, 5e-4", "spring, 0.3, 1e-7"})
    void whatIsJoinedFeelsNoSeamByEvents(String by, double friction, double bound) {
        for (int run = 0; run < 20; run++) {
            double angle = run % 2 == 0 ? 0 : 0.3;
            PhysicsEngine still = joined(by, false, friction, angle, 0.5 + 0.0625 * run);
            PhysicsEngine moving = joined(by, true, friction, angle, 0.5 + 0.0625 * run);
            for (int k = 1; k <= 60; k++) {
                still.step();
                moving.step();
                for (int m = 18; m < 20; m++) {
                    Body there = still.bodies().get(m);
                    Body here = moving.bodies().get(m);
                    assertThat(here.getX() - 3 * k / 60.0).as("run " + run).isCloseTo(there.getX(), within(bound));
                    assertThat(here.getY() + 2 * k / 60.0).as("run " + run).isCloseTo(there.getY(), within(bound));
                    assertThat(here.getAngle()).as("run " + run).isCloseTo(there.getAngle(), within(bound));
                }
            }
        }
    }

    private static PhysicsEngine joined(String by, boolean isMoving, double friction, double angle, double x) {
        Shape shape = new Rectangle(1.2, 0.6);
        PhysicsEngine engine = new Scene(0, angle, friction, shape, 0.3, 0, x, 4).build(isMoving, 3, -2);
        double cos = StrictMath.cos(angle);
        double sin = StrictMath.sin(angle);
        Body front = engine.bodies().get(18);
        Body back = engine.add(new Body(shape).at(cos * (x - 1.3) - sin * 0.3, sin * (x - 1.3) + cos * 0.3, angle));
        back.setVelocity(front.getVelocityX(), front.getVelocityY());
        back.setFriction(friction);
        back.setRestitution(0);
        double pinX = cos * (x - 0.65) - sin * 0.3;
        double pinY = sin * (x - 0.65) + cos * 0.3;
        if (by.equals("spring")) {
            engine.add(new Spring(front, 0, 0, back, 0, 0, 1.3, 200, 1));
        } else {
            engine.add(by.equals("hinge") ? new PinJoint(front, back, pinX, pinY) : new WeldJoint(front, back, pinX, pinY));
        }
        return engine;
    }

    /** The planks of a deck that turns slowly about its middle are a deck: their corners stopped what slid over it. */
    @ParameterizedTest
    @CsvSource({"0.01, 60", "0.05, 60", "0.2, 60", "0.2, 240"})
    void planksThatTurnAboutOnePointAreADeck(double rate, int steps) {
        Body one = slideOverDeck(1, rate, steps);
        Body other = slideOverDeck(20, rate, steps);
        assertThat(other.getX()).isCloseTo(one.getX(), within(1e-3));
        assertThat(other.getY()).isCloseTo(one.getY(), within(1e-3));
        assertThat(other.getAngle()).isCloseTo(one.getAngle(), within(1e-3));
    }

    private static Body slideOverDeck(int count, double rate, int steps) {
        double h = 1.0 / steps;
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(h);
        engine.setTimeStepping(4);
        engine.add(new Gravity(0, -10));
        KinematicBody[] planks = new KinematicBody[count];
        double length = 20.0 / count;
        for (int k = 0; k < count; k++) {
            planks[k] = new KinematicBody(new Rectangle(length, 0.5));
            planks[k].at(length * (k + 0.5) - 10, 0).moving(0, rate * (length * (k + 0.5) - 10), rate);
            engine.add(planks[k]);
        }
        Body box = engine.add(new Body(new Rectangle(0.7, 0.5)).at(-7.1, 0.5).moving(4, -7.1 * rate, rate));
        for (Body each : engine.bodies()) {
            each.setFriction(0);
            each.setRestitution(0);
        }
        for (int step = 1; step <= 2 * steps; step++) {
            double angle = rate * step * h;
            for (int k = 0; k < count; k++) {
                double r = length * (k + 0.5) - 10;
                planks[k].setTargetVelocity(-rate * r * StrictMath.sin(angle), rate * r * StrictMath.cos(angle), rate);
            }
            engine.step();
        }
        return box;
    }

    /** A plate that goes another way than the one beside it is a wall where it is higher, and a part of the floor only as long as it goes along. */
    @ParameterizedTest
    @CsvSource({"0", "4"})
    void aPlateThatRisesBeforeABoxStopsIt(int substeps) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.setTimeStepping(substeps);
        engine.add(new Gravity(0, -10));
        engine.add(new KinematicBody(new Rectangle(4, 0.5)).at(-2, -0.25).moving(1, 0));
        engine.add(new KinematicBody(new Rectangle(4, 0.5)).at(2, -0.25).moving(1, 0.5));
        Body box = engine.add(new Body(new Rectangle(0.5, 0.5)).at(-1.25, 0.25).moving(2, 0));
        for (Body each : engine.bodies()) {
            each.setFriction(0);
            each.setRestitution(0);
        }
        for (int k = 0; k < 90; k++) {
            engine.step();
        }
        assertThat(box.getX()).isCloseTo(1.5 - 0.25, within(5e-3));
        assertThat(box.getVelocityX()).isCloseTo(1, within(1e-3));
    }
}
