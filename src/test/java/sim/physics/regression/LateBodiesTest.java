// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Automatic;
import sim.physics.motion.Body;
import sim.physics.motion.DormandPrince853;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;

/** What one method has noted of the bodies there were does not have room for those that come after another one was chosen. */
class LateBodiesTest {
    @Test
    void bodiesMayComeAfterAutomaticWasReplaced() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.1);
        engine.setIntegrator(new Automatic(1e-9));
        Body first = hang(engine, 0);
        engine.step();
        engine.setIntegrator(new DormandPrince853(1e-9));
        for (int k = 1; k < 40; k++) {
            hang(engine, 3 * k);
        }
        Body last = engine.bodies().get(39);
        for (int k = 0; k < 20; k++) {
            engine.step();
        }
        double stiffness = 5;
        double omega = StrictMath.sqrt(stiffness / first.getMass());
        assertThat(first.getX()).isCloseTo(1 + StrictMath.cos(2.1 * omega), within(1e-6));
        assertThat(last.getX()).isCloseTo(3 * 39 + 1 + StrictMath.cos(2 * omega), within(1e-6));
    }

    /** On a spring of length 1, and pulled out by as much. */
    private static Body hang(PhysicsEngine engine, double x) {
        Body body = engine.add(new Body(new Circle(0.2)).at(x + 2, 0));
        engine.add(new Spring(body, 0, 0, null, x, 0, 1, 5, 0));
        return body;
    }
}
