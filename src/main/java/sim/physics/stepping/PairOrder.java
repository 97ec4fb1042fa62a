// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.broad.Pairs;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;

/**
 * The pairs that are to be looked at, in the order of their bodies' numbers. Rows are solved in this order, one after the other, so it must not be the one in
 * which the broad phase has found them: that depends on what is far away, and on how fast all moves together.
 */
final class PairOrder implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Binary logarithm of the bits of a word. */
    private static final int WORD = 6;

    /** By what the gaps of a sort become smaller. */
    private static final double SHRINK = 2.25;

    private final Pairs pairs;

    /** The pairs, and the numbers of the two bodies of each. */
    private int[] order = {};

    private long[] keys = {};
    private int size;

    /** A bit for each pair that is to be looked at, and for each that is at its place in the list. */
    private long[] live = {};

    private long[] listed = {};

    /** Those that have come since the list was made, some of them gone again. */
    private final IntList fresh = new IntList();

    private long[] freshKeys = {};
    private boolean isStale;

    PairOrder(Pairs pairs) {
        this.pairs = pairs;
    }

    /** Makes room for pairs. */
    void ensure(int count) {
        live = Arrays.copyOf(live, (count >> WORD) + 1);
        listed = Arrays.copyOf(listed, (count >> WORD) + 1);
    }

    /** A pair is to be looked at. */
    void add(int pair) {
        if (!isLive(pair)) {
            live[pair >> WORD] |= 1L << pair;
            fresh.add(pair);
            isStale = true;
        }
    }

    /** A pair is not to be looked at any more; its number may become another one's. */
    void drop(int pair) {
        live[pair >> WORD] &= ~(1L << pair);
        listed[pair >> WORD] &= ~(1L << pair);
        isStale = true;
    }

    boolean isLive(int pair) {
        return (live[pair >> WORD] & 1L << pair) != 0;
    }

    private boolean isListed(int pair) {
        return (listed[pair >> WORD] & 1L << pair) != 0;
    }

    /** {@return number of pairs in the list, once it has been made anew} */
    int size() {
        return size;
    }

    /** One of them: it may be that it is to be looked at no more. */
    int pair(int k) {
        return order[k];
    }

    /** Makes the list anew. */
    void update() {
        if (!isStale) {
            return;
        }
        isStale = false;
        int kept = 0;
        for (int k = 0; k < size; k++) {
            int pair = order[k];
            order[kept] = pair;
            keys[kept] = keys[k];
            kept += isListed(pair) ? 1 : 0;
        }
        takeFresh();
        sort();
        merge(kept);
    }

    /** Leaves of those that have come the ones that are still there, and each once. */
    private void takeFresh() {
        int count = 0;
        if (freshKeys.length < fresh.size) {
            freshKeys = new long[Growth.length(freshKeys.length, fresh.size)];
        }
        for (int k = 0; k < fresh.size; k++) {
            int pair = fresh.values[k];
            if (isLive(pair) && !isListed(pair)) {
                listed[pair >> WORD] |= 1L << pair;
                fresh.values[count] = pair;
                freshKeys[count++] = (long) pairs.first(pair) << Integer.SIZE | pairs.second(pair);
            }
        }
        fresh.size = count;
    }

    /** Sorts those that have come (Shell, <i>A high-speed sorting procedure</i>, 1959): few in all steps but the first. */
    private void sort() {
        int[] values = fresh.values;
        for (int gap = fresh.size; gap > 1; ) {
            gap = Math.max(1, (int) (gap / SHRINK));
            for (int k = gap; k < fresh.size; k++) {
                int pair = values[k];
                long key = freshKeys[k];
                int place = k;
                for (; place >= gap && isBefore(key, pair, freshKeys[place - gap], values[place - gap]); place -= gap) {
                    values[place] = values[place - gap];
                    freshKeys[place] = freshKeys[place - gap];
                }
                values[place] = pair;
                freshKeys[place] = key;
            }
        }
    }

    /** Bodies of several parts have several pairs. */
    private boolean isBefore(long key, int pair, long other, int otherPair) {
        if (key != other) {
            return key < other;
        }
        int part = pairs.firstPart(pair) - pairs.firstPart(otherPair);
        return part < 0 || part == 0 && pairs.secondPart(pair) < pairs.secondPart(otherPair);
    }

    /** Puts those that have come among the first ones of the list, from the end on. */
    private void merge(int kept) {
        size = kept + fresh.size;
        if (order.length < size) {
            order = Arrays.copyOf(order, Growth.length(order.length, size));
            keys = Arrays.copyOf(keys, order.length);
        }
        int old = kept - 1;
        for (int k = fresh.size - 1, place = size - 1; k >= 0; place--) {
            boolean isOld = old >= 0 && isBefore(freshKeys[k], fresh.values[k], keys[old], order[old]);
            order[place] = isOld ? order[old] : fresh.values[k];
            keys[place] = isOld ? keys[old--] : freshKeys[k--];
        }
        fresh.clear();
    }
}
