// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;
import sim.physics.internal.Check;
import sim.physics.motion.Body;
import sim.physics.motion.State;

/**
 * What a ray and a shape that moves straight on have in common: where they begin, where they go, and what they have met. Of bodies
 * at the same distance the one with the lower block is the first, in whatever order they are looked at.
 */
abstract class Walk {
    /** By which answers are sorted. */
    static final Comparator<Hit> NEARER =
            Comparator.comparingDouble(Hit::distance).thenComparingInt(hit -> hit.body().index());

    /** Makes up for rounding where a look at the circle only spares work. */
    static final double SLACK = 1 + 1e-12;

    final Census census;
    final Cells cells;

    double x;
    double y;

    /** Unit direction. */
    double dx;

    double dy;
    Predicate<? super Body> filter;

    /** Radius of what goes on; 0 for a ray. */
    double reach;

    /** Takes all that is met; null if only the first counts. */
    private List<Hit> all;

    /** What was met first, or null; how far on, or the range; the normal and the point there. */
    Body body;

    double distance;
    double nx;
    double ny;
    double hitX;
    double hitY;

    private int block;

    Walk(Census census, Cells cells) {
        this.census = census;
        this.cells = cells;
    }

    /** Checks where it goes, and begins. */
    final void begin(
            double fromX,
            double fromY,
            double directionX,
            double directionY,
            double range,
            Predicate<? super Body> which,
            List<Hit> takesAll) {
        Check.finite("x", fromX);
        Check.finite("y", fromY);
        double factor = Check.direction("directionX", directionX, "directionY", directionY);
        if (!(range >= 0)) {
            throw new IllegalArgumentException("range is " + range + ": it must not be negative");
        }
        double toX = factor * directionX;
        double toY = factor * directionY;
        double length = Math.sqrt(toX * toX + toY * toY);
        x = fromX;
        y = fromY;
        dx = toX / length;
        dy = toY / length;
        filter = which;
        all = takesAll;
        body = null;
        block = -1;
        distance = range;
    }

    /** Lets go of what is the author's. */
    final void end() {
        filter = null;
        all = null;
    }

    /** Whether the circle around what goes on comes to that around a body before the end; a ray does not come to that of none. */
    final boolean isNear(int i) {
        double[] at = census.state.x();
        double px = at[State.BLOCK * i] - x;
        double py = at[State.BLOCK * i + 1] - y;
        double radius = census.radii[i] + reach;
        double across = px * dy - py * dx;
        if (Math.abs(across) > radius) {
            return false;
        }
        double along = px * dx + py * dy;
        return along >= -radius && along - distance * SLACK <= radius;
    }

    /** Takes note of a body that is met. */
    final void take(Body met, int i, double d, double normalX, double normalY, double atX, double atY) {
        if (all != null) {
            all.add(new Hit(met, atX, atY, normalX, normalY, d));
        } else if (body == null || d < distance || d == distance && i < block) {
            body = met;
            block = i;
            distance = d;
            nx = normalX;
            ny = normalY;
            hitX = atX;
            hitY = atY;
        }
    }

    /** What was met first, or null. */
    final Hit hit() {
        return body == null ? null : new Hit(body, hitX, hitY, nx, ny, distance);
    }

    /** Puts the answer into an object of the author's; whether there is one. */
    final boolean into(RayHit hit) {
        boolean is = body != null;
        hit.set(body, is ? hitX : 0, is ? hitY : 0, is ? nx : 0, is ? ny : 0, distance);
        return is;
    }
}
