// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.references;

/** Motions in closed form, or by the recursion of their impacts. */
public final class ClosedForms {
    private ClosedForms() {}

    /**
     * Height of a ball that is dropped on the floor y = 0 and bounces, t_n = t_0 (1 + 2 Σ e^k).
     *
     * @param height from which its lowest point falls, at rest
     * @param e restitution
     * @param g gravity
     * @param t time
     * @return height of its lowest point
     */
    public static double bounce(double height, double e, double g, double t) {
        double fall = StrictMath.sqrt(2 * height / g);
        if (t <= fall) {
            return height - g * t * t / 2;
        }
        double speed = g * fall;
        double begin = fall;
        if (e == 1) {
            double s = StrictMath.IEEEremainder(t, 2 * fall);
            return height - g * s * s / 2;
        }
        while (speed > 1e-18) {
            speed *= e;
            double flight = 2 * speed / g;
            if (t < begin + flight) {
                double s = t - begin;
                return s * (speed - g * s / 2);
            }
            begin += flight;
        }
        return 0;
    }

    /**
     * A coordinate that is reflected at two walls, by unfolding.
     *
     * @param x start
     * @param v velocity
     * @param t time
     * @param half the walls are at −half and half
     * @return the coordinate
     */
    public static double folded(double x, double v, double t, double half) {
        double period = 4 * half;
        double u = StrictMath.IEEEremainder(x + half + v * t, period);
        return Math.abs(u) - half;
    }

    /**
     * Galperin's blocks without width: a small one at rest and a large one that comes in at speed 1, on a line with a
     * wall at 0. In coordinates scaled by the roots of the masses it is a straight line unfolded in a wedge.
     *
     * @param ratio of the masses
     * @param small place of the small block
     * @param large place of the large block
     * @param t time
     * @return places of the small and the large block
     */
    public static double[] blocks(double ratio, double small, double large, double t) {
        double root = StrictMath.sqrt(ratio);
        double wedge = StrictMath.atan(1 / root);
        double px = root * (large - t);
        double angle = StrictMath.atan2(small, px);
        double radius = StrictMath.sqrt(px * px + small * small);
        double folded = Math.abs(StrictMath.IEEEremainder(angle, 2 * wedge));
        return new double[] {radius * StrictMath.sin(folded), radius * StrictMath.cos(folded) / root};
    }

    /**
     * Number of impacts of Galperin's blocks.
     *
     * @param ratio of the masses
     * @return the digits of π for powers of 100
     */
    public static int blockImpacts(double ratio) {
        return (int) StrictMath.ceil(Math.PI / StrictMath.atan(1 / StrictMath.sqrt(ratio))) - 1;
    }

    /**
     * A damped oscillator x¨ + 2 ζ ω x˙ + ω² x = 0 that is let go at rest from 1.
     *
     * @param omega ω
     * @param zeta ζ, at most 1
     * @param t time
     * @return x
     */
    public static double oscillator(double omega, double zeta, double t) {
        double decay = StrictMath.exp(-zeta * omega * t);
        if (zeta == 1) {
            return decay * (1 + omega * t);
        }
        double root = StrictMath.sqrt(1 - zeta * zeta);
        return decay * (StrictMath.cos(root * omega * t) + zeta / root * StrictMath.sin(root * omega * t));
    }
}
