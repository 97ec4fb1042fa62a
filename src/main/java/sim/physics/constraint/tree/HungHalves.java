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
 * The accelerations of a {@link HungChain} from both ends at the same time: two eliminations that do not wait for one another
 * take hardly more time than one.
 */
final class HungHalves implements Serializable {
    private static final long serialVersionUID = 1L;

    private final double[] link;
    private final int links;
    private final boolean isLong;

    /** Where the link in the middle lies. */
    private final int middle;

    /** Unknowns below this are none. */
    private double nothing;

    HungHalves(double[] link, int links) {
        this.link = link;
        this.links = links;
        isLong = links > HungChain.FADING;
        middle = STRIDE * ((links - 1) / 2);
    }

    /** The stages of a step under a field (fx, fy), in units of the unknowns. */
    void step(double fx, double fy, double h, double least) {
        nothing = least;
        eliminate(fx, fy);
        accelerate(0, 0.5 * h);
        eliminate(fx, fy);
        accelerate(1, 0.5 * h);
        eliminate(fx, fy);
        accelerate(2, h);
        eliminate(fx, fy);
        accelerate();
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
    private void eliminate(double fx, double fy) {
        double[] l = link;
        double x0 = fx;
        double x1 = fy;
        double a00 = 0; // what the link before it leaves in a block, but for the sign beside its diagonal, as x in a right side
        double a01 = 0;
        double a11 = 0;
        double c00 = 0; // its own block, and 1/δ
        double c01 = 0;
        double c11 = 0;
        double perA = 0;
        double b00 = 0; // the same from the tip
        double b01 = 0;
        double b11 = 0;
        double d00 = 0;
        double d01 = 0;
        double d11 = 0;
        double perB = 0;
        double y0 = 0;
        double y1 = 0;
        for (int o = 0, q = l.length - STRIDE; o < middle; o += STRIDE, q -= STRIDE) {
            double sin = l[o + SIN];
            double across = l[o + IOTA] * sin;
            double square = l[o + TURNING] * l[o + TURNING] * l[o + SWING];
            double e00 = l[o + TAU] + across * sin;
            double e11 = l[o + ALL] - across * sin;
            double e01 = across * l[o + COS];
            double f0 = square * l[o + COS] + x0;
            double f1 = square * sin + x1;
            perA = 1 / (l[o + FULL] - perA * (e00 * c00 + e11 * c11 - (2 * e01 * c01 + 1)));
            c00 = e00 - a00;
            c11 = e11 - a11;
            c01 = a01 - e01;
            a00 = c11 * perA;
            a11 = c00 * perA;
            a01 = c01 * perA;
            x0 = fade(o, a00 * f0 - a01 * f1);
            x1 = fade(o, a11 * f1 - a01 * f0);
            keep(o, a00, a01, a11, x0, x1);
            sin = l[q + SIN];
            across = l[q + IOTA] * sin;
            square = l[q + TURNING] * l[q + TURNING] * l[q + SWING];
            e00 = l[q + TAU] + across * sin;
            e11 = l[q + ALL] - across * sin;
            e01 = across * l[q + COS];
            f0 = square * l[q + COS] + y0;
            f1 = square * sin + y1;
            perB = 1 / (l[q + FULL] - perB * (e00 * d00 + e11 * d11 - (2 * e01 * d01 + 1)));
            d00 = e00 - b00;
            d11 = e11 - b11;
            d01 = b01 - e01;
            b00 = d11 * perB;
            b11 = d00 * perB;
            b01 = d01 * perB;
            y0 = fade(o, b00 * f0 - b01 * f1);
            y1 = fade(o, b11 * f1 - b01 * f0);
            keep(q, b00, b01, b11, y0, y1);
        }
        meet(fx, fy);
    }

    /** Takes a number that has faded away for zero. */
    private double some(double x) {
        return Math.abs(x) < nothing ? 0 : x;
    }

    /** The same for one that goes on from link to link: now and then, so that it does not fade into denormal numbers. */
    private double fade(int o, double x) {
        return isLong && (o & SELDOM) == 0 ? some(x) : x;
    }

    private void keep(int o, double p00, double p01, double p11, double z0, double z1) {
        link[o + P00] = p00;
        link[o + P01] = p01;
        link[o + P11] = p11;
        link[o + Z0] = z0;
        link[o + Z1] = z1;
    }

    /** Solves for the link in the middle; before that eliminates the one behind it if there are more there than before it. */
    private void meet(double fx, double fy) {
        int o = middle - STRIDE;
        int q = middle + STRIDE;
        double[] l = link;
        if (links % 2 == 0) {
            boolean isTip = q + STRIDE == l.length;
            eliminate(q, isTip ? -1 : q + STRIDE, -1, 0, 0);
        }
        eliminate(middle, o, q < l.length ? q : -1, o < 0 ? fx : 0, o < 0 ? fy : 0);
    }

    /** Eliminates a link by itself, given its neighbours that are eliminated, −1 for none, and a field. */
    private void eliminate(int o, int one, int other, double fx, double fy) {
        double[] l = link;
        double sin = l[o + SIN];
        double across = l[o + IOTA] * sin;
        double square = l[o + TURNING] * l[o + TURNING] * l[o + SWING];
        double d00 = l[o + TAU] + across * sin - left(one, P00) - left(other, P00);
        double d11 = l[o + ALL] - across * sin - left(one, P11) - left(other, P11);
        double d01 = left(one, P01) + left(other, P01) - across * l[o + COS];
        double f0 = square * l[o + COS] + fx + left(one, Z0) + left(other, Z0);
        double f1 = square * sin + fy + left(one, Z1) + left(other, Z1);
        double per = 1 / (d00 * d11 - d01 * d01);
        keep(o, d11 * per, d01 * per, d00 * per, per * (d11 * f0 - d01 * f1), per * (d00 * f1 - d01 * f0));
    }

    /** What an eliminated link leaves. */
    private double left(int o, int what) {
        return o < 0 ? 0 : link[o + what];
    }

    /**
     * The angular accelerations, from the middle to both ends, and the links at the next stage: by c times the rates of this
     * one from the start.
     */
    private void accelerate(int stage, double c) {
        double[] l = link;
        double way = SineTable.parts(c);
        double x0 = link[middle + Z0];
        double x1 = link[middle + Z1];
        double y0 = x0;
        double y1 = x1;
        accelerate(middle, x0, x1, stage, c, way);
        int q = middle + STRIDE;
        for (int o = middle - STRIDE; o >= 0; o -= STRIDE, q += STRIDE) {
            double w0 = l[o + Z0] - l[o + P01] * x1 + l[o + P00] * x0;
            x1 = l[o + Z1] - l[o + P01] * x0 + l[o + P11] * x1;
            x0 = fade(o, w0);
            x1 = fade(o, x1);
            accelerate(o, x0, x1, stage, c, way);
            w0 = l[q + Z0] - l[q + P01] * y1 + l[q + P00] * y0;
            y1 = l[q + Z1] - l[q + P01] * y0 + l[q + P11] * y1;
            y0 = fade(o, w0);
            y1 = fade(o, y1);
            accelerate(q, y0, y1, stage, c, way);
        }
        if (q < l.length) {
            double w0 = l[q + Z0] - l[q + P01] * y1 + l[q + P00] * y0;
            accelerate(q, w0, l[q + Z1] - l[q + P01] * y0 + l[q + P11] * y1, stage, c, way);
        }
    }

    private void accelerate(int o, double g0, double g1, int stage, double c, double way) {
        double[] l = link;
        double across = l[o + COS] * g1 - l[o + SIN] * g0;
        double alpha = l[o + LEVER] * (isLong ? some(across) : across);
        double turned = l[o + BASE] + way * l[o + TURNING];
        l[o + ALPHA + stage] = alpha;
        l[o + TURNING] = l[o + OMEGA] + c * alpha;
        SineTable.directParts(turned, l[o + QUARTERS], l, o + COS); // (45), (46)
    }

    /** The angular accelerations at the last stage. */
    private void accelerate() {
        double[] l = link;
        double x0 = link[middle + Z0];
        double x1 = link[middle + Z1];
        double y0 = x0;
        double y1 = x1;
        accelerate(middle, x0, x1);
        int q = middle + STRIDE;
        for (int o = middle - STRIDE; o >= 0; o -= STRIDE, q += STRIDE) {
            double w0 = l[o + Z0] - l[o + P01] * x1 + l[o + P00] * x0;
            x1 = l[o + Z1] - l[o + P01] * x0 + l[o + P11] * x1;
            x0 = fade(o, w0);
            x1 = fade(o, x1);
            accelerate(o, x0, x1);
            w0 = l[q + Z0] - l[q + P01] * y1 + l[q + P00] * y0;
            y1 = l[q + Z1] - l[q + P01] * y0 + l[q + P11] * y1;
            y0 = fade(o, w0);
            y1 = fade(o, y1);
            accelerate(q, y0, y1);
        }
        if (q < l.length) {
            double w0 = l[q + Z0] - l[q + P01] * y1 + l[q + P00] * y0;
            accelerate(q, w0, l[q + Z1] - l[q + P01] * y0 + l[q + P11] * y1);
        }
    }

    private void accelerate(int o, double g0, double g1) {
        double across = link[o + COS] * g1 - link[o + SIN] * g0;
        link[o + LAST] = link[o + LEVER] * (isLong ? some(across) : across);
    }
}
