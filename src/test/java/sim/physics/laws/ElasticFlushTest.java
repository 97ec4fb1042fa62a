// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.response.LastingContact;
import sim.physics.shape.Rectangle;

/**
 * Bodies with the restitution of new ones, 1, that an author has put on the ground: 0.1 + 0.2 is above it by a rounding,
 * and places left and right of the origin make impacts at the same instant. They stand; what falls, be it from 10⁻⁹, does not.
 */
class ElasticFlushTest {
    private static final double GRAVITY = 9.81;

    private static PhysicsEngine ground(double width) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 60);
        engine.add(new Gravity(0, -GRAVITY));
        engine.add(Body.fixed(new Rectangle(width, 0.2)));
        return engine;
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 11, 60})
    void boxesStandWhereTheyWerePut(int count) {
        PhysicsEngine engine = ground(300);
        for (int k = 0; k < count; k++) {
            engine.add(new Body(new Rectangle(0.4, 0.4)).at(2 * (k - 0.5 * (count - 1)), 0.1 + 0.2));
        }
        engine.step();
        long first = engine.getImpacts();
        for (int k = 0; k < 30; k++) {
            engine.step();
        }
        assertThat(first).isLessThanOrEqualTo(20L * count);
        assertThat(engine.getImpacts()).isEqualTo(first);
        assertThat(engine.kineticEnergy()).isZero();
        double borne = engine.contacts().stream().mapToDouble(LastingContact::normalForce).sum();
        assertThat(borne).isCloseTo(count * 0.16 * GRAVITY, within(1e-9 * count));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-9, 1e-7, 1e-4})
    void boxesThatFallBounceForEver(double height) {
        PhysicsEngine engine = ground(30);
        Body body = engine.add(new Body(new Rectangle(0.5, 0.5)).at(0, 0.35 + height));
        double most = 0;
        for (int k = 0; k < 60; k++) {
            engine.step();
            double speed = body.getVelocityY();
            most = Math.max(most, 0.5 * speed * speed / GRAVITY + body.getY() - 0.35);
        }
        assertThat(most).isCloseTo(height, within(1e-3 * height));
        assertThat(engine.kineticEnergy() + GRAVITY * body.getMass() * (body.getY() - 0.35))
                .isCloseTo(GRAVITY * body.getMass() * height, within(1e-3 * height));
        double period = 2 * StrictMath.sqrt(2 * height / GRAVITY);
        assertThat((double) engine.getImpacts()).isCloseTo(1 / period, within(0.01 / period + 1));
    }
}
