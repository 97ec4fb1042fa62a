// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint.tree;

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

    /** Whether a tree is a chain that hangs, of links of like masses that are as good as points at their pins and moments of inertia. */
    static boolean areSuited(PinTree tree) {
        boolean yes = !tree.isFree && tree.runCount == 1 && !tree.isSpread;
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
     * @param calm gets those that only the end of a step wants
     * @param tree the tree
     * @return false if they differ so much that numbers would become too large
     */
    static boolean weigh(double[] l, double[] calm, PinTree tree) {
        double first = first(tree);
        double sigma = first;
        double before = 0; // 1/μ of the near knot
        boolean isEven = true;
        for (int k = 0; k < tree.links; k++) {
            int o = HungChain.STRIDE * k;
            int q = HungChain.CALM * k;
            int t = PinTree.STRIDE * k;
            l[o + HungChain.QUARTERS] = aim(calm, q, tree.link[t + PinTree.EX], tree.link[t + PinTree.EY]);
            double length = calm[q + HungChain.LENGTH];
            double mass = tree.link[t + PinTree.MASS];
            double mu = tree.link[t + PinTree.KNOT];
            calm[q + HungChain.MASS] = mass;
            calm[q + HungChain.INERTIA] = tree.link[t + PinTree.INERTIA];
            calm[q + HungChain.REACH] = tree.link[t + PinTree.FAR] / mass * length;
            double per = sigma / tree.link[t + PinTree.HUB];
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

    /** Along an axis of the link there is no rest, and mirror images have mirrored bits; returns the quarter turns. */
    private static double aim(double[] calm, int q, double ex, double ey) {
        boolean isSteep = Math.abs(ey) > Math.abs(ex);
        double along = isSteep ? ey : ex;
        double across = isSteep ? -ex : ey;
        double length = Math.copySign(Math.sqrt(ex * ex + ey * ey), along);
        calm[q + HungChain.LENGTH] = length;
        calm[q + HungChain.REST] = Trig.atan2(Math.copySign(1, along) * across, Math.abs(along));
        calm[q + HungChain.REST_COS] = along / length;
        calm[q + HungChain.REST_SIN] = across / length;
        return SineTable.quarters(isSteep ? 1 : 0);
    }

    /**
     * How far the centres of mass are to the left of n, by the rounding of how the chain was built: it matters to where they are only.
     *
     * @param tree the tree
     * @param calm the values of its links
     * @return by link; null if none is
     */
    static double[] asides(PinTree tree, double[] calm) {
        double[] asides = null;
        for (int k = 0; k < tree.links; k++) {
            double length = calm[HungChain.CALM * k + HungChain.LENGTH];
            double aside = tree.isOdd[k] ? Math.copySign(1, length) * aside(tree.link, PinTree.STRIDE * k) : 0;
            asides = asides == null && aside != 0 ? new double[tree.links] : asides;
            if (aside != 0) {
                asides[k] = aside;
            }
        }
        return asides;
    }
}
