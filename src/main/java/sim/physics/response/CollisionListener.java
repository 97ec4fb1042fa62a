// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;

/**
 * A listener that is asked before collisions and told after them. Listeners are part of a checkpoint. So make them named classes,
 * not lambdas, whose serialized form depends on the compiler.
 *
 * <p>In a call, all bodies are where they are at the instant of the collision, and as fast as they are then; by time stepping, as
 * they were when the step began, or are when it is over. A listener may add and remove bodies, and set positions, velocities and
 * filters. That takes effect at that instant, when the call is over. If the listener throws an exception, the step ends at that instant.
 *
 * <p>What {@link #colliding} sets on the two bodies counts in the collision itself: mass, restitution, friction and velocity. Bodies
 * that it turns away from one another, puts elsewhere or forbids to collide do not collide, and {@link #collided} is not called. A body
 * that it removes leaves after the collision.
 */
public interface CollisionListener extends Serializable {
    /** What to do about a collision. */
    enum Decision {
        /** The bodies bounce, as their coefficients say. */
        BOUNCE,
        /**
         * The collision points have the same velocity afterwards: a perfectly inelastic collision. The bodies do not slide as
         * long as they are pressed together, at rest or in a heap, until they part or collide again. But they can be pulled
         * apart.
         */
        STICK,
        /** The bodies go on as if nothing were there. They may pass through one another until they are apart again. */
        IGNORE
    }

    /**
     * Called when two bodies are about to collide. Their velocities are those before the collision.
     *
     * @param contact place and time of the collision
     * @return what to do, not null; the first listener that returns something other than {@link Decision#BOUNCE} decides
     */
    default Decision colliding(Contact contact) {
        return Decision.BOUNCE;
    }

    /**
     * Called when two bodies have collided. Their velocities are those after the collision.
     *
     * @param contact place and time of the collision, with the impulse
     */
    default void collided(Contact contact) {
        // told for information
    }
}
