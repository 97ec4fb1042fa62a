// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

/**
 * Looks for the motion q = (v, ω) by which a load l would move a body that static friction holds: the one with the most
 * power l·q for the power D(q) that friction takes. The load is held if l·q ≤ D(q) for all q (Goyal, Ruina and
 * Papadopoulos 1991).
 *
 * <p>D is convex and homogeneous, and its gradient is the friction p(q). So it is minimised on the plane l·q = |l|, by
 * Newton's method with a line search; differences of p give the second derivatives. The minimum is found to second
 * order, so that the decision is right within 1e-11 of the load, or the accuracy of friction.
 */
final class WorstTwist {
    private static final int STEPS = 100;

    /** What Newton's method may still gain, relative to D, when the decision is made. */
    private static final double GAIN = 1e-12;

    /** Step of the differences, relative to the motion. */
    private static final double DIFFERENCE = 1e-6;

    private final FlatPatch patch;

    /** Friction torque of spinning in place for unit μN: the scale of torque. */
    private final double torqueScale;

    /** The motion, two directions in the plane, and the friction of motions. */
    private final double[] q = new double[3];

    private final double[] e1 = new double[3];
    private final double[] e2 = new double[3];
    private final double[] trial = new double[3];
    private final double[] p = new double[3];
    private final double[] p1 = new double[3];
    private final double[] p2 = new double[3];

    WorstTwist(FlatPatch patch, double torqueScale) {
        this.patch = patch;
        this.torqueScale = torqueScale;
    }

    /** Whether a load, for unit μs N, is held. */
    boolean holds(double fx, double fy, double torque) {
        double t = torque / torqueScale; // torque in units of its scale, spin in units of 1 / scale
        double load = Math.sqrt(fx * fx + fy * fy + t * t);
        start(fx / load, fy / load, t / load);
        double power = power(q, p);
        for (int k = 0; k < STEPS && power >= load; k++) {
            double g1 = dot(p, e1);
            double g2 = dot(p, e2);
            double d = DIFFERENCE * Math.sqrt(dot(q, q));
            move(d, 0);
            power(trial, p1);
            move(0, d);
            power(trial, p2);
            double h11 = (dot(p1, e1) - g1) / d;
            double h22 = (dot(p2, e2) - g2) / d;
            double h12 = 0.5 * (dot(p1, e2) - g2 + dot(p2, e1) - g1) / d;
            double det = h11 * h22 - h12 * h12;
            if (!(h11 > 0 && det > 0)) {
                h11 = Math.max(Math.abs(h11), Math.abs(h22)) + Math.abs(h12) + 1e-9;
                h22 = h11;
                h12 = 0;
                det = h11 * h11;
            }
            double s1 = (h12 * g2 - h22 * g1) / det;
            double s2 = (h12 * g1 - h11 * g2) / det;
            double gain = -(g1 * s1 + g2 * s2);
            if (gain <= GAIN * power) {
                return power - 0.5 * gain >= load;
            }
            double next = search(s1, s2, gain, power);
            if (next >= power) {
                break; // what is left to gain is below the rounding of friction
            }
            power = next;
        }
        return power >= load;
    }

    /** Sets the directions, and q to the worst motion if the limit surface were an ellipsoid: here, a sphere. */
    private void start(double nx, double ny, double nz) {
        q[0] = nx;
        q[1] = ny;
        q[2] = nz;
        double c = Math.sqrt(nx * nx + ny * ny);
        e1[0] = c == 0 ? 1 : -ny / c;
        e1[1] = c == 0 ? 0 : nx / c;
        e1[2] = 0;
        e2[0] = ny * e1[2] - nz * e1[1];
        e2[1] = nz * e1[0] - nx * e1[2];
        e2[2] = nx * e1[1] - ny * e1[0];
    }

    /** Takes the friction of a motion to out, and returns its power. */
    private double power(double[] twist, double[] out) {
        patch.slip(twist[0], twist[1], twist[2] / torqueScale, out);
        out[2] /= torqueScale;
        return dot(out, twist);
    }

    private void move(double a, double b) {
        for (int k = 0; k < 3; k++) {
            trial[k] = q[k] + a * e1[k] + b * e2[k];
        }
    }

    /** Halves the step until the power falls as it should; returns the power there. */
    private double search(double s1, double s2, double gain, double power) {
        double length = 1;
        double next;
        do {
            move(length * s1, length * s2);
            next = power(trial, p);
            length *= 0.5;
        } while (next > power - 1e-4 * length * gain && length > 1e-6);
        System.arraycopy(trial, 0, q, 0, 3);
        return next;
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
