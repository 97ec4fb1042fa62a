// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import java.util.Comparator;
import sim.physics.internal.Trig;
import sim.physics.motion.Body;

/** A field of view: whether the centres of bodies are in it, and which of them is nearer to the eye. */
final class Sight implements Comparator<Body> {
    private final double x;
    private final double y;
    private final double range;
    private final double cos;
    private final double sin;
    private final double edge;

    /** From the eye to the body that was looked at last. */
    double dx;

    double dy;
    double far;

    Sight(double x, double y, double direction, double halfAngle, double range) {
        this.x = x;
        this.y = y;
        this.range = range;
        cos = Trig.cos(direction);
        sin = Trig.sin(direction);
        edge = Trig.cos(halfAngle);
    }

    boolean holds(Body body) {
        dx = body.getX() - x;
        dy = body.getY() - y;
        far = Math.sqrt(dx * dx + dy * dy);
        return far <= range && dx * cos + dy * sin >= edge * far;
    }

    @Override
    public int compare(Body a, Body b) {
        return Double.compare(square(a), square(b));
    }

    private double square(Body b) {
        return (b.getX() - x) * (b.getX() - x) + (b.getY() - y) * (b.getY() - y);
    }
}
