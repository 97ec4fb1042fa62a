// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import sim.physics.motion.Body;

/**
 * A listener that is told of lasting contacts: of bodies that come to rest on one another or lie in heaps. A
 * {@link CollisionListener} is told of the collisions before that. Calls come when a step is over. They may do anything that may
 * be done between steps, except step the engine. Listeners are part of a checkpoint, so make them named classes.
 */
public interface ContactListener extends Serializable {
    /**
     * Called when two bodies lie on one another that did not at the end of the step before.
     *
     * @param contact place and force of the contact
     */
    default void began(LastingContact contact) {
        // told for information
    }

    /**
     * Called when two bodies still lie on one another.
     *
     * @param contact place and force of the contact
     */
    default void lasts(LastingContact contact) {
        // told for information
    }

    /**
     * Called when two bodies do not lie on one another any more, or one of them has left the engine.
     *
     * @param a one body
     * @param b the other body
     */
    default void ended(Body a, Body b) {
        // told for information
    }
}
