// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.references;

import org.hipparchus.ode.OrdinaryDifferentialEquation;

/**
 * A unit mass on a spring of length 1 with a damper, hung up at the origin: Lagrange's equations in the length r and the angle φ
 * from straight down.
 *
 * <pre>
 *   r̈ = r φ̇² + g cos φ − ω² (r − 1) − 2 ζ ω ṙ        φ̈ = −(g sin φ + 2 ṙ φ̇) / r
 * </pre>
 */
public final class ElasticPendulum implements OrdinaryDifferentialEquation {
    private final double omega;
    private final double zeta;
    private final double g;

    /**
     * A pendulum.
     *
     * @param omega ω of the spring
     * @param zeta damping ratio
     * @param g gravity
     */
    public ElasticPendulum(double omega, double zeta, double g) {
        this.omega = omega;
        this.zeta = zeta;
        this.g = g;
    }

    /**
     * A state at rest with the spring stretched as the weight wants it.
     *
     * @param angle from straight down
     * @return r, φ, and their rates
     */
    public double[] start(double angle) {
        return new double[] {1 + g * StrictMath.cos(angle) / (omega * omega), angle, 0, 0};
    }

    @Override
    public int getDimension() {
        return 4;
    }

    @Override
    public double[] computeDerivatives(double t, double[] y) {
        double r = y[0];
        double pull = omega * omega * (r - 1) + 2 * zeta * omega * y[2];
        return new double[] {
            y[2], y[3], r * y[3] * y[3] + g * Math.cos(y[1]) - pull, -(g * Math.sin(y[1]) + 2 * y[2] * y[3]) / r
        };
    }

    /**
     * The states.
     *
     * @param start at time 0
     * @param t times, ascending
     * @param gragg whether by Gragg, Bulirsch and Stoer, else by Dormand and Prince 8(5,3)
     * @param tolerance of the integrator
     * @return r, φ, and their rates for each time
     */
    public double[][] states(double[] start, double[] t, boolean gragg, double tolerance) {
        // explicit methods are unstable beyond
        return RodChain.integrate(this, start.clone(), t, gragg, tolerance, 1 / omega);
    }

    /**
     * Where the mass is.
     *
     * @param state one of {@link #states}
     * @return x, y
     */
    public static double[] place(double[] state) {
        return new double[] {state[0] * StrictMath.sin(state[1]), -state[0] * StrictMath.cos(state[1])};
    }
}
