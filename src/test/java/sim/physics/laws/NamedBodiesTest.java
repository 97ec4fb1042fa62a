// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;

/** Force generators that name their bodies, when these or the names change at odd moments. */
class NamedBodiesTest {
    /** A push to the right on the bodies of a list. */
    private static final class Push implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private ArrayList<Body> bodies;

        private Push(List<Body> bodies) {
            this.bodies = bodies == null ? null : new ArrayList<>(bodies);
        }

        @Override
        public List<Body> getBodies() {
            if (bodies == null) {
                throw new IllegalStateException("not ready");
            }
            return bodies;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            forces.add(body, 1, 0);
        }
    }

    private static PhysicsEngine engine() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 64.0);
        return engine;
    }

    private static Body ball(PhysicsEngine engine, double x) {
        Body ball = engine.add(new Body(new Circle(0.5)).at(x, 0));
        ball.setMass(1);
        return ball;
    }

    @Test
    void aBodyThatASpringCouplesMayLeaveBeforeItsFirstStep() {
        PhysicsEngine engine = engine();
        Body stays = ball(engine, 0);
        Body leaves = ball(engine, 3);
        Body hangs = ball(engine, 6);
        PinJoint pin = engine.add(new PinJoint(hangs, 7, 0));
        engine.add(new Spring(stays, 0, 0, leaves, 0, 0, 1, 5, 0));
        engine.getReaction(pin); // asks what moves together
        engine.remove(leaves);
        engine.step();
        assertThat(stays.getVelocityX()).isZero(); // the spring has left with its end
        assertThat(hangs.getX()).isEqualTo(6);
    }

    @Test
    void aGeneratorThatIsRemovedActsNoMoreWhateverItNames() {
        PhysicsEngine engine = engine();
        Body pushed = ball(engine, 0);
        Body other = ball(engine, 3);
        Push push = new Push(List.of(pushed));
        engine.add(push);
        engine.add(new Push(List.of(other)));
        engine.step();
        assertThat(pushed.getVelocityX()).isCloseTo(1 / 64.0, within(1e-15));
        push.bodies.clear();
        engine.remove(push);
        engine.step();
        assertThat(pushed.getVelocityX()).isCloseTo(1 / 64.0, within(1e-15));
    }

    @Test
    void aGeneratorThatCannotNameItsBodiesIsNotAdded() {
        PhysicsEngine engine = engine();
        Body ball = ball(engine, 0);
        Push push = new Push(null);
        assertThatThrownBy(() -> engine.add(push)).hasMessage("not ready");
        push.bodies = new ArrayList<>(List.of(ball));
        engine.add(push);
        engine.step();
        assertThat(ball.getVelocityX()).isCloseTo(1 / 64.0, within(1e-15));
    }

    @Test
    void oneGeneratorServesTwoEnginesThatExchangeTheirBodies() {
        PhysicsEngine one = engine();
        PhysicsEngine two = engine();
        ball(two, 9); // so that places of bodies differ
        Body a = ball(one, 0);
        Body b = ball(two, 3);
        Push push = new Push(List.of(a, b));
        one.add(push);
        two.add(push);
        one.step();
        two.step();
        one.remove(a);
        two.remove(b);
        one.add(b);
        two.add(a);
        one.step();
        two.step();
        assertThat(a.getVelocityX()).isCloseTo(2 / 64.0, within(1e-15));
        assertThat(b.getVelocityX()).isCloseTo(2 / 64.0, within(1e-15));
    }
}
