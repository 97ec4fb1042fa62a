// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;

/**
 * The ties of an island that act at some times only, motors and stops. They decide by themselves when they act, or are
 * <i>frozen</i>: then they push with given forces, which somebody has found who knows what else acts.
 */
public interface SwitchedTies extends Serializable {
    /**
     * How many there are.
     *
     * @return not negative
     */
    int size();

    /**
     * Reads one, as it was when the island was last prepared for its replies.
     *
     * @param k which
     * @param row takes it
     */
    void read(int k, SwitchedRow row);

    /**
     * Reads one as it is where its bodies are now.
     *
     * @param k which
     * @param row takes it
     */
    void readNow(int k, SwitchedRow row);

    /**
     * Lets one push with a constant force from now on, until {@link #thaw}.
     *
     * @param k which
     * @param force along its coordinate
     */
    void freeze(int k, double force);

    /** Lets all decide by themselves again. */
    void thaw();
}
