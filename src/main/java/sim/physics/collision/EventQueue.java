// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.io.Serializable;
import java.util.Arrays;

/**
 * What will happen in the present step, in time order: a binary heap of (offset, what). Equal offsets come in the order
 * of what they are, so that the order does not depend on the order of insertion.
 */
final class EventQueue implements Serializable {
    private static final long serialVersionUID = 1L;

    private double[] times = new double[16];
    private int[] items = new int[16];
    private int size;

    boolean isEmpty() {
        return size == 0;
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
            times = Arrays.copyOf(times, 2 * size);
            items = Arrays.copyOf(items, 2 * size);
        }
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
