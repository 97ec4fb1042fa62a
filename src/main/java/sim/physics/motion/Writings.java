// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.util.IdentityHashMap;
import java.util.Map;

/** Which bodies have been written or pushed since the last step, kept for when what is tried between steps is refused. */
public final class Writings {
    private final State state;

    /** Of the kinematic bodies, which go on as if nobody had put them back. */
    private final Map<KinematicBody, double[]> courses = new IdentityHashMap<>();

    /**
     * Keeps those of the moment, until others are kept.
     *
     * @param state the state vectors
     */
    public Writings(State state) {
        this.state = state;
        state.touched.keep();
        for (int k = 0; k < state.size(); k++) {
            if (state.body(k) instanceof KinematicBody moved) {
                courses.put(moved, moved.keep());
            }
        }
    }

    /** Forgets that others have been written since. Where they are has been put back before. */
    public void putBack() {
        state.touched.putBack();
        state.placedAll();
        courses.forEach(KinematicBody::putBack);
    }
}
