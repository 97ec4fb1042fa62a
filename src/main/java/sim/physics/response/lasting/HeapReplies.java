// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;
import sim.physics.motion.State;
import sim.physics.motion.Ties;

/** What units of impulse at the points of a heap do to bodies that are tied to others, and so to those others. */
final class HeapReplies implements Serializable {
    private static final long serialVersionUID = 1L;

    /** By side of a point: the first body that replies, as a number in the heap, their count, and where the values are. */
    private int[] first = {};

    private int[] count = {};
    private int[] at = {};

    /** For each side the changes by a unit along the normal, then along the tangent. */
    private double[] values = {};

    private int used;
    private double[] velocities = {};

    HeapReplies() {
        // grows with the heaps
    }

    /** Begins a heap. */
    void begin() {
        used = 0;
    }

    /** Forgets the replies of a point. */
    void clear(int p) {
        if (count.length < 2 * p + 2) {
            first = Arrays.copyOf(first, 4 * p + 4);
            count = Arrays.copyOf(count, 4 * p + 4);
            at = Arrays.copyOf(at, 4 * p + 4);
        }
        count[2 * p] = 0;
        count[2 * p + 1] = 0;
    }

    /**
     * Finds what units of impulse at a side of a point do to a tied body and its companions.
     *
     * @param first number in the heap of the first one of the island
     * @param body whose side of the point it is
     * @param length of the vector of all velocities
     */
    void find(ContactRows rows, int p, int side, int first, Ties ties, int body, int length) {
        IntList island = ties.island(body);
        velocities = velocities.length < length ? new double[length] : velocities;
        double sign = side == 0 ? -1 : 1;
        ties.reply(body, sign * rows.nx(p), sign * rows.ny(p), sign * rows.lever(p, side), velocities);
        set(2 * p + side, first, island, false);
        ties.reply(body, -sign * rows.ny(p), sign * rows.nx(p), sign * rows.arm(p, side), velocities);
        set(2 * p + side, first, island, true);
    }

    /** Sets the replies of a side: of an island whose bodies have consecutive numbers in the heap. */
    private void set(int side, int place, IntList island, boolean tangential) {
        int n = 3 * island.size;
        if (!tangential) {
            first[side] = place;
            count[side] = island.size;
            at[side] = used;
            used += 2 * n;
            values = values.length < used ? Arrays.copyOf(values, 2 * used) : values;
        }
        int to = at[side] + (tangential ? n : 0);
        for (int k = 0; k < island.size; k++) {
            System.arraycopy(velocities, State.BLOCK * island.values[k], values, to + 3 * k, 3);
        }
    }

    /** Adds what a side's impulses do; false if it has no replies. */
    boolean push(int side, double jn, double jt, double[] v) {
        int n = 3 * count[side];
        int from = at[side];
        int to = 3 * first[side];
        for (int k = 0; k < n; k++) {
            v[to + k] += jn * values[from + k] + jt * values[from + n + k];
        }
        return n > 0;
    }
}
