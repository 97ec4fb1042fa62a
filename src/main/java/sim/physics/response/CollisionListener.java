// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;

/**
 * Is told of collisions, and decides about them. Listeners are part of a checkpoint: make them named classes, not
 * lambdas, whose serialized form depends on the compiler.
 *
 * <p>In a call a listener may add and remove bodies, and set positions, velocities and filters; that takes effect at
 * the instant of the collision, when the call is over. An exception that it throws ends the step at that instant.
 */
public interface CollisionListener extends Serializable {
    /** What is done about a collision. */
    enum Decision {
        /** The bodies bounce, as their coefficients have it. */
        BOUNCE,
        /**
         * The collision points have the same velocity afterwards: perfectly inelastic. They do not slide as long as the
         * bodies are pressed together, at rest or in a heap, until these part or collide anew; but they can be pulled apart.
         */
        STICK,
        /** The bodies go on as if there was nothing; they may pass through one another until they are apart again. */
        IGNORE
    }

    /**
     * Two bodies are about to collide; their velocities are those before.
     *
     * @param contact where and when
     * @return what to do; the first listener that wants something else than {@link Decision#BOUNCE} decides
     */
    default Decision colliding(Contact contact) {
        return Decision.BOUNCE;
    }

    /**
     * Two bodies have collided; their velocities are those afterwards.
     *
     * @param contact where and when, with the impulse
     */
    default void collided(Contact contact) {
        // told for information
    }
}
