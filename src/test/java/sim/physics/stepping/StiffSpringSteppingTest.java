// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Automatic;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;

/** Springs under time stepping: as forces where a substep can follow them, else as rows that no stiffness makes unstable. */
class StiffSpringSteppingTest {
    private static final double G = 9.81;

    private final PhysicsEngine engine = new PhysicsEngine();

    private Body hang(double stiffness, double damping) {
        engine.setTimeStep(1.0 / 60);
        engine.setTimeStepping(4);
        engine.add(new Gravity(0, -G));
        Body mass = engine.add(new Body(new Circle(0.5)).at(0, -1));
        mass.setMass(1);
        engine.add(new Spring(mass, 0, 0, null, 0, 0, 1, stiffness, damping));
        return mass;
    }

    private void run(int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e3, 1e5, 1e7, 1e9, 1e12})
    void whatHangsOnASpringComesToRestWhereStaticsHasIt(double stiffness) {
        Body mass = hang(stiffness, 2 * Math.sqrt(stiffness)); // critically damped
        run(600);
        assertThat(mass.getY()).isCloseTo(-1 - G / stiffness, within(1e-9));
        assertThat(mass.getVelocityY()).isCloseTo(0, within(1e-9));
    }

    @Test
    void whatSubstepsCanFollowKeepsItsAmplitude() {
        Body mass = hang(400, 0); // 20/s, substeps of 1/240 s
        double rest = -1 - G / 400;
        run(600);
        double most = 0;
        for (int k = 0; k < 60; k++) {
            engine.step();
            most = Math.max(most, Math.abs(mass.getY() - rest));
        }
        assertThat(most).isCloseTo(G / 400, within(0.1 * G / 400));
    }

    @Test
    void theSameSpringIsAForceAgainWhenEventsMoveTheBodies() {
        Body mass = hang(1e6, 2e3);
        run(60);
        engine.setIntegrator(new Automatic(1e-9));
        engine.setTimeStepping(0);
        run(60);
        assertThat(mass.getY()).isCloseTo(-1 - G / 1e6, within(1e-7));
    }

    @Test
    void twoStiffSpringsInARowHoldTheirMassesApart() {
        Body upper = hang(1e8, 1e3);
        Body lower = engine.add(new Body(new Circle(0.2)).at(0, -2));
        lower.setMass(1);
        engine.add(new Spring(upper, 0, 0, lower, 0, 0, 1, 1e8, 1e3));
        run(600);
        assertThat(upper.getY()).isCloseTo(-1, within(1e-4));
        assertThat(lower.getY()).isCloseTo(-2, within(1e-4));
    }
}
