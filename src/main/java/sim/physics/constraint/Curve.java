// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;

/**
 * A curve in the plane, given by the zeros of a function f: the wire of a {@link WireJoint}. The gradient of f must not vanish on
 * the curve. If |∇f| is about 1 near the curve, gaps are lengths.
 */
public interface Curve extends Serializable {
    /**
     * Evaluates f and its derivatives at a point.
     *
     * @param x x of the point, length
     * @param y y of the point, length
     * @param f array that takes f, ∂f/∂x, ∂f/∂y, ∂²f/∂x², ∂²f/∂x∂y, ∂²f/∂y²
     */
    void evaluate(double x, double y, double[] f);

    /**
     * Returns the straight line through a point, as y = x in (25).
     *
     * @param x x of a point on the line
     * @param y y of a point on the line
     * @param dx x of the direction, of any length but 0
     * @param dy y of the direction
     * @return a curve whose f is the distance, positive on one side and negative on the other
     */
    static Curve line(double x, double y, double dx, double dy) {
        return new Line(x, y, dx, dy);
    }

    /**
     * Returns the circle around a point.
     *
     * @param x x of the centre
     * @param y y of the centre
     * @param radius radius, greater than 0
     * @return a curve whose f is half the difference of the squared distance and r², over r
     */
    static Curve circle(double x, double y, double radius) {
        return new Ring(x, y, radius);
    }
}
