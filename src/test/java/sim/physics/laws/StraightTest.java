// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.DoubleStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.motion.Body;
import sim.physics.shape.Circle;

/**
 * Where nothing has ever been accelerated, nobody looks at accelerations. A body far off that is pushed once makes an engine
 * look at all of them: the others, whose are zero, must not move by another bit.
 */
class StraightTest {
    private static final int STEPS = 400;

    @ParameterizedTest
    @ValueSource(ints = {12, 40, 120})
    void bodiesMoveTheSameWhetherOrNotAnotherOneWasEverPushed(int bodies) {
        double[] alone = gas(Scenes.Kind.FIGURE_1, bodies, 0);
        assertThat(gas(Scenes.Kind.FIGURE_1, bodies, 1)).isEqualTo(alone);
    }

    @ParameterizedTest
    @ValueSource(ints = {12, 60})
    void polygonsToo(int bodies) {
        double[] alone = gas(Scenes.Kind.POLYGONS, bodies, 0);
        assertThat(gas(Scenes.Kind.POLYGONS, bodies, 1)).isEqualTo(alone);
    }

    /** Where the bodies of a gas are and how fast after some steps, but for the far one. */
    private static double[] gas(Scenes.Kind kind, int bodies, double push) {
        PhysicsEngine engine = Scenes.gas(kind, bodies, 21);
        Body far = engine.add(new Body(new Circle(1)).at(1e6, 1e6));
        far.addForce(push, 0);
        for (int k = 0; k < STEPS; k++) {
            engine.step();
        }
        assertThat(engine.getImpacts()).isGreaterThan(bodies);
        assertThat(far.getVelocityX() != 0).isEqualTo(push != 0);
        return engine.bodies().stream()
                .filter(body -> body != far)
                .flatMapToDouble(StraightTest::values)
                .toArray();
    }

    private static DoubleStream values(Body b) {
        return DoubleStream.of(
                b.getX(), b.getY(), b.getAngle(), b.getVelocityX(), b.getVelocityY(), b.getAngularVelocity());
    }
}
