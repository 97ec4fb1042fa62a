// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/**
 * Newton's cradle of five pendulums: as many fly off as have come in, however often those that swing side by side touch on their way, and lie on
 * one another by the engine's rule.
 */
class CradleTest {
    private static final double G = 9.81;
    private static final double RAISED = 0.5;

    private final PhysicsEngine engine = new PhysicsEngine();
    private final List<Body> bobs = new ArrayList<>();

    private void pendulum(double x, double angle) {
        double sine = StrictMath.sin(angle);
        double cosine = StrictMath.cos(angle);
        Body rod = engine.add(new Body(new Rectangle(0.01, 1)).at(x + 0.5 * sine, -0.5 * cosine, angle));
        rod.setMass(1e-3);
        rod.setCollisionGroup(2, 0);
        Body bob = engine.add(new Body(new Circle(0.1)).at(x + sine, -cosine, angle));
        bob.setMass(1);
        engine.add(new PinJoint(rod, x, 0));
        engine.add(new WeldJoint(rod, bob, x + sine, -cosine));
        bobs.add(bob);
    }

    private double energy() {
        double sum = 0;
        for (Body body : engine.bodies()) {
            sum += body.kineticEnergy() + G * body.getMass() * body.getY();
        }
        return sum;
    }

    @ParameterizedTest
    @CsvSource({"1, 0.001", "2, 0.001", "3, 0.001", "3, 0.0005", "4, 0.016666666666666666", "4, 0.004", "4, 0.002", "4, 0.0005"})
    void asManyFlyOffAsHaveComeIn(int raised, double step) {
        engine.setTimeStep(step);
        engine.add(new Gravity(0, -G));
        for (int k = 0; k < 5; k++) {
            pendulum(0.2 * k, k < raised ? -RAISED : 0);
        }
        double before = energy();
        double[] most = new double[5];
        int steps = (int) StrictMath.rint(1.4 / step); // two thirds of a swing
        for (int k = 0; k < steps; k++) {
            engine.step();
            for (int m = 0; m < 5; m++) {
                most[m] = StrictMath.max(most[m], bobs.get(m).getAngle());
            }
        }
        assertThat(energy()).isCloseTo(before, within(1e-5));
        for (int m = 0; m < 5; m++) {
            assertThat(most[m]).as("swing of bob %d", m).isCloseTo(m < 5 - raised ? 0 : RAISED, within(1e-3));
        }
    }
}
