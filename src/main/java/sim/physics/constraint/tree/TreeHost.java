// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint.tree;

import java.io.Serializable;
import sim.physics.internal.IntList;
import sim.physics.motion.State;

/** What a tree asks of the island whose pins it is. */
public interface TreeHost extends Serializable {
    /**
     * The bodies of the tree.
     *
     * @return indices in ascending order; live
     */
    IntList bodies();

    /**
     * The size of the smallest one.
     *
     * @return length
     */
    double leastSize();

    /**
     * The size of the largest one.
     *
     * @return length
     */
    double mostSize();

    /** Takes note that the tree makes the step, of which no equation says what another one says. */
    void step();

    /**
     * Takes note of what nothing can take from the tree in a step without forces.
     *
     * @param state where it is at the start
     */
    void keepInvariants(State state);

    /**
     * Gives that back to it.
     *
     * @param state where it is at the end; changed
     */
    void restoreInvariants(State state);
}
