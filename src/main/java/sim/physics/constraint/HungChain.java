// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import sim.physics.internal.SineTable;
import sim.physics.motion.State;

/**
 * A {@link PinTree} that is a chain hung in the world, under a uniform field: RK4 on its angles with half the operations, and
 * less waiting, since the accelerations are found from both ends at the same time.
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
 * the blocks beside the diagonal are −I. The blocks of the diagonal are eliminated from both ends to the middle, with one
 * division each, and G is found from there to both ends.
 */
final class HungChain implements Serializable {
    private static final long serialVersionUID = 1L;

    /** What a field does to links far away fades from link to link; below this part of it numbers would soon be denormal. */
    private static final double NOTHING = 0x1p-200;

    /** Links from which on it can fade so far. */
    private static final int FADING = 256;

    /** The largest turn of a link that is followed at once. */
    private static final double HALF_TURN = Math.PI;

    /** Values of a link; together, since there are more of them than a processor has registers for arrays. */
    static final int STRIDE = 32;

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
    private static final int P00 = 8;

    private static final int P01 = 9;
    private static final int P11 = 10;
    private static final int Z0 = 11;
    private static final int Z1 = 12;

    /** Angle of n, in parts of the table, but for quarter turns; angular velocity; both at the start; and those quarter turns. */
    private static final int BASE = 13;

    static final int OMEGA = 14;
    static final int QUARTERS = 15;

    /** σ L / J. */
    static final int LEVER = 16;

    /** Angular accelerations of the stages. */
    private static final int ALPHA = 17;

    private static final int LAST = ALPHA + 3;

    /** L, of either sign; from the near pin to the centre of mass, along n; mass and moment of inertia. */
    static final int LENGTH = 21;

    static final int REACH = 22;
    static final int MASS = 23;
    static final int INERTIA = 24;

    /** How far the centre of mass is to the left of n, by the rounding of how the chain was built: it matters to where it is only. */
    static final int ASIDE = 29;

    /** Angle at the start and at the end of a step. */
    static final int ANGLE = 28;

    /** What the turn from the axis of the link to n is beyond quarter turns, with cosine and sine. */
    static final int REST = 25;

    static final int REST_COS = 26;
    static final int REST_SIN = 27;

    private final PinTree tree;
    private final int links;

    /** By link. */
    private final double[] link;

    /** Where they are at the end of a step. */
    final HungEnds ends;

    /** Where the link in the middle lies among them, and its unknown. */
    private final int middle;

    private double middle0;
    private double middle1;

    /** σ of the first link. */
    private final double first;

    /** Unknowns below this are none. */
    private double nothing;

    private HungChain(PinTree tree) {
        this.tree = tree;
        links = tree.links;
        link = new double[STRIDE * links];
        middle = STRIDE * ((links - 1) / 2);
        first = HungMasses.first(tree);
        ends = new HungEnds(tree, link);
    }

    /**
     * Makes a chain of a tree of known masses.
     *
     * @return null if it is none of this kind
     */
    static HungChain of(PinTree tree) {
        HungChain chain = HungMasses.areSuited(tree) ? new HungChain(tree) : null;
        if (chain == null || !HungMasses.weigh(chain.link, tree)) {
            return null;
        }
        chain.ends.weigh();
        return chain;
    }

    /** Turns n to where an angle has it at the end of a step, and takes note of it. */
    private void point(int o, double angle) {
        double[] l = link;
        double rest = l[o + REST];
        l[o + ANGLE] = angle;
        l[o + BASE] = SineTable.parts(angle + rest);
        SineTable.direct(angle, l[o + QUARTERS], l, o + COS);
        if (rest != 0) {
            double c = l[o + COS];
            double s = l[o + SIN];
            l[o + COS] = l[o + REST_COS] * c - l[o + REST_SIN] * s;
            l[o + SIN] = l[o + REST_COS] * s + l[o + REST_SIN] * c;
        }
    }

    /** The same within a step, where places are not asked for: as at its stages. */
    private void pointOnTheWay(int o, double angle) {
        double base = SineTable.parts(angle + link[o + REST]);
        link[o + ANGLE] = angle;
        link[o + BASE] = base;
        SineTable.directParts(base, link[o + QUARTERS], link, o + COS);
    }

    /** A step, (13), or a part of one that is not its last; returns its roughness, see {@link PinTree#roughness}. */
    double step(double gx, double gy, double h, boolean isLast) {
        nothing = NOTHING * first * (Math.abs(gx) + Math.abs(gy));
        eliminate(first * gx, first * gy);
        accelerate(0, 0.5 * h);
        eliminate(first * gx, first * gy);
        accelerate(1, 0.5 * h);
        eliminate(first * gx, first * gy);
        accelerate(2, h);
        eliminate(first * gx, first * gy);
        accelerate();
        return finish(h, isLast);
    }

