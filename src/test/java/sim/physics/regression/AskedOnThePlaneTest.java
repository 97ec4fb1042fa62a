// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import org.junit.jupiter.api.Test;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.SurfaceFriction;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** Bodies that rub on two planes at once, of which some are tied and others lie against one another. */
class AskedOnThePlaneTest {
    /** Friction under tied bodies grows from rest on. To ask what holds them made that of the heap's second plane do so, too. */
    @Test
    void toAskForAReactionLeavesTheFrictionOfOthersAsItWas() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1 / 60.0);
        engine.add(new SurfaceFriction(9.81));
        engine.add(new SurfaceFriction(3));
        engine.add(new Gravity(0.5, 0));
        Body wall = engine.add(Body.fixed(new Rectangle(40, 1)).at(0, -0.5));
        wall.setRestitution(0);
        wall.setFriction(0.1);
        for (int k = 0; k < 4; k++) {
            Body box = engine.add(new Body(new Rectangle(1, 1)).at(1.01 * (k % 2), 0.6 + 1.1 * (k / 2), 0.1 * k).moving(0.3 * k - 0.2, -1, 0.5));
            box.setRestitution(0);
            box.setFriction(0.3);
            box.setSurfaceFriction(0.1);
        }
        Body arm = engine.add(new Body(new Circle(1)).at(20, 20));
        arm.setSurfaceFriction(0.2);
        PinJoint pin = engine.add(new PinJoint(arm, 20, 20.5));
        PhysicsEngine unasked = Checkpoint.copy(engine);
        for (int k = 0; k < 100; k++) {
            engine.getReaction(pin);
            engine.step();
            unasked.step();
            Checkpoint.assertSameBodies(engine, unasked);
        }
    }
}
