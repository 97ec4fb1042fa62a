// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.util.IdentityHashMap;
import java.util.Map;
import sim.physics.motion.State;

/**
 * What islands know of the cosines and sines of their bodies, kept for when what is tried between steps is refused: a tiny move turns them on
 * instead of finding them anew, so their last bits depend on the way that a body has come.
 */
public final class KeptTurns {
    private final Map<Turns, double[][]> kept = new IdentityHashMap<>();

    /**
     * Keeps those of the moment.
     *
     * @param constraints null if there are none
     * @param state the state vectors
     */
    public KeptTurns(Constraints constraints, State state) {
        if (constraints != null) {
            constraints.groups.forEach(group -> group.keepTurns(kept, state));
        }
    }

    /** Puts them back; the bodies are where they were. */
    public void putBack() {
        kept.forEach(Turns::putBack);
    }
}
