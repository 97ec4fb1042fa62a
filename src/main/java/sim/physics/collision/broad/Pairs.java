// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.broad;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.Agenda;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;

/**
 * The pairs of bodies that are possibly colliding: those whose boxes overlap. Each pair has a number that stays as
 * long as the pair does, and each body knows its pairs. Where a body has several convex parts there is a pair for each two
 * parts of two bodies; they begin and end together.
 */
public final class Pairs implements Serializable {
    private static final long serialVersionUID = 5L;

    /** Binary logarithm of the length of a pair's record. */
    public static final int SHIFT = 3;

    /** Where in it the word of an {@link Agenda} lies; its spare bits are the {@link #marks}. */
    public static final int WORD = 5;

    private static final int STRIDE = 1 << SHIFT;
    private static final int SECOND = 1;
    private static final int PLACE = 2;
    private static final int CODE = 4;
    private static final int MARKS = Integer.numberOfTrailingZeros(Agenda.SPARE);
    private static final int TIME = 6;

    /** Per body: how many pairs it has, and they; or minus 1 minus the number of a list in which they are. */
    private static final int SLOTS = 8;

    private static final int LEAST = 4;

    /** Bits of a part's number. */
    private static final int PART = 16;

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

    /**
     * Per pair half a cache line, since it is wanted together: its two bodies, its places in their lists, what the narrow phase
     * and the search for impacts keep with it.
     */
    private int[] data = {};

    private int used;
    private final IntList free = new IntList();

    private int[] ofBody = {};

    /** The pairs of bodies that have many, and which of these lists are not in use. */
    private IntList[] crowds = {};

    private final IntList freeCrowds = new IntList();
    private Listener listener;

    /** By body how many convex parts it has, 0 for one; by pair those that it is of. Null until a body has several. */
    private int[] partsOf;

    private int[] parts;

    /** Makes an empty set. */
    public Pairs() {
        // the arrays grow with the pairs
    }

    /**
     * The records of all pairs, with {@link Agenda#EMPTY} for the word of an agenda when a pair begins.
     *
     * @return live, until a pair begins
     */
    public int[] records() {
        return data;
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
        if (ofBody.length < SLOTS * bodies) {
            ofBody = Arrays.copyOf(ofBody, SLOTS * Growth.length(ofBody.length / SLOTS, bodies));
        }
    }

    /**
     * Says how many convex parts a body has, before it has pairs.
     *
     * @param body index
     * @param count 1 for most
     */
    public void setParts(int body, int count) {
        if (count == 1 && partsOf == null) {
            return;
        }
        int old = partsOf == null ? 0 : partsOf.length;
        if (old <= body) {
            partsOf = Arrays.copyOf(partsOf == null ? new int[0] : partsOf, Growth.length(old, body + 1));
        }
        partsOf[body] = count == 1 ? 0 : count;
        parts = parts == null ? new int[0] : parts;
    }

    /**
     * Whether no body has ever had several parts.
     *
     * @return true if there is one pair of two bodies at most
     */
    public boolean areWhole() {
        return parts == null;
    }

    /**
     * The part of the first body that a pair is of.
     *
     * @param pair number
     * @return 0 …
     */
    public int firstPart(int pair) {
        return parts == null || pair >= parts.length ? 0 : parts[pair] >>> PART;
    }

    /**
     * The part of the second body that a pair is of.
     *
     * @param pair number
     * @return 0 …
     */
    public int secondPart(int pair) {
        return parts == null || pair >= parts.length ? 0 : parts[pair] & (1 << PART) - 1;
    }

