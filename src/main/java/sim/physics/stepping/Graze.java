// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import sim.physics.motion.State;

/**
 * Whether two bodies pass one another that seem to meet: there is an edge that has all of the other body on its line or beyond it, but for what
 * contacts are deep, and it still has at the end of the step, while they meet along another direction only. So a box that slides over tiles, and is a
 * little deep in the one on which it lies, meets the next one with its corner, where the way out is shortest to the side.
 */
final class Graze implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Depth that is none, relative to the smaller body. */
    private static final double SHALLOW = 5e-3;

    /** Way in a step from which on they meet, relative to the smaller body. */
    private static final double NEGLIGIBLE = 1e-6;

    /** Cosine of the angle of two normals that are one. */
    private static final double SAME = 1 - 1e-6;

    private final State state;
    private final Poses poses;

    Graze(State state, Poses poses) {
        this.state = state;
        this.poses = poses;
    }

    /** Whether two bodies whose parts touch where was found pass one another in a step. */
    boolean passes(Touch touch, int a, Hull first, int b, Hull second, double h) {
        double size = Math.min(first.bounding, second.bounding);
        double closing = 0;
        for (int k = 0; k < touch.count; k++) {
            closing = Math.min(closing, opening(touch.nx, touch.ny, touch.px[k], touch.py[k], a, b));
        }
        if (closing * h > -NEGLIGIBLE * size) {
            return false;
        }
        double deep = SHALLOW * size;
        return passes(touch, a, first, b, second, 1, closing, h, deep) || passes(touch, b, second, a, first, -1, closing, h, deep);
    }

    /** The speed at which a point opens along a direction from the first body to the second one; it is given relative to the first one's centre. */
    private double opening(double nx, double ny, double x, double y, int a, int b) {
        double[] v = state.v();
        double[] at = state.x();
        int i = State.BLOCK * a;
        int k = State.BLOCK * b;
        double bx = x - (at[k] - at[i]);
        double by = y - (at[k + 1] - at[i + 1]);
        double ux = v[k] - by * v[k + 2] - v[i] + y * v[i + 2];
        double uy = v[k + 1] + bx * v[k + 2] - v[i + 1] - x * v[i + 2];
        return nx * ux + ny * uy;
    }

    private boolean passes(Touch touch, int owner, Hull on, int body, Hull other, int side, double closing, double h, double deep) {
        double[] at = state.x();
        double dx = at[State.BLOCK * body] - at[State.BLOCK * owner];
        double dy = at[State.BLOCK * body + 1] - at[State.BLOCK * owner + 1];
        double cos = poses.turns[2 * owner];
        double sin = poses.turns[2 * owner + 1];
        double otherCos = poses.turns[2 * body];
        double otherSin = poses.turns[2 * body + 1];
        for (int k = 0; k < on.count && on.count > 1; k++) {
            double nx = cos * on.nx[k] - sin * on.ny[k];
            double ny = sin * on.nx[k] + cos * on.ny[k];
            double turnedX = otherCos * nx + otherSin * ny;
            double turnedY = otherCos * ny - otherSin * nx;
            int lowest = other.lowest(turnedX, turnedY);
            double height = nx * dx + ny * dy + turnedX * other.x[lowest] + turnedY * other.y[lowest] - other.radius
                    - on.nx[k] * on.x[k] - on.ny[k] * on.y[k];
            if (height < -deep || side * (nx * touch.nx + ny * touch.ny) > SAME) {
                continue;
            }
            double x = dx + otherCos * other.x[lowest] - otherSin * other.y[lowest] - other.radius * nx;
            double y = dy + otherSin * other.x[lowest] + otherCos * other.y[lowest] - other.radius * ny;
            double opening = opening(nx, ny, x, y, owner, body);
            if (opening > closing && height + h * opening >= -deep) {
                return true;
            }
        }
        return false;
    }
}
