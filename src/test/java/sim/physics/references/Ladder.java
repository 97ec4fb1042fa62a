// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.references;

import org.hipparchus.ode.OrdinaryDifferentialEquation;

/**
 * A bar of mass 1 that slips between a smooth wall x = 0 and a smooth floor y = 0. Its length is 2 a, its width 2 b, and it
 * touches both with the corners of its lower side, φ that side's angle below the x axis to the right:
 *
 * <pre>
 *   x = a cos φ + b sin φ,   y = a sin φ + b cos φ
 * </pre>
 *
 * As long as both touch, (I + x′² + y′²) φ̈ = −(x′ x″ + y′ y″) φ̇² − g y′. It leaves the wall where ẍ = 0 (at
 * sin φ = ⅔ sin φ0 for b = 0); then ẋ stays as it is, and (I + y′²) φ̈ = −y′ y″ φ̇² − g y′.
 */
public final class Ladder {
    private final double a;
    private final double b;
    private final double inertia;
    private final double g;

    /**
     * A bar.
     *
     * @param a half its length
     * @param b half its width
     * @param inertia about its centre
     * @param g gravity
     */
    public Ladder(double a, double b, double inertia, double g) {
        this.a = a;
        this.b = b;
        this.inertia = inertia;
        this.g = g;
    }

    /** Centre, its derivatives by φ. */
    private double x(double angle, int derivative) {
        return turned(a, b, angle, derivative);
    }

    private double y(double angle, int derivative) {
        return turned(b, a, angle, derivative);
    }

    private static double turned(double p, double q, double angle, int derivative) {
        double sin = Math.sin(angle);
        double cos = Math.cos(angle);
        return derivative == 0 ? p * cos + q * sin : derivative == 1 ? q * cos - p * sin : -p * cos - q * sin;
    }

    private double pull(double angle, double rate, boolean onWall) {
        double wall = onWall ? 1 : 0;
        double mass = inertia + wall * x(angle, 1) * x(angle, 1) + y(angle, 1) * y(angle, 1);
        double bend = wall * x(angle, 1) * x(angle, 2) + y(angle, 1) * y(angle, 2);
        return -(bend * rate * rate + g * y(angle, 1)) / mass;
    }

    private double pressure(double[] state) {
        return x(state[0], 1) * pull(state[0], state[1], true) + x(state[0], 2) * state[1] * state[1];
    }

    private double[] after(double[] start, double t, boolean onWall, double tolerance) {
        OrdinaryDifferentialEquation equation = new OrdinaryDifferentialEquation() {
            @Override
            public int getDimension() {
                return 2;
            }

            @Override
            public double[] computeDerivatives(double time, double[] s) {
                return new double[] {s[1], pull(s[0], s[1], onWall)};
            }
        };
        return RodChain.integrate(equation, start, new double[] {t}, false, tolerance)[0];
    }

    /**
     * When it leaves the wall.
     *
     * @param angle φ at rest
     * @param tolerance of the integrator
     * @return time, φ and φ̇
     */
    public double[] leaves(double angle, double tolerance) {
        double[] start = {angle, 0};
        double low = 0;
        double high = 0.1;
        while (pressure(after(start, high, true, tolerance)) > 0) {
            low = high;
            high += 0.1;
        }
        for (int k = 0; k < 60; k++) {
            double middle = (low + high) / 2;
            if (pressure(after(start, middle, true, tolerance)) > 0) {
                low = middle;
            } else {
                high = middle;
            }
        }
        double[] state = after(start, low, true, tolerance);
        return new double[] {low, state[0], state[1]};
    }

    /**
     * Where it is.
     *
     * @param angle φ at time 0, at rest
     * @param t time, before its upper end is on the floor
     * @param tolerance of the integrator
     * @return centre and φ
     */
    public double[] place(double angle, double t, double tolerance) {
        double[] left = leaves(angle, tolerance);
        if (t <= left[0]) {
            double phi = after(new double[] {angle, 0}, t, true, tolerance)[0];
            return new double[] {x(phi, 0), y(phi, 0), phi};
        }
        double phi = after(new double[] {left[1], left[2]}, t - left[0], false, tolerance)[0];
        return new double[] {x(left[1], 0) + x(left[1], 1) * left[2] * (t - left[0]), y(phi, 0), phi};
    }
}
