// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/** Chains under time stepping: joints that are regained too eagerly throw one another about, and the sooner, the shorter the step. */
class SteppedChainTest {
    private static final double G = 9.81;

    @ParameterizedTest
    @CsvSource({"3, 60, 1", "3, 1000, 20", "10, 60, 20", "10, 1000, 1", "10, 10000, 1", "10, 10000, 20", "40, 60, 20", "40, 1000, 20"})
    void aChainThatFallsGainsNoEnergy(int links, int stepsInASecond, double tip) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / stepsInASecond);
        engine.setTimeStepping(4);
        engine.add(new Gravity(0, -G));
        List<Body> chain = new ArrayList<>();
        double unit = 0;
        for (int k = 0; k < links; k++) {
            Body link = engine.add(new Body(new Rectangle(1, 0.02)).at(k + 0.5, 0));
            double mass = k == links - 1 ? tip : 1;
            link.setMass(mass, mass / 12);
            link.setCollisionGroup(1, 0);
            engine.add(k == 0 ? new PinJoint(link, 0, 0) : new PinJoint(chain.get(k - 1), link, k, 0));
            chain.add(link);
            unit += mass * G * link.getX();
        }
        double most = 0;
        for (int step = 0; step < Math.min(10 * stepsInASecond, 20_000); step++) {
            engine.step();
            double energy = engine.kineticEnergy();
            for (Body link : chain) {
                energy += link.getMass() * G * link.getY();
            }
            most = Math.max(most, energy / unit);
        }
        assertThat(most).isLessThan(5e-3);
    }
}
