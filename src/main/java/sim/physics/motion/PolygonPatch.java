// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.internal.Trig;
import sim.physics.shape.Shape;

/**
 * A convex polygon on a plane. Around the instantaneous centre c the velocities are ω (r − c)⊥, and by Gauss's theorem
 * the integrals over the area are integrals over the edges,
 *
 * <pre>
 *   ∫ (r − c)/|r − c| dA = Σ n I,    ∫ |r − c| dA = ⅓ Σ d I,    I = ∫ |r − c| ds = ½ [s √(d² + s²) + d² asinh(s/d)]
 * </pre>
 *
 * <p>with n the normal of an edge and d the distance of its line from c. Where the centre is far away, and the sums
 * would cancel, Gauss's quadrature over triangles is used.
 */
final class PolygonPatch extends SurfacePatch {
    private static final long serialVersionUID = 1L;

    /** Distance of the centre, relative to the size, from which quadrature is used. */
    private static final double FAR = 6;

    // spotless:off
    private static final double[] NODE = {
        -0.9602898564975363, -0.7966664774136267, -0.5255324099163290, -0.1834346424956498,
         0.1834346424956498,  0.5255324099163290,  0.7966664774136267,  0.9602898564975363
    };
    private static final double[] WEIGHT = {
        0.1012285362903763, 0.2223810344533745, 0.3137066458778873, 0.3626837833783620,
        0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763
    };
    // spotless:on

    private final double[] xy;
    private final double area;
    private final double size;
    private double fx;
    private double fy;
    private double torque;

    PolygonPatch(Shape shape) {
        xy = shape.copyVertices();
        area = shape.area();
        size = shape.boundingRadius();
    }

    @Override
    double size() {
        return size;
    }

    @Override
    void friction(double vx, double vy, double omega, double theta, double[] out) {
        double cos = Trig.cos(theta);
        double sin = Trig.sin(theta);
        double ux = cos * vx + sin * vy; // in the body's own frame
        double uy = cos * vy - sin * vx;
        double speed = Math.sqrt(ux * ux + uy * uy);
        fx = 0;
        fy = 0;
        torque = 0;
        if (speed <= FAR * size * Math.abs(omega)) {
            if (omega != 0) {
                near(-uy / omega, ux / omega, Math.signum(omega));
            }
        } else if (omega == 0) {
            fx = -ux / speed;
            fy = -uy / speed;
        } else {
            far(ux, uy, omega);
        }
        out[0] = cos * fx - sin * fy;
        out[1] = sin * fx + cos * fy;
        out[2] = torque;
    }

    private void near(double cx, double cy, double sign) {
        double sumX = 0;
        double sumY = 0;
        double sumD = 0;
        for (int k = 0; k < xy.length; k += 2) {
            int next = (k + 2) % xy.length;
            double ex = xy[next] - xy[k];
            double ey = xy[next + 1] - xy[k + 1];
            double length = Math.sqrt(ex * ex + ey * ey);
            double tx = ex / length;
            double ty = ey / length;
            double ax = xy[k] - cx;
            double ay = xy[k + 1] - cy;
            double d = ax * ty - ay * tx; // the outward normal is (ty, -tx)
            double from = ax * tx + ay * ty;
            double integral = primitive(from + length, Math.abs(d)) - primitive(from, Math.abs(d));
            sumX += ty * integral;
            sumY -= tx * integral;
            sumD += d * integral;
        }
        fx = sign * sumY / area;
        fy = -sign * sumX / area;
        torque = -sign * (sumD / 3 + cx * sumX + cy * sumY) / area;
    }

    /** ½ [s √(d² + s²) + d² asinh(s/d)], odd in s. */
    private static double primitive(double s, double d) {
        double a = Math.abs(s);
        double root = Math.sqrt(d * d + a * a);
        double value = 0.5 * (a * root + (d == 0 ? 0 : d * d * StrictMath.log1p(a / d * (1 + a / (root + d)))));
        return s < 0 ? -value : value;
    }

    private void far(double ux, double uy, double omega) {
        for (int k = 2; k + 3 < xy.length; k += 2) {
            double ax = xy[k] - xy[0];
            double ay = xy[k + 1] - xy[1];
            double bx = xy[k + 2] - xy[0];
            double by = xy[k + 3] - xy[1];
            double jacobian = (ax * by - ay * bx) / (4 * area);
            for (int i = 0; i < NODE.length; i++) {
                double p = 0.5 * (1 + NODE[i]);
                for (int j = 0; j < NODE.length; j++) {
                    double q = 0.5 * (1 + NODE[j]);
                    double x = xy[0] + p * (ax + q * (bx - ax));
                    double y = xy[1] + p * (ay + q * (by - ay));
                    rub(x, y, ux - omega * y, uy + omega * x, p * jacobian * WEIGHT[i] * WEIGHT[j]);
                }
            }
        }
    }

    private void rub(double x, double y, double vx, double vy, double weight) {
        double share = weight / Math.sqrt(vx * vx + vy * vy);
        fx -= share * vx;
        fy -= share * vy;
        torque -= share * (x * vy - y * vx);
    }
}
