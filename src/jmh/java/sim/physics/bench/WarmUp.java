// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

/**
 * Runs before a measurement until all is compiled. Counted in rounds that was too short: crowds were taken for 1.8 times as slow as
 * they are, and a gas of disks that covers a fifth of its area for twice.
 */
final class WarmUp {
    private WarmUp() {}

    /** Runs rounds, not timed, for a number of seconds. */
    static void run(double seconds, Runnable round) {
        long end = System.nanoTime() + (long) (seconds * 1e9);
        while (System.nanoTime() < end) {
            round.run();
        }
    }
}
