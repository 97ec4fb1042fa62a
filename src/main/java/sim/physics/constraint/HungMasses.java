// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import sim.physics.internal.SineTable;
import sim.physics.internal.Trig;

/** The links of a {@link HungChain} as its equations want them: their masses in units of σ, and their directions n. */
final class HungMasses {
    /** J and the masses of the points, in units of m L² and m: less would be too little to divide by. */
    private static final double LEAST = 1.0 / 64;

    /**
     * How far a centre of mass may be beside the line between its pins, in parts of the largest coordinate in reach: a chain is
     * built in the world, and its arms are found from there, so they cannot be better known.
     */
    private static final double BUILT = 0x1p-50;

    /** By how much σ may change along the chain. */
    private static final double WIDEST = 0x1p64;

    private HungMasses() {}

    /** Whether a tree is a chain that hangs, of links that are as good as points at their pins and moments of inertia. */
    static boolean areSuited(PinTree tree) {
        boolean yes = !tree.isFree && tree.runCount == 1;
        double built = yes ? BUILT * reach(tree) : 0;
        for (int k = 0; yes && k < tree.links; k++) {
            int o = PinTree.STRIDE * k;
            double[] l = tree.link;
            double square = l[o + PinTree.EX] * l[o + PinTree.EX] + l[o + PinTree.EY] * l[o + PinTree.EY];
            double least = LEAST * l[o + PinTree.MASS];
            yes = (!tree.isOdd[k] || Math.abs(aside(l, o)) <= built)
                    && l[o + PinTree.FAR] >= least
                    && l[o + PinTree.FAR] <= l[o + PinTree.MASS]
                    && Math.abs(l[o + PinTree.HUB]) >= least * square;
        }
        return yes;
    }

    /** The largest coordinate that a chain can come to. */
    private static double reach(PinTree tree) {
        double reach = Math.abs(tree.places.hangsAtX()) + Math.abs(tree.places.hangsAtY());
        for (int o = 0; o < tree.link.length; o += PinTree.STRIDE) {
            reach += Math.abs(tree.link[o + PinTree.EX]) + Math.abs(tree.link[o + PinTree.EY]);
        }
        return reach;
    }

    /** How far a centre of mass is beside the line from pin to pin, to the left of e. */
    private static double aside(double[] l, int o) {
        double ex = l[o + PinTree.EX];
        double ey = l[o + PinTree.EY];
        return (ex * l[o + PinTree.DY] - ey * l[o + PinTree.DX]) / Math.sqrt(ex * ex + ey * ey);
    }

    /** σ of the first link. */
    static double first(PinTree tree) {
        return Math.sqrt(tree.link[PinTree.KNOT]);
    }

    /**
     * Takes the masses over.
     *
     * @param l gets the values of the links
     * @param tree the tree
     * @return false if they differ so much that numbers would become too large
     */
    static boolean weigh(double[] l, PinTree tree) {
        double first = first(tree);
        double sigma = first;
        double before = 0; // 1/μ of the near knot
        boolean isEven = true;
        for (int k = 0; k < tree.links; k++) {
            int o = HungChain.STRIDE * k;
            int t = PinTree.STRIDE * k;
            aim(l, o, tree.link[t + PinTree.EX], tree.link[t + PinTree.EY]);
            double length = l[o + HungChain.LENGTH];
            l[o + HungChain.ASIDE] = tree.isOdd[k] ? Math.copySign(1, length) * aside(tree.link, t) : 0;
            double mass = tree.link[t + PinTree.MASS];
            double mu = tree.link[t + PinTree.KNOT];
            double per = sigma / tree.link[t + PinTree.HUB];
            l[o + HungChain.MASS] = mass;
            l[o + HungChain.INERTIA] = tree.link[t + PinTree.INERTIA];
            l[o + HungChain.REACH] = tree.link[t + PinTree.FAR] / mass * length;
            l[o + HungChain.TAU] = sigma * sigma * (before + 1 / mu);
            l[o + HungChain.IOTA] = sigma * length * length * per;
            l[o + HungChain.ALL] = l[o + HungChain.TAU] + l[o + HungChain.IOTA];
            l[o + HungChain.FULL] = l[o + HungChain.TAU] * l[o + HungChain.ALL];
            l[o + HungChain.SWING] = sigma * length;
            l[o + HungChain.LEVER] = length * per;
            before = 1 / mu;
            sigma = mu / sigma;
            isEven &= sigma >= first / WIDEST && sigma <= first * WIDEST;
        }
        return isEven;
    }

    /** Along an axis of the link there is no rest, and mirror images have mirrored bits. */
    private static void aim(double[] l, int o, double ex, double ey) {
        boolean isSteep = Math.abs(ey) > Math.abs(ex);
        double along = isSteep ? ey : ex;
        double across = isSteep ? -ex : ey;
        double length = Math.copySign(Math.sqrt(ex * ex + ey * ey), along);
        l[o + HungChain.LENGTH] = length;
        l[o + HungChain.QUARTERS] = SineTable.quarters(isSteep ? 1 : 0);
        l[o + HungChain.REST] = Trig.atan2(Math.copySign(1, along) * across, Math.abs(along));
        l[o + HungChain.REST_COS] = along / length;
        l[o + HungChain.REST_SIN] = across / length;
    }
}
