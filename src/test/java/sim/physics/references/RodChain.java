// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.references;

import org.hipparchus.linear.CholeskyDecomposition;
import org.hipparchus.linear.MatrixUtils;
import org.hipparchus.linear.RealMatrix;
import org.hipparchus.ode.ODEState;
import org.hipparchus.ode.OrdinaryDifferentialEquation;
import org.hipparchus.ode.nonstiff.GraggBulirschStoerIntegrator;

/**
 * A chain of uniform rods of 1 m and 1 kg that hangs in a pin at the origin, let go from the horizontal: Lagrange's equations
 * in the angles θ of the rods from the x axis, by another library's extrapolation method.
 *
 * <pre>
 *   Σⱼ aᵢⱼ (cos(θᵢ − θⱼ) θ″ⱼ + sin(θᵢ − θⱼ) θ′ⱼ²) + g bᵢ cos θᵢ = 0,
 *   aᵢᵢ = n − 1 − i + 1/3,   aᵢⱼ = n − 1 − max(i, j) + 1/2,   bᵢ = n − 1 − i + 1/2
 * </pre>
 */
public final class RodChain implements OrdinaryDifferentialEquation {
    /** Acceleration of gravity. */
    public static final double G = 9.81;

    private static final double TOLERANCE = 1e-15;

    private final int n;

    private RodChain(int n) {
        this.n = n;
    }

    /**
     * Where the end of the chain is.
     *
     * @param rods their number
     * @param time since it was let go
     * @return x, y
     */
    public static double[] tip(int rods, double time) {
        return tip(rods, time, TOLERANCE);
    }

    static double[] tip(int rods, double time, double tolerance) {
        RodChain chain = new RodChain(rods);
        GraggBulirschStoerIntegrator method = new GraggBulirschStoerIntegrator(1e-9, 0.1, tolerance, tolerance);
        double[] end = method.integrate(chain, new ODEState(0, new double[2 * rods]), time).getPrimaryState();
        double[] tip = new double[2];
        for (int i = 0; i < rods; i++) {
            tip[0] += StrictMath.cos(end[i]);
            tip[1] += StrictMath.sin(end[i]);
        }
        return tip;
    }

    @Override
    public int getDimension() {
        return 2 * n;
    }

    @Override
    public double[] computeDerivatives(double t, double[] y) {
        RealMatrix mass = MatrixUtils.createRealMatrix(n, n);
        double[] right = new double[n];
        for (int i = 0; i < n; i++) {
            right[i] = -G * (n - 1 - i + 0.5) * StrictMath.cos(y[i]);
            for (int j = 0; j < n; j++) {
                double a = i == j ? n - 1 - i + 1.0 / 3 : n - 1 - Math.max(i, j) + 0.5;
                mass.setEntry(i, j, a * StrictMath.cos(y[i] - y[j]));
                right[i] -= a * StrictMath.sin(y[i] - y[j]) * y[n + j] * y[n + j];
            }
        }
        double[] second = new CholeskyDecomposition(mass, 1e-12, 1e-14)
                .getSolver()
                .solve(MatrixUtils.createRealVector(right))
                .toArray();
        double[] slope = new double[2 * n];
        System.arraycopy(y, n, slope, 0, n);
        System.arraycopy(second, 0, slope, n, n);
        return slope;
    }
}
