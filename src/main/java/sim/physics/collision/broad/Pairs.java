// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.broad;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;

/**
 * The pairs of bodies that are possibly colliding: those whose boxes overlap. Each pair has a number that stays as
 * long as the pair does, and each body knows its pairs.
 */
public final class Pairs implements Serializable {
    private static final long serialVersionUID = 2L;

    private static final int STRIDE = 4;
    private static final int SECOND = 1;
    private static final int PLACE = 2;

    /** What a caller of {@link BroadPhase#update} wants to know of. */
    public interface Listener {
        /**
         * A pair has begun.
         *
         * @param pair its number
         */
        void pairBegan(int pair);

        /**
         * A pair has ended; its number will be used again.
         *
         * @param pair its number
         */
        void pairEnded(int pair);
    }

    /** Per pair: its two bodies, and its places in their lists; together, since they are wanted together. */
    private int[] data = new int[STRIDE * 16];

    private int used;
    private final IntList free = new IntList();
    private IntList[] ofBody = new IntList[8];
    private Listener listener;

    /** Makes an empty set. */
    public Pairs() {
        // the arrays grow with the pairs
    }

    /**
     * Sets who is told of pairs that begin and end.
     *
     * @param listener null for nobody
     */
    public void setListener(Listener listener) {
        this.listener = listener;
    }

    /**
     * Makes room for bodies.
     *
     * @param bodies number of blocks
     */
    public void ensure(int bodies) {
        if (ofBody.length < bodies) {
            ofBody = Arrays.copyOf(ofBody, Math.max(2 * ofBody.length, bodies));
        }
    }

    /**
     * The body with the smaller index of a pair.
     *
     * @param pair number
     * @return index of a body
     */
    public int first(int pair) {
        return data[STRIDE * pair];
    }

    /**
     * The body with the larger index of a pair.
     *
     * @param pair number
     * @return index of a body
     */
    public int second(int pair) {
        return data[STRIDE * pair + SECOND];
    }

    /**
     * The partner of a body in a pair.
     *
     * @param pair number
     * @param body one of its bodies
     * @return index of the other one
     */
    public int other(int pair, int body) {
        return data[STRIDE * pair] ^ data[STRIDE * pair + SECOND] ^ body;
    }

    /**
     * One more than the largest number of a pair.
     *
     * @return length that arrays by pair need
     */
    public int capacity() {
        return used;
    }

    /**
     * Number of pairs.
     *
     * @return pairs that have begun and not ended
     */
    public int count() {
        return used - free.size;
    }

    /**
     * The pairs of a body.
     *
     * @param body index
     * @return their numbers; live, null if the body never had one
     */
    public IntList of(int body) {
        return ofBody[body];
    }

    /**
     * Looks a pair up.
     *
     * @param a a body
     * @param b another body
     * @return the number of their pair, or −1
     */
    public int find(int a, int b) {
        IntList ofA = ofBody[a];
        IntList ofB = ofBody[b];
        if (ofA == null || ofB == null) {
            return -1;
        }
        boolean fewerInA = ofA.size <= ofB.size;
        IntList list = fewerInA ? ofA : ofB;
        int other = fewerInA ? b : a;
        for (int k = 0; k < list.size; k++) {
            int p = list.values[k];
            if (data[STRIDE * p] == other || data[STRIDE * p + SECOND] == other) {
                return p;
            }
        }
        return -1;
    }

    /**
     * Begins a pair unless it has begun.
     *
     * @param a a body
     * @param b another body
     */
    public void begin(int a, int b) {
        if (find(a, b) < 0) {
            beginNew(a, b);
        }
    }

    /**
     * Begins a pair that has not begun.
     *
     * @param a a body
     * @param b another body
     */
    void beginNew(int a, int b) {
        int p = free.size > 0 ? free.values[--free.size] : used++;
        int o = STRIDE * p;
        if (o >= data.length) {
            data = Arrays.copyOf(data, 2 * data.length);
        }
        int first = Math.min(a, b);
        int second = Math.max(a, b);
        data[o] = first;
        data[o + SECOND] = second;
        data[o + PLACE] = append(first, p);
        data[o + PLACE + SECOND] = append(second, p);
        if (listener != null) {
            listener.pairBegan(p);
        }
    }

    /**
     * Ends a pair.
     *
     * @param pair its number
     */
    public void end(int pair) {
        if (listener != null) {
            listener.pairEnded(pair);
        }
        int o = STRIDE * pair;
        drop(data[o], data[o + PLACE]);
        drop(data[o + SECOND], data[o + PLACE + SECOND]);
        data[o] = -1;
        data[o + SECOND] = -1;
        free.add(pair);
    }

    private int append(int body, int pair) {
        if (ofBody[body] == null) {
            ofBody[body] = new IntList();
        }
        ofBody[body].add(pair);
        return ofBody[body].size - 1;
    }

    /** Takes an entry out of a body's list; the last entry moves into its place. */
    private void drop(int body, int place) {
        IntList list = ofBody[body];
        int last = list.values[--list.size];
        list.values[place] = last;
        int o = STRIDE * last;
        data[data[o] == body ? o + PLACE : o + PLACE + SECOND] = place;
    }
}
