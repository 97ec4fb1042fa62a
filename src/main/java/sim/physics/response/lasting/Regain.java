// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;

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

    /** What of a gap is kept for bent paths in the time, given what it is for a step: at a speed that does not depend on the time. */
    double sag(double ofStep) {
        return ofStep * part;
    }
}
