// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint.tree;

import static sim.physics.constraint.tree.HungChain.ALL;
import static sim.physics.constraint.tree.HungChain.ALPHA;
import static sim.physics.constraint.tree.HungChain.BASE;
import static sim.physics.constraint.tree.HungChain.COS;
import static sim.physics.constraint.tree.HungChain.FULL;
import static sim.physics.constraint.tree.HungChain.IOTA;
import static sim.physics.constraint.tree.HungChain.LAST;
import static sim.physics.constraint.tree.HungChain.LEVER;
import static sim.physics.constraint.tree.HungChain.OMEGA;
import static sim.physics.constraint.tree.HungChain.P00;
import static sim.physics.constraint.tree.HungChain.P01;
import static sim.physics.constraint.tree.HungChain.P11;
import static sim.physics.constraint.tree.HungChain.QUARTERS;
import static sim.physics.constraint.tree.HungChain.SELDOM;
import static sim.physics.constraint.tree.HungChain.SIN;
import static sim.physics.constraint.tree.HungChain.STRIDE;
import static sim.physics.constraint.tree.HungChain.SWING;
import static sim.physics.constraint.tree.HungChain.TAU;
import static sim.physics.constraint.tree.HungChain.TURNING;
import static sim.physics.constraint.tree.HungChain.Z0;
import static sim.physics.constraint.tree.HungChain.Z1;

import java.io.Serializable;
import sim.physics.internal.SineTable;

/**
 * The accelerations of a long {@link HungChain}. A stage takes one way over the chain, in turns from the tip and from the root:
 * on it the forces of the stage follow from what was eliminated on the way before, so each link is at the next stage as soon as
 * it is passed, and is eliminated for that one. So a step comes by each link five times in place of nine, which is what it costs when
 * links have to be fetched from afar. Nearby {@link HungHalves} wait less for divisions.
 */
final class HungSweep implements Serializable {
    private static final long serialVersionUID = 1L;

    private final double[] link;
    private final int links;

    /** The unknowns of the link before the next one, at the last stage. */
    private double force0;

    private double force1;

    /** Unknowns below this are none. */
    private double nothing;

    HungSweep(double[] link, int links) {
        this.link = link;
        this.links = links;
    }

    /** The stages of a step under a field (fx, fy), in units of the unknowns, but for the accelerations of the last one. */
    void step(double fx, double fy, double h, double least) {
        int tip = STRIDE * (links - 1);
        nothing = least;
        eliminate(fx, fy);
        sweep(tip, -STRIDE, 0, 0.5 * h, 0, 0);
        hang(fx, fy);
        sweep(0, STRIDE, 1, 0.5 * h, fx, fy);
        sweep(tip, -STRIDE, 2, h, 0, 0);
        hang(fx, fy);
        force0 = 0;
        force1 = 0;
    }

    /**
     * Eliminates the links from the root to the tip at the start of a step. With E a block as it is without its
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
        double d00 = 0; // its own block, and 1/δ
        double d01 = 0;
        double d11 = 0;
        double per = 0;
        for (int k = 0, o = 0; k < links; k++, o += STRIDE) {
            double cos = l[o + COS];
            double sin = l[o + SIN];
            double square = l[o + TURNING] * l[o + TURNING] * l[o + SWING];
            double across = l[o + IOTA] * sin;
            double e00 = l[o + TAU] + across * sin;
            double e11 = l[o + ALL] - across * sin;
            double e01 = across * cos;
            double f0 = square * cos + x0;
            double f1 = square * sin + x1;
            per = 1 / (l[o + FULL] - per * (e00 * d00 + e11 * d11 - (2 * e01 * d01 + 1)));
            d00 = e00 - a00;
            d11 = e11 - a11;
            d01 = a01 - e01;
            a00 = d11 * per;
            a11 = d00 * per;
            a01 = d01 * per;
            x0 = a00 * f0 - a01 * f1;
            x1 = a11 * f1 - a01 * f0;
            if ((o & SELDOM) == 0) {
                x0 = some(x0);
                x1 = some(x1);
            }
            keep(o, a00, a01, a11, x0, x1);
        }
    }

    /** Takes a number that has faded away for zero. */
    private double some(double x) {
        return Math.abs(x) < nothing ? 0 : x;
    }

