// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import sim.physics.motion.State;

/** Queries that answer by one way only, for comparison. */
public final class Ways {
    private Ways() {}

    /**
     * Looks at all bodies.
     *
     * @param state the bodies
     * @return never uses cells
     */
    public static Queries all(State state) {
        return new Queries(state, Integer.MAX_VALUE, Integer.MAX_VALUE);
    }

    /**
     * Looks into cells.
     *
     * @param state the bodies
     * @return lays the grid at the first question after any change of all bodies
     */
    public static Queries cells(State state) {
        return new Queries(state, 0, 1);
    }
}
