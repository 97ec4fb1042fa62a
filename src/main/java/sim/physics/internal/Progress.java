// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

/** Whether something that is to vanish still falls. */
public final class Progress {
    /** Part of the least value so far that is less. */
    private static final double LESS = 0.99;

    private final int patience;
    private double least = Double.POSITIVE_INFINITY;
    private int idle;

    /**
     * Makes one that knows no value yet.
     *
     * @param patience how many values may be no less than those before, one after the other
     */
    public Progress(int patience) {
        this.patience = patience;
    }

    /**
     * Takes note of a value.
     *
     * @param value not negative
     * @return whether it has ceased to fall
     */
    public boolean stalls(double value) {
        if (value < LESS * least) {
            least = value;
            idle = 0;
        } else {
            idle++;
        }
        return idle > patience;
    }
}
