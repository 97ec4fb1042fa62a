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
    private static final long serialVersionUID = 2L;

    /** The date of an item that is never due. */
    public static final long NEVER = Long.MAX_VALUE;

    private static final int BUCKETS = 64;

    private final IntList[] wheel = new IntList[BUCKETS];

    /** Per item: the step it is wanted in, and the bucket's step it really waits in (at most BUCKETS − 1 ahead). */
    private long[] dates = new long[16];

    private long now;

    private final IntList due = new IntList();

    /** Makes an empty agenda at step 0. */
    public Agenda() {
        for (int k = 0; k < BUCKETS; k++) {
            wheel[k] = new IntList();
        }
        Arrays.fill(dates, NEVER);
    }

    /**
     * Makes room for items.
     *
     * @param count number of items
     */
    public void ensure(int count) {
        int old = dates.length;
        if (old < 2 * count) {
            dates = Arrays.copyOf(dates, Math.max(2 * old, 2 * count));
            Arrays.fill(dates, old, dates.length, NEVER);
        }
    }

    /**
     * Sets the date of an item.
     *
     * @param item index
     * @param step a step after the present one, or {@link #NEVER}
     */
    public void schedule(int item, long step) {
        dates[2 * item] = step;
        if (step == NEVER) {
            dates[2 * item + 1] = NEVER;
            return;
        }
        long bucket = Math.min(step, now + BUCKETS - 1);
        if (dates[2 * item + 1] != bucket) {
            dates[2 * item + 1] = bucket;
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
        return dates[2 * item];
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
            if (dates[2 * item + 1] != step) {
                continue;
            }
            dates[2 * item + 1] = NEVER;
            if (dates[2 * item] > step) {
                schedule(item, dates[2 * item]);
            } else {
                dates[2 * item] = NEVER;
                due.add(item);
            }
        }
        return due;
    }
}
