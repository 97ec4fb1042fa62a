// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import java.util.Map;

/** A scene in an engine. */
interface World extends AutoCloseable {
    /** Takes one step. */
    void step();

    /** Writes x, y, angle and their rates of each part. */
    void read(double[] state);

    /** Counts of work that are the same on every machine. */
    default Map<String, Long> counts() {
        return Map.of();
    }

    @Override
    default void close() {
        // nothing to give back
    }
}
