// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

/**
 * A line that touches a disc and turns evenly, as fast as the one from its centre to the closest corner or centre of another
 * body does now: as long as all of that is beyond it the two do not touch. A line that is held still is left soon by a disc
 * that slides round a corner, or rolls on another disc.
 */
final class TurningLine {
    private TurningLine() {}

    /**
     * A time for which the bodies surely do not touch, at least that which is known.
     *
     * @param pose of the bodies, of which two vertices are closest
     * @param features which these are
     * @param known such a time
     * @param horizon beyond which none is of use
     */
    static double time(Pose pose, ClosestFeatures features, double known, double horizon) {
        boolean isFirst = isDisc(pose.a);
        if (!pose.isQuadratic() || !isFirst && !isDisc(pose.b) || !(features.gap > 0)) {
            return known;
        }
        Pose.Placed disc = isFirst ? pose.a : pose.b;
        Pose.Placed other = isFirst ? pose.b : pose.a;
        int side = isFirst ? 1 : -1;
        double ex = side * features.nx;
        double ey = side * features.ny;
        int closest = isFirst ? features.featureB >> 1 : features.featureA >> 1;
        double spin = spin(pose, other, closest, side, ex, ey) / (features.gap + pose.rounding);
        double square = spin * spin;
        double cube = square * Math.abs(spin);
        double relative = other.omega - spin;
        double most = other.maxOmega + Math.abs(spin);
        double twist = Math.abs(other.alpha);
        double speed = Math.sqrt(pose.ux * pose.ux + pose.uy * pose.uy) + pose.maxAcceleration * horizon;
        double reach = Math.sqrt(pose.px * pose.px + pose.py * pose.py) + speed * horizon;
        double bound = pose.maxAcceleration + (most * most + twist) * other.core + 2 * Math.abs(spin) * speed + square * reach;
        double third = most * (3 * twist + most * most) * other.core
                + 3 * Math.abs(spin) * pose.maxAcceleration + 3 * square * speed + cube * reach;
        double fourth = GapBound.fourthOfTurn(most, twist) * other.core
                + 6 * square * pose.maxAcceleration + 4 * cube * speed + square * square * reach;
        double pull = side * (pose.ax * ex + pose.ay * ey) + 2 * spin * side * (pose.uy * ex - pose.ux * ey);
        double ofCentres = side * (3 * spin * (pose.ay * ex - pose.ax * ey)
                - spin * square * (pose.py * ex - pose.px * ey)
                - 3 * square * (pose.ux * ex + pose.uy * ey));
        double time = horizon;
        for (int k = 0; k < other.n && time > known; k++) {
            double qx = other.vx[k] - disc.cx;
            double qy = other.vy[k] - disc.cy;
            double rx = other.vx[k] - other.cx;
            double ry = other.vy[k] - other.cy;
            double gap = qx * ex + qy * ey - pose.rounding;
            double wx = side * pose.ux - other.omega * ry + spin * qy;
            double wy = side * pose.uy + other.omega * rx - spin * qx;
            double rate = wx * ex + wy * ey;
            double along = rx * ex + ry * ey;
            double across = rx * ey - ry * ex;
            double curvature = pull + other.alpha * across - relative * relative * along - square * ((qx - rx) * ex + (qy - ry) * ey);
            double jerk = ofCentres - 3 * relative * other.alpha * along - relative * relative * relative * across;
            double first = gap > 0 ? GapBound.root(gap, rate, bound) : 0;
            time = Math.min(time, GapBound.ahead(gap, rate, curvature, third, jerk, fourth, first, time));
        }
        return Math.max(known, time);
    }

    /** Whether a body is a disc about its own centre. */
    private static boolean isDisc(Pose.Placed body) {
        return body.n == 1 && body.core == 0;
    }

    /** How fast a vertex goes across a direction, as seen from the other body's centre. */
    private static double spin(Pose pose, Pose.Placed other, int k, int side, double ex, double ey) {
        double wx = side * pose.ux - other.omega * (other.vy[k] - other.cy);
        double wy = side * pose.uy + other.omega * (other.vx[k] - other.cx);
        return wy * ex - wx * ey;
    }
}
