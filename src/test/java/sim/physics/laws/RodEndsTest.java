// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.RodJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** A rod may be held by the world or by a fixed body, at either end. */
class RodEndsTest {
    private final PhysicsEngine engine = new PhysicsEngine();
    private final Body bob = engine.add(new Body(new Circle(0.1)).at(3, 0));
    private final Body wall = engine.add(Body.fixed(new Rectangle(1, 1)).at(-1, 2, 0.6));

    enum End {
        WORLD,
        FIXED_SECOND,
        FIXED_FIRST
    }

    @ParameterizedTest
    @EnumSource(End.class)
    void aBobSwingsDown(End end) {
        engine.setTimeStep(1 / 256.0);
        engine.add(new Gravity(0, -10));
        RodJoint rod = end == End.FIXED_FIRST
                ? new RodJoint(wall, 0, 0, bob, 3, 0)
                : new RodJoint(bob, 3, 0, end == End.WORLD ? null : wall, 0, 0);
        engine.add(rod);
        assertThat(rod.getLength()).isEqualTo(3);
        double sign = end == End.FIXED_FIRST ? -1 : 1; // what is told is the force on the first body
        while (bob.getX() > 0) {
            engine.step();
            double distance = Math.sqrt(bob.getX() * bob.getX() + bob.getY() * bob.getY());
            assertThat(distance).isCloseTo(3, within(1e-13));
            assertThat(bob.kineticEnergy()).isCloseTo(-bob.getMass() * 10 * bob.getY(), within(1e-9));
        }
        double sine = -bob.getY() / 3; // of the angle below the horizon: the pull is 3 m g times that
        double pull = Math.sqrt(square(engine.getReaction(rod).forceX()) + square(engine.getReaction(rod).forceY()));
        assertThat(pull).isCloseTo(3 * bob.getMass() * 10 * sine, within(1e-7));
        assertThat(Math.signum(engine.getReaction(rod).forceY())).isEqualTo(sign);
    }

    private static double square(double x) {
        return x * x;
    }

    @Test
    void whatCannotMoveIsNotLinked() {
        Body other = engine.add(Body.fixed(new Rectangle(1, 1)).at(9, 9));
        refused(new RodJoint(wall, 0, 0, null, 1, 1));
        refused(new RodJoint(wall, 0, 0, other, 9, 9));
        assertThatNullPointerException()
                .isThrownBy(() -> new RodJoint(null, 0, 0, null, 1, 1))
                .withMessageContaining("only the second body of a joint may be null, for the world");
        assertThat(engine.allConstraints()).isEmpty();
    }

    private void refused(RodJoint rod) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> engine.add(rod))
                .withMessageContaining("none of its bodies can move, but one of them must");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> engine.assemble(rod))
                .withMessageContaining("none of its bodies can move");
    }
}
