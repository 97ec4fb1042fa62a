// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import sim.physics.shape.Shape;

/**
 * Friction of a flat body that presses on a plane with uniform pressure (Goyal, Ruina and Papadopoulos 1991): each
 * element resists its own velocity, so the force of a unit of μN is −⟨v/|v|⟩ over the area, and the torque likewise.
 */
abstract class SurfacePatch implements Serializable {
    private static final long serialVersionUID = 1L;

    private final double[] unit = new double[State.BLOCK];

    static SurfacePatch of(Shape shape) {
        return shape.vertexCount() == 1 ? new DiscPatch(shape.radius()) : new PolygonPatch(shape);
    }

    /**
     * Force and torque for μN = 1, in world coordinates; zero for a body exactly at rest.
     *
     * @param out takes force x, force y and torque
     */
    abstract void friction(double vx, double vy, double omega, double theta, double[] out);

    /** The longest distance from the centre, a scale. */
    abstract double size();

    /**
     * Whether static friction holds a body at rest: its load lies within the limit surface, that is, no motion gains
     * more power from the load than friction takes from it.
     *
     * @param limit the largest friction force, μs N
     */
    final boolean holds(double fx, double fy, double torque, double theta, double limit) {
        double force = Math.sqrt(fx * fx + fy * fy);
        if (force > limit || Math.abs(torque) > limit * size()) {
            return false;
        }
        // by the triangle inequality friction of any motion takes at least limit · |v|
        return torque == 0 || limit > 0 && leastExcess(fx / limit, fy / limit, torque / limit, theta) >= 0;
    }

    /** Minimum over v of ⟨|v|⟩ − f·v − τω at |ω| = 1 / size, a convex function of v: Newton's method with a line search. */
    private double leastExcess(double fx, double fy, double torque, double theta) {
        double omega = Math.signum(torque) / size();
        double vx = 0;
        double vy = 0;
        double value = excess(fx, fy, torque, vx, vy, omega, theta);
        for (int k = 0; k < 60; k++) {
            double gx = -unit[0] - fx;
            double gy = -unit[1] - fy;
            double d = 1e-6;
            excess(fx, fy, torque, vx + d, vy, omega, theta);
            double hxx = Math.max(1e-9, (-unit[0] - fx - gx) / d);
            double hxy = (-unit[1] - fy - gy) / d;
            excess(fx, fy, torque, vx, vy + d, omega, theta);
            double hyy = Math.max(1e-9, (-unit[1] - fy - gy) / d);
            double det = Math.max(1e-3 * hxx * hyy, hxx * hyy - hxy * hxy);
            double sx = -(hyy * gx - hxy * gy) / det;
            double sy = -(hxx * gy - hxy * gx) / det;
            double length = 1;
            double next = excess(fx, fy, torque, vx + sx, vy + sy, omega, theta);
            while (next > value && length > 1e-9) {
                length *= 0.5;
                next = excess(fx, fy, torque, vx + length * sx, vy + length * sy, omega, theta);
            }
            if (!(next < value - 1e-15)) {
                return value;
            }
            vx += length * sx;
            vy += length * sy;
            value = next;
        }
        return value;
    }

    private double excess(double fx, double fy, double torque, double vx, double vy, double omega, double theta) {
        friction(vx, vy, omega, theta, unit);
        double taken = -(unit[0] * vx + unit[1] * vy + unit[2] * omega);
        return taken - fx * vx - fy * vy - torque * omega;
    }
}
