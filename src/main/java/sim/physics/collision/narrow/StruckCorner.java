// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

import sim.physics.internal.Tolerances;

/**
 * Where a body strikes an edge that two of its corners have reached: the deepest one may be on its way out while the other one comes in, and
 * an impulse at the deepest one would pull it back.
 */
final class StruckCorner {
    private StruckCorner() {}

    /**
     * The corner that strikes an edge.
     *
     * @param owner the body of the edge
     * @param other the body of the corners
     * @param deepest the deepest one, over the edge
     * @param side +1 if the other body is B, −1 if it is A
     * @return the deepest one if it does not leave, else the one behind the edge's line that goes deeper fastest, or a neighbour of the deepest
     *     one beyond the edge's end, if it is the stretch between these that does so there; the deepest one if there is none
     */
    static int of(Pose pose, Pose.Placed owner, int edge, Pose.Placed other, int deepest, int side) {
        double leaving = other.n == 1 ? 0 : rate(pose, owner, edge, other, deepest, side);
        if (leaving <= 0) {
            return deepest;
        }
        int corner = deepest;
        double least = 0;
        double at = owner.along(edge, other, deepest);
        for (int k = 0; k < other.n; k++) {
            double along = owner.along(edge, other, k);
            double end = Math.max(0, Math.min(owner.length(edge), along));
            double rate = k == deepest ? 0 : leaving + (end - at) / (along - at) * (rate(pose, owner, edge, other, k, side) - leaving);
            boolean isThere = end == along || areNeighbours(other, deepest, k);
            if (isThere && rate < least && owner.height(edge, other, k) - pose.rounding <= Tolerances.GAP * pose.extent) {
                corner = k;
                least = rate;
            }
        }
        return corner;
    }

    private static boolean areNeighbours(Pose.Placed body, int first, int second) {
        return second == (first + 1) % body.n || first == (second + 1) % body.n;
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
