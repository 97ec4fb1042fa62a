// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.broad;

import java.io.Serializable;

/**
 * Finds the pairs of bodies that are possibly colliding, the write-up's <i>Broad Phase</i>. All implementations report
 * the same pairs: those whose {@link Boxes} overlap, touching ones included, two fixed bodies excluded.
 */
public interface BroadPhase extends Serializable {

    /**
     * Takes note that an engine is to use it, before the first body is added. It keeps what it knows of the bodies, so another engine
     * would be given pairs of bodies that are not its own.
     *
     * @throws IllegalStateException if an engine uses it, or has used it; not thrown unless it is overridden
     */
    default void claim() {
        // one without a memory may be shared
    }

    /**
     * Takes a body in whose box has been set, and begins its pairs.
     *
     * @param body index
     * @param boxes all boxes
     * @param pairs the pairs
     */
    void add(int body, Boxes boxes, Pairs pairs);

    /**
     * Takes note that a body's box has been set again, begins the pairs that are new and ends those that are over.
     *
     * @param body index
     * @param boxes all boxes
     * @param pairs the pairs
     */
    void update(int body, Boxes boxes, Pairs pairs);

    /**
     * Forgets a body and ends its pairs.
     *
     * @param body index
     * @param boxes all boxes
     * @param pairs the pairs
     */
    void remove(int body, Boxes boxes, Pairs pairs);
}
