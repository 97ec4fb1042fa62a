// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

import java.io.Serializable;
import java.util.Arrays;

/**
 * Which items are to be looked at in which step: a wheel of buckets, one a step. Scheduling an item again replaces its
 * earlier date. Both operations take constant time, and an item that is not due costs nothing.
 *
 * <p>The buckets share one array of chunks, which a bucket takes and gives back, because each of them is full at a time of
 * its own: an item takes 4 bytes, and 4 for each bucket in which it waits, or waited before it was scheduled again. What
 * does not wait any more is dropped before the array would grow, so that the memory does not depend on how often items are
 * scheduled.
 *
 * <p>The 4 bytes of an item may lie in a record that is wanted anyway when it is scheduled. They hold the lower bits of its
 * date, which tell dates apart up to {@link #AHEAD} steps ahead, and leave two for whoever keeps the records.
 */
public final class Agenda implements Serializable {
    private static final long serialVersionUID = 4L;

    /** The date of an item that is never due. */
    public static final long NEVER = Long.MAX_VALUE;

    private static final int BUCKETS = 64;

    /** Length of a chunk; its last value is the chunk after it. */
    private static final int CHUNK = 32;

    /** An item that is wanted later than in so many steps is due by then. */
    public static final int AHEAD = (1 << 22) - 1;

    /** Bits of a word that are not the agenda's: the uppermost two. */
    public static final int SPARE = 3 << 30;

    /** A word of an item that is never due. */
    public static final int EMPTY = BUCKETS;

    /** Bits of a word below the date: the bucket in which the item really waits, or {@link #EMPTY}. */
    private static final int SHIFT = 7;

    private static final int WAITS = 2 * BUCKETS - 1;
    private static final int DATES = (1 << 23) - 1;

    /** Per item, between others' words: the step it is wanted in, and the bucket where it waits, at most BUCKETS − 1 ahead. */
    private int[] words = {};

    /** The place of an item's word: its number shifted by this, and this. */
    private final int shift;

    private final int at;

    private int[] chunks = {};

    /** Chunks that were in use ever, and the first of those that are not now, plus 1. */
    private int used;

    private int free;

    /** Per bucket: its first chunk, its last one, and how many items lie in it. */
    private final int[] first = new int[BUCKETS];

    private final int[] last = new int[BUCKETS];
    private final int[] count = new int[BUCKETS];

    private long now;

    private final IntList due = new IntList();

    /** Makes an empty agenda at step 0. */
    public Agenda() {
        this(0, 0);
    }

    /**
     * Makes an empty agenda at step 0 for items that have records of 2<sup>shift</sup> words.
     *
     * @param shift binary logarithm of the length of a record
     * @param at where in it the agenda's word is; {@link #EMPTY} at first
     */
    public Agenda(int shift, int at) {
        this.shift = shift;
        this.at = at;
    }

    /**
     * Sets the records.
     *
     * @param records of all items that are scheduled; used until they are set again
     */
    public void setRecords(int[] records) {
        if (words != records) { // a reference that is written costs more than one that is compared
            words = records;
        }
    }

    /**
     * Makes room for items.
     *
     * @param items number of items
     */
    public void ensure(int items) {
        int old = words.length;
        if (old < items) {
            words = Arrays.copyOf(words, Growth.length(old, items));
            Arrays.fill(words, old, words.length, EMPTY);
        }
    }

    /**
     * Sets the date of an item.
     *
     * @param item index
     * @param step a step after the present one, or {@link #NEVER}
     */
    public void schedule(int item, long step) {
        int place = (item << shift) + at;
        int word = words[place];
        if (step == NEVER) {
            words[place] = word & SPARE | EMPTY;
            return;
        }
        int bucket = (int) (Math.min(step, now + BUCKETS - 1) & BUCKETS - 1);
        int date = (int) Math.min(step, now + AHEAD) & DATES;
        words[place] = word & SPARE | date << SHIFT | bucket;
        if ((word & WAITS) != bucket) {
            append(bucket, item);
        }
    }

    private void append(int bucket, int item) {
        int place = count[bucket] % (CHUNK - 1);
        if (place == 0 && free == 0 && used + CHUNK > chunks.length) {
            makeRoom();
            place = count[bucket] % (CHUNK - 1);
        }
        count[bucket]++;
        if (place == 0) {
            int chunk = take();
            if (count[bucket] == 1) {
                first[bucket] = chunk;
            } else {
                chunks[last[bucket] + CHUNK - 1] = chunk;
            }
            last[bucket] = chunk;
        }
        chunks[last[bucket] + place] = item;
    }

