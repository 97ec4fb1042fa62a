// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

/** Which bodies have been written or pushed since the last step, kept for when what is tried between steps is refused. */
public final class Writings {
    private final State state;

    /**
     * Keeps those of the moment, until others are kept.
     *
     * @param state the state vectors
     */
    public Writings(State state) {
        this.state = state;
        state.touched.keep();
    }

    /** Forgets that others have been written since. Where they are has been put back before. */
    public void putBack() {
        state.touched.putBack();
        state.placedAll();
    }
}
