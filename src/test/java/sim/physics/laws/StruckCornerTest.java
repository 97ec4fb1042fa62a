// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Rectangle;

/**
 * A box is put with one corner in a wall, and turns so that this one leaves while the next one comes in: where that one strikes, the wall
 * pushes, and pulls nowhere.
 */
class StruckCornerTest {
    private double told;

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.3, 0.54, 1})
    void theWallOnlyPushes(double restitution) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        Body wall = engine.add(Body.fixed(new Rectangle(0.4, 4)).at(1.2, 0));
        wall.setRestitution(restitution);
        Body box = engine.add(new Body(new Rectangle(0.79, 0.57)).at(0.613, 0, 0.04)).moving(0, 0, -2);
        box.setRestitution(restitution);
        engine.addListener(new CollisionListener() {
            private static final long serialVersionUID = 1L;

            @Override
            public void collided(Contact contact) {
                told += contact.impulse() * (contact.a() == box ? -contact.normalX() : contact.normalX());
            }
        });
        double energy = box.kineticEnergy();
        for (int k = 0; k < 60; k++) {
            engine.step();
            assertThat(box.getVelocityX()).as("step " + k).isLessThanOrEqualTo(0);
            assertThat(box.getMass() * box.getVelocityX()).as("step " + k).isCloseTo(told, within(1e-12));
        }
        assertThat(told).isNegative();
        assertThat(box.kineticEnergy()).isLessThanOrEqualTo(energy * (1 + 1e-12));
    }
}
