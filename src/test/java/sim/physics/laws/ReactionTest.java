// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.ConstraintException;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.Reaction;
import sim.physics.constraint.RodJoint;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** The forces of joints, as statics and circular motion have them; and joints that break under them. */
class ReactionTest {
    private static PhysicsEngine heavy() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(0.01);
        engine.add(new Gravity(0, -9.81));
        return engine;
    }

    @Test
    void aPendulumPullsWithItsWeightAndItsSwing() {
        PhysicsEngine engine = heavy();
        Body rod = engine.add(new Body(new Rectangle(0.2, 2)).at(0, -1));
        rod.setMass(3, 1);
        rod.moving(2, 0, 2);
        PinJoint pin = engine.add(new PinJoint(rod, 0, 0));
        Reaction r = engine.getReaction(pin);
        assertThat(r.forceX()).isCloseTo(0, within(1e-13));
        assertThat(r.forceY()).isCloseTo(3 * (9.81 + 2 * 2), within(1e-11 * 40));
        assertThat(r.torque()).isCloseTo(0, within(1e-12));
    }

    @Test
    void aCantileverBearsForceAndTorque() {
        PhysicsEngine engine = heavy();
        Body beam = engine.add(new Body(new Rectangle(4, 0.2)).at(2, 0));
        beam.setMass(5, 7);
        WeldJoint weld = engine.add(new WeldJoint(beam, null, 0, 0));
        for (int k = 0; k < 100; k++) {
            engine.step();
        }
        Reaction r = engine.getReaction(weld);
        assertThat(r.forceY()).isCloseTo(5 * 9.81, within(1e-11 * 50));
        assertThat(r.torque()).as("about the beam's centre").isCloseTo(0, within(1e-10));
        assertThat(beam.getY()).isCloseTo(0, within(1e-14));
    }

    @Test
    void aTrussCarriesItsLoadInItsBars() {
        PhysicsEngine engine = heavy();
        Body load = engine.add(new Body(new Circle(0.1)).at(0, 0));
        load.setMass(10);
        RodJoint left = engine.add(new RodJoint(load, 0, 0, null, -3, 4));
        RodJoint right = engine.add(new RodJoint(load, 0, 0, null, 3, 4));
        double pull = 10 * 9.81 / 2 / 0.8;
        assertThat(engine.getReaction(left).force()).isCloseTo(pull, within(1e-11 * pull));
        assertThat(engine.getReaction(right).forceX()).isCloseTo(pull * 0.6, within(1e-11 * pull));
    }

    @Test
    void twoHingesOfADoorShareItsWeight() {
        PhysicsEngine engine = heavy();
        Body door = engine.add(new Body(new Rectangle(1, 2)).at(0.5, 0));
        PinJoint low = engine.add(new PinJoint(door, 0, -0.8));
        PinJoint high = engine.add(new PinJoint(door, 0, 0.8));
        double weight = door.getMass() * 9.81;
        Reaction a = engine.getReaction(low);
        Reaction b = engine.getReaction(high);
        assertThat(a.forceY() + b.forceY()).isCloseTo(weight, within(1e-9 * weight));
        assertThat(a.forceY()).isCloseTo(weight / 2, within(1e-6 * weight));
        assertThat(a.forceX()).isCloseTo(weight * 0.5 / 1.6, within(1e-9 * weight));
        engine.step();
        assertThat(engine.getRedundantEquations()).isEqualTo(1);
    }

    @Test
    void aJointBreaksAtItsLoad() {
        PhysicsEngine engine = heavy();
        Body rod = engine.add(new Body(new Rectangle(2, 0.1)).at(1, 0));
        rod.setMass(1, 1 / 3.0);
        PinJoint pin = new PinJoint(rod, 0, 0);
        pin.setBreakingLoad(2 * 9.81, Double.POSITIVE_INFINITY); // at the bottom it is 2.5 m g
        engine.add(pin);
        double last = 0;
        while (engine.contains(pin)) {
            last = engine.getReaction(pin).force();
            engine.step();
        }
        assertThat(last).isLessThanOrEqualTo(2.1 * 9.81).isGreaterThan(1.9 * 9.81);
        double vx = rod.getVelocityX();
        engine.step();
        assertThat(rod.getVelocityX()).isEqualTo(vx);
    }

    /** A joint breaks also under what lies on its bodies, and bears it while that is less than its load. */
    @ParameterizedTest
    @ValueSource(doubles = {0.9, 1.1})
    void aJointBreaksUnderWhatLiesOnIt(double strength) {
        PhysicsEngine engine = heavy();
        engine.setTimeStep(1 / 60.0);
        Body beam = engine.add(new Body(new Rectangle(2, 0.2)).at(0, 0));
        Body box = engine.add(new Body(new Rectangle(0.5, 0.5)).at(0.7, 0.35));
        beam.setMass(1);
        box.setMass(5);
        box.setRestitution(0);
        WeldJoint weld = new WeldJoint(beam, null, -1, 0);
        weld.setBreakingLoad(Double.POSITIVE_INFINITY, strength * 5 * 9.81 * 0.7); // about its middle
        engine.add(weld);
        for (int k = 0; k < 200; k++) {
            engine.step();
        }
        assertThat(engine.contains(weld)).isEqualTo(strength > 1);
        assertThat(box.getY()).isLessThan(strength > 1 ? 0.36 : 0);
    }

    @Test
    void aMotorsTorqueIsReadToo() {
        PhysicsEngine engine = heavy();
        Body arm = engine.add(new Body(new Rectangle(2, 0.1)).at(1, 0));
        arm.setMass(1, 1 / 3.0);
        engine.add(new PinJoint(arm, 0, 0));
        Motor motor = engine.add(Motor.turning(arm, null, 0, 100));
        engine.step();
        assertThat(engine.getReaction(motor).torque()).isCloseTo(9.81, within(1e-11));
    }

    @Test
    void aSpringSwingsAtItsFrequency() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 512.0);
        Body weight = engine.add(new Body(new Circle(0.5)).at(3, 0));
        weight.setMass(2);
        Spring spring = new Spring(weight, 0, 0, null, 0, 0, 2, 18, 0);
        engine.add(spring);
        for (int k = 0; k < 512; k++) {
            engine.step();
        }
        assertThat(weight.getX()).isCloseTo(2 + StrictMath.cos(3), within(1e-10));
        assertThat(spring.energy() + weight.kineticEnergy()).isCloseTo(9, within(1e-9));
    }

    @Test
    void badJointsAreRefusedAtTheCall() {
        PhysicsEngine engine = new PhysicsEngine();
        Body a = engine.add(new Body(new Circle(1)));
        Body b = engine.add(new Body(new Circle(1)).at(5, 0));
        Body stranger = new Body(new Circle(1));
        Body wall = engine.add(Body.fixed(new Circle(1)).at(9, 9));
        Body wall2 = engine.add(Body.fixed(new Circle(1)).at(9, 12));
        assertThatThrownBy(() -> new PinJoint(a, a, 0, 0)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new PinJoint(a, b, Double.NaN, 0)).hasMessageContaining("NaN");
        assertThatThrownBy(() -> engine.add(new PinJoint(a, stranger, 0, 0)))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("not in this engine");
        assertThatThrownBy(() -> engine.add(new PinJoint(wall, wall2, 0, 0))).hasMessageContaining("none of its bodies");
        assertThatThrownBy(() -> engine.add(new PinJoint(a, 0, 0, b, 0, 0))).hasMessageContaining("open by -5.0");
        PinJoint pin = new PinJoint(a, b, 2, 0);
        assertThatThrownBy(() -> pin.setBreakingLoad(0, 1)).hasMessageContaining("0.0");
        engine.add(pin);
        assertThatThrownBy(() -> engine.add(pin)).hasMessageContaining("added already");
        engine.remove(pin);
        assertThatThrownBy(() -> engine.remove(pin)).hasMessageContaining("not in this engine");
        assertThat(engine.allConstraints()).isEmpty();
    }

    @Test
    void openJointsAreAssembledByTheLeastMoveOrNotAtAll() {
        PhysicsEngine engine = new PhysicsEngine();
        Body light = engine.add(new Body(new Circle(0.5)).at(0, 0));
        Body heavy = engine.add(new Body(new Circle(0.5)).at(3, 0));
        light.setMass(1);
        heavy.setMass(3);
        engine.assemble(new PinJoint(light, 0.5, 0, heavy, -0.5, 0));
        assertThat(light.getX()).isCloseTo(1.5, within(1e-14));
        assertThat(heavy.getX()).isCloseTo(2.5, within(1e-14));

        Body rod = engine.add(new Body(new Rectangle(2, 0.1)).at(0, 9));
        Constraint[] tooFar = {new PinJoint(rod, -1, 0, null, -4, 9), new PinJoint(rod, 1, 0, null, 4, 9.5)};
        assertThatThrownBy(() -> engine.assemble(tooFar)).hasMessageContaining("cannot be satisfied").hasMessageContaining("open by 3.04");
        assertThat(rod.getX()).isZero();
        assertThat(rod.getY()).isEqualTo(9);
        assertThat(engine.allConstraints()).hasSize(1);
        engine.step();
    }

    /** Two rods of different lengths between the same points: what is said is which of them is open, and by how much where the author put it. */
    @ParameterizedTest
    @ValueSource(doubles = {0x1p-20, 1, 0x1p20})
    void whatContradictsIsToldAsItWasSet(double length) {
        PhysicsEngine engine = new PhysicsEngine();
        Body bob = engine.add(new Body(new Circle(0.5 * length)).at(2 * length, 0));
        RodJoint fits = RodJoint.bodyPoints(bob, 0, 0, null, 0, 0, 2 * length);
        RodJoint open = RodJoint.bodyPoints(bob, 0, 0, null, 0, 0, 2.5 * length);
        assertThatThrownBy(() -> engine.assemble(fits, open))
                .isInstanceOfSatisfying(ConstraintException.class, e -> assertThat(e.residual()).isEqualTo(0.5 * length))
                .hasMessageContaining("constraints [" + fits + ", " + open + "] cannot be satisfied: number 2 of them, " + open + ", is open by " + 0.5 * length);
        assertThat(bob.getX()).isEqualTo(2 * length);
        assertThat(engine.allConstraints()).isEmpty();
    }

    /** The same of angles: two welds that are a quarter of a radian apart had the box stand half-way between them. */
    @Test
    void anglesThatContradictAreToldInRad() {
        PhysicsEngine engine = new PhysicsEngine();
        Body box = engine.add(new Body(new Rectangle(1, 1)).at(3, 0));
        WeldJoint first = new WeldJoint(box, null, 3, 0);
        box.setAngle(0.25);
        WeldJoint second = new WeldJoint(box, null, 3, 0);
        assertThatThrownBy(() -> engine.assemble(first, second)).hasMessageContaining("number 1 of them, " + first + ", is open by 0.25 rad where the bodies are");
    }
}
