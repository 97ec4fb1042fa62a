// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.references;

import org.hipparchus.ode.ODEIntegrator;
import org.hipparchus.ode.ODEState;
import org.hipparchus.ode.OrdinaryDifferentialEquation;
import org.hipparchus.ode.nonstiff.DormandPrince853Integrator;
import org.hipparchus.ode.nonstiff.GraggBulirschStoerIntegrator;

/**
 * A row of n pinned uniform rods of length and mass 1, let go from the horizontal at x = 0 … n: Lagrange's equations in
 * the angles,
 *
 * <pre>
 *   Σ S_kl cos(θk − θl) θ̈l = −Σ S_kl sin(θk − θl) θ̇l² − g G_k cos θk,   S_kl = n − max(k, l) − 1/2 (k ≠ l), S_kk = n − k − 2/3
 * </pre>
 *
 * by Hipparchus' integrators.
 */
public final class RodChain implements OrdinaryDifferentialEquation {
    private final int n;
    private final double g;

    /**
     * A chain.
     *
     * @param n number of rods
     * @param g gravity, downwards
     */
    public RodChain(int n, double g) {
        this.n = n;
        this.g = g;
    }

    @Override
    public int getDimension() {
        return 2 * n;
    }

    @Override
    public double[] computeDerivatives(double t, double[] y) {
        double[][] m = new double[n][n + 1];
        for (int k = 0; k < n; k++) {
            m[k][n] = -g * (n - k - 0.5) * Math.cos(y[k]);
            for (int l = 0; l < n; l++) {
                double s = k == l ? n - k - 2.0 / 3 : n - Math.max(k, l) - 0.5;
                m[k][l] = s * Math.cos(y[k] - y[l]);
                m[k][n] -= s * Math.sin(y[k] - y[l]) * y[n + l] * y[n + l];
            }
        }
        double[] rates = new double[2 * n];
        System.arraycopy(y, n, rates, 0, n);
        solve(m);
        for (int k = 0; k < n; k++) {
            rates[n + k] = m[k][n];
        }
        return rates;
    }

    /** Gauss's elimination with pivots; the last column becomes the solution. */
    static void solve(double[][] m) {
        int n = m.length;
        for (int c = 0; c < n; c++) {
            int pivot = c;
            for (int r = c + 1; r < n; r++) {
                pivot = Math.abs(m[r][c]) > Math.abs(m[pivot][c]) ? r : pivot;
            }
            double[] row = m[pivot];
            m[pivot] = m[c];
            m[c] = row;
            for (int r = 0; r < n; r++) {
                double f = r == c ? 0 : m[r][c] / row[c];
                for (int k = c + 1; f != 0 && k <= n; k++) {
                    m[r][k] -= f * row[k];
                }
            }
        }
        for (int r = 0; r < n; r++) {
            m[r][n] /= m[r][r];
        }
    }

    /**
     * The angles.
     *
     * @param t times, ascending
     * @param gragg whether by Gragg, Bulirsch and Stoer, else by Dormand and Prince 8(5,3)
     * @param tolerance of the integrator
     * @return for each time the angles from the x axis, then their rates
     */
    public double[][] states(double[] t, boolean gragg, double tolerance) {
        return integrate(this, new double[2 * n], t, gragg, tolerance);
    }

    static double[][] integrate(
            OrdinaryDifferentialEquation equation, double[] start, double[] t, boolean gragg, double tolerance) {
        return integrate(equation, start, t, gragg, tolerance, 0.1);
    }

    static double[][] integrate(
            OrdinaryDifferentialEquation equation, double[] start, double[] t, boolean gragg, double tolerance, double most) {
        ODEIntegrator integrator = gragg
                ? new GraggBulirschStoerIntegrator(1e-12, most, tolerance, tolerance)
                : new DormandPrince853Integrator(1e-12, most, tolerance, tolerance);
        double[][] states = new double[t.length][];
        ODEState state = new ODEState(0, start);
        for (int k = 0; k < t.length; k++) {
            if (t[k] > state.getTime()) {
                state = integrator.integrate(equation, state, t[k]);
            }
            states[k] = state.getPrimaryState();
        }
        return states;
    }

    /**
     * The tip of a chain.
     *
     * @param angles of the rods
     * @return x, y
     */
    public double[] tip(double[] angles) {
        double x = 0;
        double y = 0;
        for (int k = 0; k < n; k++) {
            x += Math.cos(angles[k]);
            y += Math.sin(angles[k]);
        }
        return new double[] {x, y};
    }
}
