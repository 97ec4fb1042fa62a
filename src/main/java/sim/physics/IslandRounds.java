// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;

/** Tells which islands have been come to in a round, so that each is only once. */
final class IslandRounds implements Serializable {
    private static final long serialVersionUID = 1L;

    /** By first body of an island the last round that came to it. */
    private transient int[] last = {};

    private transient int round;

    void begin() {
        round++;
    }

    /** Whether an island has not been asked about in this round. */
    boolean isFirst(IntList island) {
        int first = island.values[0];
        if (last == null || last.length <= first) { // null: just restored
            last = last == null ? new int[first + 1] : Arrays.copyOf(last, Growth.length(last.length, first + 1));
        }
        boolean yes = last[first] != round;
        last[first] = round;
        return yes;
    }
}
