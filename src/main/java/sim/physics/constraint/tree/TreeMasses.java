// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint.tree;

import sim.physics.motion.State;

/** The masses of the links of a {@link PinTree} as those of two points each, and what is left over. */
final class TreeMasses {
    /** The largest part of its mass that a link has at its far pin; and what counts as rounding of d. */
    private static final double FARTHEST = 4;

    private static final double ROUNDING = 0x1p-49;

    /** Ratio of masses up to which they are alike. */
    private static final double ALIKE = 100;

    private TreeMasses() {}

    /** Takes the masses over. */
    static void weigh(PinTree tree, double[] w) {
        double least = Double.POSITIVE_INFINITY;
        double most = 0;
        for (int k = tree.links - 1; k >= 0; k--) {
            double[] l = tree.link;
            int o = PinTree.STRIDE * k;
            double m = 1 / w[tree.block[k]];
            least = Math.min(least, m);
            most = Math.max(most, m);
            double ex = l[o + PinTree.EX];
            double ey = l[o + PinTree.EY];
            double dx = l[o + PinTree.DX];
            double dy = l[o + PinTree.DY];
            double far = (dx * ex + dy * ey) / (ex * ex + ey * ey);
            far = Math.abs(far) <= FARTHEST ? far : 0;
            double restX = dx - far * ex;
            double restY = dy - far * ey;
            boolean isAlong = Math.abs(restX) + Math.abs(restY) <= ROUNDING * (Math.abs(dx) + Math.abs(dy));
            l[o + PinTree.MASS] = m;
            l[o + PinTree.INERTIA] = 1 / w[tree.block[k] + State.THETA];
            l[o + PinTree.RESTX] = isAlong ? 0 : m * restX;
            l[o + PinTree.RESTY] = isAlong ? 0 : m * restY;
            l[o + PinTree.FAR] = m * far;
            l[o + PinTree.HUB] = l[o + PinTree.INERTIA] + m * (dx * dx + dy * dy) - m * far * (ex * ex + ey * ey);
            boolean goesOn = k + 1 < tree.links && tree.parent[k + 1] == k;
            int next = o + PinTree.STRIDE;
            l[o + PinTree.KNOT] = l[o + PinTree.FAR] + (goesOn ? l[next + PinTree.MASS] - l[next + PinTree.FAR] : 0);
            tree.isOdd[k] = !isAlong || tree.child[k] >= 0;
        }
        tree.isSpread = most > ALIKE * least;
    }
}
