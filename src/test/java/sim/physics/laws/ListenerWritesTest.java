// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sim.physics.Cuts;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Spring;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** What a listener changes on bodies that do not collide takes effect at the instant of the collision, from where they are. */
class ListenerWritesTest {
    private double atEntry;

    /** Two balls that meet at the time 0.6 of the first step. */
    private static PhysicsEngine twoBalls() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.add(new Body(new Circle(1)).moving(1, 0));
        engine.add(new Body(new Circle(1)).at(3.2, 0).moving(-1, 0));
        return engine;
    }

    private static final class TurnsThird implements CollisionListener {
        private static final long serialVersionUID = 1L;

        private final Body third;

        TurnsThird(Body third) {
            this.third = third;
        }

        @Override
        public void collided(Contact contact) {
            third.setVelocity(0, 2);
        }
    }

    @Test
    void aThirdBodyTurnsWhereItIs() {
        PhysicsEngine engine = twoBalls();
        Body third = engine.add(new Body(new Circle(1)).at(0, 10).moving(1, 0, 0.5));
        engine.addListener(new TurnsThird(third));
        engine.step();
        assertThat(third.getX()).isCloseTo(0.6, within(1e-14));
        assertThat(third.getY()).isCloseTo(10 + 2 * 0.4, within(1e-14));
        assertThat(third.getAngle()).isCloseTo(0.5, within(1e-15));
    }

    @Test
    void aPinThatIsCutInAStepLetsGoAtThatInstant() {
        PhysicsEngine engine = twoBalls();
        Body rod = engine.add(new Body(new Rectangle(2, 0.1)).at(1, 10).moving(0, 1.5, 1.5));
        engine.addListener(new Cuts(engine, engine.add(new PinJoint(rod, 0, 10))));
        engine.setTimeStep(0.07);
        while (engine.getTime() < 1) {
            engine.step();
        }
        double angle = 1.5 * 0.6;
        double flown = engine.getTime() - 0.6;
        double x = StrictMath.cos(angle);
        double y = StrictMath.sin(angle);
        assertThat(engine.allConstraints()).isEmpty();
        assertThat(rod.getAngle()).isCloseTo(1.5 * engine.getTime(), within(1e-6));
        assertThat(rod.getX()).isCloseTo(x - flown * 1.5 * y, within(1e-6));
        assertThat(rod.getY()).isCloseTo(10 + y + flown * 1.5 * x, within(1e-6));
    }

    /** A spring pulls a body that comes into the engine within a step, whatever its number was before. */
    @Test
    void aSpringPullsWhatComesLater() {
        PhysicsEngine one = new PhysicsEngine();
        one.setTimeStep(0.1);
        Body[] links = new Body[2];
        for (int k = 0; k < 2; k++) {
            links[k] = one.add(new Body(new Rectangle(1, 0.1)).at(0.5 + k, 0));
            one.add(new PinJoint(links[k], k == 0 ? null : links[0], k, 0));
        }
        Body later = new Body(new Circle(0.2)).at(0, 3);
        one.add(new Spring(links[0], 0, 0, later, 0, 0, 1, 5, 0));
        Body ball = one.add(new Body(new Circle(0.1)).at(10, 10));
        ball.setVelocity(1.07, 0);
        one.add(new Body(new Circle(0.1)).at(11, 10));
        one.addListener(new CollisionListener() {
            @Override
            public void collided(Contact contact) {
                if (!one.bodies().contains(later)) {
                    one.add(later);
                    atEntry = momentOfAll(links, later);
                }
            }
        });
        for (int k = 0; k < 40; k++) {
            one.step();
        }
        assertThat(later.getVelocityY()).isNotZero();
        assertThat(momentOfAll(links, later)).isEqualTo(atEntry, within(1e-2)); // about the pin, whose force has no moment
    }

    private static double momentOfAll(Body[] links, Body later) {
        double sum = 0;
        for (Body b : new Body[] {links[0], links[1], later}) {
            sum += b.getInertia() * b.getAngularVelocity()
                    + b.getMass() * (b.getX() * b.getVelocityY() - b.getY() * b.getVelocityX());
        }
        return sum;
    }
}
