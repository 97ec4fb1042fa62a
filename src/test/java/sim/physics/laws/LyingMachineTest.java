// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Machines that lie still are where they are, to the bit, until something happens to them; then they move as they must. */
class LyingMachineTest {
    private static final double G = 9.81;
    private static final double MU = 0.5;

    private final PhysicsEngine engine = new PhysicsEngine();
    private final Gravity gravity = new Gravity(0, -G);
    private final List<Body> parts = new ArrayList<>();
    private Body floor;
    private PinJoint hinge;
    private Motor motor;

    /** Two planks with a hinge between them, which has stops and a motor that is off by next to nothing, fall on a floor. */
    @BeforeEach
    void lie() {
        engine.setTimeStep(1 / 60.0);
        engine.add(gravity);
        floor = engine.add(rough(Body.fixed(new Rectangle(40, 2)).at(0, -1)));
        for (int side = -1; side <= 1; side += 2) {
            Body plank = engine.add(rough(new Body(new Rectangle(1, 0.2)).at(0.5 * side, 0.3)));
            plank.setMass(2);
            parts.add(plank);
        }
        hinge = engine.add(new PinJoint(parts.get(0), parts.get(1), 0, 0.3));
        engine.add(Limit.angle(parts.get(1), parts.get(0), -1, 1));
        motor = engine.add(Motor.turning(parts.get(1), parts.get(0), 0, 1e-3));
        step(300);
    }

    private static Body rough(Body body) {
        body.setFriction(MU);
        body.setRestitution(0);
        return body;
    }

    private void step(int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    private double[] places() {
        return parts.stream().flatMapToDouble(b -> java.util.stream.DoubleStream.of(
                b.getX(), b.getY(), b.getAngle(), b.getVelocityX(), b.getVelocityY(), b.getAngularVelocity())).toArray();
    }

    @Test
    void itStaysWhereItIsToTheBit() {
        double[] before = places();
        step(600);
        assertThat(places()).containsExactly(before);
        parts.forEach(part -> assertThat(part.getVelocityX()).isZero());
        assertThat(parts.get(0).getY()).isEqualTo(0.1, within(1e-6));
    }

    @Test
    void theFloorBearsItsWeightAllTheWhile() {
        step(200);
        double sum = engine.contacts(floor).stream().mapToDouble(contact -> -contact.forceY(floor)).sum();
        assertThat(sum).isEqualTo(4 * G, within(1e-8));
    }

    @Test
    void itSlidesUnderAForceThatIsMoreThanItsFriction() {
        double x = parts.get(0).getX();
        double force = 30;
        for (int k = 0; k < 60; k++) {
            parts.get(1).addForce(force, 0);
            engine.step();
        }
        double a = force / 4 - MU * G;
        assertThat(parts.get(0).getVelocityX()).isEqualTo(a, within(1e-6));
        assertThat(parts.get(0).getX() - x).isEqualTo(a / 2, within(1e-5));
    }

    @Test
    void itStaysUnderAForceThatIsLess() {
        double x = parts.get(0).getX();
        for (int k = 0; k < 60; k++) {
            parts.get(1).addForce(0.9 * MU * 4 * G, 0);
            engine.step();
        }
        assertThat(parts.get(0).getX()).isEqualTo(x, within(1e-9));
    }

    @Test
    void itFallsWhenItsFloorIsTakenAway() {
        double y = parts.get(0).getY();
        engine.remove(floor);
        step(60);
        parts.forEach(part -> assertThat(part.getY()).isEqualTo(y - G / 2, within(1e-6)));
    }

    @Test
    void itRisesWhenTheFieldTurnsRound() {
        double y = parts.get(0).getY();
        engine.remove(gravity);
        engine.add(new Gravity(0, 2));
        step(60);
        parts.forEach(part -> assertThat(part.getY()).isEqualTo(y + 1, within(1e-6)));
    }

    @Test
    void itFoldsWhenItsMotorIsSet() {
        motor.setLimit(40);
        motor.setSpeed(1);
        step(30);
        assertThat(parts.get(1).getAngle() - parts.get(0).getAngle()).isEqualTo(0.5, within(0.03));
    }

    @Test
    void whatStrikesItMovesIt() {
        parts.forEach(part -> part.setFriction(0));
        floor.setFriction(0);
        step(10);
        Body ball = engine.add(new Body(new Circle(0.05)).at(3, 0.1));
        ball.setMass(1);
        ball.setFriction(0);
        ball.setRestitution(0);
        ball.setVelocity(-5, 0);
        step(60);
        double p = ball.getVelocityX() + 2 * parts.get(0).getVelocityX() + 2 * parts.get(1).getVelocityX();
        assertThat(p).isEqualTo(-5, within(1e-8));
        assertThat(parts.get(0).getVelocityX()).isLessThan(-0.9);
    }

    @Test
    void aPartWhoseHingeIsRemovedFollowsItsOwnForce() {
        engine.remove(hinge);
        for (int k = 0; k < 30; k++) {
            parts.get(1).addForce(20, 0);
            engine.step();
        }
        assertThat(parts.get(1).getVelocityX()).isGreaterThan(1);
    }

    @Test
    void whatLiesOnItFallsWithIt() {
        Body load = engine.add(rough(new Body(new Rectangle(0.4, 0.4)).at(0.5, 0.5)));
        step(300);
        double y = load.getY();
        step(100);
        assertThat(load.getY()).isEqualTo(y);
        engine.remove(floor);
        step(60);
        assertThat(load.getY()).isEqualTo(y - G / 2, within(1e-5));
    }

    @Test
    void aCheckpointGoesOnToTheBit() {
        PhysicsEngine copy = Checkpoint.copy(engine);
        Body part = copy.bodies().get(parts.get(1).index());
        for (int k = 0; k < 40; k++) {
            parts.get(1).addForce(k < 20 ? 0 : 30, 0);
            part.addForce(k < 20 ? 0 : 30, 0);
            engine.step();
            copy.step();
        }
        assertThat(part.getX()).isEqualTo(parts.get(1).getX());
    }

    @Test
    void threadsChangeNothing() {
        engine.setThreads(2);
        double[] before = places();
        step(50);
        assertThat(places()).containsExactly(before);
        engine.setThreads(1);
    }

    @Test
    void anAuditFindsNothingMissing() {
        engine.setAudited(true);
        step(100);
        assertThat(parts.get(0).getVelocityX()).isEqualTo(0, within(1e-9));
    }
}