    private int partsOf(int body) {
        return body < partsOf.length ? Math.max(1, partsOf[body]) : 1;
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
     * How many pairs a body has.
     *
     * @param body index
     * @return 0 for one that never had any
     */
    public int countOf(int body) {
        int count = ofBody[SLOTS * body];
        return count >= 0 ? count : crowds[~count].size;
    }

    /**
     * A pair of a body.
     *
     * @param body index
     * @param k 0 … countOf(body) − 1
     * @return its number
     */
    public int of(int body, int k) {
        int count = ofBody[SLOTS * body];
        return count >= 0 ? ofBody[SLOTS * body + 1 + k] : crowds[~count].values[k];
    }

    /**
     * The code of the closest features of a pair.
     *
     * @param pair its number
     * @return what was set last
     */
    public int code(int pair) {
        return data[STRIDE * pair + CODE];
    }

    /**
     * Sets the code of the closest features of a pair.
     *
     * @param pair its number
     * @param code any
     */
    public void setCode(int pair, int code) {
        data[STRIDE * pair + CODE] = code;
    }

    /**
     * What the search for impacts has noted of a pair.
     *
     * @param pair its number
     * @return bits
     */
    public int marks(int pair) {
        return data[STRIDE * pair + WORD] >>> MARKS;
    }

    /**
     * Notes something of a pair.
     *
     * @param pair its number
     * @param marks bits
     */
    public void setMarks(int pair, int marks) {
        int word = data[STRIDE * pair + WORD];
        data[STRIDE * pair + WORD] = word & ~Agenda.SPARE | marks << MARKS;
    }

    /**
     * The time of a pair.
     *
     * @param pair its number
     * @return what was set last
     */
    public double time(int pair) {
        int o = STRIDE * pair + TIME;
        return Double.longBitsToDouble((long) data[o + 1] << 32 | data[o] & 0xffffffffL);
    }

    /**
     * Sets the time of a pair.
     *
     * @param pair its number
     * @param time any
     */
    public void setTime(int pair, double time) {
        int o = STRIDE * pair + TIME;
        long bits = Double.doubleToRawLongBits(time);
        data[o] = (int) bits;
        data[o + 1] = (int) (bits >>> 32);
    }

    /**
     * Looks a pair up.
     *
     * @param a a body
     * @param b another body
     * @return the number of their pair, or of one of them, or −1
     */
    public int find(int a, int b) {
        boolean fewerInA = countOf(a) <= countOf(b);
        int body = fewerInA ? a : b;
        int other = fewerInA ? b : a;
        for (int k = 0; k < countOf(body); k++) {
            int p = of(body, k);
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
        int first = Math.min(a, b);
        int second = Math.max(a, b);
        if (partsOf == null) {
            begin(first, second, 0);
            return;
        }
        for (int i = 0; i < partsOf(first); i++) {
            for (int k = 0; k < partsOf(second); k++) {
                begin(first, second, i << PART | k);
            }
        }
    }

    private void begin(int first, int second, int ofParts) {
        int p = free.size > 0 ? free.values[--free.size] : used++;
        int o = STRIDE * p;
        if (o >= data.length) {
            data = Arrays.copyOf(data, STRIDE * Growth.length(data.length / STRIDE, p + 1));
        }
        data[o] = first;
        data[o + SECOND] = second;
        data[o + WORD] = Agenda.EMPTY;
        data[o + PLACE] = append(first, p);
        data[o + PLACE + SECOND] = append(second, p);
        if (parts != null && (ofParts != 0 || p < parts.length)) {
            parts = p < parts.length ? parts : Arrays.copyOf(parts, data.length / STRIDE);
            parts[p] = ofParts;
        }
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
        int o = SLOTS * body;
        int count = ofBody[o];
        if (count == SLOTS - 1) {
            count = crowd(o);
        }
        if (count < 0) {
            crowds[~count].add(pair);
            return crowds[~count].size - 1;
        }
        ofBody[o + 1 + count] = pair;
        ofBody[o] = count + 1;
        return count;
    }

    /** Moves a body's pairs into a list; the number of it, inverted. */
    private int crowd(int o) {
        if (freeCrowds.size == 0) {
            int old = crowds.length;
            crowds = Arrays.copyOf(crowds, Growth.length(old, 4));
            for (int k = crowds.length - 1; k >= old; k--) {
                crowds[k] = new IntList();
                freeCrowds.add(k);
            }
        }
        int number = freeCrowds.values[--freeCrowds.size];
        for (int k = 1; k < SLOTS; k++) {
            crowds[number].add(ofBody[o + k]);
        }
        ofBody[o] = ~number;
        return ~number;
    }

    /** Takes an entry out of a body's list; the last entry moves into its place. */
    private void drop(int body, int place) {
        int b = SLOTS * body;
        int count = ofBody[b];
        int last;
        if (count >= 0) {
            last = ofBody[b + count];
            ofBody[b + 1 + place] = last;
            ofBody[b] = count - 1;
        } else {
            IntList list = crowds[~count];
            last = list.values[--list.size];
            list.values[place] = last;
            if (list.size <= LEAST) {
                System.arraycopy(list.values, 0, ofBody, b + 1, list.size);
                ofBody[b] = list.size;
                list.clear();
                freeCrowds.add(~count);
            }
        }
        int o = STRIDE * last;
        data[data[o] == body ? o + PLACE : o + PLACE + SECOND] = place;
    }
}
