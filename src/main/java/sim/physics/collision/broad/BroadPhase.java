// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.broad;

import java.io.Serializable;

/**
 * Finds the pairs of bodies that may be colliding; see the write-up's <i>Broad Phase</i>. All implementations report the same
 * pairs: those whose {@link Boxes} overlap or touch, except pairs of two fixed bodies.
 */
public interface BroadPhase extends Serializable {

    /**
     * Is called when an engine is to use this broad phase, before the first body is added. A broad phase keeps what it knows of
     * the bodies, so another engine would be given pairs of bodies that are not its own.
     *
     * @throws IllegalStateException if an engine uses it, or has used it; not thrown unless overridden
     */
    default void claim() {
        // one without a memory may be shared
    }

    /**
     * Adds a body whose box has been set, and begins its pairs.
     *
     * @param body index of the body
     * @param boxes all boxes
     * @param pairs the pairs
     */
    void add(int body, Boxes boxes, Pairs pairs);

    /**
     * Updates a body whose box has been set again: begins the pairs that are new, and ends those that are over.
     *
     * @param body index of the body
     * @param boxes all boxes
     * @param pairs the pairs
     */
    void update(int body, Boxes boxes, Pairs pairs);

    /**
     * Removes a body and ends its pairs.
     *
     * @param body index of the body
     * @param boxes all boxes
     * @param pairs the pairs
     */
    void remove(int body, Boxes boxes, Pairs pairs);
}
