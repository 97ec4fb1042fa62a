// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import sim.physics.motion.Body;

/**
 * Is told of contacts that last: of bodies that come to rest on one another or lie in heaps, while the collisions before are
 * told to a {@link CollisionListener}. Calls come when a step is over, and may do all that may be done between steps, but for
 * stepping the engine. Listeners are part of a checkpoint: make them named classes.
 */
public interface ContactListener extends Serializable {
    /**
     * Two bodies lie on one another that did not at the end of the step before.
     *
     * @param contact where, and with which force
     */
    default void began(LastingContact contact) {
        // told for information
    }

    /**
     * Two bodies lie on one another still.
     *
     * @param contact where, and with which force
     */
    default void lasts(LastingContact contact) {
        // told for information
    }

    /**
     * Two bodies do not lie on one another any more, or one has left the engine.
     *
     * @param a one body
     * @param b the other body
     */
    default void ended(Body a, Body b) {
        // told for information
    }
}
