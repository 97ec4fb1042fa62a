// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

/** How far arrays grow: small ones double, large ones take an eighth more, since what nobody uses is memory for nothing. */
public final class Growth {
    private static final int LARGE = 1024;

    private Growth() {}

    /**
     * The length of an array that has become too short.
     *
     * @param old its length
     * @param needed the least length wanted
     * @return at least needed
     */
    public static int length(int old, int needed) {
        int grown = old < LARGE ? 2 * old : old + (old >> 3);
        return Math.max(grown, needed);
    }
}
