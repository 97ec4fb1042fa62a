// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import sim.physics.collision.narrow.Manifold;

/**
 * How a gap bends while its bodies go straight on and turn evenly. A corner on an edge that turns, a disc on a disc: which way and how much is
 * known to second order in the time, and what opens by itself need not be lifted.
 */
final class GapBend {
    private GapBend() {}

    /**
     * The second derivative of a point's gap by time.
     *
     * @return NaN where a corner meets a corner, and nothing says how their normal turns
     */
    static double curvature(Manifold m, int k, ContactPoint point) {
        double awayA = point.omegaA * point.omegaA * (m.roundA ? 0 : point.armA - m.radiusA); // of a corner, or the centre of a disc
        double awayB = point.omegaB * point.omegaB * (m.roundB ? 0 : point.armB + m.radiusB);
        double slide = point.slip + point.omegaA * m.radiusA + point.omegaB * m.radiusB;
        int owner = m.count == 2 && m.isEnd[k] ? 1 - m.owner : m.owner;
        if (owner < 0) {
            double apart = m.radiusA + m.radiusB;
            return apart > 0 ? awayA - awayB + slide * slide / apart : Double.NaN;
        }
        double turn = owner == 0 ? point.omegaA : point.omegaB; // the normal turns with the edge
        return awayA - awayB + turn * (2 * slide - turn * (owner == 0 ? m.radiusB : m.radiusA));
    }

    /** By how much a gap bends in a time; 0 where that is not known. */
    static double most(Manifold m, int k, ContactPoint point, double time) {
        double bend = 0.5 * Math.abs(curvature(m, k, point)) * time * time;
        return bend > 0 ? bend : 0;
    }

    /**
     * What a gap must have in reserve at the start of a time for its bends, for its velocity to be found as if there were none. A gap that opens by
     * itself is led to where it is least in the middle of a time, which then is so in each of them; none closes on its way there.
     *
     * @param curvature of the gap
     * @param gap beyond that which is kept
     * @param time for which the velocity holds
     * @return less than 0 where the gap may close faster than it would have to without bends
     */
    static double reserve(double curvature, double gap, double time) {
        double bend = 0.5 * curvature * time * time;
        if (bend <= 0) {
            return -bend;
        }
        double open = Math.min(bend, Math.max(0, gap));
        return Math.max(open - 2 * Math.sqrt(bend * open), -0.75 * bend);
    }
}