    /**
     * Eliminates the links from both ends, and solves for the one in the middle. With E a block as it is without its
     * neighbours, D′ the one eliminated before it, and δ for determinants, D = E − D′⁻¹ has
     *
     * <pre>
     *   δ = δ_E − (E₀₀ D′₀₀ + E₁₁ D′₁₁ + 2 E₀₁ D′₀₁ − 1) / δ′
     * </pre>
     *
     * <p>so that each division waits for little more than the one before it.
     */
    private void eliminate(double x0, double x1) {
        double[] l = link;
        double a00 = 0; // what the link before it leaves in a block, but for the sign beside its diagonal, as x in a right side
        double a01 = 0;
        double a11 = 0;
        double c00 = 0; // its own block, and 1/δ
        double c01 = 0;
        double c11 = 0;
        double perA = 0;
        int odd = eliminateOdd();
        boolean isOdd = odd < l.length;
        double y0 = isOdd ? l[odd + Z0] : 0; // the same from the tip
        double y1 = isOdd ? l[odd + Z1] : 0;
        double b00 = isOdd ? l[odd + P00] : 0;
        double b01 = isOdd ? l[odd + P01] : 0;
        double b11 = isOdd ? l[odd + P11] : 0;
        double perB = isOdd ? 1 / l[odd + FULL] : 0;
        double d00 = isOdd ? b11 * l[odd + FULL] : 0;
        double d01 = isOdd ? b01 * l[odd + FULL] : 0;
        double d11 = isOdd ? b00 * l[odd + FULL] : 0;
        for (int o = 0, q = odd - STRIDE; o < middle; o += STRIDE, q -= STRIDE) {
            double s = l[o + SIN];
            double across = l[o + IOTA] * s;
            double square = l[o + TURNING] * l[o + TURNING] * l[o + SWING];
            double e00 = l[o + TAU] + across * s;
            double e11 = l[o + ALL] - across * s;
            double e01 = across * l[o + COS];
            double f0 = square * l[o + COS] + x0;
            double f1 = square * s + x1;
            perA = 1 / (l[o + FULL] - perA * (e00 * c00 + e11 * c11 - (2 * e01 * c01 + 1)));
            c00 = e00 - a00;
            c11 = e11 - a11;
            c01 = a01 - e01;
            a00 = c11 * perA;
            a11 = c00 * perA;
            a01 = c01 * perA;
            x0 = a00 * f0 - a01 * f1;
            x1 = a11 * f1 - a01 * f0;
            keep(o, a00, a01, a11, x0, x1);
            s = l[q + SIN];
            across = l[q + IOTA] * s;
            square = l[q + TURNING] * l[q + TURNING] * l[q + SWING];
            e00 = l[q + TAU] + across * s;
            e11 = l[q + ALL] - across * s;
            e01 = across * l[q + COS];
            f0 = square * l[q + COS] + y0;
            f1 = square * s + y1;
            perB = 1 / (l[q + FULL] - perB * (e00 * d00 + e11 * d11 - (2 * e01 * d01 + 1)));
            d00 = e00 - b00;
            d11 = e11 - b11;
            d01 = b01 - e01;
            b00 = d11 * perB;
            b11 = d00 * perB;
            b01 = d01 * perB;
            y0 = b00 * f0 - b01 * f1;
            y1 = b11 * f1 - b01 * f0;
            keep(q, b00, b01, b11, y0, y1);
        }
        meet(a00 + b00, a01 + b01, a11 + b11, x0 + y0, x1 + y1);
    }

    private void keep(int o, double p00, double p01, double p11, double z0, double z1) {
        link[o + P00] = p00;
        link[o + P01] = p01;
        link[o + P11] = p11;
        link[o + Z0] = z0;
        link[o + Z1] = z1;
    }

    /** The last link goes first if there are not as many before the middle as behind; returns the one behind the last that is left. */
    private int eliminateOdd() {
        double[] l = link;
        int o = l.length - STRIDE;
        if (links % 2 == 0) {
            double c = l[o + COS];
            double s = l[o + SIN];
            double across = l[o + IOTA] * s;
            double square = l[o + TURNING] * l[o + TURNING] * l[o + SWING];
            double per = 1 / l[o + FULL];
            l[o + P00] = (l[o + ALL] - across * s) * per;
            l[o + P01] = -across * c * per;
            l[o + P11] = (l[o + TAU] + across * s) * per;
            l[o + Z0] = square * (l[o + P00] * c - l[o + P01] * s);
            l[o + Z1] = square * (l[o + P11] * s - l[o + P01] * c);
            return o;
        }
        return l.length;
    }

    /** Solves for the link in the middle, given what both sides leave there. */
    private void meet(double a00, double a01, double a11, double x0, double x1) {
        double[] l = link;
        double c = l[middle + COS];
        double s = l[middle + SIN];
        double across = l[middle + IOTA] * s;
        double square = l[middle + TURNING] * l[middle + TURNING] * l[middle + SWING];
        double d00 = l[middle + TAU] + across * s - a00;
        double d11 = l[middle + ALL] - across * s - a11;
        double d01 = a01 - across * c;
        double f0 = square * c + x0;
        double f1 = square * s + x1;
        double per = 1 / (d00 * d11 - d01 * d01);
        middle0 = per * (d11 * f0 - d01 * f1);
        middle1 = per * (d00 * f1 - d01 * f0);
    }

