// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;

/**
 * The block tridiagonal equations A λ = b of a {@link PinChain}: factors L D Lᵀ, eliminated from both ends towards the pin
 * in the middle, which the processor does at the same time, as it waits for a link's operations far longer than their
 * number asks for. There is one reciprocal per block, that of its determinant, which is taken while the products with the
 * adjugate are formed, so that the way from block to block is as short as can be.
 */
final class ChainFactor implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Pivots below this part of their diagonal are left to the general solver, which damps their corrections. */
    private static final double WEAK = 1e-5;

    /** By pin: the diagonal blocks of A, and b. */
    final double[] d00;

    final double[] d01;
    final double[] d11;
    final double[] b0;
    final double[] b1;

    /** By body: the block of the pin before it, in the rows, and of the pin after it. */
    final double[] e00;

    final double[] e01;
    final double[] e10;
    final double[] e11;

    /** λ of pin k at k + 1, between zeros. */
    final double[] lambdaX;

    final double[] lambdaY;

    private final int pins;
    private final int middle;

    /** By pin: the inverses of the blocks of D, L of the block towards the middle, and D⁻¹ L⁻¹ b. */
    private final double[] i00;

    private final double[] i01;
    private final double[] i11;
    private final double[] l00;
    private final double[] l01;
    private final double[] l10;
    private final double[] l11;
    private final double[] z0;
    private final double[] z1;

    /** What the last pin leaves behind. */
    private final double[] rest = new double[5];

    ChainFactor(int pins) {
        this.pins = pins;
        middle = (pins - 1) / 2;
        d00 = new double[pins];
        d01 = new double[pins];
        d11 = new double[pins];
        b0 = new double[pins];
        b1 = new double[pins];
        e00 = new double[pins + 1];
        e01 = new double[pins + 1];
        e10 = new double[pins + 1];
        e11 = new double[pins + 1];
        lambdaX = new double[pins + 2];
        lambdaY = new double[pins + 2];
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

    /** Factors A, and leaves L⁻¹ b in the place of b, which the processor does while it waits for the factors. */
    void factor() {
        int q = last();
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
        for (int k = 0; k < middle; k++, q--) {
            double p00 = d00[k] - s00;
            double p01 = d01[k] - s01;
            double p11 = d11[k] - s11;
            double r = 1 / (p00 * p11 - p01 * p01);
            double c00 = e00[k + 1];
            double c01 = e10[k + 1];
            double c10 = e01[k + 1];
            double c11 = e11[k + 1];
            keep(k, p00, p01, p11, r, c00, c01, c10, c11);
            s00 = r * product(c00, c01, p00, p01, p11, c00, c01);
            s01 = r * product(c00, c01, p00, p01, p11, c10, c11);
            s11 = r * product(c10, c11, p00, p01, p11, c10, c11);
            b0[k] -= s0;
            b1[k] -= s1;
            s0 = r * product(c00, c01, p00, p01, p11, b0[k], b1[k]);
            s1 = r * product(c10, c11, p00, p01, p11, b0[k], b1[k]);
            p00 = d00[q] - t00;
            p01 = d01[q] - t01;
            p11 = d11[q] - t11;
            r = 1 / (p00 * p11 - p01 * p01);
            c00 = e00[q];
            c01 = e01[q];
            c10 = e10[q];
            c11 = e11[q];
            keep(q, p00, p01, p11, r, c00, c01, c10, c11);
            t00 = r * product(c00, c01, p00, p01, p11, c00, c01);
            t01 = r * product(c00, c01, p00, p01, p11, c10, c11);
            t11 = r * product(c10, c11, p00, p01, p11, c10, c11);
            b0[q] -= t0;
            b1[q] -= t1;
            t0 = r * product(c00, c01, p00, p01, p11, b0[q], b1[q]);
            t1 = r * product(c10, c11, p00, p01, p11, b0[q], b1[q]);
        }
        int k = middle;
        double p00 = d00[k] - (s00 + t00);
        double p01 = d01[k] - (s01 + t01);
        double p11 = d11[k] - (s11 + t11);
        keep(k, p00, p01, p11, 1 / (p00 * p11 - p01 * p01), 0, 0, 0, 0);
        b0[k] -= s0 + t0;
        b1[k] -= s1 + t1;
    }

    /** The last pin is eliminated first if the pins do not come out even; returns the last one that is left. */
    private int last() {
        int q = pins - 1;
        Arrays.fill(rest, 0);
        if (pins % 2 == 0) {
            double p00 = d00[q];
            double p01 = d01[q];
            double p11 = d11[q];
            double r = 1 / (p00 * p11 - p01 * p01);
            keep(q, p00, p01, p11, r, e00[q], e01[q], e10[q], e11[q]);
            rest[0] = r * product(e00[q], e01[q], p00, p01, p11, e00[q], e01[q]);
            rest[1] = r * product(e00[q], e01[q], p00, p01, p11, e10[q], e11[q]);
            rest[2] = r * product(e10[q], e11[q], p00, p01, p11, e10[q], e11[q]);
            rest[3] = r * product(e00[q], e01[q], p00, p01, p11, b0[q], b1[q]);
            rest[4] = r * product(e10[q], e11[q], p00, p01, p11, b0[q], b1[q]);
            q--;
        }
        return q;
    }

    /** c adj(P) qᵀ. */
    private static double product(double c0, double c1, double p00, double p01, double p11, double q0, double q1) {
        return (c0 * p11 - c1 * p01) * q0 + (c1 * p00 - c0 * p01) * q1;
    }

    /** Keeps the inverse of a block of D, and L of the block towards the middle. */
    private void keep(
            int k, double p00, double p01, double p11, double r, double c00, double c01, double c10, double c11) {
        i00[k] = r * p11;
        i01[k] = -(r * p01);
        i11[k] = r * p00;
        l00[k] = r * (c00 * p11 - c01 * p01);
        l01[k] = r * (c01 * p00 - c00 * p01);
        l10[k] = r * (c10 * p11 - c11 * p01);
        l11[k] = r * (c11 * p00 - c10 * p01);
    }

    /** Whether no pivot of the last factors is weak. */
    boolean isSound() {
        boolean sound = true;
        for (int k = 0; k < pins; k++) {
            double first = WEAK * d00[k] * i00[k];
            double second = WEAK * d11[k] * i11[k];
            sound &= first > 0 && first < 1 && second > 0 && second < 1;
        }
        return sound;
    }

    /** Solves for λ with the last factors; b is used up. */
    void solve() {
        forward();
        back();
    }

    /** Solves for λ, given L⁻¹ b in the place of b. */
    void back() {
        Lanes.dot(i00, b0, i01, b1, z0);
        Lanes.dot(i01, b0, i11, b1, z1);
        substitute();
    }

    private void forward() {
        double s0 = 0;
        double s1 = 0;
        double t0 = 0;
        double t1 = 0;
        int q = pins - 1;
        if (pins % 2 == 0) {
            t0 = l00[q] * b0[q] + l01[q] * b1[q];
            t1 = l10[q] * b0[q] + l11[q] * b1[q];
            q--;
        }
        for (int k = 0; k < middle; k++, q--) {
            double x0 = b0[k] - s0;
            double x1 = b1[k] - s1;
            b0[k] = x0;
            b1[k] = x1;
            s0 = l00[k] * x0 + l01[k] * x1;
            s1 = l10[k] * x0 + l11[k] * x1;
            x0 = b0[q] - t0;
            x1 = b1[q] - t1;
            b0[q] = x0;
            b1[q] = x1;
            t0 = l00[q] * x0 + l01[q] * x1;
            t1 = l10[q] * x0 + l11[q] * x1;
        }
        b0[middle] -= s0 + t0;
        b1[middle] -= s1 + t1;
    }

    private void substitute() {
        double x0 = z0[middle];
        double x1 = z1[middle];
        double y0 = x0;
        double y1 = x1;
        lambdaX[middle + 1] = x0;
        lambdaY[middle + 1] = x1;
        int q = middle + 1;
        for (int k = middle - 1; k >= 0; k--, q++) {
            double w0 = z0[k] - (l00[k] * x0 + l10[k] * x1);
            x1 = z1[k] - (l01[k] * x0 + l11[k] * x1);
            x0 = w0;
            lambdaX[k + 1] = x0;
            lambdaY[k + 1] = x1;
            w0 = z0[q] - (l00[q] * y0 + l10[q] * y1);
            y1 = z1[q] - (l01[q] * y0 + l11[q] * y1);
            y0 = w0;
            lambdaX[q + 1] = y0;
            lambdaY[q + 1] = y1;
        }
        if (q < pins) {
            lambdaX[q + 1] = z0[q] - (l00[q] * y0 + l10[q] * y1);
            lambdaY[q + 1] = z1[q] - (l01[q] * y0 + l11[q] * y1);
        }
    }
}
