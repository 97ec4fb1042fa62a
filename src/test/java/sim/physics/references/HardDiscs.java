// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.references;

/**
 * Elastic discs of radius r and mass 1 in a square, by events: all pairs are looked at after each impact, which is slow
 * and has nothing that could be wrong.
 */
public final class HardDiscs {
    private final double[] x;
    private final double[] y;
    private final double[] u;
    private final double[] v;
    private final double radius;
    private final double half;
    private double time;
    private long impacts;

    /**
     * A gas.
     *
     * @param x start
     * @param y start
     * @param u velocity
     * @param v velocity
     * @param radius of the discs
     * @param half the walls are at ±half
     */
    public HardDiscs(double[] x, double[] y, double[] u, double[] v, double radius, double half) {
        this.x = x.clone();
        this.y = y.clone();
        this.u = u.clone();
        this.v = v.clone();
        this.radius = radius;
        this.half = half;
    }

    /**
     * Goes on to a time.
     *
     * @param until not before now
     */
    public void run(double until) {
        while (true) {
            double soonest = until - time;
            int a = -1;
            int b = -1;
            for (int i = 0; i < x.length; i++) {
                double wx = wall(x[i], u[i]);
                double wy = wall(y[i], v[i]);
                if (wx < soonest) {
                    soonest = wx;
                    a = i;
                    b = -1;
                }
                if (wy < soonest) {
                    soonest = wy;
                    a = i;
                    b = -2;
                }
                for (int j = i + 1; j < x.length; j++) {
                    double s = meeting(i, j);
                    if (s < soonest) {
                        soonest = s;
                        a = i;
                        b = j;
                    }
                }
            }
            move(soonest);
            if (a < 0) {
                time = until;
                return;
            }
            bounce(a, b);
            impacts++;
        }
    }

    private double wall(double at, double speed) {
        return speed == 0 ? Double.POSITIVE_INFINITY : Math.max(0, (half - radius - Math.signum(speed) * at) / Math.abs(speed));
    }

    private double meeting(int i, int j) {
        double dx = x[j] - x[i];
        double dy = y[j] - y[i];
        double du = u[j] - u[i];
        double dv = v[j] - v[i];
        double approach = dx * du + dy * dv;
        if (approach >= 0) {
            return Double.POSITIVE_INFINITY;
        }
        double speed2 = du * du + dv * dv;
        double c = dx * dx + dy * dy - 4 * radius * radius;
        double cross = dx * dv - dy * du;
        double discriminant = 4 * radius * radius * speed2 - cross * cross;
        return discriminant < 0 ? Double.POSITIVE_INFINITY : Math.max(0, c / (-approach + StrictMath.sqrt(discriminant)));
    }

    private void move(double s) {
        for (int i = 0; i < x.length; i++) {
            x[i] += u[i] * s;
            y[i] += v[i] * s;
        }
        time += s;
    }

    private void bounce(int a, int b) {
        if (b == -1) {
            u[a] = -u[a];
        } else if (b == -2) {
            v[a] = -v[a];
        } else {
            double dx = x[b] - x[a];
            double dy = y[b] - y[a];
            double f = ((u[b] - u[a]) * dx + (v[b] - v[a]) * dy) / (dx * dx + dy * dy);
            u[a] += f * dx;
            v[a] += f * dy;
            u[b] -= f * dx;
            v[b] -= f * dy;
        }
    }

    /**
     * Number of impacts so far.
     *
     * @return with walls and with one another
     */
    public long impacts() {
        return impacts;
    }

    /**
     * A place.
     *
     * @param i disc
     * @return x, y
     */
    public double[] place(int i) {
        return new double[] {x[i], y[i]};
    }

    /**
     * Kinetic energy.
     *
     * @return Σ v²/2
     */
    public double energy() {
        double sum = 0;
        for (int i = 0; i < x.length; i++) {
            sum += (u[i] * u[i] + v[i] * v[i]) / 2;
        }
        return sum;
    }
}
