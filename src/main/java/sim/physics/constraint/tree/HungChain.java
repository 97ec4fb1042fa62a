// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint.tree;

import java.io.Serializable;
import sim.physics.internal.SineTable;
import sim.physics.motion.State;

/**
 * A {@link PinTree} that is a chain hung in the world, under a uniform field: RK4 on its angles with half the operations.
 *
 * <p>Where a link's centre of mass is on the line between its pins, the link is as good as two points at the pins, and a
 * moment of inertia J that is left and may be negative. So the chain is knots of mass μ, joined by links without a mass. Link
 * k, of length L and direction n, pulls its knots with forces ± G, which turn it, J α = L n⊥·G. With the accelerations of
 * the knots, μ A = G_k − G_{k−1}, what its ends have to do is
 *
 * <pre>
 *   ((1/μ_k + 1/μ_{k+1}) I + L²/J n⊥ n⊥ᵀ) G_k − G_{k−1} / μ_k − G_{k+1} / μ_{k+1} = ω² L n
 * </pre>
 *
 * <p>The knot that hangs has no 1/μ, and the acceleration −g takes its place. In units σ of G with σ_k σ_{k+1} = μ_{k+1}
 * the blocks beside the diagonal are −I. Those of the diagonal are eliminated with one division each: from both ends to the
 * middle at the same time, with less waiting ({@link HungHalves}), or, where a chain is too long for the fast memory of a
 * processor, on the way on which the accelerations of the stage before are found ({@link HungSweep}).
 */
final class HungChain implements Serializable {
    private static final long serialVersionUID = 1L;

    /** What a field does to links far away fades from link to link; below this part of it numbers would soon be denormal. */
    private static final double NOTHING = 0x1p-200;

    /** Links from which on it can fade so far. */
    static final int FADING = 256;

    /** Bits that the place of every 32nd link lacks: so many links lie between two looks at what has faded. */
    static final int SELDOM = 0xf8;

    /** Links from which on memory is what they wait for. */
    private static final int MANY = 5000;

    /** Links that end a step together: so many are at hand still when they are placed. */
    private static final int PORTION = 64;

    /** The largest turn of a link that is followed at once. */
    private static final double HALF_TURN = Math.PI;

    /** Values of a link that every stage wants: together, since there are more of them than a processor has registers for arrays. */
    static final int STRIDE = 24;

    /** At a stage: n and the angular velocity. */
    static final int COS = 0;

    static final int SIN = 1;
    static final int TURNING = 2;

    /** σ L; the diagonal blocks, τ I + ι n⊥ n⊥ᵀ, as τ, τ + ι and ι; and their determinant. */
    static final int SWING = 3;

    static final int TAU = 4;
    static final int ALL = 5;
    static final int IOTA = 6;
    static final int FULL = 7;

    /** Inverses of the eliminated blocks, without the sign beside the diagonal, and those times the right-hand sides. */
    static final int P00 = 8;

    static final int P01 = 9;
    static final int P11 = 10;
    static final int Z0 = 11;
    static final int Z1 = 12;

    /** Angle of n, in parts of the table, but for quarter turns; angular velocity; both at the start; and those quarter turns. */
    static final int BASE = 13;

    static final int OMEGA = 14;
    static final int QUARTERS = 15;

    /** σ L / J. */
    static final int LEVER = 16;

    /** Angular accelerations of the stages. */
    static final int ALPHA = 17;

    static final int LAST = ALPHA + 3;

    /** Values of a link that only the end of a step wants. */
    static final int CALM = 8;

    /** Angle at the start and at the end of a step. */
    static final int ANGLE = 0;

    /** What the turn from the axis of the link to n is beyond quarter turns, with cosine and sine. */
    static final int REST = 1;

    static final int REST_COS = 2;
    static final int REST_SIN = 3;

    /** L, of either sign; from the near pin to the centre of mass, along n; mass and moment of inertia. */
    static final int LENGTH = 4;

    static final int REACH = 5;
    static final int MASS = 6;
    static final int INERTIA = 7;

    private static final long STAGES = 4;

    private final PinTree tree;
    private final int links;

    /** By link. */
    private final double[] link;

    private final double[] calm;

    /** Where they are at the end of a step. */
    final HungEnds ends;

    /** One of these is null. */
    private final HungHalves halves;

    private final HungSweep sweep;

    /** σ of the first link. */
    private final double first;

