// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Rectangle;

/** Elastic bars end to end in a row, which all spin alike: their ends close from rest on, and bounce off without end. Every step ends. */
class FlushSpinTest {
    private static final int MOST = 400_000;

    private int told;

    @ParameterizedTest
    @CsvSource({
        "5, 0.5, 0, 0", "5, 0.5, 0, 7.14", "5, 35.000054, 0.3, 7.14", "20, 0.5, 0, 7.14", "20, 35.000054, 0.3, 0", "20, 35.000054, 0.3, 7.14"
    })
    void theStepEndsAndNothingIsLost(int count, double x, double angle, double speed) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        for (int k = 0; k < count; k++) {
            Body bar = engine.add(new Body(new Rectangle(1, 0.2)).at(x + k * Math.cos(angle), k * Math.sin(angle), angle));
            bar.setVelocity(speed, 0);
            bar.setAngularVelocity(2.444);
        }
        engine.addListener(new CollisionListener() {
            private static final long serialVersionUID = 1L;

            @Override
            public void collided(Contact contact) {
                if (++told > MOST) {
                    throw new IllegalStateException("step " + engine.getSteps() + " does not end");
                }
            }
        });
        double energy = engine.kineticEnergy();
        for (int k = 0; k < 10; k++) {
            told = 0;
            engine.step();
        }
        assertThat(engine.kineticEnergy()).isEqualTo(energy, within(1e-12 * energy));
        double momentum = engine.bodies().stream().mapToDouble(b -> b.getMass() * b.getVelocityX()).sum();
        assertThat(momentum).isEqualTo(count * 0.2 * speed, within(1e-11));
        assertThat(engine.getDeepestPenetration()).isLessThan(1e-6);
    }
}
