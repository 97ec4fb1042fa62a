// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.references;

import org.hipparchus.special.elliptic.jacobi.JacobiEllipticBuilder;
import org.hipparchus.special.elliptic.legendre.LegendreEllipticIntegral;

/** A pendulum let go from the horizontal, in Jacobi's elliptic functions of modulus k² = 1/2. */
public final class Swing {
    private static final double QUARTER = LegendreEllipticIntegral.bigK(0.5);

    private Swing() {}

    /**
     * Its angle from straight down.
     *
     * @param omega0 √(weight · arm / inertia about the pin), 1/time
     * @param time since it was let go
     * @return rad, π/2 at first
     */
    public static double angle(double omega0, double time) {
        double phase = omega0 * time % (4 * QUARTER); // a full swing
        return 2 * StrictMath.asin(
                StrictMath.sqrt(0.5) * JacobiEllipticBuilder.build(0.5).valuesN(QUARTER - phase).sn());
    }

    /**
     * The time of a quarter of a full swing.
     *
     * @param omega0 as above
     * @return time from the horizontal to straight down
     */
    public static double quarter(double omega0) {
        return QUARTER / omega0;
    }
}
