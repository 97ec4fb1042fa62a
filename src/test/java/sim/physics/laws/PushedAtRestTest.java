// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Limit;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/**
 * What is at rest and is pushed, for one step and less than would move it, rests on as it did: when the force ends the ground bears
 * something else. It was borne as if it still were pushed, and sank into the ground with what the force had been.
 */
class PushedAtRestTest {
    private static final double FORCE = 0.1;

    private final PhysicsEngine engine = new PhysicsEngine();

    PushedAtRestTest() {
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -9.81));
        put(Body.fixed(new Rectangle(20, 1)).at(0, -0.5));
    }

    private Body put(Body body) {
        body.setFriction(0.5);
        body.setRestitution(0);
        return engine.add(body);
    }

    private Body put(Shape shape, double x, double y) {
        return put(new Body(shape).at(x, y));
    }

    private void steps(int n) {
        for (int k = 0; k < n; k++) {
            engine.step();
        }
    }

    @ParameterizedTest
    @CsvSource({"1, 0, 1", "1, 0, -1", "1, 1, 0", "2, 0, 1", "2, 0, -1", "2, 1, 0"})
    void aPushThatMovesNothingLeavesNothing(int high, double fx, double fy) {
        Body top = null;
        for (int k = 0; k < high; k++) {
            top = put(new Rectangle(1, 1), 0, k + 0.5);
        }
        steps(50);
        double y = top.getY();
        top.addForce(FORCE * fx, FORCE * fy);
        steps(60);
        assertThat(top.getX()).isZero();
        assertThat(top.getY()).isCloseTo(y, within(1e-9));
        assertThat(top.getVelocityX()).isZero();
        assertThat(top.getVelocityY()).isZero();
    }

    /** It is driven from then on, and what it rested on must be seen. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void whatIsPushedAndTiedInOneStepStaysOnTheGround(boolean bySpring) {
        Body disc = put(new Circle(0.5), 0, 0.5);
        Body box = put(new Rectangle(1, 1), 3, 0.5);
        steps(50);
        if (bySpring) {
            engine.add(new Spring(disc, 0, 0, null, 0, 3, 2.5, 0.1, 0));
        } else {
            engine.add(Limit.rope(disc, 0, 0, box, 0, 0, 5));
        }
        disc.addForce(0, FORCE);
        steps(60);
        assertThat(disc.getY()).isCloseTo(0.5, within(1e-6));
    }

    /** A push that lifts it does so. */
    @Test
    void aPushThatIsStrongerThanItsWeightLiftsIt() {
        Body box = put(new Rectangle(1, 1), 0, 0.5);
        steps(50);
        box.addForce(0, 20 * box.getMass());
        engine.step();
        double h = engine.getTimeStep();
        assertThat(box.getY() - 0.5).isCloseTo((20 - 9.81) * h * h / 2, within(1e-12));
    }
}
