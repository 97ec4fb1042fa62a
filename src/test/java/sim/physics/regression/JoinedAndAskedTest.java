// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.regression;

import org.junit.jupiter.api.Test;
import sim.physics.Checkpoint;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.shape.Rectangle;

/** A body is added, and tied to others, and something is asked before the next step. */
class JoinedAndAskedTest {
    private static void add(PhysicsEngine engine, int at) {
        Body link = engine.add(new Body(new Rectangle(1, 0.1)).at(at + 0.5, 0));
        link.setCollisionGroup(1, 0);
        engine.add(at == 0 ? new PinJoint(link, 0, 0) : new PinJoint(engine.bodies().get(at - 1), link, at, 0));
    }

    /** A chain that collides with nobody grows by a link at a time: where arrays by body were full, the step threw, as the link was grouped before it came in. */
    @Test
    void aChainThatGrowsWhileItIsAskedAbout() {
        PhysicsEngine engine = new PhysicsEngine();
        engine.setTimeStep(1.0 / 1024);
        engine.add(new Gravity(0, -1e-9));
        PhysicsEngine unasked = Checkpoint.copy(engine);
        for (int k = 0; k < 70; k++) {
            add(engine, k);
            add(unasked, k);
            engine.overlaps();
            engine.step();
            unasked.step();
            Checkpoint.assertSameBodies(engine, unasked);
        }
    }
}
