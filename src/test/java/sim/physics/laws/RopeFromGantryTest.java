// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Limit;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Compound;
import sim.physics.shape.Rectangle;

/** A weight that swings on a rope from a gantry, which stands on the ground: the stop of the rope turns as the forces on the ground do not. */
class RopeFromGantryTest {
    private static final double G = 9.81;
    private static final double LENGTH = 1.5;
    private static final double START = 0.5;
    private static final double TIME = 4;

    private final PhysicsEngine engine = new PhysicsEngine();

    private Body put(Body body, double mass) {
        body.setFriction(1);
        body.setRestitution(0);
        if (mass > 0) {
            body.setMass(mass);
        }
        return engine.add(body);
    }

    /** The weight swings as a pendulum does whose pivot stands still, and the rope becomes no longer. */
    @ParameterizedTest
    @CsvSource({"60, 1e-4, 3e-4", "240, 2e-6, 1e-5"})
    void aWeightOnRopeIsPendulum(int stepsASecond, double longer, double off) {
        engine.setTimeStep(1.0 / stepsASecond);
        engine.add(new Gravity(0, -G));
        put(Body.fixed(new Rectangle(20, 1)).at(0, -0.5), 0);
        Compound portal = new Compound(Compound.box(-1, 1, 0.2, 2), Compound.box(1, 1, 0.2, 2), Compound.box(0, 2.1, 2.2, 0.2));
        Body gantry = put(new Body(portal).at(portal.centroidX(), portal.centroidY()), 200);
        Body weight = put(new Body(new Circle(0.1)).at(LENGTH * Math.sin(START), 2 - LENGTH * Math.cos(START)), 10);
        Limit rope = engine.add(Limit.rope(weight, 0, 0, gantry, 0, 2 - portal.centroidY(), LENGTH));
        for (int k = 0; k < TIME * stepsASecond; k++) {
            engine.step();
            assertThat(rope.getValue()).isLessThan(longer);
        }
        double angle = pendulum();
        assertThat(weight.getX()).isCloseTo(LENGTH * Math.sin(angle), within(off));
        assertThat(weight.getY()).isCloseTo(2 - LENGTH * Math.cos(angle), within(off));
        assertThat(gantry.getX()).isCloseTo(0, within(1e-5)); // it slips a little as it is put down
    }

    /** The angle of a pendulum after the time, by Runge and Kutta's method in steps of a millisecond. */
    private static double pendulum() {
        double angle = START;
        double rate = 0;
        double h = 1e-3;
        for (int k = 0; k < TIME / h; k++) {
            double a1 = bend(angle);
            double a2 = bend(angle + h / 2 * rate);
            double a3 = bend(angle + h / 2 * (rate + h / 2 * a1));
            double a4 = bend(angle + h * (rate + h / 2 * a2));
            angle += h * rate + h * h / 6 * (a1 + a2 + a3);
            rate += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
        }
        return angle;
    }

    private static double bend(double angle) {
        return -G / LENGTH * Math.sin(angle);
    }
}
