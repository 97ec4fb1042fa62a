// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;

/** What was seen at some instant of ties that may begin to act: by tie a value that turns negative then, and how fast it changes. */
public final class Watched implements Serializable {
    private static final long serialVersionUID = 1L;

    double[] values = {};
    double[] rates = {};
    int size;

    Watched() {
        // grows with the ties
    }

    /** Forgets all. */
    public void clear() {
        size = 0;
    }

    /**
     * Takes what was seen of the next tie.
     *
     * @param value NaN if it is not watched
     * @param rate NaN if that is not known
     */
    public void take(double value, double rate) {
        if (size == values.length) {
            values = Arrays.copyOf(values, 2 * size + 8);
            rates = Arrays.copyOf(rates, values.length);
        }
        values[size] = value;
        rates[size] = rate;
        size++;
    }
}
