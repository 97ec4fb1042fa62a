// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** In a call of a listener, every body is where it is at the instant of the collision, and what the call sets is kept. */
class ListenerReadsTest {
    private static final double MEETING = 0.053;

    private final PhysicsEngine engine = new PhysicsEngine();
    private int calls;

    /** Does something when it is asked, or told, for the first time. */
    private static final class Once implements CollisionListener {
        private static final long serialVersionUID = 1L;

        private final transient Consumer<Contact> asked;
        private final transient Consumer<Contact> told;
        private boolean isAsked;
        private boolean isTold;

        Once(Consumer<Contact> asked, Consumer<Contact> told) {
            this.asked = asked;
            this.told = told;
        }

        @Override
        public Decision colliding(Contact contact) {
            if (!isAsked) {
                isAsked = true;
                asked.accept(contact);
            }
            return Decision.BOUNCE;
        }

        @Override
        public void collided(Contact contact) {
            if (!isTold) {
                isTold = true;
                told.accept(contact);
            }
        }
    }

    /** A force against the motion of one body. */
    private static final class Drag implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        private final Body slow;

        Drag(Body slow) {
            this.slow = slow;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            if (body == slow) {
                forces.add(body, -3 * body.getMass() * body.getVelocityX(), -3 * body.getMass() * body.getVelocityY());
            }
        }
    }

    private Body ball(double x) {
        Body ball = engine.add(new Body(new Circle(0.5)).at(x, 0.5 + 10 * MEETING).moving(0, -10));
        ball.setRestitution(1);
        ball.setFriction(0);
        return ball;
    }

    private void floor() {
        engine.setTimeStep(0.1);
        engine.add(Body.fixed(new Rectangle(40, 2)).at(0, -1));
    }

    @Test
    void whatFliesIsWhereItIsThen() {
        floor();
        ball(-3);
        Body other = engine.add(new Body(new Circle(0.5)).at(5, 11).moving(1, 2, 3));
        Consumer<Contact> look = contact -> {
            calls++;
            assertThat(contact.time()).isCloseTo(MEETING, within(1e-15));
            assertThat(other.getX()).isCloseTo(5 + MEETING, within(1e-14));
            assertThat(other.getY()).isCloseTo(11 + 2 * MEETING, within(1e-14));
            assertThat(other.getAngle()).isCloseTo(3 * MEETING, within(1e-14));
        };
        engine.addListener(new Once(look, look));
        engine.step();
        assertThat(calls).isEqualTo(2);
        assertThat(other.getX()).isCloseTo(5.1, within(1e-14));
    }

    /** What a force drives, or a joint ties, to the error of its method: at the end of the step it was off by 4 cm. */
    @Test
    void whatIsDrivenOrTiedIsWhereItIsThen() {
        floor();
        ball(-3);
        Body slow = engine.add(new Body(new Circle(0.5)).at(5, 11).moving(1, 2));
        engine.add(new Drag(slow));
        Body bar = engine.add(new Body(new Rectangle(1, 0.1)).at(10.5, 10).moving(0, 1, 2));
        engine.add(new PinJoint(bar, 10, 10));
        Consumer<Contact> look = contact -> {
            calls++;
            assertThat(slow.getX()).isCloseTo(5 + (1 - Math.exp(-3 * MEETING)) / 3, within(1e-5));
            assertThat(slow.getVelocityX()).isCloseTo(Math.exp(-3 * MEETING), within(1e-3));
            assertThat(bar.getAngle()).isCloseTo(2 * MEETING, within(1e-12));
            assertThat(bar.getX()).isCloseTo(10 + 0.5 * Math.cos(2 * MEETING), within(1e-5));
            assertThat(bar.getAngularVelocity()).isCloseTo(2, within(1e-12));
        };
        engine.addListener(new Once(look, look));
        engine.step();
        assertThat(calls).isEqualTo(2);
    }

    /** To read does not change the run by a bit. */
    @Test
    void readingChangesNothing() {
        ListenerReadsTest unread = new ListenerReadsTest();
        for (ListenerReadsTest one : new ListenerReadsTest[] {this, unread}) {
            one.floor();
            one.ball(-3);
            Body slow = one.engine.add(new Body(new Circle(0.5)).at(5, 11).moving(1, 2));
            one.engine.add(new Drag(slow));
            Consumer<Contact> look = contact -> one.calls += one == unread || slow.getX() + slow.getVelocityY() > 0 ? 1 : 0;
            one.engine.addListener(new Once(look, look));
            for (int k = 0; k < 20; k++) {
                one.engine.step();
            }
        }
        assertThat(calls).isEqualTo(unread.calls).isEqualTo(2);
        for (int k = 0; k < engine.bodies().size(); k++) {
            Body one = engine.bodies().get(k);
            Body other = unread.engine.bodies().get(k);
            assertThat(one.getX()).isEqualTo(other.getX());
            assertThat(one.getVelocityY()).isEqualTo(other.getVelocityY());
        }
    }

    /** Three balls land at one instant; of the first one's landing the listener is told first, and moves the second one. */
    @Test
    void whatIsSetOnOneThatCollidesAtTheSameInstantIsKept() {
        floor();
        ball(-3);
        Body second = ball(0);
        Body third = ball(3);
        engine.addListener(new Once(contact -> third.setVelocity(1, -5), contact -> second.setPosition(second.getX() + 0.1, second.getY())));
        engine.step();
        assertThat(engine.getImpacts()).isGreaterThanOrEqualTo(3);
        assertThat(second.getX()).isCloseTo(0.1, within(1e-14));
        assertThat(second.getY()).isCloseTo(0.5 + 10 * (0.1 - MEETING), within(1e-12));
        assertThat(third.getX()).isCloseTo(3 + (0.1 - MEETING), within(1e-12));
        assertThat(third.getY()).isCloseTo(0.5 + 5 * (0.1 - MEETING), within(1e-12));
    }
}
