// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;

/**
 * A curve in the plane, as the zeros of a function f: the wire of a {@link WireJoint}. The gradient of f must not vanish
 * on the curve; near it, |∇f| about 1 makes gaps lengths.
 */
public interface Curve extends Serializable {
    /**
     * Evaluates f and its derivatives at a point.
     *
     * @param x length
     * @param y length
     * @param f takes f, ∂f/∂x, ∂f/∂y, ∂²f/∂x², ∂²f/∂x∂y, ∂²f/∂y²
     */
    void evaluate(double x, double y, double[] f);

    /**
     * The straight line through a point, as y = x in (25).
     *
     * @param x a point
     * @param y a point
     * @param dx direction, of any length but 0
     * @param dy direction
     * @return f is the distance
     */
    static Curve line(double x, double y, double dx, double dy) {
        return new Line(x, y, dx, dy);
    }

    /**
     * The circle around a point.
     *
     * @param x centre
     * @param y centre
     * @param radius greater than 0
     * @return f is half the difference of the squared distance and r², over r
     */
    static Curve circle(double x, double y, double radius) {
        return new Ring(x, y, radius);
    }
}
