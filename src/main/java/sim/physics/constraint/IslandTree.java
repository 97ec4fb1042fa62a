// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import sim.physics.constraint.tree.TreeHost;
import sim.physics.internal.IntList;
import sim.physics.motion.State;

/** An island of pins, as the tree sees it that they form. */
final class IslandTree implements TreeHost {
    private static final long serialVersionUID = 1L;

    private final Island island;

    IslandTree(Island island) {
        this.island = island;
    }

    @Override
    public IntList bodies() {
        return island.bodies;
    }

    @Override
    public double leastSize() {
        return island.leastSize;
    }

    @Override
    public double mostSize() {
        return island.mostSize;
    }

    @Override
    public void step() {
        island.redundantRows = 0;
    }

    @Override
    public void keepInvariants(State state) {
        island.invariants.begin(state, true);
    }

    @Override
    public void restoreInvariants(State state) {
        island.evaluate(state);
        island.invariants.restore(state, true);
    }
}
