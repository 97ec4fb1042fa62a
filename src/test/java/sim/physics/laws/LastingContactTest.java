// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.ViscousFriction;
import sim.physics.response.CollisionListener;
import sim.physics.response.Contact;
import sim.physics.response.ContactListener;
import sim.physics.response.LastingContact;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** The forces of contacts that last are those that Newton's and Coulomb's laws ask for; they begin, last, and end. */
class LastingContactTest {
    private static final double G = 9.81;

    private final PhysicsEngine engine = new PhysicsEngine();

    LastingContactTest() {
        engine.setTimeStep(1 / 60.0);
        engine.add(new Gravity(0, -G));
    }

    private Body put(Body body, double friction) {
        body.setRestitution(0.3);
        body.setFriction(friction);
        return engine.add(body);
    }

    private Body floor(double friction) {
        return put(Body.fixed(new Rectangle(100, 2)).at(0, -1), friction);
    }

    private void run(int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    /** The sum of the forces of contacts on a body. */
    private double[] sum(Body body) {
        double[] sum = new double[3];
        for (LastingContact c : engine.contacts(body)) {
            double x = c.forceX(body);
            double y = c.forceY(body);
            sum[0] += x;
            sum[1] += y;
            sum[2] += (c.x() - body.getX()) * y - (c.y() - body.getY()) * x;
        }
        return sum;
    }

    private void assertBorne(Body body, double x, double y, double error) {
        double[] sum = sum(body);
        assertThat(sum[0]).isCloseTo(x, within(error));
        assertThat(sum[1]).isCloseTo(y, within(error));
        assertThat(sum[2]).as("torque").isCloseTo(0, within(error));
    }

    private void assertCone(double friction) {
        for (LastingContact c : engine.contacts()) {
            assertThat(c.normalForce()).isNotNegative();
            assertThat(Math.abs(c.tangentForce())).isLessThanOrEqualTo(friction * c.normalForce() * (1 + 1e-9) + 1e-9);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.2})
    void aStackBearsItsWeight(double offset) {
        Body floor = floor(0.5);
        List<Body> stack = new ArrayList<>();
        for (int k = 0; k < 5; k++) {
            stack.add(put(new Body(new Rectangle(1, 1)).at(offset * (k % 2), 1.1 * k + 0.6), 0.5));
        }
        run(600);
        assertThat(engine.kineticEnergy()).isZero();
        for (Body body : stack) {
            assertBorne(body, 0, body.getMass() * G, 1e-6);
        }
        assertThat(sum(floor)[1]).isCloseTo(-5 * G, within(1e-6));
        assertThat(engine.contacts()).hasSize(5);
        assertThat(engine.contacts(stack.get(2))).hasSize(2);
        assertCone(0.5);
    }

    @Test
    void aBoxOnASlopeIsHeldByFriction() {
        double slope = StrictMath.atan(0.5);
        Body ground = floor(0.6);
        ground.setPosition(0, 0);
        ground.setAngle(-slope);
        Body box = put(new Body(new Rectangle(1, 1)).at(1.5 * StrictMath.sin(slope), 1.5 * StrictMath.cos(slope)), 0.6);
        box.setAngle(-slope);
        run(120);
        assertBorne(box, 0, G, 1e-8);
        LastingContact c = engine.contacts().get(0);
        assertThat(c.normalForce()).isCloseTo(G * StrictMath.cos(slope), within(1e-8));
        assertThat(Math.abs(c.tangentForce())).isCloseTo(G * StrictMath.sin(slope), within(1e-8));
        assertThat(c.normalX()).isCloseTo(StrictMath.sin(slope), within(1e-12));
        assertThat(c.other(box)).isSameAs(ground);
        assertThat(c.x()).as("below the centre, where the weight's line meets the ground").isCloseTo(box.getX(), within(1e-8));
    }

    @Test
    void aBoxThatSlidesRubsAtTheEdgeOfTheCone() {
        floor(0.25);
        Body box = put(new Body(new Rectangle(2, 1)).at(0, 0.5), 0.25);
        run(60);
        box.setVelocity(5, 0);
        run(30);
        assertBorne(box, -0.25 * box.getMass() * G, box.getMass() * G, 1e-6);
        assertCone(0.25);
    }

    @Test
    void aDiscRollsByAThirdOfItsWeightDownTheSlope() {
        double slope = StrictMath.atan(0.5);
        Body ground = floor(0.6);
        ground.setPosition(0, 0);
        ground.setAngle(-slope);
        Body disc = put(new Body(new Circle(0.5)).at(1.5 * StrictMath.sin(slope), 1.5 * StrictMath.cos(slope)), 0.6);
        run(60);
        LastingContact c = engine.contacts(disc).get(0);
        assertThat(Math.abs(c.tangentForce())).isCloseTo(disc.getMass() * G * StrictMath.sin(slope) / 3, within(1e-8));
        assertThat(StrictMath.hypot(c.x() - disc.getX(), c.y() - disc.getY())).isCloseTo(0.5, within(1e-12));
    }

    @Test
    void aCarRestsOnItsWheels() {
        floor(0.8);
        Body chassis = put(new Body(new Rectangle(4, 1)).at(0, 2), 0.8);
        Body rear = put(new Body(new Circle(0.5)).at(-1.2, 1.2), 0.8);
        Body front = put(new Body(new Circle(0.5)).at(1.2, 1.2), 0.8);
        engine.add(new PinJoint(chassis, rear, -1.2, 1.2));
        engine.add(new PinJoint(chassis, front, 1.2, 1.2));
        chassis.setMass(4);
        run(600);
        double wheel = rear.getMass() * G;
        assertThat(sum(rear)[1]).isCloseTo(2 * G + wheel, within(1e-6));
        assertThat(sum(front)[1]).isCloseTo(2 * G + wheel, within(1e-6));
        assertThat(engine.contacts()).hasSize(2);
        assertCone(0.8);
        for (int k = 0; k < 60; k++) {
            rear.addTorque(-20);
            run(1);
            assertCone(0.8);
        }
        LastingContact push = engine.contacts(rear).get(0);
        assertThat(push.forceX(rear)).as("the wheel slips").isCloseTo(0.8 * push.normalForce(), within(1e-6));
    }

    /** Momentum that a heap gets in a step is that of its contacts and weight, whatever happens in it. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void impulsesMakeTheChangeOfMomentum(boolean driven) {
        if (driven) {
            engine.add(new ViscousFriction(0));
        }
        Body floor = floor(0.5);
        Push push = new Push(floor);
        engine.addListener(push);
        double mass = 0;
        for (int k = 0; k < 4; k++) {
            Body box = put(new Body(new Rectangle(1, 1)).at(0.1 * k, 1.1 * k + 0.6), 0.5);
            box.setSurfaceFriction(0.1);
            mass += box.getMass();
        }
        int quiet = 0;
        for (int k = 0; k < 240; k++) {
            double[] before = momentum();
            List<LastingContact> old = engine.contacts(floor);
            push.sum = 0;
            engine.step();
            double[] after = momentum();
            List<LastingContact> now = engine.contacts(floor);
            if (old.size() == 1 && now.size() == 1 && push.sum == 0) {
                double borne = -sum(floor)[1] / 60;
                assertThat(borne).as("step " + k).isCloseTo(after[1] - before[1] + mass * G / 60, within(1e-7));
                quiet++;
            }
        }
        assertThat(quiet).isGreaterThan(100);
    }

    /** Sums the impulses of collisions with the floor. */
    private static final class Push implements CollisionListener {
        private static final long serialVersionUID = 1L;
        private final Body floor;
        private double sum;

        Push(Body floor) {
            this.floor = floor;
        }

        @Override
        public void collided(Contact contact) {
            sum += contact.a() == floor || contact.b() == floor ? contact.impulse() : 0;
        }
    }

    private double[] momentum() {
        double[] sum = new double[2];
        for (Body body : engine.bodies()) {
            if (!body.isFixed()) {
                sum[0] += body.getMass() * body.getVelocityX();
                sum[1] += body.getMass() * body.getVelocityY();
            }
        }
        return sum;
    }

    /** Writes down what it is told. */
    private static final class Log implements ContactListener {
        private static final long serialVersionUID = 1L;
        private final List<String> lines = new ArrayList<>();
        private int steps;

        @Override
        public void began(LastingContact contact) {
            lines.add("began");
        }

        @Override
        public void lasts(LastingContact contact) {
            assertThat(contact.normalForce()).isNotNegative();
            steps++;
        }

        @Override
        public void ended(Body a, Body b) {
            lines.add("ended");
        }
    }

    @Test
    void contactsBeginLastAndEnd() {
        floor(0.5);
        Body box = put(new Body(new Rectangle(1, 1)).at(0, 1), 0.5);
        Log log = new Log();
        engine.addContactListener(log);
        run(300);
        assertThat(log.lines).containsExactly("began");
        assertThat(log.steps).isGreaterThan(200);
        box.setVelocity(0, 5);
        run(3);
        assertThat(log.lines).containsExactly("began", "ended");
        assertThat(engine.contacts()).isEmpty();
        run(300);
        assertThat(log.lines).containsExactly("began", "ended", "began");
        engine.remove(box);
        run(1);
        assertThat(log.lines).containsExactly("began", "ended", "began", "ended");
        engine.removeContactListener(log);
        assertThatThrownBy(() -> engine.removeContactListener(log)).isInstanceOf(IllegalStateException.class);
    }

    @Test
    void whoListensChangesNoBit() {
        List<double[]> ends = new ArrayList<>();
        for (boolean listens : new boolean[] {false, true}) {
            PhysicsEngine pile = new PhysicsEngine();
            pile.setTimeStep(1 / 60.0);
            pile.add(new Gravity(0, -G));
            pile.add(Body.fixed(new Rectangle(100, 2)).at(0, -1)).setFriction(0.5);
            for (int k = 0; k < 8; k++) {
                Body body = pile.add(new Body(new Rectangle(1, 1)).at(0.3 * (k % 3), 1.5 * k + 1));
                body.setAngle(0.2 * k);
                body.setFriction(0.5);
                body.setRestitution(0.2);
            }
            if (listens) {
                pile.addContactListener(new Log());
            }
            for (int k = 0; k < 200; k++) {
                pile.step();
                if (listens) {
                    pile.contacts();
                }
            }
            ends.add(pile.bodies().stream().mapToDouble(Body::getX).toArray());
        }
        assertThat(ends.get(1)).isEqualTo(ends.get(0));
    }

    /** A box that is lifted off another one so slowly that it is near for long touches nothing any more. */
    @Test
    void whatHasPartedIsNotListed() {
        floor(0.5);
        Body low = put(new Body(new Rectangle(1, 1)).at(0, 0.5), 0.5);
        Body high = put(new Body(new Rectangle(1, 1)).at(0, 1.5), 0.5);
        Log log = new Log();
        engine.addContactListener(log);
        run(30);
        assertThat(engine.contacts(high)).hasSize(1);
        int listed = 0;
        for (int k = 0; k < 60; k++) {
            high.addForce(0, 1.002 * G * high.getMass());
            engine.step();
            boolean isThere = !engine.contacts(high).isEmpty();
            listed += isThere ? 1 : 0;
            assertThat(isThere && high.getY() - low.getY() - 1 > 1e-3).isFalse();
        }
        assertThat(high.getY() - low.getY() - 1).isBetween(0.008, 0.011);
        assertThat(listed).isLessThan(15);
        assertThat(engine.contacts(low)).hasSize(1);
        assertThat(log.lines).endsWith("ended");
    }

    @Test
    void contactsAreAskedForBetweenSteps() {
        Body floor = floor(0);
        put(new Body(new Circle(0.5)).at(0, 1), 0);
        engine.addListener(new CollisionListener() {
            private static final long serialVersionUID = 1L;

            @Override
            public void collided(Contact contact) {
                assertThatThrownBy(engine::contacts).isInstanceOf(IllegalStateException.class);
            }
        });
        run(60);
        assertThatThrownBy(() -> engine.contacts(new Body(new Circle(1)))).isInstanceOf(IllegalStateException.class);
        assertThatThrownBy(() -> engine.contacts(floor).get(0).other(new Body(new Circle(1))))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("takes no part");
    }
}
