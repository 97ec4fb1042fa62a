// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.Reaction;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/** What joints bear under forces that an author applies in each step: the same, whether one asks before the step or after it. */
class PushedReactionTest {
    private static PhysicsEngine engine(int substeps) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 60);
        engine.setTimeStepping(substeps);
        return engine;
    }

    private static Body arm(PhysicsEngine engine) {
        Body arm = engine.add(new Body(new Rectangle(1, 1)).at(0, 0));
        engine.add(new PinJoint(arm, 0, 0));
        return arm;
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aBrakeBearsTheTorqueOfTheStepThatIsOver(int substeps) {
        PhysicsEngine engine = engine(substeps);
        Body arm = arm(engine);
        Motor brake = engine.add(Motor.turning(arm, null, 0, 100));
        for (int k = 0; k < 10; k++) {
            arm.addTorque(3);
            engine.step();
            assertThat(engine.getReaction(brake).torque()).isCloseTo(-3, within(1e-9));
        }
        engine.step();
        assertThat(engine.getReaction(brake).torque()).as("nothing was applied").isCloseTo(0, within(1e-9));
    }

    @Test
    void whatIsAppliedForTheNextStepTakesThePlaceOfWhatWas() {
        PhysicsEngine engine = engine(0);
        Body arm = arm(engine);
        Motor brake = engine.add(Motor.turning(arm, null, 0, 100));
        arm.addTorque(3);
        engine.step();
        assertThat(engine.getReaction(brake).torque()).isCloseTo(-3, within(1e-12));
        arm.addTorque(5);
        assertThat(engine.getReaction(brake).torque()).isCloseTo(-5, within(1e-12));
        arm.addTorque(-5);
        assertThat(engine.getReaction(brake).torque()).as("none").isCloseTo(0, within(1e-12));
        engine.step();
        assertThat(arm.getAngle()).isZero();
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "0, 3", "0, 20", "4, 0", "4, 3", "4, 20"})
    void aPostOnABoxThatIsPushedOverAFloor(int substeps, double push) {
        PhysicsEngine engine = engine(substeps);
        engine.add(new Gravity(0, -10));
        Body floor = engine.add(Body.fixed(new Rectangle(200, 2)).at(0, -1));
        floor.setFriction(0.5);
        Body box = engine.add(new Body(new Rectangle(2, 0.5)).at(0, 0.25));
        box.setMass(2);
        box.setFriction(0.5);
        box.setRestitution(0);
        Body post = engine.add(new Body(new Rectangle(0.5, 0.5)).at(0, 0.75));
        post.setMass(1);
        post.setRestitution(0);
        WeldJoint weld = engine.add(new WeldJoint(post, box, 0, 0.5));
        for (int k = 0; k < 60; k++) {
            box.addForce(push, 0);
            engine.step();
        }
        Reaction r = engine.getReaction(weld);
        assertThat(r.forceX()).as("mass of the post · (F − μ m g) / m").isCloseTo(Math.max(0, push - 15) / 3, within(1e-6));
        assertThat(r.forceY()).isCloseTo(10, within(1e-6));
    }

    @Test
    void toAskChangesNothingAndACopyAnswersTheSame() {
        PhysicsEngine engine = engine(0);
        Body arm = arm(engine);
        Motor brake = engine.add(Motor.turning(arm, null, 0, 2));
        PhysicsEngine silent = Checkpoint.copy(engine);
        for (int k = 0; k < 20; k++) {
            arm.addTorque(3);
            silent.bodies().get(0).addTorque(3);
            engine.step();
            silent.step();
            PhysicsEngine copy = Checkpoint.copy(engine);
            Reaction r = engine.getReaction(brake);
            assertThat(copy.getReaction(copy.allConstraints().get(1))).isEqualTo(r);
        }
        assertThat(arm.getAngle()).isPositive().isEqualTo(silent.bodies().get(0).getAngle());
    }
}
