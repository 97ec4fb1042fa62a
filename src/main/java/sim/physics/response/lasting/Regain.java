// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;

/**
 * How fast a gap is regained by a velocity that holds for a time. Where that is a small part of the step a whole gap would need
 * forces without bounds, and its bodies would be thrown apart with them.
 */
final class Regain implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Part of a step in which a gap is regained at the soonest, by forces that are larger than those which act. */
    private static final double SLOW = 0.125;

    private double time;
    private double slow;
    private double fall;
    private double part;

    /** By point. */
    private double[] lacks = {};

    Regain() {
        // set for each solution
    }

    /**
     * Sets the time.
     *
     * @param length for which velocities hold
     * @param step of the engine
     * @param swift speed that is not too much in any case: what forces give in the time
     */
    void set(double length, double step, double swift) {
        time = length;
        slow = Math.max(length, SLOW * step);
        fall = swift;
        part = length / step;
    }

    double time() {
        return time;
    }

    /** The speed that regains a way. */
    double speed(double way) {
        return Math.min(way / time, Math.max(way / slow, fall));
    }

    /** Takes note of what is missing of a point's gap at the end of the time if its bodies neither part nor approach; negative if there is more. */
    void lack(int p, double way) {
        lacks = p < lacks.length ? lacks : Arrays.copyOf(lacks, 2 * p + 2);
        lacks[p] = way;
    }

    /** Raises the least velocities at the end to where points do not close on their ways, on which velocities change evenly. */
    void raise(HeapSystem s) {
        for (int p = 0; p < s.contacts(); p++) {
            s.bound(p, Math.max(s.bound(p), 2 * lacks[p] / time - s.normal(p)));
        }
    }

    /** What of a gap is kept for bent paths in the time, given what it is for a step: at a speed that does not depend on the time. */
    double sag(double ofStep) {
        return ofStep * part;
    }
}
