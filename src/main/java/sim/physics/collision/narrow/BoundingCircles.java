// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.broad.Boxes;
import sim.physics.collision.broad.Pairs;
import sim.physics.internal.Tolerances;
import sim.physics.motion.Trajectories;

/**
 * When the bounding circles of two bodies on parabolas of equal acceleration meet: the root of a quadratic. It settles most
 * pairs, and is the contact itself where both bodies are circles.
 */
final class BoundingCircles implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Part of the time to a wall's box after which the search begins, so that rounding does not make it late. */
    private static final double BEFORE = 1 - 0x1p-20;

    private static final long INFINITE = Double.doubleToRawLongBits(Double.POSITIVE_INFINITY);

    private final Trajectories trajectories;
    private final ShapeTable shapes;
    private final Boxes boxes;

    /** Whether the last two bodies are circles that touch and approach at the offset that was found. */
    boolean touching;

    private double[] starts = new double[16];

    BoundingCircles(Trajectories trajectories, ShapeTable shapes, Boxes boxes) {
        this.trajectories = trajectories;
        this.shapes = shapes;
        this.boxes = boxes;
    }

    /**
     * When the circle of a body that moves uniformly meets those of its partners, which do so too.
     *
     * <p>No branch but for what lies in one another's circles, since nobody could foretell who approaches whom.
     *
     * @param body index
     * @param pairs the pairs
     * @param tau offset in the present step from which on to look
     * @return for each pair of the body an offset, infinite if they part or pass; NaN if their circles overlap
     */
    double[] meetAll(int body, Pairs pairs, double tau) {
        int n = pairs.countOf(body);
        if (n > starts.length) {
            starts = Arrays.copyOf(starts, 2 * n);
        }
        double[] m = trajectories.data();
        double step = trajectories.step();
        double h = trajectories.h();
        int a = body * Trajectories.STRIDE;
        double da = (step - m[a + Trajectories.STEP]) * h + (tau - m[a + Trajectories.OFFSET]);
        double vx = m[a + Trajectories.VX];
        double vy = m[a + Trajectories.VY];
        double x = m[a] + da * vx;
        double y = m[a + 1] + da * vy;
        double radius = trajectories.radius(body);
        for (int k = 0; k < n; k++) {
            int other = pairs.other(pairs.of(body, k), body);
            int b = other * Trajectories.STRIDE;
            double db = (step - m[b + Trajectories.STEP]) * h + (tau - m[b + Trajectories.OFFSET]);
            double ux = m[b + Trajectories.VX] - vx;
            double uy = m[b + Trajectories.VY] - vy;
            double px = m[b] + db * m[b + Trajectories.VX] - x;
            double py = m[b + 1] + db * m[b + Trajectories.VY] - y;
            double reach = radius + trajectories.radius(other);
            double c = px * px + py * py - reach * reach;
            double approach = px * ux + py * uy;
            double d = approach * approach - (ux * ux + uy * uy) * c;
            long meets = (Double.doubleToRawLongBits(approach) & Double.doubleToRawLongBits(-d)) >> 63;
            long start = Double.doubleToRawLongBits(tau + c / (Math.sqrt(d) - approach));
            double first = Double.longBitsToDouble(start & meets | INFINITE & ~meets);
            starts[k] = c > 0 ? first : Double.NaN;
        }
        return starts;
    }

    /**
     * When the circles of two bodies meet.
     *
     * @param i body A
     * @param j body B
     * @param tau offset in the present step from which on to look
     * @return as {@link NarrowPhase#boundingCircles(int, double)}
     */
    double meet(int i, int j, double tau) {
        touching = false;
        double[] m = trajectories.data();
        int a = i * Trajectories.STRIDE;
        int b = j * Trajectories.STRIDE;
        double ax = 0;
        double ay = 0;
        if (!trajectories.areStraight()) {
            double[] bends = trajectories.bends();
            ax = bends[a + Trajectories.AX];
            ay = bends[a + Trajectories.AY];
            double driven = bends[a + Trajectories.DRIVEN] + bends[b + Trajectories.DRIVEN];
            if (bends[b + Trajectories.AX] != ax || bends[b + Trajectories.AY] != ay || driven != 0) {
                return tau;
            }
        }
        double step = trajectories.step();
        double h = trajectories.h();
        double da = (step - m[a + Trajectories.STEP]) * h + (tau - m[a + Trajectories.OFFSET]);
        double db = (step - m[b + Trajectories.STEP]) * h + (tau - m[b + Trajectories.OFFSET]);
        double vax = m[a + Trajectories.VX];
        double vay = m[a + Trajectories.VY];
        double vbx = m[b + Trajectories.VX];
        double vby = m[b + Trajectories.VY];
        double px = m[b] + db * vbx - (m[a] + da * vax);
        double py = m[b + 1] + db * vby - (m[a + 1] + da * vay);
        if (ax != 0 || ay != 0) {
            px += (db * db - da * da) * ax; // both fall alike
            py += (db * db - da * da) * ay;
            vax += 2 * da * ax;
            vay += 2 * da * ay;
            vbx += 2 * db * ax;
            vby += 2 * db * ay;
        }
        double ux = vbx - vax;
        double uy = vby - vay;
        double radius = trajectories.radius(i) + trajectories.radius(j);
        double c = px * px + py * py - radius * radius;
        double approach = px * ux + py * uy;
        if (c > 0) {
            double d = approach * approach - (ux * ux + uy * uy) * c;
            if ((Double.doubleToRawLongBits(approach) & Double.doubleToRawLongBits(-d)) >= 0) {
                return Double.POSITIVE_INFINITY; // they part or pass; one branch, since nobody could foretell two
            }
            touching = shapes.isCircle(i) & shapes.isCircle(j); // no branch
            return tau + c / (Math.sqrt(d) - approach);
        }
        if (shapes.isCircle(i) & shapes.isCircle(j)) {
            double noise = Tolerances.APPROACH * radius * Math.sqrt(vax * vax + vay * vay + vbx * vbx + vby * vby);
            touching = approach < -noise;
            return touching ? tau : Double.POSITIVE_INFINITY;
        }
        if ((boxes.isFixed(i) || boxes.isFixed(j)) && ax == 0 && ay == 0) {
            return tau + (boxes.isFixed(i) ? approach(i, j, db) : approach(j, i, da));
        }
        return tau;
    }

    /**
     * Where two circles touch that move uniformly, as {@link ClosestFeatures} has it.
     *
     * @param i body A
     * @param j body B
     * @param tau offset in the present step
     * @param contact filled with the point and the normal
     * @return false if they are no circles, or so deep in one another that there is no normal
     */
    boolean contact(int i, int j, double tau, Manifold contact) {
        if (!shapes.isCircle(i) || !shapes.isCircle(j)) {
            return false;
        }
        double[] m = trajectories.data();
        int a = i * Trajectories.STRIDE;
        int b = j * Trajectories.STRIDE;
        double da = trajectories.duration(i, tau);
        double db = trajectories.duration(j, tau);
        double px = m[b] + db * m[b + Trajectories.VX] - (m[a] + da * m[a + Trajectories.VX]);
        double py = m[b + 1] + db * m[b + Trajectories.VY] - (m[a + 1] + da * m[a + Trajectories.VY]);
        double radiusA = shapes.rounding(i);
        double radiusB = shapes.rounding(j);
        double distance = Math.sqrt(px * px + py * py);
        if (!(distance > Tolerances.CORNERS * (trajectories.radius(i) + trajectories.radius(j)))) {
            return false;
        }
        contact.touch(px / distance, py / distance, distance - (radiusA + radiusB), radiusA, radiusB);
        return true;
    }

    /** Whether the centres of two bodies in uniform motion move away from one another. */
    boolean part(int i, int j, double tau) {
        double[] m = trajectories.data();
        int a = i * Trajectories.STRIDE;
        int b = j * Trajectories.STRIDE;
        double da = trajectories.duration(i, tau);
        double db = trajectories.duration(j, tau);
        double px = m[b] + db * m[b + Trajectories.VX] - (m[a] + da * m[a + Trajectories.VX]);
        double py = m[b + 1] + db * m[b + Trajectories.VY] - (m[a + 1] + da * m[a + Trajectories.VY]);
        double ux = m[b + Trajectories.VX] - m[a + Trajectories.VX];
        double uy = m[b + Trajectories.VY] - m[a + Trajectories.VY];
        return px * ux + py * uy > 0;
    }

    /** Whether nothing can be said of two bodies whose circles overlap but by their shapes. */
    boolean hide(int i, int j) {
        return !(shapes.isCircle(i) & shapes.isCircle(j)) & !boxes.isFixed(i) & !boxes.isFixed(j);
    }

    /**
     * How long a body surely stays off the box of a fixed one: the circle around a wall is large, and nearly everybody is
     * in it.
     *
     * @param fixed index of the fixed body
     * @param body index of the other one, whose motion is straight
     * @param d time since its anchor
     */
    private double approach(int fixed, int body, double d) {
        int o = body * Trajectories.STRIDE;
        double[] m = trajectories.data();
        double[] box = boxes.data();
        int k = Boxes.STRIDE * fixed;
        double radius = trajectories.radius(body);
        double vx = m[o + Trajectories.VX];
        double vy = m[o + Trajectories.VY];
        double x = m[o] + d * vx;
        double y = m[o + 1] + d * vy;
        return Math.max(
                entering(box[k] - (x + radius), x - radius - box[k + 2], vx),
                entering(box[k + 1] - (y + radius), y - radius - box[k + 3], vy));
    }

    /** The same along one axis, by how far the body is below and above the box. */
    private static double entering(double below, double above, double v) {
        if (below > 0) {
            return v > 0 ? below / v * BEFORE : Double.POSITIVE_INFINITY;
        }
        if (above > 0) {
            return v < 0 ? above / -v * BEFORE : Double.POSITIVE_INFINITY;
        }
        return 0;
    }
}
