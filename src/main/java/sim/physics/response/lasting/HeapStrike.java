// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;

/** What happens at once in a {@link HeapSystem}, before forces act: the approach of points that close too fast ends. */
final class HeapStrike implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Part of the energy that a strike may add to it, where points have to part. */
    private static final double GAIN = 1e-3;

    /** Least normal velocities, while others are in their place. */
    private double[] kept = {};

    HeapStrike() {
        // grows with the heaps
    }

    /** Whether a point closes faster than it may. */
    static boolean isDue(HeapSystem s, double speed) {
        for (int p = 0; p < s.size(); p++) {
            if (!s.isMotor(p) && s.normal(p) < Math.min(0, s.bound(p)) - speed) {
                return true;
            }
        }
        return false;
    }

    /**
     * Ends the approach of points that close faster than they may.
     *
     * @param rebounds by points behind the contacts: speeds with which they are to part then
     * @param lift part that points which have to part get of the speed for that
     */
    void strike(HeapSystem s, double scale, double[] rebounds, double lift) {
        if (kept.length < s.size()) {
            kept = new double[2 * s.size()];
        }
        for (int p = 0; p < s.size(); p++) {
            kept[p] = s.bound(p);
            double least = kept[p] > 0 && !s.isMotor(p) ? lift * kept[p] : Math.min(0, kept[p]);
            s.bound(p, p < s.contacts() ? least : Math.max(least, rebounds[p - s.contacts()]));
        }
        boolean right = s.solve(scale, true);
        if (!right || !(HeapEnergy.gained(s, s.free()) <= GAIN * HeapEnergy.of(s, s.free()))) {
            s.solveSoftly(scale);
        }
        for (int p = 0; p < s.size(); p++) {
            s.bound(p, kept[p]);
        }
    }
}
