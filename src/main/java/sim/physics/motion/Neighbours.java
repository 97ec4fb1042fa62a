// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.internal.IntList;

/** Who knows whether bodies may meet others, as their motion sees it. */
public interface Neighbours {
    /** Of bodies about which nobody is asked, and which may yet have neighbours. */
    Neighbours NONE = new Neighbours() {
        @Override
        public boolean hasNeighbours(IntList bodies) {
            return false;
        }

        @Override
        public boolean areAloof(IntList bodies) {
            return false;
        }
    };

    /**
     * Whether some body may meet one of its neighbours.
     *
     * @param bodies indices
     * @return true if a pair of one of them is looked at
     */
    boolean hasNeighbours(IntList bodies);

    /**
     * Whether nobody can collide with any of some bodies, wherever they go.
     *
     * @param bodies indices
     * @return true if no path of theirs is looked at before something happens
     */
    boolean areAloof(IntList bodies);
}