    private void keep(int o, double p00, double p01, double p11, double z0, double z1) {
        link[o + P00] = p00;
        link[o + P01] = p01;
        link[o + P11] = p11;
        link[o + Z0] = z0;
        link[o + Z1] = z1;
    }

    /**
     * The angular accelerations of a stage, from the link that was eliminated last to the first one; and on the same way the links
     * at the next stage, by c times the rates of this one from the start, and their elimination.
     *
     * @param from the first link on the way
     * @param stride to the next one
     * @param stage 0 to 2
     * @param c the time from the start to the next stage
     * @param x0 what there is on the right side before the first link
     * @param x1 the same in the direction of y
     */
    private void sweep(int from, int stride, int stage, double c, double x0, double x1) {
        double[] l = link;
        double way = SineTable.parts(c);
        double g0 = 0;
        double g1 = 0;
        double a00 = 0;
        double a01 = 0;
        double a11 = 0;
        double d00 = 0;
        double d01 = 0;
        double d11 = 0;
        double per = 0;
        for (int k = 0, o = from; k < links; k++, o += stride) {
            double w0 = l[o + Z0] - l[o + P01] * g1 + l[o + P00] * g0;
            g1 = l[o + Z1] - l[o + P01] * g0 + l[o + P11] * g1;
            g0 = w0;
            if ((o & SELDOM) == 0) {
                g0 = some(g0);
                g1 = some(g1);
            }
            double alpha = l[o + LEVER] * some(l[o + COS] * g1 - l[o + SIN] * g0);
            double turned = l[o + BASE] + way * l[o + TURNING];
            double turning = l[o + OMEGA] + c * alpha;
            l[o + ALPHA + stage] = alpha;
            l[o + TURNING] = turning;
            SineTable.directParts(turned, l[o + QUARTERS], l, o + COS); // (45), (46)
            double cos = l[o + COS];
            double sin = l[o + SIN];
            double square = turning * turning * l[o + SWING];
            double across = l[o + IOTA] * sin;
            double e00 = l[o + TAU] + across * sin;
            double e11 = l[o + ALL] - across * sin;
            double e01 = across * cos;
            double f0 = square * cos + x0;
            double f1 = square * sin + x1;
            per = 1 / (l[o + FULL] - per * (e00 * d00 + e11 * d11 - (2 * e01 * d01 + 1)));
            d00 = e00 - a00;
            d11 = e11 - a11;
            d01 = a01 - e01;
            a00 = d11 * per;
            a11 = d00 * per;
            a01 = d01 * per;
            x0 = a00 * f0 - a01 * f1;
            x1 = a11 * f1 - a01 * f0;
            if ((o & SELDOM) == 0) {
                x0 = some(x0);
                x1 = some(x1);
            }
            keep(o, a00, a01, a11, x0, x1);
        }
    }

    /** Adds the field, which acts where the chain hangs, to what was eliminated from the tip. */
    private void hang(double fx, double fy) {
        link[Z0] += link[P00] * fx - link[P01] * fy;
        link[Z1] += link[P11] * fy - link[P01] * fx;
    }

    /** The angular accelerations of the next links, from the root on, at the last stage. */
    void accelerate(int from, int to) {
        double[] l = link;
        double g0 = force0;
        double g1 = force1;
        for (int o = STRIDE * from; o < STRIDE * to; o += STRIDE) {
            double w0 = l[o + Z0] - l[o + P01] * g1 + l[o + P00] * g0;
            g1 = l[o + Z1] - l[o + P01] * g0 + l[o + P11] * g1;
            g0 = w0;
            if ((o & SELDOM) == 0) {
                g0 = some(g0);
                g1 = some(g1);
            }
            l[o + LAST] = l[o + LEVER] * some(l[o + COS] * g1 - l[o + SIN] * g0);
        }
        force0 = g0;
        force1 = g1;
    }
}
