// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;

/**
 * The factors L D Lᵀ of the block tridiagonal matrix of a {@link PinChain}, eliminated from both ends towards the pin in
 * the middle. One reciprocal per block, that of its determinant, which is taken while the products with the adjugate are
 * formed: the chain of operations from block to block is as short as can be.
 */
final class ChainFactor implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Pivots below this part of their diagonal are left to the general solver, which damps their corrections. */
    private static final double WEAK = 1e-7;

    private final int pins;
    private final int middle;

    /** By pin: the inverses of the diagonal blocks, L of the block towards the middle, and D⁻¹ L⁻¹ b. */
    private final double[] i00;

    private final double[] i01;
    private final double[] i11;
    private final double[] l00;
    private final double[] l01;
    private final double[] l10;
    private final double[] l11;
    private final double[] z0;
    private final double[] z1;

    /** What the right end has left behind for the pins before. */
    private final double[] tail = new double[5];

    private boolean isWeak;

    ChainFactor(int pins) {
        this.pins = pins;
        middle = (pins - 1) / 2;
        i00 = new double[pins];
        i01 = new double[pins];
        i11 = new double[pins];
        l00 = new double[pins];
        l01 = new double[pins];
        l10 = new double[pins];
        l11 = new double[pins];
        z0 = new double[pins];
        z1 = new double[pins];
    }

    /** Factors, and solves as far as D⁻¹ L⁻¹ b; false if some pivot is weak. */
    boolean factor(PinChain c) {
        isWeak = false;
        double[] rest = rest(c);
        double s00 = 0; // what the left end has left behind, and the right one
        double s01 = 0;
        double s11 = 0;
        double s0 = 0;
        double s1 = 0;
        double t00 = rest[0];
        double t01 = rest[1];
        double t11 = rest[2];
        double t0 = rest[3];
        double t1 = rest[4];
        int q = pins - 1 - (pins - 1) % 2;
        for (int k = 0; k < middle; k++, q--) {
            double d00 = c.next00[k] + c.last00[k + 1] - s00;
            double d01 = c.next01[k] + c.last01[k + 1] - s01;
            double d11 = c.next11[k] + c.last11[k + 1] - s11;
            double b0 = c.lastX[k + 1] - c.nextX[k] - s0;
            double b1 = c.lastY[k + 1] - c.nextY[k] - s1;
            double r = 1 / (d00 * d11 - d01 * d01);
            double e00 = c.mid00[k + 1];
            double e01 = c.mid10[k + 1];
            double e10 = c.mid01[k + 1];
            double e11 = c.mid11[k + 1];
            keepInverse(k, d00, d01, d11, r, d00 + s00, d11 + s11, b0, b1);
            keep(k, d00, d01, d11, r, e00, e01, e10, e11);
            s00 = r * product(e00, e01, d00, d01, d11, e00, e01);
            s01 = r * product(e00, e01, d00, d01, d11, e10, e11);
            s11 = r * product(e10, e11, d00, d01, d11, e10, e11);
            s0 = r * product(e00, e01, d00, d01, d11, b0, b1);
            s1 = r * product(e10, e11, d00, d01, d11, b0, b1);
            d00 = c.next00[q] + c.last00[q + 1] - t00;
            d01 = c.next01[q] + c.last01[q + 1] - t01;
            d11 = c.next11[q] + c.last11[q + 1] - t11;
            b0 = c.lastX[q + 1] - c.nextX[q] - t0;
            b1 = c.lastY[q + 1] - c.nextY[q] - t1;
            r = 1 / (d00 * d11 - d01 * d01);
            e00 = c.mid00[q];
            e01 = c.mid01[q];
            e10 = c.mid10[q];
            e11 = c.mid11[q];
            keepInverse(q, d00, d01, d11, r, d00 + t00, d11 + t11, b0, b1);
            keep(q, d00, d01, d11, r, e00, e01, e10, e11);
            t00 = r * product(e00, e01, d00, d01, d11, e00, e01);
            t01 = r * product(e00, e01, d00, d01, d11, e10, e11);
            t11 = r * product(e10, e11, d00, d01, d11, e10, e11);
            t0 = r * product(e00, e01, d00, d01, d11, b0, b1);
            t1 = r * product(e10, e11, d00, d01, d11, b0, b1);
        }
        meet(c, s00 + t00, s01 + t01, s11 + t11, s0 + t0, s1 + t1);
        return !isWeak;
    }

    /** If the pins do not come out even, the one at the right end is eliminated first; what it leaves behind. */
    private double[] rest(PinChain c) {
        Arrays.fill(tail, 0);
        if (pins % 2 == 0) {
            int q = pins - 1;
            double d00 = c.next00[q] + c.last00[q + 1];
            double d01 = c.next01[q] + c.last01[q + 1];
            double d11 = c.next11[q] + c.last11[q + 1];
            double b0 = c.lastX[q + 1] - c.nextX[q];
            double b1 = c.lastY[q + 1] - c.nextY[q];
            double r = 1 / (d00 * d11 - d01 * d01);
            double e00 = c.mid00[q];
            double e01 = c.mid01[q];
            double e10 = c.mid10[q];
            double e11 = c.mid11[q];
            keepInverse(q, d00, d01, d11, r, d00, d11, b0, b1);
            keep(q, d00, d01, d11, r, e00, e01, e10, e11);
            tail[0] = r * product(e00, e01, d00, d01, d11, e00, e01);
            tail[1] = r * product(e00, e01, d00, d01, d11, e10, e11);
            tail[2] = r * product(e10, e11, d00, d01, d11, e10, e11);
            tail[3] = r * product(e00, e01, d00, d01, d11, b0, b1);
            tail[4] = r * product(e10, e11, d00, d01, d11, b0, b1);
        }
        return tail;
    }

    /** The pin in the middle, to which both ends have left something behind. */
    private void meet(PinChain c, double s00, double s01, double s11, double s0, double s1) {
        int k = middle;
        double d00 = c.next00[k] + c.last00[k + 1] - s00;
        double d01 = c.next01[k] + c.last01[k + 1] - s01;
        double d11 = c.next11[k] + c.last11[k + 1] - s11;
        double b0 = c.lastX[k + 1] - c.nextX[k] - s0;
        double b1 = c.lastY[k + 1] - c.nextY[k] - s1;
        keepInverse(k, d00, d01, d11, 1 / (d00 * d11 - d01 * d01), d00 + s00, d11 + s11, b0, b1);
    }

    /** p adj(D) qᵀ. */
    private static double product(double p0, double p1, double d00, double d01, double d11, double q0, double q1) {
        return (p0 * d11 - p1 * d01) * q0 + (p1 * d00 - p0 * d01) * q1;
    }

    /** Keeps the inverse of a diagonal block, L, and the half solved right side. */
    private void keepInverse(
            int k, double d00, double d01, double d11, double r, double size0, double size1, double b0, double b1) {
        isWeak |= !(d00 > WEAK * size0) || !(d00 * d11 - d01 * d01 > WEAK * size1 * d00);
        i00[k] = r * d11;
        i01[k] = -(r * d01);
        i11[k] = r * d00;
        z0[k] = r * (d11 * b0 - d01 * b1);
        z1[k] = r * (d00 * b1 - d01 * b0);
    }

    /** Keeps L of the block towards the middle. */
    private void keep(
            int k, double d00, double d01, double d11, double r, double e00, double e01, double e10, double e11) {
        l00[k] = r * (e00 * d11 - e01 * d01);
        l01[k] = r * (e01 * d00 - e00 * d01);
        l10[k] = r * (e10 * d11 - e11 * d01);
        l11[k] = r * (e11 * d00 - e10 * d01);
    }

    /** Solves for another right side as far as D⁻¹ L⁻¹ b. */
    void forward(PinChain c) {
        double s0 = 0;
        double s1 = 0;
        double t0 = 0;
        double t1 = 0;
        int q = pins - 1;
        if (pins % 2 == 0) {
            double b0 = c.lastX[q + 1] - c.nextX[q];
            double b1 = c.lastY[q + 1] - c.nextY[q];
            halve(q, b0, b1);
            t0 = l00[q] * b0 + l01[q] * b1;
            t1 = l10[q] * b0 + l11[q] * b1;
            q--;
        }
        for (int k = 0; k < middle; k++, q--) {
            double b0 = c.lastX[k + 1] - c.nextX[k] - s0;
            double b1 = c.lastY[k + 1] - c.nextY[k] - s1;
            halve(k, b0, b1);
            s0 = l00[k] * b0 + l01[k] * b1;
            s1 = l10[k] * b0 + l11[k] * b1;
            b0 = c.lastX[q + 1] - c.nextX[q] - t0;
            b1 = c.lastY[q + 1] - c.nextY[q] - t1;
            halve(q, b0, b1);
            t0 = l00[q] * b0 + l01[q] * b1;
            t1 = l10[q] * b0 + l11[q] * b1;
        }
        int k = middle;
        halve(k, c.lastX[k + 1] - c.nextX[k] - (s0 + t0), c.lastY[k + 1] - c.nextY[k] - (s1 + t1));
    }

    private void halve(int k, double b0, double b1) {
        z0[k] = i00[k] * b0 + i01[k] * b1;
        z1[k] = i01[k] * b0 + i11[k] * b1;
    }

    /** The second half of the solution. */
    void back(PinChain c) {
        double x0 = z0[middle];
        double x1 = z1[middle];
        double y0 = x0;
        double y1 = x1;
        put(c, middle, x0, x1);
        int q = middle + 1;
        for (int k = middle - 1; k >= 0; k--, q++) {
            double w0 = z0[k] - (l00[k] * x0 + l10[k] * x1);
            x1 = z1[k] - (l01[k] * x0 + l11[k] * x1);
            x0 = w0;
            put(c, k, x0, x1);
            w0 = z0[q] - (l00[q] * y0 + l10[q] * y1);
            y1 = z1[q] - (l01[q] * y0 + l11[q] * y1);
            y0 = w0;
            put(c, q, y0, y1);
        }
        if (q < pins) {
            put(c, q, z0[q] - (l00[q] * y0 + l10[q] * y1), z1[q] - (l01[q] * y0 + l11[q] * y1));
        }
    }

    private static void put(PinChain c, int k, double x0, double x1) {
        c.lambdaNextX[k] = x0;
        c.lambdaNextY[k] = x1;
        c.lambdaLastX[k + 1] = x0;
        c.lambdaLastY[k + 1] = x1;
    }
}
