// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;

/**
 * Friction of a body that slides more than it spins: its instantaneous centre is far away. With the plane as the
 * complex numbers, the velocity at z is u + iωz = u (1 + wz) with w = iω/u, so by the binomial series
 *
 * <pre>
 *   ⟨v/|v|⟩     = û Σ αⱼ βₖ wʲ w̄ᵏ ⟨zʲ z̄ᵏ⟩        (1 + x)^½  = Σ αⱼ xʲ
 *   ⟨z × v/|v|⟩ = Im û Σ αⱼ βₖ wʲ w̄ᵏ ⟨zʲ z̄ᵏ⁺¹⟩   (1 + x)^−½ = Σ βₖ xᵏ
 * </pre>
 *
 * <p>The moments ⟨zʲ z̄ᵏ⟩ of a polygon are sums over the triangles that its edges make with the centroid: along the
 * rays they are integrated in closed form, along the edge by Gauss's quadrature, which is exact for this degree.
 */
final class FarMotion implements Serializable {
    private static final long serialVersionUID = 1L;

    /** For |wz| ≤ 1/16 the first term left out is below 1e-14. */
    private static final int DEGREE = 10;

    /** Bits to which the series is summed. */
    private static final int BITS = 48;

    private static final double[] ALPHA = binomial(0.5);
    private static final double[] BETA = binomial(-0.5);

    // spotless:off
    /** Gauss's quadrature on [0, 1], exact to degree 11 = DEGREE + 1. */
    private static final double[] NODE = {
        0.033765242898423986, 0.16939530676686774, 0.3806904069584015,
        0.6193095930415985,   0.8306046932331323,  0.966234757101576
    };
    private static final double[] WEIGHT = {
        0.08566224618958517, 0.1803807865240693, 0.23395696728634552,
        0.23395696728634552, 0.1803807865240693, 0.08566224618958517
    };
    // spotless:on

    /** Real and imaginary parts of ⟨zʲ z̄ᵏ⟩, rows j of k = 0 … DEGREE + 1 − j. */
    private final double[] moment = new double[(DEGREE + 2) * (DEGREE + 3)];

    /** For vertices x0, y0, x1, y1 … of at most about 1, counter-clockwise around the centroid. */
    FarMotion(double[] xy, double area) {
        double[] power = new double[2 * DEGREE + 4];
        for (int k = 0; k < xy.length; k += 2) {
            int next = (k + 2) % xy.length;
            double share = (xy[k] * xy[next + 1] - xy[k + 1] * xy[next]) / area;
            for (int i = 0; i < NODE.length; i++) {
                double x = xy[k] + NODE[i] * (xy[next] - xy[k]);
                double y = xy[k + 1] + NODE[i] * (xy[next + 1] - xy[k + 1]);
                addPowers(x, y, share * WEIGHT[i], power);
            }
        }
        set(0, 0, 1);
        set(0, 1, 0); // the centroid
        set(1, 0, 0);
    }

    private static double[] binomial(double exponent) {
        double[] c = new double[DEGREE + 1];
        c[0] = 1;
        for (int k = 1; k < c.length; k++) {
            c[k] = c[k - 1] * (exponent - k + 1) / k;
        }
        return c;
    }

    /** Index of the first moment of row j. */
    private static int row(int j) {
        return j * (2 * DEGREE + 5 - j);
    }

    private void set(int j, int k, double value) {
        moment[row(j) + 2 * k] = value;
        moment[row(j) + 2 * k + 1] = 0;
    }

    private void addPowers(double x, double y, double weight, double[] power) {
        power[0] = 1;
        power[1] = 0;
        for (int n = 2; n < power.length; n += 2) {
            power[n] = power[n - 2] * x - power[n - 1] * y;
            power[n + 1] = power[n - 2] * y + power[n - 1] * x;
        }
        for (int j = 0; j <= DEGREE + 1; j++) {
            for (int k = 0; j + k <= DEGREE + 1; k++) {
                double re = power[2 * j] * power[2 * k] + power[2 * j + 1] * power[2 * k + 1];
                double im = power[2 * j + 1] * power[2 * k] - power[2 * j] * power[2 * k + 1];
                moment[row(j) + 2 * k] += weight * re / (j + k + 2);
                moment[row(j) + 2 * k + 1] += weight * im / (j + k + 2);
            }
        }
    }

    /**
     * Sets out to friction.
     *
     * @param vx velocity in any frame, not zero with vy
     * @param ux the same in the body's frame
     */
    void friction(double vx, double vy, double ux, double uy, double spin, double[] out) {
        double speed = Math.sqrt(vx * vx + vy * vy);
        double wx = spin * (uy / speed) / speed;
        double wy = spin * (ux / speed) / speed;
        int bits = Math.max(1, -1 - Math.getExponent(Math.max(Math.abs(wx), Math.abs(wy))));
        int degree = Math.min(DEGREE, 1 + BITS / bits);
        double fx = 0;
        double fy = 0;
        double tx = 0;
        double ty = 0;
        for (int j = degree; j >= 0; j--) {
            double rowFx = 0;
            double rowFy = 0;
            double rowTx = 0;
            double rowTy = 0;
            for (int k = degree - j, at = row(j) + 2 * k; k >= 0; k--, at -= 2) {
                double re = rowFx * wx + rowFy * wy + BETA[k] * moment[at];
                rowFy = rowFy * wx - rowFx * wy + BETA[k] * moment[at + 1];
                rowFx = re;
                re = rowTx * wx + rowTy * wy + BETA[k] * moment[at + 2];
                rowTy = rowTy * wx - rowTx * wy + BETA[k] * moment[at + 3];
                rowTx = re;
            }
            double re = fx * wx - fy * wy + ALPHA[j] * rowFx;
            fy = fx * wy + fy * wx + ALPHA[j] * rowFy;
            fx = re;
            re = tx * wx - ty * wy + ALPHA[j] * rowTx;
            ty = tx * wy + ty * wx + ALPHA[j] * rowTy;
            tx = re;
        }
        out[0] = -(fx * (vx / speed) - fy * (vy / speed));
        out[1] = -(fx * (vy / speed) + fy * (vx / speed));
        out[2] = -(tx * (uy / speed) + ty * (ux / speed));
    }
}
