// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import sim.physics.internal.Check;

/** A straight wire. */
final class Line implements Curve {
    private static final long serialVersionUID = 1L;

    private final double x;
    private final double y;
    private final double nx;
    private final double ny;

    Line(double x, double y, double dx, double dy) {
        Joint.point("", x, y);
        double factor = Check.direction("dx", dx, "dy", dy);
        double toX = factor * dx;
        double toY = factor * dy;
        double length = Math.sqrt(toX * toX + toY * toY);
        this.x = x;
        this.y = y;
        nx = -toY / length;
        ny = toX / length;
    }

    @Override
    public void evaluate(double px, double py, double[] f) {
        f[0] = nx * (px - x) + ny * (py - y);
        f[1] = nx;
        f[2] = ny;
        f[3] = 0;
        f[4] = 0;
        f[5] = 0;
    }
}
