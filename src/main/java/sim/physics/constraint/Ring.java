// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import sim.physics.internal.Check;

/** A round wire. */
final class Ring implements Curve {
    private static final long serialVersionUID = 1L;

    private final double x;
    private final double y;
    private final double radius;

    Ring(double x, double y, double radius) {
        Joint.point("", x, y);
        this.x = x;
        this.y = y;
        this.radius = Check.positive("radius", radius);
    }

    @Override
    public void evaluate(double px, double py, double[] f) {
        double dx = px - x;
        double dy = py - y;
        f[0] = (dx * dx + dy * dy - radius * radius) / (2 * radius);
        f[1] = dx / radius;
        f[2] = dy / radius;
        f[3] = 1 / radius;
        f[4] = 0;
        f[5] = 1 / radius;
    }
}
