// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.narrow.Manifold;

/**
 * Gaps as they really are when bodies have gone straight on and have turned evenly with velocities that were found for them, and what these lack
 * then: the iteration of SHAKE (Ryckaert, Ciccotti, Berendsen 1977), for contacts that may open.
 */
final class StraightGaps implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Part of what is missing that is made up for: with others' velocities points turn a little farther. */
    private static final double MORE = 1.25;

    private final HeapSystem system;
    private final TurnedPoint point = new TurnedPoint();

    /** By point: how deep it may be; NaN where it is deeper already. */
    private double[] depths = {};

    StraightGaps(HeapSystem system) {
        this.system = system;
    }

    /** Takes in a point where it is now. */
    void set(int p, Manifold m, int k, double depth) {
        depths = depths.length <= p ? Arrays.copyOf(depths, 2 * p + 2) : depths;
        depths[p] = m.gaps[k] < -depth ? Double.NaN : depth;
        point.set(p, m, k);
    }

    /**
     * Raises the least velocities of points that would be too deep in the middle of a time or at its end, with the velocities of the system.
     *
     * @return false if none would
     */
    boolean lift(double time) {
        boolean lifts = false;
        for (int p = 0; p < system.contacts(); p++) {
            double deepest = Math.min(gap(p, time), 2 * gap(p, 0.5 * time));
            if (deepest < -depths[p]) {
                system.bound(p, Math.max(system.bound(p), system.normal(p) + (depths[p] - MORE * deepest) / time));
                lifts = true;
            }
        }
        return lifts;
    }

    private double gap(int p, double time) {
        int a = system.rows().body(p, 0);
        int b = system.rows().body(p, 1);
        point.look(p, way(b, 0, time) - way(a, 0, time), way(b, 1, time) - way(a, 1, time), way(a, 2, time), way(b, 2, time));
        return point.gap;
    }

    private double way(int body, int c, double time) {
        return body < 0 ? 0 : system.v[3 * body + c] * time;
    }
}
