// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.references;

/**
 * A disc of radius ½ and mass 3 that a constant force pushes along x against a square of side 1 and mass 2, which slides on a
 * plane with friction; the contact has none. RK4 for the equations of motion with a multiplier for C = n·(d − b) + 1 = 0, n the
 * square's axis, and Gauss's quadrature for the friction.
 */
public final class PushedBox {
    private static final double[] NODES = {
        -0.9602898564975363, -0.7966664774136267, -0.5255324099163290, -0.1834346424956498,
        0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363
    };
    private static final double[] WEIGHTS = {
        0.1012285362903763, 0.2223810344533745, 0.3137066458778873, 0.3626837833783620,
        0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763
    };

    private final double deceleration;
    private final double push;
    private final double[] start;

    /**
     * Makes it.
     *
     * @param deceleration that friction gives a square which does not turn, length/time²
     * @param push force on the disc
     * @param offset of the disc from the middle of the side
     */
    public PushedBox(double deceleration, double push, double offset) {
        this.deceleration = deceleration;
        this.push = push;
        this.start = new double[] {1, 0, 0, 0, offset, 1, 0, 0, 1, 0};
    }

    /**
     * Integrates.
     *
     * @param time to go
     * @param steps number of steps
     * @return positions of the square (x, y, θ) and of the disc (x, y), then their velocities
     */
    public double[] solve(double time, int steps) {
        double h = time / steps;
        double[] y = start.clone();
        for (int k = 0; k < steps; k++) {
            double[] k1 = rate(y);
            double[] k2 = rate(add(y, 0.5 * h, k1));
            double[] k3 = rate(add(y, 0.5 * h, k2));
            double[] k4 = rate(add(y, h, k3));
            for (int i = 0; i < y.length; i++) {
                y[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
            }
        }
        return y;
    }

    private static double[] add(double[] y, double h, double[] k) {
        double[] sum = y.clone();
        for (int i = 0; i < y.length; i++) {
            sum[i] += h * k[i];
        }
        return sum;
    }

    private double[] rate(double[] y) {
        double c = Math.cos(y[2]);
        double s = Math.sin(y[2]);
        double[] f = friction(y[5], y[6], y[7], c, s);
        double inertia = 2.0 / 6;
        double dx = y[3] - y[0];
        double dy = y[4] - y[1];
        double vx = y[8] - y[5];
        double vy = y[9] - y[6];
        double w = y[7];
        // C = n·d + 1 with n = (c, s): C' = n·v + ω t·d, t = (−s, c); the multiplier pushes the disc along n
        double arm = -s * dx + c * dy;
        double bias = 2 * w * (-s * vx + c * vy) - w * w * (c * dx + s * dy);
        double ax = push / 3 - f[0] / 2;
        double ay = -f[1] / 2;
        double alpha = f[2] / inertia;
        double lambda = -(c * ax + s * ay + arm * alpha + bias) / (1.0 / 3 + 1.0 / 2 + arm * arm / inertia);
        return new double[] {
            y[5], y[6], y[7], y[8], y[9],
            f[0] / 2 - lambda * c / 2, f[1] / 2 - lambda * s / 2, alpha + lambda * arm / inertia,
            push / 3 + lambda * c / 3, lambda * s / 3
        };
    }

    /** Force and torque of the plane: −μ m g times the means of v/|v| and r × v/|v| over the square. */
    private double[] friction(double vx, double vy, double omega, double c, double s) {
        double[] f = new double[3];
        for (int i = 0; i < 8; i++) {
            for (int j = 0; j < 8; j++) {
                double rx = 0.5 * (c * NODES[i] - s * NODES[j]);
                double ry = 0.5 * (s * NODES[i] + c * NODES[j]);
                double ux = vx - omega * ry;
                double uy = vy + omega * rx;
                double size = Math.hypot(ux, uy);
                double share = -2 * deceleration * WEIGHTS[i] * WEIGHTS[j] / 4 / size;
                f[0] += share * ux;
                f[1] += share * uy;
                f[2] += share * (rx * uy - ry * ux);
            }
        }
        return f;
    }
}
