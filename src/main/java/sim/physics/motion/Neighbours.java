// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.internal.IntList;

/** Who knows whether bodies may meet others, as their motion sees it. */
public interface Neighbours {
    /**
     * Whether some body may meet one of its neighbours.
     *
     * @param bodies indices
     * @return true if a pair of one of them is looked at
     */
    boolean hasNeighbours(IntList bodies);
}
