// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;
import sim.physics.motion.Motion;
import sim.physics.motion.State;
import sim.physics.motion.Ties;

/** What units of impulse at the points of a heap do to bodies that are tied to others, and so to those others. */
final class HeapReplies implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Both sides of a point at once; and the count of a second side whose replies are among those of the first one. */
    static final int BOTH = 2;

    private static final int COVERED = -1;

    /** By side of a point: the first body that replies, as a number in the heap, their count, and where the values are. */
    private int[] first = {};

    private int[] count = {};
    private int[] at = {};

    /** For each side the changes by a unit along the normal, then along the tangent. */
    private double[] values = {};

    private int used;
    private double[] velocities = {};
    private double[] alone = {};

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

    /** Whether a body of a point is tied to others; given the bodies of the heap. */
    static boolean areNeeded(HeapSystem s, int p, IntList bodies, Motion motion) {
        return isTied(s.rows().body(p, 0), bodies, motion) || isTied(s.rows().body(p, 1), bodies, motion);
    }

    private static boolean isTied(int place, IntList bodies, Motion motion) {
        return place >= 0 && motion.isTied(bodies.values[place]);
    }

    /**
     * Finds what a point's impulses do to bodies that are tied to others.
     *
     * @param bodies of the heap
     * @param places by body: its number in the heap, plus 1
     */
    void find(HeapSystem s, int p, IntList bodies, Motion motion, Ties ties, int[] places) {
        int a = s.rows().body(p, 0);
        int b = s.rows().body(p, 1);
        int first = isTied(a, bodies, motion) ? bodies.values[a] : -1;
        int second = isTied(b, bodies, motion) ? bodies.values[b] : -1;
        boolean isOne = first >= 0 && second >= 0 && ties.island(first) == ties.island(second);
        if (first >= 0) {
            IntList island = ties.island(first);
            find(s.rows(), p, s.w, isOne ? BOTH : 0, places[island.values[0]] - 1, ties, island, p < s.contacts());
        }
        if (second >= 0 && !isOne) {
            IntList island = ties.island(second);
            find(s.rows(), p, s.w, 1, places[island.values[0]] - 1, ties, island, p < s.contacts());
        }
    }

    /**
     * Finds what units of impulse at a point do to tied bodies: at one of its sides, or at both at once where these are tied together.
     *
     * @param w inverse masses and moments of inertia of the bodies of the heap
     * @param side 0 or 1, or {@link #BOTH}
     * @param place number in the heap of the first one of the island
     * @param island the bodies, which have consecutive numbers in the heap
     * @param twice whether along the tangent too
     */
    private void find(PointRows rows, int p, double[] w, int side, int place, Ties ties, IntList island, boolean twice) {
        int n = 3 * island.size;
        int own = side == BOTH ? 2 * p : 2 * p + side;
        first[own] = place;
        count[own] = island.size;
        at[own] = used;
        count[2 * p + 1] = side == BOTH ? COVERED : count[2 * p + 1];
        used += (twice ? 2 : 1) * n;
        values = values.length < used ? Arrays.copyOf(values, 2 * used) : values;
        alone = alone.length < 3 * place + n ? new double[2 * (3 * place + n)] : alone;
        for (int k = 0; k < (twice ? 2 : 1); k++) {
            Arrays.fill(alone, 3 * place, 3 * place + n, 0);
            if (side != 0) {
                rows.pushSecond(p, 1 - k, k, w, alone);
            }
            if (side != 1) {
                rows.pushFirst(p, 1 - k, k, w, alone);
            }
            reply(ties, island, 3 * place, at[own] + k * n);
        }
    }

    /** Asks an island what is left of changes that its bodies would have alone. */
    private void reply(Ties ties, IntList island, int from, int to) {
        int last = State.BLOCK * (island.values[island.size - 1] + 1);
        velocities = velocities.length < last ? new double[2 * last] : velocities;
        for (int k = 0; k < island.size; k++) {
            System.arraycopy(alone, from + 3 * k, velocities, State.BLOCK * island.values[k], State.BLOCK);
        }
        ties.reply(island.values[0], velocities);
        for (int k = 0; k < island.size; k++) {
            System.arraycopy(velocities, State.BLOCK * island.values[k], values, to + 3 * k, State.BLOCK);
        }
    }

    /** Takes for a point the replies of another one on the same two bodies, or their opposite; false if these are not tied together. */
    boolean share(int p, int other, boolean isOpposite) {
        if (count[2 * other + 1] != COVERED) {
            return false;
        }
        first[2 * p] = first[2 * other];
        count[2 * p] = count[2 * other];
        count[2 * p + 1] = COVERED;
        at[2 * p] = used;
        int n = 3 * count[2 * p];
        used += n;
        values = values.length < used ? Arrays.copyOf(values, 2 * used) : values;
        for (int k = 0; k < n; k++) {
            values[at[2 * p] + k] = isOpposite ? -values[at[2 * other] + k] : values[at[2 * other] + k];
        }
        return true;
    }

    /** Adds what a side's impulses do; false if it has no replies. */
    boolean push(int side, double jn, double jt, double[] v) {
        int n = 3 * count[side];
        int from = at[side];
        int to = 3 * first[side];
        for (int k = 0; k < n; k++) {
            v[to + k] += jn * values[from + k];
        }
        for (int k = 0; k < n && jt != 0; k++) {
            v[to + k] += jt * values[from + n + k];
        }
        return n != 0;
    }
}
