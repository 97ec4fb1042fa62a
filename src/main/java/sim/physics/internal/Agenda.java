// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

import java.io.Serializable;
import java.util.Arrays;

/**
 * Which items are to be looked at in which step: a wheel of buckets, one a step. Scheduling an item again replaces its
 * earlier date. Both operations take constant time, and an item that is not due costs nothing.
 */
public final class Agenda implements Serializable {
    private static final long serialVersionUID = 1L;

    /** The date of an item that is never due. */
    public static final long NEVER = Long.MAX_VALUE;

    private static final int BUCKETS = 64;

    private final IntList[] wheel = new IntList[BUCKETS];

    /** The step an item is wanted in, and the bucket's step it really waits in (at most BUCKETS − 1 ahead). */
    private long[] wanted = new long[8];

    private long[] waiting = new long[8];
    private long now;

    private final IntList due = new IntList();

    /** Makes an empty agenda at step 0. */
    public Agenda() {
        for (int k = 0; k < BUCKETS; k++) {
            wheel[k] = new IntList();
        }
        Arrays.fill(wanted, NEVER);
        Arrays.fill(waiting, NEVER);
    }

    /**
     * Makes room for items.
     *
     * @param count number of items
     */
    public void ensure(int count) {
        int old = wanted.length;
        if (old < count) {
            wanted = Arrays.copyOf(wanted, Math.max(2 * old, count));
            waiting = Arrays.copyOf(waiting, wanted.length);
            Arrays.fill(wanted, old, wanted.length, NEVER);
            Arrays.fill(waiting, old, waiting.length, NEVER);
        }
    }

    /**
     * Sets the date of an item.
     *
     * @param item index
     * @param step a step after the present one, or {@link #NEVER}
     */
    public void schedule(int item, long step) {
        wanted[item] = step;
        if (step == NEVER) {
            waiting[item] = NEVER;
            return;
        }
        long bucket = Math.min(step, now + BUCKETS - 1);
        if (waiting[item] != bucket) {
            waiting[item] = bucket;
            wheel[(int) (bucket % BUCKETS)].add(item);
        }
    }

    /**
     * The date of an item.
     *
     * @param item index
     * @return a step, or {@link #NEVER}
     */
    public long date(int item) {
        return wanted[item];
    }

    /**
     * Goes on to a step and collects what is due in it. Steps must be visited one by one.
     *
     * @param step the present step
     * @return the items that are due, each once; valid until the next call
     */
    public IntList advance(long step) {
        now = step;
        due.clear();
        IntList bucket = wheel[(int) (step % BUCKETS)];
        int count = bucket.size;
        bucket.clear();
        for (int k = 0; k < count; k++) {
            int item = bucket.values[k];
            if (waiting[item] != step) {
                continue;
            }
            waiting[item] = NEVER;
            if (wanted[item] > step) {
                schedule(item, wanted[item]);
            } else {
                wanted[item] = NEVER;
                due.add(item);
            }
        }
        return due;
    }
}
