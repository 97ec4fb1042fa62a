// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.broad.Pairs;

/**
 * What will happen in the present step, in time order. Equal offsets come in the order of what they are, so that the order
 * does not depend on the order of insertion.
 *
 * <p>The step is divided into spans of equal length, so many that a few events fall into each. What falls into the span that
 * is being gone through, or before it, lies in a binary heap of (offset, what); what comes later waits in the list of its span,
 * where it costs nothing but its place. Most of what is planned is called off before its span begins.
 *
 * <p>An event that is planned again, or called off, is left where it lies: it counts only as long as its pair's time, or the
 * end of its body's path, is its own. Before a list would grow it drops all that do not count any more, so it has room for
 * four times as many as do.
 */
final class EventQueue implements Serializable {
    private static final long serialVersionUID = 2L;

    /** Events in a span, about, and the most spans. */
    private static final int PER_SPAN = 4;

    private static final int MOST_SPANS = 1 << 16;

    private static final int NONE = 0;

    private final Pairs pairs;
    private final PathEnds pathEnds;

    /** The heap. */
    private double[] times = new double[16];

    private int[] items = new int[16];
    private int size;

    /** What waits; what else is in its span, plus 1. */
    private double[] laterTimes = new double[16];

    private int[] laterItems = new int[16];
    private int[] next = new int[16];
    private int waiting;

    /** The first that waits for each span, plus 1. */
    private int[] heads = {NONE};

    private int spans = 1;
    private int span;
    private double perTime;

    /** How many events have been planned in the step. */
    private int planned;

    EventQueue(Pairs pairs, PathEnds pathEnds) {
        this.pairs = pairs;
        this.pathEnds = pathEnds;
    }

    /** Empties the queue for a step of a length, in which about as much will happen as in the last one. */
    void begin(double h) {
        if (spans > 1 || planned >= 2 * PER_SPAN) {
            divide(h);
        }
        size = 0;
        waiting = 0;
        planned = 0;
    }

    private void divide(double h) {
        Arrays.fill(heads, span, spans, NONE);
        spans = Math.min(MOST_SPANS, Integer.highestOneBit(Math.max(1, planned / PER_SPAN)));
        if (heads.length < spans) {
            heads = new int[spans];
        }
        perTime = spans / h;
        span = 0;
    }

    /** Whether something is to happen still. */
    boolean hasNext() {
        do {
            while (size > 0) {
                if (counts(times[0], items[0])) {
                    return true;
                }
                removeFirst(); // planned before a later change of course
            }
        } while (waiting > 0 && enterNextSpan());
        return false;
    }

    /** Goes on to the next span; false if there is none. */
    private boolean enterNextSpan() {
        if (span == spans - 1) {
            waiting = 0;
            return false;
        }
        int k = heads[++span];
        heads[span] = NONE;
        for (; k != NONE; k = next[k - 1]) {
            if (counts(laterTimes[k - 1], laterItems[k - 1])) {
                addNow(laterTimes[k - 1], laterItems[k - 1]);
            }
        }
        return true;
    }

    private boolean counts(double time, int item) {
        return time == (item >= 0 ? pairs.time(item) : pathEnds.end(~item));
    }

    /** Number of events that there is room for. */
    int capacity() {
        return times.length + laterTimes.length;
    }

    double firstTime() {
        return times[0];
    }

    int firstItem() {
        return items[0];
    }

    void add(double time, int item) {
        planned++;
        int at = (int) Math.min(time * perTime, spans - 1);
        if (at <= span) {
            addNow(time, item);
            return;
        }
        if (waiting == next.length) {
            compactWaiting();
        }
        await(at, time, item);
    }

    private void await(int at, double time, int item) {
        laterTimes[waiting] = time;
        laterItems[waiting] = item;
        next[waiting] = heads[at];
        heads[at] = ++waiting;
    }

    private void addNow(double time, int item) {
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

    /** Makes room in the heap. */
    private void compact() {
        int kept = keep(times, items, size);
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

    /** Makes room among those that wait. */
    private void compactWaiting() {
        int kept = keep(laterTimes, laterItems, waiting);
        if (2 * kept > next.length) {
            next = new int[2 * next.length];
            laterTimes = Arrays.copyOf(laterTimes, next.length);
            laterItems = Arrays.copyOf(laterItems, next.length);
        }
        Arrays.fill(heads, span, spans, NONE);
        waiting = 0;
        for (int k = 0; k < kept; k++) {
            setTime(laterItems[k], laterTimes[k]);
            int at = (int) Math.min(laterTimes[k] * perTime, spans - 1);
            if (at > span) { // else it is in the heap
                await(at, laterTimes[k], laterItems[k]);
            }
        }
    }

    /** Keeps the first of some events that count, and all but one of what was planned twice; how many. No item counts then. */
    private int keep(double[] when, int[] what, int count) {
        int kept = 0;
        for (int k = 0; k < count; k++) {
            if (counts(when[k], what[k])) {
                when[kept] = when[k];
                what[kept++] = what[k];
                setTime(what[k], Double.NaN); // another one does not count
            }
        }
        return kept;
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
