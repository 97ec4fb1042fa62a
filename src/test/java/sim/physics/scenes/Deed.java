// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.scenes;

import sim.physics.PhysicsEngine;
import sim.physics.motion.Body;

/** What a collision elsewhere does to an island of jointed bodies. */
public enum Deed {
    NOTHING,
    PUSH,
    STRIKE,
    SHOVE,
    CUT,
    CATCH;

    /**
     * Does it.
     *
     * @param engine that of the bodies
     * @param root the first body of the island
     * @param tip its last one
     */
    public void act(PhysicsEngine engine, Body root, Body tip) {
        switch (this) {
            case PUSH -> tip.addForce(3, 0);
            case STRIKE -> tip.setVelocity(tip.getVelocityX() + 0.5, tip.getVelocityY());
            case SHOVE -> root.setAngle(root.getAngle() + 0.001);
            case CUT -> engine.remove(tip);
            case CATCH -> tip.setCollisionGroup(1, -1);
            case NOTHING -> { }
        }
    }
}
