// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.references;

import java.math.BigDecimal;
import java.math.MathContext;

/**
 * A pendulum θ̈ = −w sin θ, θ from straight down, in elliptic functions: the arithmetic–geometric mean in 40 digits for
 * the period, descending Landen transformations for the amplitude. Good to a few units of the last place of a double
 * after any number of turns, as the time is reduced by the period in 40 digits.
 */
public final class EllipticPendulum {
    private static final MathContext MC = new MathContext(40);
    private static final BigDecimal TWO = BigDecimal.valueOf(2);
    private static final BigDecimal PI = new BigDecimal("3.141592653589793238462643383279502884197169399375");
    private static final int LEVELS = 12;

    private final boolean turning;
    private final double modulus;
    private final BigDecimal rate;
    private final BigDecimal quarter;
    private final BigDecimal phase;
    private final double sign;

    private EllipticPendulum(BigDecimal w, BigDecimal k2, boolean turning, double sign) {
        this.turning = turning;
        this.sign = sign;
        BigDecimal m = turning ? BigDecimal.ONE.divide(k2, MC) : k2;
        modulus = m.sqrt(MC).doubleValue();
        BigDecimal omega = w.sqrt(MC);
        rate = turning ? omega.multiply(k2.sqrt(MC), MC) : omega;
        quarter = PI.divide(TWO.multiply(mean(BigDecimal.ONE.subtract(m, MC).sqrt(MC)), MC), MC);
        phase = quarter;
    }

    /**
     * A pendulum that is let go at rest.
     *
     * @param w m g d / I about the pin, 1/time²
     * @param cosine of the angle at which it is let go, exact; the angle is positive
     * @return the motion
     */
    public static EllipticPendulum released(BigDecimal w, BigDecimal cosine) {
        return new EllipticPendulum(w, BigDecimal.ONE.subtract(cosine).divide(TWO, MC), false, 1);
    }

    /**
     * A pendulum that starts straight up and turns over.
     *
     * @param w m g d / I about the pin, 1/time²
     * @param omega its angular velocity there, not 0
     * @return the motion
     */
    public static EllipticPendulum overTheTop(BigDecimal w, double omega) {
        BigDecimal speed = new BigDecimal(omega);
        BigDecimal k2 = BigDecimal.ONE.add(
                speed.multiply(speed, MC).divide(w.multiply(BigDecimal.valueOf(4)), MC), MC);
        return new EllipticPendulum(w, k2, true, Math.signum(omega));
    }

    private static BigDecimal mean(BigDecimal complement) {
        BigDecimal a = BigDecimal.ONE;
        BigDecimal b = complement;
        for (int k = 0; k < LEVELS; k++) {
            BigDecimal next = a.add(b).divide(TWO, MC);
            b = a.multiply(b, MC).sqrt(MC);
            a = next;
        }
        return a;
    }

    /**
     * Time of a whole swing, or of a whole turn.
     *
     * @return 4 K / ω of a swing, 2 K / (k ω) of a turn
     */
    public double period() {
        return quarter.multiply(BigDecimal.valueOf(turning ? 2 : 4)).divide(rate, MC).doubleValue();
    }

    /**
     * The angle.
     *
     * @param t time
     * @return θ from straight down; of a turning pendulum within (−π, π]
     */
    public double angle(double t) {
        double phi = amplitude(argument(t));
        if (turning) {
            double theta = 2 * phi;
            return sign * (theta > Math.PI ? theta - 2 * Math.PI : theta);
        }
        return 2 * StrictMath.asin(modulus * StrictMath.sin(phi));
    }

    /**
     * The angular velocity.
     *
     * @param t time
     * @return θ̇
     */
    public double velocity(double t) {
        double phi = amplitude(argument(t));
        double sn = StrictMath.sin(phi);
        double factor = 2 * rate.doubleValue();
        return turning
                ? sign * factor * StrictMath.sqrt(1 - modulus * modulus * sn * sn)
                : factor * modulus * StrictMath.cos(phi);
    }

    /** The argument of sn, reduced to (−2K, 2K] in 40 digits. */
    private double argument(double t) {
        BigDecimal u = rate.multiply(new BigDecimal(t), MC).add(phase, MC);
        BigDecimal whole = quarter.multiply(BigDecimal.valueOf(4));
        BigDecimal rest = u.remainder(whole, new MathContext(60));
        return (rest.compareTo(quarter.multiply(TWO)) > 0 ? rest.subtract(whole) : rest).doubleValue();
    }

    /** The Jacobi amplitude by descending Landen transformations. */
    private double amplitude(double u) {
        double[] a = new double[LEVELS];
        double[] c = new double[LEVELS];
        a[0] = 1;
        double b = StrictMath.sqrt((1 - modulus) * (1 + modulus));
        c[0] = modulus;
        int n = 0;
        while (n < LEVELS - 1 && Math.abs(c[n]) > 1e-18) {
            a[n + 1] = (a[n] + b) / 2;
            c[n + 1] = c[n] * c[n] / (4 * a[n + 1]);
            b = StrictMath.sqrt(a[n] * b);
            n++;
        }
        double phi = StrictMath.scalb(a[n] * u, n);
        for (; n > 0; n--) {
            phi = (phi + StrictMath.asin(c[n] / a[n] * StrictMath.sin(phi))) / 2;
        }
        return phi;
    }
}
