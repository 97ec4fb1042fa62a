// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

import java.io.Serializable;
import java.util.Arrays;

/** A growable list of ints whose array the kernels may read. */
public final class IntList implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int[] NONE = {};

    /** Length up to which insertion sort is faster. */
    private static final int SHORT = 40;

    /** The values, {@link #size} of them. */
    public int[] values = NONE;
    /** How many there are. */
    public int size;

    /** Makes an empty list. */
    public IntList() {
        // room comes with the first value
    }

    /**
     * Appends a value.
     *
     * @param value any
     */
    public void add(int value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, Math.max(4, 2 * size));
        }
        values[size++] = value;
    }

    /**
     * Replaces all values by one.
     *
     * @param value the one
     * @return this list
     */
    public IntList only(int value) {
        size = 0;
        add(value);
        return this;
    }

    /**
     * Whether the values of a list in ascending order follow one another without a gap, so that loops need not look them up.
     *
     * @return true for one value, false for none
     */
    public boolean isRow() {
        return size > 0 && values[size - 1] - values[0] == size - 1;
    }

    /**
     * How many values of another list this one goes on with; both are in ascending order.
     *
     * @param from index of the first
     * @param other its values are looked for from its first on
     * @return number of values that are the same
     */
    public int common(int from, IntList other) {
        int most = Math.min(size - from, other.size);
        if (most > 0 && other.isRow() && values[from] == other.values[0] && values[from + most - 1] == other.values[most - 1]) {
            return most; // both ascend, so there is no room for others between
        }
        int k = 0;
        while (k < most && values[from + k] == other.values[k]) {
            k++;
        }
        return k;
    }

    /** Puts the values in ascending order, without making any object. */
    public void sort() {
        sort(values, 0, size);
    }

    /**
     * Puts a range of an array in ascending order, without making any object: that of the JDK makes one each time that it parts a
     * range, from JDK 22 on. Quicksort with the median of three (Hoare 1962), insertion sort of what is short.
     *
     * @param values any
     * @param from index of the first
     * @param to index behind the last
     */
    public static void sort(int[] values, int from, int to) {
        int length = to - from;
        sort(values, from, to, 2 * (Integer.SIZE - Integer.numberOfLeadingZeros(length)));
    }

    private static void sort(int[] values, int from, int to, int depth) {
        int low = from;
        int high = to;
        int left = depth;
        while (high - low > SHORT) {
            if (left-- == 0) { // it was made to be parted badly
                Arrays.sort(values, low, high);
                return;
            }
            int middle = part(values, low, high);
            if (middle - low < high - middle) {
                sort(values, low, middle, left);
                low = middle;
            } else {
                sort(values, middle, high, left);
                high = middle;
            }
        }
        insert(values, low, high);
    }

    /** Brings what is not more than a value before what is not less; returns where the latter begins, which is within. */
    private static int part(int[] values, int low, int high) {
        int quarter = high - low >> 2;
        int pivot = median(values[low + quarter], values[low + 2 * quarter], values[low + 3 * quarter]);
        int i = low - 1;
        int k = high;
        while (true) {
            do {
                i++;
            } while (values[i] < pivot);
            do {
                k--;
            } while (values[k] > pivot);
            if (i >= k) {
                return k + 1;
            }
            int value = values[i];
            values[i] = values[k];
            values[k] = value;
        }
    }

    private static int median(int a, int b, int c) {
        return Math.max(Math.min(a, b), Math.min(Math.max(a, b), c));
    }

    private static void insert(int[] values, int low, int high) {
        for (int i = low + 1; i < high; i++) {
            int value = values[i];
            int k = i - 1;
            while (k >= low && values[k] > value) {
                values[k + 1] = values[k];
                k--;
            }
            values[k + 1] = value;
        }
    }

    /**
     * Whether a value is in the list.
     *
     * @param value any
     * @return found by a look at all
     */
    public boolean contains(int value) {
        for (int k = 0; k < size; k++) {
            if (values[k] == value) {
                return true;
            }
        }
        return false;
    }

    /** Removes all values and keeps the array. */
    public void clear() {
        size = 0;
    }

    /**
     * Puts a value into a list in ascending order.
     *
     * @param value one that is not there
     */
    public void insert(int value) {
        int k = place(value);
        add(value);
        System.arraycopy(values, k, values, k + 1, size - 1 - k);
        values[k] = value;
    }

    /**
     * Takes a value out of a list in ascending order.
     *
     * @param value one that is there
     */
    public void takeOut(int value) {
        int k = place(value);
        System.arraycopy(values, k + 1, values, k, size - 1 - k);
        size--;
    }

    private int place(int value) {
        if (size == 0 || values[size - 1] < value) {
            return size; // mostly
        }
        int k = Arrays.binarySearch(values, 0, size, value);
        return k < 0 ? -1 - k : k;
    }
}
