// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

import java.io.Serializable;
import java.util.Arrays;

/**
 * When velocities of bodies changed last, counted in solutions. Of what hangs together and is solved in turn, most is settled long before all is: what has
 * been solved since both its bodies got their velocities is left alone.
 */
public final class Freshness implements Serializable {
    private static final long serialVersionUID = 1L;

    /** A body that cannot move. */
    public static final int FIXED = -1;

    /** By body: when its velocity changed last. */
    private long[] changed = {};

    private long now;
    private long begun;

    /** Makes one of no body. */
    public Freshness() {
        // they are counted
    }

    /**
     * Begins anew: nothing has been solved.
     *
     * @param bodies their number
     */
    public void begin(int bodies) {
        if (changed.length < bodies) {
            changed = Arrays.copyOf(changed, Growth.length(changed.length, bodies));
        }
        begun = ++now;
    }

    /**
     * Whether a row is to be solved.
     *
     * @param solved when it was solved last, 0 for never
     * @param first a body, or {@link #FIXED}
     * @param second the other one, or {@link #FIXED}
     * @return whether one of them has got another velocity since then
     */
    public boolean isStale(long solved, int first, int second) {
        return solved < begun || first >= 0 && solved < changed[first] || second >= 0 && solved < changed[second];
    }

    /**
     * A row has been solved.
     *
     * @param first a body, or {@link #FIXED}
     * @param second the other one, or {@link #FIXED}
     * @param changes whether it gave them another velocity
     * @param isBeyond whether it gave them more than it asks for, so that it is to be solved once more by itself
     * @return when that was
     */
    public long solve(int first, int second, boolean changes, boolean isBeyond) {
        long solved = changes && isBeyond ? now : now + 1;
        now++;
        if (changes && first >= 0) {
            changed[first] = now;
        }
        if (changes && second >= 0) {
            changed[second] = now;
        }
        return solved;
    }
}