    private HungChain(PinTree tree) {
        this.tree = tree;
        links = tree.links;
        link = new double[STRIDE * links];
        calm = new double[CALM * links];
        first = HungMasses.first(tree);
        ends = new HungEnds(tree, link, calm);
        halves = links < MANY ? new HungHalves(link, links) : null;
        sweep = links < MANY ? null : new HungSweep(link, links);
    }

    /**
     * Makes a chain of a tree of known masses.
     *
     * @return null if it is none of this kind
     */
    static HungChain of(PinTree tree) {
        HungChain chain = HungMasses.areSuited(tree) ? new HungChain(tree) : null;
        if (chain == null || !HungMasses.weigh(chain.link, chain.calm, tree)) {
            return null;
        }
        chain.ends.weigh();
        return chain;
    }

    /** A step, (13), or a part of one that is not its last; returns its roughness, see {@link PinTree#roughness}. */
    double step(double gx, double gy, double h, boolean isLast) {
        tree.passed += STAGES * links;
        double fx = first * gx;
        double fy = first * gy;
        double nothing = links > FADING ? NOTHING * (Math.abs(fx) + Math.abs(fy)) : 0;
        if (sweep == null) {
            halves.step(fx, fy, h, nothing);
        } else {
            sweep.step(fx, fy, h, nothing);
        }
        double roughest = 0;
        ends.begin();
        for (int from = 0; from < links; from += PORTION) {
            int to = Math.min(from + PORTION, links);
            if (sweep != null) {
                sweep.accelerate(from, to);
            }
            roughest = Math.max(roughest, finish(from, to, h, isLast));
            if (isLast) {
                ends.place(from, to);
            }
        }
        return roughest;
    }

    /** Links at the end of a step, (13), or of a part of one; returns their roughness. */
    private double finish(int from, int to, double h, boolean isLast) {
        double[] l = link;
        double sixth = h / 6;
        double fastest = HALF_TURN / Math.abs(h);
        double roughest = 0;
        int o = STRIDE * from;
        for (int q = CALM * from; q < CALM * to; q += CALM, o += STRIDE) {
            double before = l[o + OMEGA];
            double one = l[o + ALPHA];
            double two = l[o + ALPHA + 1];
            double three = l[o + ALPHA + 2];
            double last = l[o + LAST];
            double inner = two + three;
            double rough = Math.abs(one - inner + last) + Math.abs(two - three);
            if (!(rough <= roughest && Math.abs(before) <= fastest)) { // seldom; a maximum would make each wait for the last
                roughest = rough >= 0 && Math.abs(before) <= fastest ? rough : Double.POSITIVE_INFINITY; // NaN stays
            }
            double sum = one + inner;
            double after = before + sixth * (sum + (inner + last));
            double angle = calm[q + ANGLE] + h * (before + sixth * sum);
            l[o + OMEGA] = after;
            l[o + TURNING] = after;
            if (isLast) {
                point(o, q, angle);
            } else {
                pointOnTheWay(o, q, angle);
            }
        }
        return roughest;
    }

    /** Turns n to where an angle has it at the end of a step, and takes note of it. */
    private void point(int o, int q, double angle) {
        double rest = calm[q + REST];
        calm[q + ANGLE] = angle;
        link[o + BASE] = SineTable.parts(angle + rest);
        SineTable.direct(angle, link[o + QUARTERS], link, o + COS);
        if (rest != 0) {
            double c = link[o + COS];
            double s = link[o + SIN];
            link[o + COS] = calm[q + REST_COS] * c - calm[q + REST_SIN] * s;
            link[o + SIN] = calm[q + REST_COS] * s + calm[q + REST_SIN] * c;
        }
    }

    /** The same within a step, where places are not asked for: as at its stages. */
    private void pointOnTheWay(int o, int q, double angle) {
        double base = SineTable.parts(angle + calm[q + REST]);
        calm[q + ANGLE] = angle;
        link[o + BASE] = base;
        SineTable.directParts(base, link[o + QUARTERS], link, o + COS);
    }

    /** Takes a state over. */
    void begin(State state) {
        double[] x = state.x();
        double[] v = state.v();
        for (int k = 0, o = 0; k < links; k++, o += STRIDE) {
            int b = tree.block[k];
            link[o + OMEGA] = v[b + 2];
            link[o + TURNING] = v[b + 2];
            point(o, CALM * k, x[b + 2]);
        }
        ends.take(state);
    }
}
