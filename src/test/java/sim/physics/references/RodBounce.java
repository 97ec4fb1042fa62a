// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.references;

/**
 * A rectangle that falls without friction on the floor y = 0 and bounces elastically: parabola and constant spin
 * between impacts, whose times are roots found by sure steps and bisection.
 */
public final class RodBounce {
    private static final int GRID = 400;

    private final double g;
    private final double[] cornerX = new double[4];
    private final double[] cornerY = new double[4];
    private final double inertia;
    private double t;
    private double y;
    private double theta;
    private double v;
    private double omega;

    /**
     * A rectangle of mass 1 at rest.
     *
     * @param length of the rectangle
     * @param width of the rectangle, may be 0
     * @param inertia about the centre
     * @param height of the centre
     * @param angle of its length from the x axis
     * @param g gravity, downwards
     */
    public RodBounce(double length, double width, double inertia, double height, double angle, double g) {
        this.g = g;
        this.inertia = inertia;
        y = height;
        theta = angle;
        for (int k = 0; k < 4; k++) {
            cornerX[k] = (k & 1) == 0 ? length / 2 : -length / 2;
            cornerY[k] = (k & 2) == 0 ? width / 2 : -width / 2;
        }
    }

    private double gap(int corner, double s) {
        double angle = theta + omega * s;
        return y + v * s - g * s * s / 2
                + cornerX[corner] * StrictMath.sin(angle) + cornerY[corner] * StrictMath.cos(angle);
    }

    private double gapRate(int corner, double s) {
        double angle = theta + omega * s;
        return v - g * s
                + omega * (cornerX[corner] * StrictMath.cos(angle) - cornerY[corner] * StrictMath.sin(angle));
    }

    /**
     * Goes on to the next impact and over it, or to a time.
     *
     * @param until time to stop at
     * @return time of the impact, or infinity if there is none before
     */
    public double next(double until) {
        double pace = 1e-3 / (1 + Math.abs(omega));
        for (double s = 0; t + s < until; s += pace) {
            double end = Math.min(s + pace, until - t);
            int corner = lowest(end);
            if (gap(corner, end) < 0 && gapRate(corner, end) < 0) {
                double root = root(corner, s, end);
                advance(root);
                bounce(corner);
                return t;
            }
        }
        advance(until - t);
        return Double.POSITIVE_INFINITY;
    }

    private int lowest(double s) {
        int corner = 0;
        for (int k = 1; k < 4; k++) {
            corner = gap(k, s) < gap(corner, s) ? k : corner;
        }
        return corner;
    }

    private double root(int corner, double from, double to) {
        double low = from;
        double high = to;
        for (int k = 0; k < GRID && high > low; k++) {
            double middle = low + (high - low) / 2;
            if (middle == low || middle == high) {
                break;
            }
            if (gap(corner, middle) > 0 || gapRate(corner, middle) > 0) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    private void advance(double s) {
        y += v * s - g * s * s / 2;
        v -= g * s;
        theta += omega * s;
        t += s;
    }

    private void bounce(int corner) {
        double arm = cornerX[corner] * StrictMath.cos(theta) - cornerY[corner] * StrictMath.sin(theta);
        double impulse = -2 * (v + omega * arm) / (1 + arm * arm / inertia);
        v += impulse;
        omega += impulse * arm / inertia;
    }

    /**
     * Where it is.
     *
     * @return height of the centre and angle
     */
    public double[] pose() {
        return new double[] {y, theta};
    }

    /**
     * Energy.
     *
     * @return kinetic and potential
     */
    public double energy() {
        return v * v / 2 + inertia * omega * omega / 2 + g * y;
    }
}
