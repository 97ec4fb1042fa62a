// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

import sim.physics.internal.Tolerances;

/**
 * Where a body that is in another one goes deeper: the deepest of its corners may be on its way out while another one comes in, and an
 * impulse at the deepest one would pull it back.
 */
final class DeepCorner {
    private DeepCorner() {}

    /**
     * The corner behind an edge that is struck.
     *
     * @param owner the body of the edge
     * @param other the body of the corners
     * @param deepest the deepest one
     * @param side +1 if the other body is B, −1 if it is A
     * @return the deepest one if it does not leave, else the one behind the edge that goes deeper fastest; the deepest one if none does
     */
    static int of(Pose pose, Pose.Placed owner, int edge, Pose.Placed other, int deepest, int side) {
        if (rate(pose, owner, edge, other, deepest, side) <= 0) {
            return deepest;
        }
        int corner = deepest;
        double least = 0;
        for (int k = 0; k < other.n; k++) {
            double rate = rate(pose, owner, edge, other, k, side);
            if (rate < least && isBehind(pose, owner, edge, other, k)) {
                corner = k;
                least = rate;
            }
        }
        return corner;
    }

    private static boolean isBehind(Pose pose, Pose.Placed owner, int edge, Pose.Placed other, int corner) {
        double x = other.vx[corner] - owner.vx[edge];
        double y = other.vy[corner] - owner.vy[edge];
        double along = y * owner.normalX(edge) - x * owner.normalY(edge);
        double height = x * owner.normalX(edge) + y * owner.normalY(edge) - pose.rounding;
        return along >= 0 && along <= owner.length(edge) && height <= Tolerances.GAP * pose.extent;
    }

    /** How fast a corner rises over an edge that turns with its body. */
    private static double rate(Pose pose, Pose.Placed owner, int edge, Pose.Placed other, int corner, int side) {
        double x = other.vx[corner];
        double y = other.vy[corner];
        double wx = side * pose.ux - other.omega * (y - other.cy) + owner.omega * (y - owner.cy);
        double wy = side * pose.uy + other.omega * (x - other.cx) - owner.omega * (x - owner.cx);
        return wx * owner.normalX(edge) + wy * owner.normalY(edge);
    }
}
