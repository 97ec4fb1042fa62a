// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.motion.Gravity;
import sim.physics.motion.SurfaceFriction;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** The smallest scenes of bodies that something presses on a fixed one: the impacts of a step are bounded. */
class SustainedContactTest {
    private static final int MOST_IMPACTS = 25_000;

    /** Draws bodies to the origin; by the integrator. */
    private static final class Pull implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        @Override
        public void addForce(Body body, double time, Forces forces) {
            forces.add(body, -body.getMass() * body.getX(), -body.getMass() * body.getY());
        }
    }

    /** Counts the impacts of a step, and ends a step that does not end by itself. */
    private static final class Counter implements CollisionListener {
        private static final long serialVersionUID = 1L;
        private final Decision decision;
        private int count;

        Counter(Decision decision) {
            this.decision = decision;
        }

        @Override
        public Decision colliding(Contact contact) {
            return decision;
        }

        @Override
        public void collided(Contact contact) {
            count++;
            assertThat(count).as("impacts in one step, %s", contact).isLessThanOrEqualTo(MOST_IMPACTS);
        }
    }

    private final PhysicsEngine engine = new PhysicsEngine();

    @BeforeEach
    void floor() {
        engine.setTimeStep(0.1);
        engine.add(Body.fixed(new Rectangle(20, 2)).at(0, -1));
    }

    private Body drop(Shape shape, double x, double restitution) {
        Body body = new Body(shape).at(x, 1);
        body.setRestitution(restitution);
        return engine.add(body);
    }

    private void run(CollisionListener.Decision decision) {
        Counter counter = new Counter(decision);
        engine.addListener(counter);
        for (int k = 0; k < 100; k++) {
            counter.count = 0;
            engine.step();
        }
    }

    @Test
    void aBallComesToRestInACorner() {
        engine.add(new Gravity(3, -9));
        engine.add(Body.fixed(new Rectangle(2, 20)).at(6, 8));
        Body ball = drop(new Circle(0.5), 4, 0);
        run(CollisionListener.Decision.BOUNCE);
        assertThat(ball.kineticEnergy()).isLessThan(0.05);
    }

    @Test
    void aBallIsPulledOnTheFloor() {
        engine.add(new Pull());
        drop(new Circle(0.5), 0.3, 0.5);
        run(CollisionListener.Decision.BOUNCE);
    }

    @Test
    void aBoxComesToRestInACorner() {
        engine.add(new Gravity(3, -9));
        engine.add(Body.fixed(new Rectangle(2, 20)).at(6, 8));
        drop(new Rectangle(1, 1), 4, 0);
        run(CollisionListener.Decision.BOUNCE);
    }

    @Test
    void aBoxIsPulledOnTheFloor() {
        engine.add(new Pull());
        drop(new Rectangle(1, 1), 0.3, 0);
        run(CollisionListener.Decision.BOUNCE);
    }

    @Test
    void aBoxWithSurfaceFrictionFallsOnTheFloor() {
        engine.add(new Gravity(0, -10));
        engine.add(new SurfaceFriction(1));
        drop(new Rectangle(1, 1), 0, 0).setSurfaceFriction(0.3);
        run(CollisionListener.Decision.BOUNCE);
    }

    @Test
    void aBoxSticksToTheFloorUnderGravity() {
        engine.add(new Gravity(0, -10));
        Body box = drop(new Rectangle(1, 1), 0.3, 0.5);
        box.setPosition(0.3, 0.5);
        box.setVelocity(1, -1);
        run(CollisionListener.Decision.STICK);
        assertThat(box.getX()).isCloseTo(0.3, within(1e-9));
        assertThat(box.kineticEnergy()).isZero();
    }
}
