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
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Friction of an impact at one point: Newton's restitution along the normal, and Coulomb's law against what slides afterwards. */
class RubbedImpactTest {
    private static final double TILT = -0.3;

    private final PhysicsEngine engine = new PhysicsEngine();

    private Body drop(double restitution, double friction, double along) {
        engine.setTimeStep(0.1);
        Body floor = engine.add(Body.fixed(new Rectangle(40, 1)).at(0, -0.5));
        floor.setFriction(friction);
        floor.setRestitution(restitution);
        Body box = engine.add(new Body(new Rectangle(1, 0.5)).at(0, 0.5, TILT).moving(along, -3));
        box.setFriction(friction);
        box.setRestitution(restitution);
        return box;
    }

    /** Falls straight, so that nothing slides before: the impulse is found by hand, on the edge of the cone. */
    @Test
    void aTiltedBoxThatFallsStraightIsRubbed() {
        Body box = drop(0, 0.5, 0);
        engine.step();
        double lever = 0.5 * Math.cos(TILT) + 0.25 * Math.sin(TILT);
        double arm = 0.5 * Math.sin(TILT) - 0.25 * Math.cos(TILT);
        double w = 1 / box.getMass();
        double i = 1 / box.getInertia();
        double slope = -0.5; // the corner would slide ahead
        double normal = 3 / (w + i * lever * (lever - arm * slope));
        assertThat(box.getVelocityX()).isCloseTo(slope * normal * w, within(1e-12));
        assertThat(box.getVelocityY()).isCloseTo(-3 + normal * w, within(1e-12));
        assertThat(box.getAngularVelocity()).isCloseTo(i * (lever - arm * slope) * normal, within(1e-12));
        assertThat(box.getVelocityX() - box.getAngularVelocity() * arm).as("what slides").isPositive();
    }

    /** A body of no weight that is pinned to it changes nothing: ties reply as the free body does. */
    @ParameterizedTest
    @CsvSource({"0.3, 0", "0.3, 0.5", "0.3, -1", "0.8, 0", "0.8, 0.5", "0.8, -1", "1, 0.2"})
    void aTiedBodyIsRubbedAsAFreeOne(double restitution, double along) {
        Body free = drop(restitution, 0.5, along);
        engine.step();
        RubbedImpactTest other = new RubbedImpactTest();
        Body tied = other.drop(restitution, 0.5, along);
        Body bob = other.engine.add(new Body(new Circle(0.05)).at(0, 0.5).moving(along, -3));
        bob.setMass(1e-12);
        bob.setCollisionGroup(2, 0);
        other.engine.add(new PinJoint(tied, bob, 0, 0.5));
        other.engine.step();
        assertThat(other.engine.getImpacts()).isEqualTo(engine.getImpacts());
        assertThat(tied.getVelocityX()).isCloseTo(free.getVelocityX(), within(1e-9));
        assertThat(tied.getVelocityY()).isCloseTo(free.getVelocityY(), within(1e-9));
        assertThat(tied.getAngularVelocity()).isCloseTo(free.getAngularVelocity(), within(1e-9));
    }

    /** What hangs in a pin can only turn: it comes back at e of its speed, whatever friction there is. */
    @ParameterizedTest
    @ValueSource(doubles = {0.25, 0.5, 0.9})
    void aRodOnAPinComesBackByItsRestitution(double restitution) {
        engine.setTimeStep(0.1);
        Body floor = engine.add(Body.fixed(new Rectangle(40, 1)).at(0, -0.5));
        Body rod = engine.add(new Body(new Rectangle(2, 0.2)).at(0, 0.4).moving(0, -1, -1));
        for (Body body : new Body[] {floor, rod}) {
            body.setFriction(0.5);
            body.setRestitution(restitution);
        }
        engine.add(new PinJoint(rod, -1, 0.4));
        while (rod.getAngularVelocity() < 0) {
            engine.step();
        }
        assertThat(engine.getImpacts()).isEqualTo(1);
        assertThat(rod.getAngularVelocity()).isCloseTo(restitution, within(1e-9));
    }
}
