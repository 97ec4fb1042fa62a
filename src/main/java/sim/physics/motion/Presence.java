// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;

/**
 * Knows where bodies are in the middle of a step, when the state vectors still hold the step's start: a body that a
 * listener writes is brought to the present instant first, so that what was not written stays true.
 */
public interface Presence extends Serializable {
    /**
     * Writes where a body is now into the state vectors.
     *
     * @param index of the body
     */
    void bring(int index);
}