    private int take() {
        if (free > 0) {
            int chunk = free - 1;
            free = chunks[chunk + CHUNK - 1];
            return chunk;
        }
        int chunk = used;
        used += CHUNK;
        return chunk;
    }

    private void giveBack(int chunk) {
        chunks[chunk + CHUNK - 1] = free;
        free = chunk + 1;
    }

    /** Number of places in buckets that there is room for. */
    int places() {
        return chunks.length;
    }

    /** Drops what does not wait any more; makes the array longer if that is less than a third of it. */
    private void makeRoom() {
        int dropped = 0;
        for (int bucket = 0; bucket < BUCKETS; bucket++) {
            if (count[bucket] > 0) {
                dropped += compact(bucket);
            }
        }
        if (3 * dropped * CHUNK <= used) {
            chunks = Arrays.copyOf(chunks, Growth.length(chunks.length, used + CHUNK));
        }
    }

    /** Keeps what waits in a bucket, each item once; returns how many chunks are given back. */
    private int compact(int bucket) {
        int waiting = count[bucket];
        int from = first[bucket];
        int to = from;
        int kept = 0;
        for (int k = 0; k < waiting; k++) {
            if (k > 0 && k % (CHUNK - 1) == 0) {
                from = chunks[from + CHUNK - 1];
            }
            int item = chunks[from + k % (CHUNK - 1)];
            int place = (item << shift) + at;
            if ((words[place] & WAITS) == bucket) {
                words[place] ^= BUCKETS; // another one does not wait
                if (kept > 0 && kept % (CHUNK - 1) == 0) {
                    to = chunks[to + CHUNK - 1];
                }
                chunks[to + kept++ % (CHUNK - 1)] = item;
            }
        }
        count[bucket] = kept;
        last[bucket] = to;
        for (int k = 0, chunk = first[bucket]; k < kept; k++) {
            if (k > 0 && k % (CHUNK - 1) == 0) {
                chunk = chunks[chunk + CHUNK - 1];
            }
            words[(chunks[chunk + k % (CHUNK - 1)] << shift) + at] ^= BUCKETS;
        }
        int spare = kept == 0 ? first[bucket] : chunks[to + CHUNK - 1];
        int left = (waiting + CHUNK - 2) / (CHUNK - 1) - (kept + CHUNK - 2) / (CHUNK - 1);
        for (int k = 0; k < left; k++) {
            int next = chunks[spare + CHUNK - 1];
            giveBack(spare);
            spare = next;
        }
        return left;
    }

    /**
     * The date of an item.
     *
     * @param item index
     * @return a step, at most {@link #AHEAD} after the present one, or {@link #NEVER}
     */
    long date(int item) {
        int word = words[(item << shift) + at];
        return (word & WAITS) == EMPTY ? NEVER : now + ahead(word, now);
    }

    /**
     * Goes on to a step and collects what is due in it, or was in the steps that have been left out since the last call.
     *
     * @param step the present step
     * @return the items that are due, each once; valid until the next call
     */
    public IntList advance(long step) {
        long before = now;
        now = step;
        due.clear();
        long until = Math.min(step, before + BUCKETS);
        for (long visited = Math.min(before + 1, step); visited <= until; visited++) {
            empty((int) (visited & BUCKETS - 1), visited, step);
        }
        return due;
    }

    private void empty(int bucket, long visited, long step) {
        int waiting = count[bucket];
        int chunk = first[bucket];
        count[bucket] = 0; // before items are scheduled again, which may compact all buckets but what is left of this one
        for (int k = 0, place = 0; k < waiting; k++) {
            look(chunks[chunk + place], bucket, visited, step);
            if (++place == CHUNK - 1 || k == waiting - 1) {
                int next = chunks[chunk + CHUNK - 1];
                giveBack(chunk);
                chunk = next;
                place = 0;
            }
        }
    }

    /** Takes an item out of a bucket, unless it has been scheduled to another one since, and finds out whether it is due. */
    private void look(int item, int bucket, long visited, long step) {
        int place = (item << shift) + at;
        int word = words[place];
        if ((word & WAITS) != bucket) {
            return;
        }
        words[place] = word & SPARE | EMPTY;
        long date = visited + ahead(word, visited);
        if (date > step) {
            schedule(item, date);
        } else {
            due.add(item);
        }
    }

    /** How many steps after a step an item that waits is wanted. */
    private static int ahead(int word, long step) {
        return (word >>> SHIFT) - (int) step & DATES;
    }
}