    /**
     * The angular accelerations, from the middle to both ends, and the links at the next stage: by c times the rates of this
     * one from the start.
     */
    private void accelerate(int stage, double c) {
        double[] l = link;
        double way = SineTable.parts(c);
        double x0 = middle0;
        double x1 = middle1;
        double y0 = x0;
        double y1 = x1;
        boolean isLong = links > FADING;
        accelerate(middle, x0, x1, stage, c, way);
        int q = middle + STRIDE;
        for (int o = middle - STRIDE; o >= 0; o -= STRIDE, q += STRIDE) {
            double w0 = l[o + Z0] - l[o + P01] * x1 + l[o + P00] * x0;
            x1 = l[o + Z1] - l[o + P01] * x0 + l[o + P11] * x1;
            x0 = w0;
            accelerate(o, x0, x1, stage, c, way);
            w0 = l[q + Z0] - l[q + P01] * y1 + l[q + P00] * y0;
            y1 = l[q + Z1] - l[q + P01] * y0 + l[q + P11] * y1;
            y0 = w0;
            if (isLong) {
                y0 = Math.abs(y0) < nothing ? 0 : y0;
                y1 = Math.abs(y1) < nothing ? 0 : y1;
            }
            accelerate(q, y0, y1, stage, c, way);
        }
        if (q < l.length) {
            double w0 = l[q + Z0] - l[q + P01] * y1 + l[q + P00] * y0;
            accelerate(q, w0, l[q + Z1] - l[q + P01] * y0 + l[q + P11] * y1, stage, c, way);
        }
    }

    private void accelerate(int o, double g0, double g1, int stage, double c, double way) {
        double[] l = link;
        double alpha = l[o + LEVER] * (l[o + COS] * g1 - l[o + SIN] * g0);
        double turned = l[o + BASE] + way * l[o + TURNING];
        l[o + ALPHA + stage] = alpha;
        l[o + TURNING] = l[o + OMEGA] + c * alpha;
        SineTable.directParts(turned, l[o + QUARTERS], l, o + COS); // (45), (46)
    }

    /** The angular accelerations at the last stage. */
    private void accelerate() {
        double[] l = link;
        double x0 = middle0;
        double x1 = middle1;
        double y0 = x0;
        double y1 = x1;
        boolean isLong = links > FADING;
        accelerate(middle, x0, x1);
        int q = middle + STRIDE;
        for (int o = middle - STRIDE; o >= 0; o -= STRIDE, q += STRIDE) {
            double w0 = l[o + Z0] - l[o + P01] * x1 + l[o + P00] * x0;
            x1 = l[o + Z1] - l[o + P01] * x0 + l[o + P11] * x1;
            x0 = w0;
            accelerate(o, x0, x1);
            w0 = l[q + Z0] - l[q + P01] * y1 + l[q + P00] * y0;
            y1 = l[q + Z1] - l[q + P01] * y0 + l[q + P11] * y1;
            y0 = w0;
            if (isLong) {
                y0 = Math.abs(y0) < nothing ? 0 : y0;
                y1 = Math.abs(y1) < nothing ? 0 : y1;
            }
            accelerate(q, y0, y1);
        }
        if (q < l.length) {
            double w0 = l[q + Z0] - l[q + P01] * y1 + l[q + P00] * y0;
            accelerate(q, w0, l[q + Z1] - l[q + P01] * y0 + l[q + P11] * y1);
        }
    }

    private void accelerate(int o, double g0, double g1) {
        link[o + LAST] = link[o + LEVER] * (link[o + COS] * g1 - link[o + SIN] * g0);
    }

    /** The links at the end of the step, (13). */
    private double finish(double h, boolean isLast) {
        double[] l = link;
        double sixth = h / 6;
        double fastest = HALF_TURN / Math.abs(h);
        double roughest = 0;
        for (int o = 0; o < l.length; o += STRIDE) {
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
            double angle = l[o + ANGLE] + h * (before + sixth * sum);
            l[o + OMEGA] = after;
            l[o + TURNING] = after;
            if (isLast) {
                point(o, angle);
            } else {
                pointOnTheWay(o, angle);
            }
        }
        return roughest;
    }

    /** Takes a state over. */
    void begin(State state) {
        double[] x = state.x();
        double[] v = state.v();
        for (int k = 0, o = 0; k < links; k++, o += STRIDE) {
            int b = tree.block[k];
            link[o + OMEGA] = v[b + 2];
            link[o + TURNING] = v[b + 2];
            point(o, x[b + 2]);
        }
        ends.take(state);
    }
}
