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

    /** Part of a time in which no gap is made up for. */
    private static final double SOON = 0.05;

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
     * Raises the least velocities of points that would be too deep on the way or at the end of a time, with the velocities of the system.
     *
     * @return false if none would
     */
    boolean lift(double time) {
        boolean lifts = false;
        for (int p = 0; p < system.contacts(); p++) {
            double raise = Double.isNaN(depths[p]) ? 0 : raise(p, time) / time;
            if (raise > 0) {
                system.bound(p, Math.max(system.bound(p), system.normal(p) + raise));
                lifts = true;
            }
        }
        return lifts;
    }

    /** By how much higher a point is to be at the end of a time, to be nowhere too deep in it. */
    private double raise(int p, double time) {
        double end = gap(p, time);
        double when = least(gap(p, 0), gap(p, 0.5 * time), end);
        return Math.max(missing(p, end), missing(p, when < 1 ? gap(p, when * time) : end) / when);
    }

    /** By how much a point is to be higher that would be at a gap; 0 if it may be there. */
    private double missing(int p, double gap) {
        return gap < -depths[p] ? depths[p] - MORE * gap : 0;
    }

    /** The part of a time after which a gap is least, by a parabola. */
    private static double least(double start, double middle, double end) {
        double bend = start - 2 * middle + end;
        double least = bend > 0 ? (3 * start - 4 * middle + end) / (4 * bend) : 1;
        return Math.max(SOON, Math.min(1, least));
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
