// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

/**
 * A disc on a plane (Farkas, Bartels, Unger and Wolf, <i>Frictional coupling between sliding and spinning motion</i>,
 * 2003): with ε = v / (R |ω|) and complete elliptic integrals of parameter m = ε² or 1/ε²,
 *
 * <pre>
 *   ε ≤ 1:  F = 4/(3π) ((1 + m) E − (1 − m) K) / ε,      T = 4/(9π) R ((4 − 2m) E − (1 − m) K)
 *   ε ≥ 1:  F = 4/(3π) ((1 + 1/m) E − (1/m − 1) K),      T = 4/(9π) R ε ((4 − 2/m) E + (2/m − 5 + 3m) K)
 * </pre>
 *
 * <p>For small m the sums cancel and are taken from their power series.
 */
final class DiscPatch extends SurfacePatch {
    private static final long serialVersionUID = 1L;

    private static final int TERMS = 16;
    private static final double SERIES_BELOW = 0.06;

    /** Coefficients of 2/π K(m) and 2/π E(m). */
    private static final double[] KM = new double[TERMS + 2];

    private static final double[] EM = new double[TERMS + 2];

    static {
        double root = 1;
        for (int k = 0; k < KM.length; k++) {
            KM[k] = root * root;
            EM[k] = -KM[k] / (2 * k - 1);
            root *= (2 * k + 1) / (2 * k + 2.0);
        }
    }

    private final double radius;
    private double first;
    private double second;

    DiscPatch(double radius) {
        this.radius = radius;
    }

    @Override
    double size() {
        return radius;
    }

    @Override
    void friction(double vx, double vy, double omega, double theta, double[] out) {
        double v = Math.sqrt(vx * vx + vy * vy);
        double rim = radius * Math.abs(omega);
        out[0] = 0;
        out[1] = 0;
        out[2] = 0;
        if (v == 0 && rim == 0) {
            return;
        }
        double force;
        double torque;
        if (v <= rim) {
            double e = v / rim;
            force = slowForce(e);
            torque = 4 / (9 * Math.PI) * ((4 - 2 * e * e) * second - (1 - e * e) * first);
        } else {
            double q = rim / v;
            force = fastForce(q * q);
            torque = fastTorque(q);
        }
        if (v > 0) {
            out[0] = -force * vx / v;
            out[1] = -force * vy / v;
        }
        out[2] = -Math.signum(omega) * radius * torque;
    }

    private double slowForce(double e) {
        double m = e * e;
        elliptic(m);
        if (m >= SERIES_BELOW) {
            return 4 / (3 * Math.PI) * ((1 + m) * second - (1 - m) * first) / e;
        }
        double sum = 0;
        for (int j = TERMS; j >= 1; j--) {
            sum = sum * m + (EM[j] + EM[j - 1] + KM[j - 1] - KM[j]);
        }
        return 2.0 / 3 * e * sum;
    }

    private double fastForce(double m) {
        if (m >= SERIES_BELOW) {
            elliptic(m);
            return 4 / (3 * Math.PI) * ((1 + 1 / m) * second - (1 / m - 1) * first);
        }
        double sum = 0;
        for (int j = TERMS; j >= 0; j--) {
            sum = sum * m + (EM[j + 1] + EM[j] - KM[j + 1] + KM[j]);
        }
        return 2.0 / 3 * sum;
    }

    private double fastTorque(double q) {
        double m = q * q;
        if (m >= SERIES_BELOW) {
            return 4 / (9 * Math.PI) / q * ((4 - 2 / m) * second + (2 / m - 5 + 3 * m) * first);
        }
        double sum = 0;
        for (int j = TERMS; j >= 1; j--) {
            sum = sum * m + (4 * EM[j] - 2 * EM[j + 1] + 2 * KM[j + 1] - 5 * KM[j] + 3 * KM[j - 1]);
        }
        return 2.0 / 9 * q * sum;
    }

    /** K(m) and E(m) by the arithmetic-geometric mean; at m = 1, where K is infinite, (1 − m) K = 0 is wanted. */
    private void elliptic(double m) {
        if (m == 1) {
            first = 0;
            second = 1;
            return;
        }
        double a = 1;
        double b = Math.sqrt(1 - m);
        double c2 = m;
        double sum = 0.5 * c2;
        for (double power = 1; Math.abs(a - b) > 1e-15 * a && power < 1e9; power *= 2) {
            double next = 0.5 * (a + b);
            double c = 0.5 * (a - b);
            b = Math.sqrt(a * b);
            a = next;
            sum += power * c * c;
        }
        first = 0.5 * Math.PI / a;
        second = first * (1 - sum);
    }
}
