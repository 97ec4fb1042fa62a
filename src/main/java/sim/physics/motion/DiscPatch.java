// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

/**
 * A disc on a plane (Farkas, Bartels, Unger and Wolf 2003). With ε = v / (R |ω|), q the smaller of ε and 1/ε, and
 * complete elliptic integrals of parameter m = q²,
 *
 * <pre>
 *   ε ≤ 1:  F = 4/(3π) q (E + B),   T = 4/(9π) R ((3 − 2m) E + m B),    B = (E − (1 − m) K) / m
 *   ε ≥ 1:  F = 4/(3π) (E + B),     T = 4/(9π) R (E − (2 − 3m) B) / q
 * </pre>
 *
 * <p>These cancel for small m. The arithmetic-geometric mean (a, b) ← ((a + b)/2, √(ab)) from (1, √(1 − m)), with the
 * half differences c, gives K = π / (2a), B = K (½ − mσ) and E = K (1 − ½m − m²σ) by the sum of positive terms
 * σ = Σ 2ⁿ⁻¹ (cₙ/m)², n ≥ 1. With these the powers of m that cancel do so on paper, not in the computer, and no series
 * or table is needed.
 */
final class DiscPatch extends SurfacePatch {
    private static final long serialVersionUID = 1L;

    /** The mean converges quadratically: after this difference the next one is below rounding. */
    private static final double CONVERGED = 1e-9;

    /** Relative accuracy of the direction in which a load is tested; its effect is of second order. */
    private static final double DIRECTION = 1e-7;

    private static final double LARGEST_TORQUE = 2.0 / 3;

    DiscPatch(double radius) {
        super(radius);
    }

    @Override
    double mostTorque() {
        return LARGEST_TORQUE;
    }

    @Override
    void rub(double vx, double vy, double spin, double theta, double[] out) {
        double v = Math.sqrt(vx * vx + vy * vy);
        limit(v, Math.abs(spin), out);
        double force = out[0];
        out[0] = v == 0 ? 0 : -force * (vx / v);
        out[1] = v == 0 ? 0 : -force * (vy / v);
        out[2] *= -Math.signum(spin);
    }

    /**
     * Looks for the motion that the load drives most: there force and torque of friction are in the same ratio as those
     * of the load. As F / (T ε) grows from 3/2 to 4, that is between ε = f / (4τ) and f / (1.5τ). The secant method
     * with bisection's safety (Illinois).
     */
    @Override
    boolean carries(double fx, double fy, double torque) {
        double f = Math.sqrt(fx * fx + fy * fy);
        double t = Math.abs(torque);
        if (!(t <= LARGEST_TORQUE)) {
            return false;
        }
        if (f + t / LARGEST_TORQUE <= 1 || f == 0) {
            return true; // in the double cone of known points
        }
        double[] point = new double[State.BLOCK];
        double low = f / (4 * t);
        double high = f / (1.5 * t);
        double atLow = turn(low, f, t, point);
        double atHigh = turn(high, f, t, point);
        double e = low;
        for (int k = 0; k < 60 && high - low > DIRECTION * low; k++) {
            double next = atLow < 0 && atHigh > 0 ? low - atLow * (high - low) / (atHigh - atLow) : 0.5 * (low + high);
            boolean settled = Math.abs(next - e) <= DIRECTION * e;
            e = next;
            double at = turn(e, f, t, point);
            if (f * e + t > point[0] * e + point[2]) {
                return false; // this motion proves it
            }
            if (settled || at == 0) {
                break;
            }
            boolean below = at < 0;
            atLow = below ? at : 0.5 * atLow;
            atHigh = below ? 0.5 * atHigh : at;
            low = below ? e : low;
            high = below ? high : e;
        }
        return true;
    }

    /** Positive if friction at ε has more force in relation to torque than the load. */
    private static double turn(double e, double f, double t, double[] point) {
        limit(e, 1, point);
        return point[0] * t - point[2] * f;
    }

    /** The point of the limit surface for a motion: takes F to out[0] and T / R to out[2]. */
    private static void limit(double v, double rim, double[] out) {
        double fast = Math.max(v, rim);
        double slow = Math.min(v, rim);
        if (slow == fast) {
            out[0] = 8 / (3 * Math.PI);
            out[2] = 8 / (9 * Math.PI);
            return;
        }
        double q = slow / fast;
        double m = q * q;
        double b = Math.sqrt((fast - slow) * (fast + slow)) / fast;
        double a = 0.5 * (1 + b);
        double c = 0.5 / (1 + b); // divided by m, as it is throughout
        b = Math.sqrt(b);
        double sigma = c * c;
        for (double power = 2; m * c > CONVERGED * a; power *= 2) {
            double mean = 0.5 * (a + b);
            b = Math.sqrt(a * b);
            a = mean;
            c = m * c * c / (4 * a);
            sigma += power * c * c;
        }
        double force = (1 - m * (1 + 2 * sigma * (1 + m)) / 3) / a;
        if (v < rim) {
            out[0] = q * force;
            out[2] = 2 * (3 * (1 - m) + m * m * (1 - sigma * (4 - 2 * m))) / (9 * a);
        } else {
            out[0] = force;
            out[2] = 2 * q * (1 + 2 * sigma * (1 - 2 * m)) / (9 * a);
        }
    }
}
