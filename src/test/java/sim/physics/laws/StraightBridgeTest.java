// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * A bridge of planks that are laid in a line from shore to shore, as one builds it first. It cannot sag but by rounding; what drives over
 * it bends it by next to nothing now and then, and that was followed in thousands of parts of a step, seconds each.
 */
class StraightBridgeTest {
    private static final double G = 9.81;
    private static final int PLANKS = 12;
    private static final double TORQUE = 25;

    private final PhysicsEngine engine = new PhysicsEngine();
    private final Weight weight = new Weight();
    private final Body[] wheels = new Body[2];

    /** Gravity that counts how often it is asked for. */
    private static final class Weight implements ForceGenerator {
        private static final long serialVersionUID = 1L;
        private long asked;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            asked++;
            forces.add(body, 0, -G * body.getMass());
        }
    }

    private Body add(Body body, double friction, double restitution) {
        body.setFriction(friction);
        body.setRestitution(restitution);
        return engine.add(body);
    }

    private Body build(long seed, ForceGenerator gravity) {
        engine.setTimeStep(1 / 60.0);
        engine.add(gravity);
        double end = 0.5 * PLANKS;
        add(Body.fixed(new Rectangle(10, 4)).at(-end - 5, 2.1), 0.8, 0);
        add(Body.fixed(new Rectangle(10, 4)).at(end + 5, 2.1), 0.8, 0);
        Body last = null;
        for (int k = 0; k < PLANKS; k++) {
            Body plank = add(new Body(new Rectangle(0.98, 0.2)).at(k + 0.5 - end, 4), 0.8, 0);
            plank.setMass(3);
            engine.add(last == null ? new PinJoint(plank, -end, 4) : new PinJoint(last, plank, k - end, 4));
            last = plank;
        }
        engine.add(new PinJoint(last, end, 4));
        Body truck = add(new Body(new Rectangle(2.4, 0.5)).at(-end - 2, 4.9), 0.5, 0);
        truck.setMass(6);
        for (int k = 0; k < 2; k++) {
            double x = 1.6 * k - end - 2.8;
            wheels[k] = add(new Body(new Circle(0.35)).at(x, 4.46), 0.9, 0);
            engine.add(new PinJoint(truck, wheels[k], x, 4.46));
            engine.add(Motor.turning(wheels[k], truck, -6, TORQUE));
        }
        Random random = new Random(seed);
        for (int k = 0; k < 6; k++) {
            Body box = new Body(k % 2 == 0 ? new Rectangle(0.6, 0.6) : new Circle(0.3));
            box.setPosition(0.9 * k - 2, k % 2 == 0 ? 5.5 + random.nextDouble() : 6);
            add(box, 0.7, 0.1);
        }
        return truck;
    }

    private double energy() {
        double sum = engine.kineticEnergy();
        for (Body body : engine.bodies()) {
            sum += body.isFixed() ? 0 : G * body.getMass() * body.getY();
        }
        return sum;
    }

    /** Boxes that the bridge stopped were thrown up at 300 m/s (3): what its planks lose at once looked like what presses them together. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void trafficGainsNoEnergyButThatOfMotors(long seed) {
        Body truck = build(seed, new Gravity(0, -G));
        for (int k = 0; k < 60; k++) {
            double energy = energy();
            double turn = -turn(truck);
            engine.step();
            turn += turn(truck);
            assertThat(energy() - energy).as("step %s", k).isLessThan(TORQUE * (Math.abs(turn) + 0.1));
        }
    }

    private double turn(Body truck) {
        return wheels[0].getAngle() + wheels[1].getAngle() - 2 * truck.getAngle();
    }

    @Test
    void noStepOfTrafficCostsMuchMoreThanOthers() {
        build(1, weight);
        engine.step(); // in which it is found that it cannot sag
        long most = 0;
        for (int k = 0; k < 100; k++) {
            long before = weight.asked;
            engine.step();
            most = Math.max(most, weight.asked - before);
            for (int m = 2; m < 2 + PLANKS; m++) {
                assertThat(Math.abs(engine.bodies().get(m).getY() - 4)).isLessThan(1e-3);
            }
        }
        assertThat(most).isLessThan(200_000);
    }

    @ParameterizedTest
    @ValueSource(ints = {3, 12, 100, 400})
    void aLongBridgeFindsSoonThatItCannotSag(int planks) {
        engine.setTimeStep(1 / 60.0);
        engine.add(weight);
        Body last = null;
        for (int k = 0; k < planks; k++) {
            Body plank = engine.add(new Body(new Rectangle(0.98, 0.2)).at(k + 0.5, 0));
            engine.add(last == null ? new PinJoint(plank, 0, 0) : new PinJoint(last, plank, k, 0));
            last = plank;
        }
        engine.add(new PinJoint(last, planks, 0));
        engine.step();
        assertThat(weight.asked).isLessThan(200L * planks);
        for (Body plank : engine.bodies()) {
            assertThat(plank.getY()).isCloseTo(0, within(1e-3));
        }
    }

    /** When a shore lets go it falls as it must: what was found is forgotten. */
    @Test
    void itFallsWhenAShoreLetsGo() {
        build(1, weight);
        for (int k = 0; k < 60; k++) {
            engine.step();
        }
        Body last = engine.bodies().get(1 + PLANKS);
        engine.remove(engine.allConstraints().get(PLANKS));
        for (int k = 0; k < 30; k++) {
            engine.step();
        }
        assertThat(last.getY()).isLessThan(3.5);
    }
}
