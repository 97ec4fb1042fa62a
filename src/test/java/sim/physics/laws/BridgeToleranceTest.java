// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static sim.physics.laws.Methods.method;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.motion.Automatic;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * A bridge of planks in a line from shore to shore, under methods with a tolerance. What swings in such a pose is as fast as it is small,
 * and was followed in ever shorter steps: the first step of the engine did not end.
 */
class BridgeToleranceTest {
    private static final double G = 9.81;

    private final PhysicsEngine engine = new PhysicsEngine();
    private long asked;
    private int planks;

    private void bridge(int count, String name, double tolerance) {
        planks = count;
        engine.setTimeStep(1 / 60.0);
        engine.setIntegrator(method(name, tolerance));
        engine.add((ForceGenerator) (body, time, forces) -> {
            asked++;
            forces.add(body, 0, -G * body.getMass());
        });
        double end = 0.5 * count;
        Body last = null;
        for (int k = 0; k < count; k++) {
            Body plank = engine.add(new Body(new Rectangle(0.98, 0.2)).at(k + 0.5 - end, 4));
            plank.setMass(3);
            plank.setFriction(0.8);
            plank.setRestitution(0);
            engine.add(last == null ? new PinJoint(plank, -end, 4) : new PinJoint(last, plank, k - end, 4));
            last = plank;
        }
        engine.add(new PinJoint(last, end, 4));
    }

    /** How far the joints are open. */
    private double gap() {
        double x = -0.5 * planks;
        double y = 4;
        double most = 0;
        for (int k = 0; k < planks; k++) {
            Body plank = engine.bodies().get(k);
            double cos = 0.5 * StrictMath.cos(plank.getAngle());
            double sin = 0.5 * StrictMath.sin(plank.getAngle());
            most = Math.max(most, StrictMath.hypot(plank.getX() - cos - x, plank.getY() - sin - y));
            x = plank.getX() + cos;
            y = plank.getY() + sin;
        }
        return Math.max(most, StrictMath.hypot(0.5 * planks - x, 4 - y));
    }

    private double energy() {
        double sum = engine.kineticEnergy();
        for (Body body : engine.bodies()) {
            sum += G * body.getMass() * body.getY();
        }
        return sum;
    }

    @ParameterizedTest
    @CsvSource({
        "3, DOP853, 1e-3", "4, DOP853, 1e-6", "7, DOP853, 1e-6", "12, DOP853, 1e-10", "4, Automatic, 1e-6", "7, Automatic, 1e-9",
        "12, Automatic, 1e-3", "4, GBS, 1e-3", "7, GBS, 1e-8", "12, GBS, 1e-10", "3, Radau, 1e-6", "7, Radau, 1e-9", "12, Radau, 1e-3"
    })
    void itStandsAndItsStepsEnd(int count, String name, double tolerance) {
        bridge(count, name, tolerance);
        double before = energy();
        for (int k = 0; k < 60; k++) {
            asked = 0;
            engine.step();
            assertThat(asked / count).as("step %s", k).isLessThan(50_000);
            assertThat(energy()).as("step %s", k).isLessThanOrEqualTo(before + 1e-12 * before);
            assertThat(gap()).isLessThan(400 * 0x1p-52 * 2 * count);
        }
        assertThat(engine.bodies().get(count / 2).getY()).isGreaterThan(4 - 1e-5);
    }

    @ParameterizedTest
    @CsvSource({"4, DOP853, 1e-6", "7, Automatic, 1e-6", "12, GBS, 1e-4", "7, Radau, 1e-4"})
    void itBearsWhatFallsOntoIt(int count, String name, double tolerance) {
        bridge(count, name, tolerance);
        for (int k = 0; k < 3; k++) {
            double x = (k + 0.5) * count / 3.0 - 0.5 * count;
            Body body = engine.add(new Body(k == 1 ? new Circle(0.3) : new Rectangle(0.6, 0.6)).at(x, 4.45 + 0.3 * k));
            body.setFriction(0.7);
            body.setRestitution(0.1);
        }
        double last = energy();
        for (int k = 0; k < 60; k++) {
            asked = 0;
            engine.step();
            assertThat(asked / (count + 3)).as("step %s", k).isLessThan(50_000);
            assertThat(energy() - last).as("step %s", k).isLessThan(1e-3);
            assertThat(gap()).isLessThan(400 * 0x1p-52 * 2 * count);
            last = energy();
        }
        for (int k = count; k < count + 3; k++) {
            assertThat(engine.bodies().get(k).getY()).isGreaterThan(4.35);
        }
    }

    /**
     * Two bodies that a pin between them and a rod along it hold straight, hung from a slider and rods: they are in such a pose wherever they
     * go, and rows that depend on others all the way are still not implied by them.
     */
    @ParameterizedTest
    @CsvSource({"DOP853, 1e-2", "DOP853, 2e-3", "DOP853, 1e-4", "GBS, 1e-2", "Radau, 1e-2", "Radau, 1e-6"})
    void aStraightPairMovesOn(String name, double tolerance) {
        engine.setTimeStep(1 / 60.0);
        engine.setIntegrator(method(name, tolerance));
        engine.add((ForceGenerator) (body, time, forces) -> {
            asked++;
            forces.add(body, 0, -G * body.getMass());
        });
        Body disc = engine.add(new Body(new Circle(0.2)).at(-3.3, 3.8).moving(1, -1, 0));
        Body one = engine.add(new Body(new Rectangle(1.2, 0.4)).at(-2.1, 4.4).moving(1, -2, 0));
        Body other = engine.add(new Body(new Rectangle(0.3, 0.4)).at(-0.9, 6.1).moving(-1, 2, 0));
        for (Body body : engine.bodies()) {
            body.setCollisionGroup(1, 0);
        }
        engine.add(new PinJoint(one, other, -1.5, 5.25));
        engine.add(new RodJoint(other, -0.9, 6.1, one, -2.1, 4.4));
        engine.add(new RodJoint(disc, -3.3, 3.8, other, -0.9, 6.1));
        engine.add(new RodJoint(disc, -3.2, 3.8, null, -2.3, 5.2));
        engine.add(new SliderJoint(other, null, -0.9, 6.1, 1, -0.7));
        double length = StrictMath.hypot(1.2, 1.7);
        for (int k = 0; k < 60; k++) {
            asked = 0;
            engine.step();
            assertThat(asked / 3).as("step %s", k).isLessThan(50_000);
            assertThat(StrictMath.hypot(one.getX() - other.getX(), one.getY() - other.getY())).isCloseTo(length, within(1e-10));
        }
    }

    /** When a shore lets go it falls, to the tolerance again: the lowest plank of three as in an engine that never was a bridge. */
    @Test
    void itFallsWhenAShoreLetsGo() {
        bridge(3, "DOP853", 1e-9);
        for (int k = 0; k < 20; k++) {
            engine.step();
        }
        engine.remove(engine.allConstraints().get(3));
        double before = energy();
        for (int k = 0; k < 60; k++) {
            engine.step();
        }
        assertThat(engine.bodies().get(2).getY()).isLessThan(2.5);
        assertThat(Math.abs(energy() - before)).isLessThan(1e-6 * before);
    }
}
