// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.broad.Pairs;

/**
 * What will happen in the present step, in time order: a binary heap of (offset, what). Equal offsets come in the order
 * of what they are, so that the order does not depend on the order of insertion.
 *
 * <p>An event that is planned again, or called off, is left where it lies: it counts only as long as its pair's time, or the
 * end of its body's path, is its own. Before the heap would grow it drops all that do not count any more, so it has room for
 * four times as many as do.
 */
final class EventQueue implements Serializable {
    private static final long serialVersionUID = 1L;

    private double[] times = new double[16];
    private int[] items = new int[16];
    private int size;
    private final Pairs pairs;
    private final PathEnds pathEnds;

    EventQueue(Pairs pairs, PathEnds pathEnds) {
        this.pairs = pairs;
        this.pathEnds = pathEnds;
    }

    /** Whether something is to happen still. */
    boolean hasNext() {
        while (size > 0) {
            if (counts(0)) {
                return true;
            }
            removeFirst(); // planned before a later change of course
        }
        return false;
    }

    private boolean counts(int k) {
        int item = items[k];
        return times[k] == (item >= 0 ? pairs.time(item) : pathEnds.end(~item));
    }

    /** Number of events that there is room for. */
    int capacity() {
        return times.length;
    }

    double firstTime() {
        return times[0];
    }

    int firstItem() {
        return items[0];
    }

    void clear() {
        size = 0;
    }

    void add(double time, int item) {
        if (size == times.length) {
            compact();
        }
        insert(time, item);
    }

    private void insert(double time, int item) {
        int k = size++;
        while (k > 0) {
            int parent = (k - 1) >>> 1;
            if (!before(time, item, parent)) {
                break;
            }
            times[k] = times[parent];
            items[k] = items[parent];
            k = parent;
        }
        times[k] = time;
        items[k] = item;
    }

    /** Drops what does not count any more, and all but one of what was planned twice; then makes room. */
    private void compact() {
        int kept = 0;
        for (int k = 0; k < size; k++) {
            if (counts(k)) {
                times[kept] = times[k];
                items[kept++] = items[k];
                setTime(items[k], Double.NaN); // another one does not count
            }
        }
        if (2 * kept > times.length) {
            times = Arrays.copyOf(times, 2 * times.length);
            items = Arrays.copyOf(items, times.length);
        }
        size = 0;
        for (int k = 0; k < kept; k++) {
            setTime(items[k], times[k]);
            insert(times[k], items[k]);
        }
    }

    private void setTime(int item, double time) {
        if (item >= 0) {
            pairs.setTime(item, time);
        } else {
            pathEnds.plan(~item, time);
        }
    }

    void removeFirst() {
        double time = times[--size];
        int item = items[size];
        int k = 0;
        for (int child = 1; child < size; child = 2 * k + 1) {
            if (child + 1 < size && before(times[child + 1], items[child + 1], child)) {
                child++;
            }
            boolean rises = times[child] < time || times[child] == time && items[child] < item;
            if (!rises) {
                break;
            }
            times[k] = times[child];
            items[k] = items[child];
            k = child;
        }
        times[k] = time;
        items[k] = item;
    }

    private boolean before(double time, int item, int other) {
        return time < times[other] || time == times[other] && item < items[other];
    }
}
