// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Joint;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.PulleyJoint;
import sim.physics.constraint.Reaction;
import sim.physics.constraint.WeldJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** What joints bear, and when they break, where their bodies lie on something: by statics, also long after all has come to rest. */
class RestingReactionTest {
    private static final double G = 10;

    private final PhysicsEngine engine = new PhysicsEngine();

    private void floor(int substeps) {
        engine.setTimeStep(1.0 / 60);
        engine.setTimeStepping(substeps);
        engine.add(new Gravity(0, -G));
        engine.add(Body.fixed(new Rectangle(100, 2)).at(0, -1)).setFriction(0.5);
    }

    private Body put(Body body, double x, double y, double mass) {
        body.setMass(mass);
        body.setRestitution(0);
        body.setFriction(0.5);
        return engine.add(body.at(x, y));
    }

    /** A weight that hangs from a rope, whose other end is tied to a heavier one on the floor. */
    private Joint tackle(double height) {
        Body light = put(new Body(new Rectangle(2, 2)), -10, 5, 4);
        Body heavy = put(new Body(new Rectangle(2, 2)), 10, 1 + height, 6);
        return engine.add(PulleyJoint.worldPoints(light, -10, 6, -10, 30, heavy, 10, 2 + height, 10, 30, 1));
    }

    private void run(int steps) {
        for (int k = 0; k < steps; k++) {
            engine.step();
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "0, 0.5", "4, 0", "4, 0.5"})
    void aRopeToWhatStandsOnTheFloorBearsTheWeightThatHangs(int substeps, double height) {
        floor(substeps);
        Joint rope = tackle(height);
        run(400);
        assertThat(engine.getReaction(rope).forceY()).isCloseTo(4 * G, within(1e-6));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aShelfWeldedToABoxThatStands(int substeps) {
        floor(substeps);
        Body box = put(new Body(new Rectangle(2, 2)), 0, 1, 6);
        Body shelf = put(new Body(new Rectangle(1, 0.2)), 1.5, 1.5, 2);
        Joint weld = engine.add(new WeldJoint(shelf, box, 1, 1.5));
        for (int k = 0; k < 4; k++) {
            run(100);
            Reaction r = engine.getReaction(weld);
            assertThat(r.forceY()).as("step %d", engine.getSteps()).isCloseTo(2 * G, within(1e-6));
            assertThat(r.torque()).isCloseTo(0, within(1e-5)); // about the middle of the shelf
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void theAxlesOfACarThatStands(int substeps) {
        floor(substeps);
        Body chassis = put(new Body(new Rectangle(3, 0.5)), 0.25, 0.8, 8);
        Body rear = put(new Body(new Circle(0.4)), -1, 0.4, 1);
        Body front = put(new Body(new Circle(0.4)), 1, 0.4, 1);
        Joint rearAxle = engine.add(new PinJoint(chassis, rear, -1, 0.4));
        Joint frontAxle = engine.add(new PinJoint(chassis, front, 1, 0.4));
        run(600);
        double error = substeps > 0 ? 1e-4 * 8 * G : 1e-6; // joints that give way by 1e-4 m shift the chassis
        assertThat(engine.getReaction(rearAxle).forceY()).isCloseTo(8 * G * 0.375, within(error));
        assertThat(engine.getReaction(frontAxle).forceY()).isCloseTo(8 * G * 0.625, within(error));
    }

    /** Without the floor, as in the first instant, the rope would bear 48. */
    @ParameterizedTest
    @CsvSource({"0, 43, none", "0, 43, push", "0, 43, friction", "0, 38, none", "0, 38, push", "0, 38, friction", "4, 43, none", "4, 43, push", "4, 38, none"})
    void aRopeBreaksByWhatItBearsWithTheFloorsHelp(int substeps, double load, String edit) {
        floor(substeps);
        Joint rope = tackle(0);
        rope.setBreakingLoad(load, 1);
        Body heavy = rope.getBodyB();
        for (int k = 0; k < 200; k++) {
            if (edit.equals("push")) {
                heavy.addForce(0.5, 0);
            } else if (edit.equals("friction")) {
                heavy.setFriction(0.5 + 1e-3 * k);
            }
            engine.step();
        }
        assertThat(engine.contains(rope)).isEqualTo(load > 4 * G);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aLoadThatIsSetWhenAllIsAtRest(int substeps) {
        floor(substeps);
        Joint rope = tackle(0);
        run(300);
        rope.setBreakingLoad(4 * G + 1, 1);
        run(2);
        assertThat(engine.contains(rope)).isTrue();
        rope.setBreakingLoad(4 * G - 1, 1);
        run(2);
        assertThat(engine.contains(rope)).isFalse();
    }
}
