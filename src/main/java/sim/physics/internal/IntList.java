// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

import java.io.Serializable;
import java.util.Arrays;

/** A growable list of ints whose array the kernels may read. */
public final class IntList implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int[] NONE = {};

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
     * Puts a value into an ascending list, if it is not there.
     *
     * @param value any
     */
    public void include(int value) {
        int k = place(value);
        if (k < size && values[k] == value) {
            return;
        }
        add(value);
        System.arraycopy(values, k, values, k + 1, size - 1 - k);
        values[k] = value;
    }

    /**
     * Takes a value out of an ascending list, if it is there.
     *
     * @param value any
     */
    public void exclude(int value) {
        int k = place(value);
        if (k < size && values[k] == value) {
            System.arraycopy(values, k + 1, values, k, size - 1 - k);
            size--;
        }
    }

    /** Where the first value is that is not less, looked for from the end. */
    private int place(int value) {
        int k = size;
        while (k > 0 && values[k - 1] >= value) {
            k--;
        }
        return k;
    }

    /** Removes all values and keeps the array. */
    public void clear() {
        size = 0;
    }
}
