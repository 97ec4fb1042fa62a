// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

import sim.physics.motion.Trajectories;

/** Derivatives of a body's centre in the frame of another body, which turns; both move and spin uniformly. */
final class CentrePath {
    /** By how much larger than they are circles are taken where they are to be apart, relative to them. */
    private static final double MARGIN = 1e-6;

    /** First derivative. */
    double q1x;

    double q1y;

    /** Second derivative. */
    double q2x;

    double q2y;

    /** Third derivative. */
    double q3x;

    double q3y;

    /** Whether two bodies fall alike and spin uniformly, in a scene in which some have been accelerated. */
    static boolean isStraight(Trajectories trajectories, int i, int j) {
        double[] bends = trajectories.bends();
        int a = i * Trajectories.STRIDE;
        int b = j * Trajectories.STRIDE;
        return bends[a + Trajectories.AX] == bends[b + Trajectories.AX]
                && bends[a + Trajectories.AY] == bends[b + Trajectories.AY]
                && trajectories.isParabola(i)
                && trajectories.isParabola(j);
    }

    /** Whether they do so and no integrator drives them: their paths hold beyond the step. */
    static boolean areFree(Trajectories trajectories, int i, int j) {
        return !trajectories.isDriven(i) && !trajectories.isDriven(j) && isStraight(trajectories, i, j);
    }

    /** The sum of the radii of two circles that is to be taken where they are to be apart, for all rounding. */
    static double reach(double radii, double tolerance) {
        return radii + (MARGIN * radii + 4 * tolerance);
    }

    /** The time after which two circles that are not apart yet, and move uniformly, are apart for good. */
    static double timeToPart(double px, double py, double ux, double uy, double reach) {
        double approach = px * ux + py * uy;
        double square = ux * ux + uy * uy;
        double d = approach * approach - square * (px * px + py * py - reach * reach);
        return d > 0 && square > 0 ? (Math.sqrt(d) - approach) / square : Double.POSITIVE_INFINITY;
    }

    /**
     * Sets them.
     *
     * @param qx centre in that frame
     * @param qy centre in that frame
     * @param wx its velocity, in the direction of the frame's axes
     * @param wy its velocity
     * @param spin angular velocity of the frame
     */
    void expand(double qx, double qy, double wx, double wy, double spin) {
        double spin2 = spin * spin;
        q1x = wx + spin * qy;
        q1y = wy - spin * qx;
        q2x = 2 * spin * wy - spin2 * qx;
        q2y = -2 * spin * wx - spin2 * qy;
        q3x = -spin2 * (3 * wx + spin * qy);
        q3y = -spin2 * (3 * wy - spin * qx);
    }
}
