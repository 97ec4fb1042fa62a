// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

/**
 * Heaps in which a body fills all the room between two walls. Whatever presses it against one of them may press it against the other as well: what its
 * points bear is not unique, and with friction its motion is not either. Nor is there room for gaps, and impulses that regain them grow without
 * bounds. So no gap is regained, and points bear what they would if they were a little soft, which is the least.
 */
final class Squeezed {
    /** By how much walls that face one another may miss being parallel: half of the square of an angle. */
    private static final double PARALLEL = 1e-12;

    private Squeezed() {}

    /** Lets points regain no gap at which a body fills all the room between two walls; false if there are none, or too many to look at. */
    static boolean yields(HeapSystem s) {
        boolean are = false;
        for (int p = 1; p < s.contacts() && s.contacts() <= HeapShare.MOST; p++) {
            for (int q = 0; q < p && presses(s, p); q++) {
                if (presses(s, q) && areOpposed(s.rows(), p, q)) {
                    are = true;
                    s.bound(p, 0);
                    s.bound(q, 0);
                }
            }
        }
        return are;
    }

    private static boolean presses(HeapSystem s, int p) {
        return s.bound(p) >= 0 && s.rows().isOnFixed(p);
    }

    private static boolean areOpposed(PointRows rows, int p, int q) {
        int side = rows.body(p, 0) < 0 ? 1 : 0;
        int other = rows.body(q, 0) < 0 ? 1 : 0;
        double along = rows.nx(p) * rows.nx(q) + rows.ny(p) * rows.ny(q);
        return rows.body(p, side) == rows.body(q, other) && (side == other ? along : -along) < PARALLEL - 1;
    }
}
