// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.collision.Overlap;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.SlotJoint;
import sim.physics.constraint.Wheel;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.response.LastingContact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Jointed bodies that motors or walls jam, in long steps: they stay out of one another, and steps end. */
class JammedMachineTest {
    private final PhysicsEngine engine = new PhysicsEngine();

    private double deepest() {
        double most = 0;
        for (Overlap overlap : engine.overlaps()) {
            most = Math.max(most, overlap.depth());
        }
        return most;
    }

    private Body wall(double x, double y, double width, double height, double restitution) {
        Body wall = engine.add(Body.fixed(new Rectangle(width, height)).at(x, y));
        wall.setRestitution(restitution);
        return wall;
    }

    /**
     * A robot whose two axles let it roll along its heading only drives at a smooth wall, no field acts. It stands there: along the heading
     * its drive bears what the wall does, F = N cos α. It does not sink in, and what stands costs nothing.
     */
    @ParameterizedTest
    @CsvSource({"0.05, 0.6, 0", "0.5, 0.6, 0", "1, 0.6, 0", "1, 0.1, 0.4", "0.5, 1.1, 0.4", "1, 0.6, 0.9"})
    void aRobotThatPressesDoesNotSink(double step, double angle, double restitution) {
        engine.setTimeStep(step);
        wall(3, 0, 2, 20, restitution);
        Body robot = engine.add(new Body(new Circle(0.3)).at(1, 0, angle));
        robot.setRestitution(restitution);
        Wheel front = engine.add(new Wheel(robot, 0.2, 0));
        Wheel back = engine.add(new Wheel(robot, -0.2, 0));
        engine.add(Motor.rolling(front, 0.3, 1.5));
        engine.add(Motor.rolling(back, 0.2, 0.25));
        double at = 0;
        for (double time = 0; time < 200; time += step) {
            at = time < 100 ? engine.getWork() : at;
            engine.step();
            assertThat(deepest()).as("time %s", time).isLessThan(1e-6 * 0.3);
        }
        assertThat(robot.getX()).isEqualTo(1.7, within(1e-6));
        assertThat(engine.kineticEnergy()).isLessThan(1e-12);
        assertThat(engine.getWork() - at).isLessThan((long) (200 * 100 / step));
        assertThat(engine.contacts()).hasSize(1);
        LastingContact contact = engine.contacts().get(0);
        assertThat(contact.normalForce() * StrictMath.cos(angle)).isEqualTo(1.75, within(1e-6));
    }

    /** Two rods on a pin fly about between walls, several times their length in a step; time stepping stands in for events. */
    @ParameterizedTest
    @ValueSource(doubles = {1 / 60.0, 0.1, 0.5, 1})
    void relievedStepsAreAsShortAsBodiesAreFast(double step) {
        engine.setTimeStep(step);
        engine.setWorkLimit(1);
        engine.add(new Gravity(0, -0.3));
        for (int side = -1; side <= 1; side += 2) {
            wall(side * 2.5, 0, 1, 6, 0.5);
            wall(0, side * 2.5, 6, 1, 0.5);
        }
        for (int k = 0; k < 2; k++) {
            Body a = engine.add(new Body(new Rectangle(0.6, 0.2)).at(-1, k).moving(2, 1));
            Body b = engine.add(new Body(new Rectangle(0.6, 0.2)).at(-0.3, k).moving(2, 1));
            a.setRestitution(0.5);
            b.setRestitution(0.5);
            engine.add(PinJoint.worldPoint(a, b, -0.65, k));
        }
        double deepest = 0;
        for (int k = 0; k < 100; k++) {
            engine.step();
            deepest = Math.max(deepest, deepest());
            for (Body body : engine.bodies()) {
                assertThat(body.isFixed() || Math.abs(body.getX()) < 2 && Math.abs(body.getY()) < 2).as("step %s, %s", k, body).isTrue();
            }
        }
        assertThat(engine.getRelievedSteps()).isPositive();
        assertThat(deepest).isLessThan(0.03 * 0.3);
    }

    /**
     * A disc hangs in its slot on the end of a rod that swings, with stops of the slot. Within a long step it is pressed against a stop, let
     * go, and pressed again. No stop is passed, stops give no energy, and such a step costs some hundred units, and not ten million.
     */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11})
    void aStopThatLetsGoWithinAStepIsNotPassed(int seed) {
        Random random = new Random(seed);
        engine.setTimeStep(0.5);
        engine.add(new Gravity(0, -0.3));
        Body disc = engine.add(new Body(new Circle(0.3)).at(0.5, 0));
        Body rod = engine.add(new Body(new Rectangle(0.6, 0.1)).at(0, 0));
        engine.add(new PinJoint(rod, 0.05, 0));
        SlotJoint slot = engine.add(new SlotJoint(disc, rod, 0, 0, random.nextDouble() - 0.5, random.nextDouble() - 0.5));
        engine.add(Limit.travel(slot, -0.3, 0.3));
        rod.setAngularVelocity(2 - 4 * random.nextDouble());
        disc.setAngularVelocity(2 - 4 * random.nextDouble());
        double energy = engine.kineticEnergy();
        for (int k = 0; k < 60; k++) {
            long work = engine.getWork();
            engine.step();
            assertThat(engine.getWork() - work).as("step %s", k).isLessThan(5_000);
            assertThat(slot.getTravel()).as("step %s", k).isBetween(-0.3 - 1e-11, 0.3 + 1e-11);
            double now = engine.kineticEnergy() + 0.3 * (disc.getMass() * disc.getY() + rod.getMass() * rod.getY());
            assertThat(now).as("step %s", k).isLessThan(energy + 1e-3); // errors of steps of half a radian
        }
        assertThat(engine.getRelievedSteps()).isZero();
    }
}
