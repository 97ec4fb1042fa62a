// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.ViscousFriction;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** What a listener lets stick does not slide as long as it is pressed on, without any friction; and comes off when pulled. */
class StickingTest {
    private static final double G = 9.81;

    /** Lets one body stick to all others, or all if it is null. */
    private static final class Glue implements CollisionListener {
        private static final long serialVersionUID = 1L;
        private final Body sticky;

        Glue(Body sticky) {
            this.sticky = sticky;
        }

        @Override
        public Decision colliding(Contact contact) {
            boolean yes = sticky == null || contact.a() == sticky || contact.b() == sticky;
            return yes ? Decision.STICK : Decision.BOUNCE;
        }
    }

    private final PhysicsEngine engine = new PhysicsEngine();

    StickingTest() {
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -G));
    }

    private Body box(double x, double y) {
        Body box = engine.add(new Body(new Rectangle(1, 1)).at(x, y));
        box.setRestitution(0.5);
        return box;
    }

    private void run(int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    @Test
    void aBoxSticksToASlopeWithoutFriction() {
        double slope = StrictMath.atan(0.5);
        engine.add(Body.fixed(new Rectangle(400, 2))).setAngle(-slope);
        Body box = box(1.5 * StrictMath.sin(slope), 1.5 * StrictMath.cos(slope));
        box.setAngle(-slope);
        double x = box.getX();
        engine.addListener(new Glue(null));
        run(300);
        assertThat(box.getX()).isCloseTo(x, within(1e-7));
        assertThat(box.kineticEnergy()).isZero();
    }

    @Test
    void aBoxThatFallsOnASlopeAskewComesToRestWhereItSticks() {
        double slope = StrictMath.atan(0.3);
        engine.add(Body.fixed(new Rectangle(400, 2))).setAngle(-slope);
        Body box = box(1, 3);
        box.setAngle(0.2);
        engine.addListener(new Glue(null));
        run(600);
        double x = box.getX();
        run(300);
        assertThat(box.getX()).isEqualTo(x);
        assertThat(box.kineticEnergy()).isZero();
    }

    /** The floor is smooth and does not stick: a force on the lower box accelerates both alike. */
    @Test
    void aBoxCarriesWhatSticksToIt() {
        engine.add(Body.fixed(new Rectangle(400, 2)).at(0, -1));
        Body below = box(0, 0.6);
        Body above = box(0, 1.7);
        engine.addListener(new Glue(above));
        run(300);
        for (int k = 0; k < 60; k++) {
            below.addForce(3, 0);
            engine.step();
        }
        assertThat(below.getVelocityX()).isCloseTo(1.5, within(1e-8));
        assertThat(above.getVelocityX()).isCloseTo(1.5, within(1e-8));
        assertThat(above.getX()).isCloseTo(below.getX(), within(1e-6));
    }

    @Test
    void aDrivenBoxSticksToTheFloor() {
        engine.add(Body.fixed(new Rectangle(400, 2)).at(0, -1));
        engine.add(new ViscousFriction(1));
        Body box = box(0, 0.6);
        box.setSurfaceFriction(0.1);
        engine.addListener(new Glue(null));
        run(120);
        double x = box.getX();
        for (int k = 0; k < 300; k++) {
            box.addForce(2, 0);
            engine.step();
        }
        assertThat(box.getX()).isCloseTo(x, within(1e-6));
    }

    @Test
    void aDiscThatSticksRolls() {
        double slope = StrictMath.atan(0.5);
        engine.add(Body.fixed(new Rectangle(400, 2))).setAngle(-slope);
        Body disc = engine.add(new Body(new Circle(0.5)).at(1.5 * StrictMath.sin(slope), 1.5 * StrictMath.cos(slope)));
        engine.addListener(new Glue(null));
        run(120);
        double speed = 2 * 2.0 / 3 * G * StrictMath.sin(slope);
        assertThat(StrictMath.hypot(disc.getVelocityX(), disc.getVelocityY())).isCloseTo(speed, within(1e-9));
    }

    @Test
    void whatSticksComesOffWhenItIsPulled() {
        engine.add(Body.fixed(new Rectangle(400, 2)).at(0, -1));
        Body box = box(0, 0.6);
        engine.addListener(new Glue(null));
        run(300);
        for (int k = 0; k < 60; k++) {
            box.addForce(0, 2 * G);
            engine.step();
        }
        assertThat(box.getVelocityY()).isCloseTo(G, within(1e-8));
    }

    @Test
    void whatSticksToNobodyAnyMoreSlides() {
        double slope = StrictMath.atan(0.5);
        engine.add(Body.fixed(new Rectangle(400, 2))).setAngle(-slope);
        Body box = box(1.5 * StrictMath.sin(slope), 1.5 * StrictMath.cos(slope));
        box.setAngle(-slope);
        Glue glue = new Glue(null);
        engine.addListener(glue);
        run(60);
        engine.removeListener(glue);
        box.setVelocity(box.getVelocityX(), box.getVelocityY()); // it lies down anew
        double x = box.getX();
        run(60);
        assertThat(box.getX()).isGreaterThan(x + 1);
    }
}
