// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/**
 * Two boxes without friction and restitution that fall on a floor, one on the other, and slide on one another at 8 m/s as they turn. To stay
 * on one another they have to be lifted by what turning takes of their gap in a step. That was not afforded, and they were stopped.
 */
class SlidingWhileTurningTest {
    private static final double TIME = 3 / 102.0;

    private final PhysicsEngine engine = new PhysicsEngine();

    private Body put(Body body) {
        body.setRestitution(0);
        return engine.add(body);
    }

    /** A box, or two halves that are welded. */
    private void box(double width, double height, double mass, boolean isWelded, double[] pose, double[] velocity) {
        double cos = StrictMath.cos(pose[2]);
        double sin = StrictMath.sin(pose[2]);
        Body last = null;
        for (double part = isWelded ? -0.25 : 0; part <= 0.25; part += 0.5) {
            double x = part * width * cos;
            double y = part * width * sin;
            Body body = new Body(new Rectangle(isWelded ? 0.5 * width : width, height));
            body.setMass(isWelded ? 0.5 * mass : mass);
            body.at(pose[0] + x, pose[1] + y, pose[2]);
            put(body.moving(velocity[0] - velocity[2] * y, velocity[1] + velocity[2] * x, velocity[2]));
            if (last != null) {
                engine.add(new WeldJoint(last, body, pose[0], pose[1]));
            }
            last = body;
        }
    }

    private double energyAfter(int steps, boolean isWelded) {
        engine.setTimeStep(TIME / steps);
        engine.add(new Gravity(0, -9.81));
        put(Body.fixed(new Rectangle(20, 2)).at(0, -9.688579327635907));
        box(0.7021536364147383, 0.692392169253357, 3.70551027363244, isWelded,
                new double[] {-1.1914610446563598, -7.241673891009945, 0.28788302614030475},
                new double[] {-0.873554610725723, -9.486595436458687, 0.048824623010694096});
        box(1.1723893006083266, 0.6241042925731831, 1, isWelded,
                new double[] {-1.7265650029356172, -8.04409331232747, -1.421108304930775},
                new double[] {-0.2526656390270562, -12.295779052969362, -0.38089813994489985});
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
        return engine.kineticEnergy();
    }

    /** Whatever the step, and whether each is one body that lies in a heap or two that are welded, which meet at impacts: 0.02 to 0.14 J were left. */
    @ParameterizedTest
    @CsvSource({"3, false", "12, false", "48, false", "192, false", "3, true", "12, true", "48, true"})
    void theyGoOn(int steps, boolean isWelded) {
        assertThat(energyAfter(steps, isWelded)).isCloseTo(176.875, within(0.1));
        assertThat(engine.getImpacts()).isLessThan(20);
        assertThat(engine.getDeepestPenetration()).isLessThan(1e-9);
    }
}
