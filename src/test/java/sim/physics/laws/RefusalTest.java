// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.laws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.LinkedHashMap;
import java.util.Map;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.Scenes;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.ConstraintException;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.PulleyJoint;
import sim.physics.constraint.RodJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Spring;
import sim.physics.response.PairRule;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** A call that is refused leaves the engine as it was, to the last byte of its checkpoint. */
class RefusalTest {
    private static PhysicsEngine scene(int substeps) {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 60);
        engine.setTimeStepping(substeps);
        engine.add(new Gravity(0, -9.81));
        engine.add(Body.fixed(new Rectangle(20, 1)).at(0, -0.5));
        for (int k = 0; k < 4; k++) {
            Body body = engine.add(new Body(new Rectangle(1, 1)).at(2 * k - 3, 0.5));
            body.setRestitution(0);
            body.setFriction(0.5);
        }
        return engine;
    }

    /** What cannot be, by name. */
    private static Map<String, Runnable> calls(PhysicsEngine engine) {
        Body floor = engine.bodies().get(0);
        Body a = engine.bodies().get(1);
        Body b = engine.bodies().get(2);
        Body elsewhere = new Body(new Circle(1));
        PinJoint twice = new PinJoint(a, b, -2, 0.5);
        Map<String, Runnable> all = new LinkedHashMap<>();
        all.put("a fixed body that turns", () -> floor.moving(0, 0, 1));
        all.put("a fixed body that moves", () -> floor.moving(0, 1, 0));
        all.put("a place that is none", () -> a.at(1, 2, Double.NaN));
        all.put("a velocity that is none", () -> a.moving(1, 2, Double.POSITIVE_INFINITY));
        all.put("an impulse that is none", () -> a.addImpulseAt(1, 1, Double.NaN, 0));
        all.put("a torque that is none", () -> a.addForceAt(1e300, 1, 0, -1e300));
        all.put("a moment of inertia that is none", () -> a.setMass(2, 0));
        all.put("a joint that is open", () -> engine.add(new RodJoint(a, 0, 0, b, 0, 0, 7)));
        all.put("a joint of the floor", () -> engine.add(new PinJoint(floor, 0, 0)));
        all.put("a joint of a body that is elsewhere", () -> engine.add(new PinJoint(a, elsewhere, 0, 0)));
        all.put("a joint that is none", () -> engine.assemble(twice, null));
        all.put("a joint that is named twice", () -> engine.assemble(twice, twice));
        all.put("a joint that is not there", () -> engine.remove((Constraint) twice));
        all.put("a spring that is not there", () -> engine.remove(new Spring(a, 0, 0, b, 0, 0, 1, 1, 1)));
        all.put("a rule that is none", () -> engine.setPairRules(PairRule.MAXIMUM, null));
        all.put("a body twice", () -> engine.add(a));
        return all;
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void whatIsRefusedChangesNothing(int substeps) {
        for (int steps : new int[] {1, 200}) {
            for (String name : calls(scene(substeps)).keySet()) {
                PhysicsEngine engine = scene(substeps);
                for (int k = 0; k < steps; k++) {
                    engine.step();
                }
                byte[] before = Checkpoint.bytes(engine);
                Runnable call = calls(engine).get(name);
                assertThatThrownBy(call::run).as(name).isInstanceOf(RuntimeException.class);
                assertThat(Checkpoint.bytes(engine)).as(name).isEqualTo(before);
            }
        }
    }

    /** A pendulum that a motor brakes, a chain of two that swings, and two discs that are held in one another. */
    private static PhysicsEngine machines(int substeps) {
        PhysicsEngine engine = scene(substeps);
        Body arm = engine.add(new Body(new Rectangle(1, 0.2)).at(10.5, 5));
        engine.add(new PinJoint(arm, 10, 5));
        engine.add(Motor.turning(arm, null, 0, 0.1));
        Body upper = engine.add(new Body(new Rectangle(1, 0.2)).at(20.5, 5));
        Body lower = engine.add(new Body(new Rectangle(1, 0.2)).at(21.5, 5));
        engine.add(new PinJoint(upper, 20, 5));
        engine.add(new PinJoint(upper, lower, 21, 5));
        for (int k = 0; k < 2; k++) {
            Body disc = engine.add(new Body(new Circle(1)).at(30 + k, 5));
            engine.add(new PinJoint(disc, 30 + k, 5));
        }
        return engine;
    }

    /** Bit for bit: the workspace of those who tried is not looked at. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void whatCannotBeClosedOrPartedChangesNothing(int substeps) {
        for (int steps : new int[] {1, 20, 200}) {
            PhysicsEngine engine = machines(substeps);
            for (int k = 0; k < steps; k++) {
                engine.step();
            }
            PhysicsEngine twin = Checkpoint.copy(engine);
            Body arm = engine.bodies().get(5);
            Body lower = engine.bodies().get(7);
            for (int k = 0; k < 60; k++) {
                if (k % 15 == 0) {
                    assertThatThrownBy(() -> engine.assemble(PinJoint.bodyPoints(arm, 0, 0, lower, 0, 0))).isInstanceOf(ConstraintException.class);
                    assertThatThrownBy(engine::separate).isInstanceOf(RuntimeException.class);
                    PulleyJoint.bodyPoints(arm, 0, 0, 10, 9, lower, 0, 0, 20, 9, 1, 8); // is made, but not added
                }
                engine.step();
                twin.step();
                assertThat(Scenes.hash(engine)).as("%d steps, then %d", steps, k).isEqualTo(Scenes.hash(twin));
                assertThat(engine.isAsleep(arm)).isEqualTo(twin.isAsleep(twin.bodies().get(5)));
            }
        }
    }
}
