// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.motion.Body;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;

/**
 * Elastic impacts of free bodies of which nobody is told are solved on the shortest way. One who listens and does nothing
 * makes the engine go the long way, to the same bits.
 */
class PlainImpactTest {
    private static final int STEPS = 400;

    @ParameterizedTest
    @ValueSource(ints = {12, 120})
    void listeningChangesNoBit(int bodies) {
        assertThat(run(Scenes.gas(Scenes.Kind.FIGURE_1, bodies, 5), true))
                .isEqualTo(run(Scenes.gas(Scenes.Kind.FIGURE_1, bodies, 5), false));
        assertThat(run(Scenes.s3(bodies, 6), true)).isEqualTo(run(Scenes.s3(bodies, 6), false));
    }

    @Test
    void norWhereOnlySomeImpactsArePlain() {
        assertThat(run(mixed(), true)).isEqualTo(run(mixed(), false));
    }

    /** Some bodies lose energy or rub, so that both ways are taken in turns. */
    private static PhysicsEngine mixed() {
        PhysicsEngine engine = Scenes.gas(Scenes.Kind.FIGURE_1, 60, 7);
        int k = 0;
        for (Body body : engine.bodies()) {
            body.setRestitution(k % 5 == 0 ? 0.9 : 1);
            body.setFriction(k++ % 2 == 0 ? 0 : 0.3); // the mean of both is 0 with one that has none
        }
        return engine;
    }

    private static double[] run(PhysicsEngine engine, boolean isHeard) {
        long[] heard = {0};
        if (isHeard) {
            engine.addListener(new CollisionListener() {
                @Override
                public void collided(Contact contact) {
                    heard[0]++;
                }
            });
        }
        for (int k = 0; k < STEPS; k++) {
            engine.step();
        }
        assertThat(engine.getImpacts()).isGreaterThan(engine.bodies().size());
        assertThat(heard[0]).isEqualTo(isHeard ? engine.getImpacts() : 0);
        return DoubleStream.concat(
                        DoubleStream.of(engine.getImpacts()),
                        engine.bodies().stream().flatMapToDouble(b -> DoubleStream.of(
                                b.getX(), b.getY(), b.getAngle(), b.getVelocityX(), b.getVelocityY(),
                                b.getAngularVelocity())))
                .toArray();
    }
}
