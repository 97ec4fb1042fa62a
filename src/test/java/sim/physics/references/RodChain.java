// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.references;

import org.hipparchus.ode.ODEIntegrator;
import org.hipparchus.ode.ODEState;
import org.hipparchus.ode.OrdinaryDifferentialEquation;
import org.hipparchus.ode.nonstiff.DormandPrince853Integrator;
import org.hipparchus.ode.nonstiff.GraggBulirschStoerIntegrator;

/**
 * A row of n pinned uniform rods of length 1, let go from the horizontal at x = 0 … n, or struck as it hangs: Lagrange's
 * equations in the angles,
 *
 * <pre>
 *   Σ S_kl cos(θk − θl) θ̈l = −Σ S_kl sin(θk − θl) θ̇l² − g G_k cos θk
 *   G_k = m_k / 2 + Σ m_j (j &gt; k),   S_kl = G_max(k, l) (k ≠ l),   S_kk = G_k − m_k / 6
 * </pre>
 *
 * by Hipparchus' integrators.
 */
public final class RodChain implements OrdinaryDifferentialEquation {
    private final int n;
    private final double g;
    private final double[] masses;

    /** Of the rods beyond a rod's middle. */
    private final double[] beyond;

    /**
     * A chain of masses 1.
     *
     * @param n number of rods
     * @param g gravity, downwards
     */
    public RodChain(int n, double g) {
        this(ones(n), g);
    }

    /**
     * A chain.
     *
     * @param masses of the rods
     * @param g gravity, downwards
     */
    public RodChain(double[] masses, double g) {
        this.masses = masses.clone();
        this.g = g;
        n = masses.length;
        beyond = new double[n];
        double sum = 0;
        for (int k = n - 1; k >= 0; k--) {
            beyond[k] = sum + masses[k] / 2;
            sum += masses[k];
        }
    }

    private static double[] ones(int n) {
        double[] ones = new double[n];
        java.util.Arrays.fill(ones, 1);
        return ones;
    }

    private double share(int k, int l) {
        return k == l ? beyond[k] - masses[k] / 6 : beyond[Math.max(k, l)];
    }

    @Override
    public int getDimension() {
        return 2 * n;
    }

    @Override
    public double[] computeDerivatives(double t, double[] y) {
        double[][] m = new double[n][n + 1];
        for (int k = 0; k < n; k++) {
            m[k][n] = -g * beyond[k] * Math.cos(y[k]);
            for (int l = 0; l < n; l++) {
                double s = share(k, l);
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
            for (int r = c + 1; r < n; r++) {
                double f = m[r][c] / row[c];
                for (int k = c + 1; f != 0 && k <= n; k++) {
                    m[r][k] -= f * row[k];
                }
            }
        }
        for (int r = n - 1; r >= 0; r--) {
            for (int k = r + 1; k < n; k++) {
                m[r][n] -= m[r][k] * m[k][n];
            }
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

    /**
     * The state after a blow to the right on the chain as it hangs at rest: S ω = J b, with b what the angles do to the place
     * that is struck, and J of Newton's law of impact, J = (1 + e) v / (1 / m + b·S⁻¹ b).
     *
     * @param link that is struck
     * @param along how far from its upper end
     * @param mass of a ball that strikes
     * @param v speed of the ball
     * @param e restitution
     * @return the angles, their rates, and the speed of the ball
     */
    public double[] struck(int link, double along, double mass, double v, double e) {
        double[][] m = new double[n][n + 1];
        double[] b = new double[n];
        for (int k = 0; k < n; k++) {
            b[k] = k < link ? 1 : k == link ? along : 0;
            m[k][n] = b[k];
            for (int l = 0; l < n; l++) {
                m[k][l] = share(k, l);
            }
        }
        solve(m);
        double gives = 0;
        for (int k = 0; k < n; k++) {
            gives += b[k] * m[k][n];
        }
        double impulse = (1 + e) * v / (1 / mass + gives);
        double[] state = new double[2 * n + 1];
        for (int k = 0; k < n; k++) {
            state[k] = -Math.PI / 2;
            state[n + k] = impulse * m[k][n];
        }
        state[2 * n] = v - impulse / mass;
        return state;
    }

    /**
     * The angles.
     *
     * @param start angles and their rates at time 0
     * @param t times, ascending
     * @param gragg whether by Gragg, Bulirsch and Stoer, else by Dormand and Prince 8(5,3)
     * @param tolerance of the integrator
     * @return for each time the angles from the x axis, then their rates
     */
    public double[][] states(double[] start, double[] t, boolean gragg, double tolerance) {
        return integrate(this, start, t, gragg, tolerance);
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
        return end(angles, n - 1);
    }

    /**
     * The end of a rod.
     *
     * @param angles of the rods
     * @param rod its number
     * @return x, y
     */
    public double[] end(double[] angles, int rod) {
        double x = 0;
        double y = 0;
        for (int k = 0; k <= rod; k++) {
            x += Math.cos(angles[k]);
            y += Math.sin(angles[k]);
        }
        return new double[] {x, y};
    }
}
