// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

import sim.physics.internal.Tolerances;
import sim.physics.motion.Trajectories;

/**
 * How long two bodies that have just bounced off one another surely stay apart. Where they touched they are placed already,
 * so this takes no sine and no search.
 *
 * <p>The line on which they touched, fixed to the one that owns it and turning with it, has all of that one below it and the
 * other one's corner on it. The corner's height grows at a rate c₁ and its second derivative is at most M, so it stays above
 * the line for 2 c₁/M. It stays the lowest corner until the body has turned by as much as its edges there rise.
 */
final class Rebound {
    /** Part of the time that is made use of, so that rounding does not matter. */
    private static final double SHORT = 1 - 0x1p-20;

    private Rebound() {}

    /**
     * The time for which two bodies that move and spin uniformly stay apart.
     *
     * @param pose where both are placed, at the instant of their impact
     * @param features their closest features there
     * @param m the values of the bodies' trajectories, with the velocities after the impact
     * @param a where those of body A begin
     * @param b where those of body B begin
     * @return duration, 0 if it is not known, infinite if they never touch again
     */
    static double time(Pose pose, ClosestFeatures features, double[] m, int a, int b) {
        boolean onEdge = ((features.featureA | features.featureB) & 1) != 0;
        boolean ofB = (features.featureB & 1) != 0 || pose.a.n == 1;
        Pose.Placed owner = ofB ? pose.b : pose.a;
        Pose.Placed other = ofB ? pose.a : pose.b;
        if (!onEdge && other.n > 1 || isTurning(pose.a) || isTurning(pose.b)) {
            return 0;
        }
        int vertex = (ofB ? features.featureB : features.featureA) >> 1;
        int corner = (ofB ? features.featureA : features.featureB) >> 1;
        double nx = ofB ? -features.nx : features.nx;
        double ny = ofB ? -features.ny : features.ny;
        double x = other.vx[corner];
        double y = other.vy[corner];
        double gap = nx * (x - owner.vx[vertex]) + ny * (y - owner.vy[vertex]) - pose.rounding;
        double tolerance = Tolerances.GAP * pose.extent;
        int u = ofB ? a : b;
        int v = ofB ? b : a;
        double ux = m[u + Trajectories.VX] - m[v + Trajectories.VX];
        double uy = m[u + Trajectories.VY] - m[v + Trajectories.VY];
        double speed = Math.abs(ux) + Math.abs(uy);
        double spin = m[v + Trajectories.OMEGA];
        double otherSpin = m[u + Trajectories.OMEGA];
        double ownerX = ofB ? pose.px : 0;
        double ownerY = ofB ? pose.py : 0;
        double otherX = pose.px - ownerX;
        double otherY = pose.py - ownerY;
        double rise = nx * ux + ny * uy
                + spin * (nx * (y - ownerY) - ny * (x - ownerX))
                - otherSpin * (nx * (y - otherY) - ny * (x - otherX));
        double slowness = Tolerances.APPROACH * (speed + Math.abs(spin) * owner.core + Math.abs(otherSpin) * other.core);
        if (!(rise > slowness && Math.abs(gap) <= tolerance)) {
            return 0;
        }
        double relative = other.n > 1 ? Math.abs(otherSpin - spin) : 0;
        double reach = Math.max(Math.abs(pose.px) + Math.abs(pose.py), pose.bounding); // until the circles part
        double bend = Math.abs(spin) * (2 * speed + Math.abs(spin) * reach) + relative * relative * other.core;
        double time = 2 * rise / bend;
        if (relative > 0) {
            time = Math.min(time, slope(other, corner, nx, ny) / relative);
        }
        time *= SHORT;
        return hasLeft(pose, ofB ? -ux : ux, ofB ? -uy : uy, time, tolerance) ? Double.POSITIVE_INFINITY : time;
    }

    /** Whether it is a disc whose centre goes round with the body that it is a part of. */
    private static boolean isTurning(Pose.Placed part) {
        return part.n == 1 && !part.isRound();
    }

    /** How steeply the less steep one of a corner's edges rises along a direction: the sine of the angle. */
    private static double slope(Pose.Placed body, int corner, double nx, double ny) {
        int before = corner == 0 ? body.n - 1 : corner - 1;
        int after = corner + 1 == body.n ? 0 : corner + 1;
        double x = body.vx[corner];
        double y = body.vy[corner];
        double back = nx * (body.vx[before] - x) + ny * (body.vy[before] - y);
        double ahead = nx * (body.vx[after] - x) + ny * (body.vy[after] - y);
        return Math.max(0, Math.min(back / body.length(before), ahead / body.length(corner)));
    }

    /** Whether after a time the bounding circles are apart for good. */
    private static boolean hasLeft(Pose pose, double ux, double uy, double time, double tolerance) {
        if (time == Double.POSITIVE_INFINITY) {
            return true;
        }
        double x = pose.px + time * ux;
        double y = pose.py + time * uy;
        double reach = CentrePath.reach(pose.bounding, tolerance);
        return x * ux + y * uy > 0 && x * x + y * y > reach * reach;
    }
}
