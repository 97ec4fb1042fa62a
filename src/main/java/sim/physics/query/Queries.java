// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;
import sim.physics.internal.Check;
import sim.physics.internal.Trig;
import sim.physics.motion.Body;
import sim.physics.motion.State;

/**
 * Where bodies are: what a robot senses. Answers are about the places that the bodies' getters give, between steps; within a
 * step, in a listener, those of bodies that have no part in the collision are still of the step's start. All shapes are
 * exact. Each question looks at the circle around every body once, so it costs some nanoseconds for each. Among equals the
 * body that was added first comes first.
 *
 * <p>A filter says which bodies count, {@code body -> body != this} for one; null for all.
 */
public final class Queries {
    private final State state;
    private final Outline outline = new Outline();

    /** The bodies that were there when last asked, and the radii around them. */
    private Body[] known = {};

    private double[] radii = {};

    /**
     * Makes queries.
     *
     * @param state the bodies
     */
    public Queries(State state) {
        this.state = state;
    }

    /**
     * The first body that a ray enters.
     *
     * @param x start
     * @param y start
     * @param directionX of any length
     * @param directionY of any length
     * @param range length of the ray, may be infinite
     * @param filter which bodies count, or null
     * @return null if there is none
     * @throws IllegalArgumentException if a number is not finite, the direction is zero, or the range negative
     */
    public Hit rayCast(
            double x, double y, double directionX, double directionY, double range, Predicate<? super Body> filter) {
        double length = checkRay(x, y, directionX, directionY, range);
        double dx = directionX / length;
        double dy = directionY / length;
        Body first = null;
        double nearest = range;
        double nx = 0;
        double ny = 0;
        learn();
        for (int i = 0; i < state.size(); i++) {
            Body body = known[i];
            if (!isNear(i, x, y, dx, dy, nearest) || filter != null && !filter.test(body)) {
                continue;
            }
            outline.of(body);
            if (outline.enters(x, y, dx, dy, nearest) && (first == null || outline.distance < nearest)) {
                first = body;
                nearest = outline.distance;
                nx = outline.nx;
                ny = outline.ny;
            }
        }
        return first == null ? null : new Hit(first, x + nearest * dx, y + nearest * dy, nx, ny, nearest);
    }

    /**
     * All bodies that a ray enters, as if each were alone.
     *
     * @param x start
     * @param y start
     * @param directionX of any length
     * @param directionY of any length
     * @param range length of the ray, may be infinite
     * @param filter which bodies count, or null
     * @return nearest first
     * @throws IllegalArgumentException if a number is not finite, the direction is zero, or the range negative
     */
    public List<Hit> rayCastAll(
            double x, double y, double directionX, double directionY, double range, Predicate<? super Body> filter) {
        double length = checkRay(x, y, directionX, directionY, range);
        double dx = directionX / length;
        double dy = directionY / length;
        List<Hit> hits = new ArrayList<>();
        learn();
        for (int i = 0; i < state.size(); i++) {
            Body body = known[i];
            if (!isNear(i, x, y, dx, dy, range) || filter != null && !filter.test(body)) {
                continue;
            }
            outline.of(body);
            if (outline.enters(x, y, dx, dy, range)) {
                double d = outline.distance;
                hits.add(new Hit(body, x + d * dx, y + d * dy, outline.nx, outline.ny, d));
            }
        }
        hits.sort(Comparator.comparingDouble(Hit::distance));
        return hits;
    }

    private static double checkRay(double x, double y, double directionX, double directionY, double range) {
        Check.finite("x", x);
        Check.finite("y", y);
        Check.finite("directionX", directionX);
        Check.finite("directionY", directionY);
        if (!(range >= 0)) {
            throw new IllegalArgumentException("range is " + range + ": it must not be negative");
        }
        double length = Math.sqrt(directionX * directionX + directionY * directionY);
        if (!(length > 0)) {
            throw new IllegalArgumentException("direction is (" + directionX + ", " + directionY + "): it must not be zero");
        }
        return length;
    }

    /** Takes note of bodies that have come or gone. */
    private void learn() {
        int n = state.size();
        if (known.length < n) {
            known = Arrays.copyOf(known, 2 * n);
            radii = Arrays.copyOf(radii, 2 * n);
        }
        for (int i = 0; i < n; i++) {
            Body body = state.body(i);
            if (body != known[i]) {
                known[i] = body;
                radii[i] = body == null ? -1 : body.getShape().boundingRadius() * (1 + 1e-12);
            }
        }
    }

    /** Whether a ray comes into the circle around a body; not into that of none. */
    private boolean isNear(int body, double x, double y, double dx, double dy, double range) {
        double px = state.x()[State.BLOCK * body] - x;
        double py = state.x()[State.BLOCK * body + 1] - y;
        double radius = radii[body];
        double across = px * dy - py * dx;
        if (Math.abs(across) > radius) {
            return false;
        }
        double along = px * dx + py * dy;
        return along >= -radius && along - range <= radius;
    }

    /**
     * The distances at which a fan of rays meets bodies, evenly spread over an angle.
     *
     * @param x start
     * @param y start
     * @param from angle of the first ray, rad
     * @param to angle of the last one, rad
     * @param range length of the rays
     * @param filter which bodies count, or null
     * @param distances takes one distance per ray, and the range where it meets nothing
     * @throws IllegalArgumentException if a number is not finite, or the range negative
     */
    public void fan(
            double x, double y, double from, double to, double range, Predicate<? super Body> filter, double[] distances) {
        Check.finite("from", from);
        Check.finite("to", to);
        double step = distances.length < 2 ? 0 : (to - from) / (distances.length - 1);
        for (int k = 0; k < distances.length; k++) {
            double angle = from + k * step;
            double dx = Trig.cos(angle);
            double dy = Trig.sin(angle);
            Hit hit = rayCast(x, y, dx, dy, range, filter);
            distances[k] = hit == null ? range : hit.distance();
        }
    }

    /**
     * Distance of a point from a body's surface.
     *
     * @param body any
     * @param x point
     * @param y point
     * @return length; 0 inside
     */
    public double distance(Body body, double x, double y) {
        outline.of(body);
        return outline.distance(Check.finite("x", x), Check.finite("y", y));
    }

    /**
     * The bodies that are not farther from a point than a distance.
     *
     * @param x point
     * @param y point
     * @param distance length; 0: the bodies at that point
     * @param filter which bodies count, or null
     * @return in the order of their blocks
     * @throws IllegalArgumentException if a number is not finite or the distance negative
     */
    public List<Body> within(double x, double y, double distance, Predicate<? super Body> filter) {
        Check.finite("x", x);
        Check.finite("y", y);
        Check.notNegative("distance", distance);
        List<Body> found = new ArrayList<>();
        for (int i = 0; i < state.size(); i++) {
            Body body = state.body(i);
            if (body != null && far(body, x, y) <= distance && (filter == null || filter.test(body))) {
                outline.of(body);
                if (outline.distance(x, y) <= distance) {
                    found.add(body);
                }
            }
        }
        return found;
    }

    /** Distance of a point from the circle around a body, or a little less; negative inside. */
    private static double far(Body body, double x, double y) {
        double px = body.getX() - x;
        double py = body.getY() - y;
        return Math.sqrt(px * px + py * py) * (1 - 1e-12) - body.getShape().boundingRadius();
    }

    /**
     * The bodies that are nearest to a point.
     *
     * @param x point
     * @param y point
     * @param count how many at most, not negative
     * @param filter which bodies count, or null
     * @return nearest first
     * @throws IllegalArgumentException if a number is not finite or the count negative
     */
    public List<Body> nearest(double x, double y, int count, Predicate<? super Body> filter) {
        Check.finite("x", x);
        Check.finite("y", y);
        Check.notNegative("count", count);
        List<Body> found = new ArrayList<>(count + 1);
        List<Double> distances = new ArrayList<>(count + 1);
        for (int i = 0; i < state.size() && count > 0; i++) {
            Body body = state.body(i);
            double most = found.size() < count ? Double.POSITIVE_INFINITY : distances.get(count - 1);
            if (body == null || far(body, x, y) > most || filter != null && !filter.test(body)) {
                continue;
            }
            double d = distance(body, x, y);
            if (d < most) {
                int k = found.size();
                while (k > 0 && distances.get(k - 1) > d) {
                    k--;
                }
                found.add(k, body);
                distances.add(k, d);
                if (found.size() > count) {
                    found.remove(count);
                    distances.remove(count);
                }
            }
        }
        return found;
    }

    /**
     * The bodies that meet a box with sides along the axes.
     *
     * @param lowX its left side
     * @param lowY its lower side
     * @param highX its right side, not less than the left one
     * @param highY its upper side, not less than the lower one
     * @param filter which bodies count, or null
     * @return in the order of their blocks
     * @throws IllegalArgumentException if a number is not finite, or the sides are the wrong way round
     */
    public List<Body> inBox(double lowX, double lowY, double highX, double highY, Predicate<? super Body> filter) {
        Check.finite("lowX", lowX);
        Check.finite("lowY", lowY);
        Check.notNegative("highX - lowX", Check.finite("highX", highX) - lowX);
        Check.notNegative("highY - lowY", Check.finite("highY", highY) - lowY);
        List<Body> found = new ArrayList<>();
        for (int i = 0; i < state.size(); i++) {
            Body body = state.body(i);
            if (body == null) {
                continue;
            }
            double radius = body.getShape().boundingRadius();
            boolean near = body.getX() + radius >= lowX && body.getX() - radius <= highX
                    && body.getY() + radius >= lowY && body.getY() - radius <= highY;
            if (near && (filter == null || filter.test(body))) {
                outline.of(body);
                if (outline.meets(lowX, lowY, highX, highY)) {
                    found.add(body);
                }
            }
        }
        return found;
    }

    /**
     * The bodies whose centres lie in a field of view and are not hidden: the line of sight to the centre enters no other
     * body that counts before.
     *
     * @param x the eye
     * @param y the eye
     * @param direction in which it looks, rad
     * @param halfAngle of the field to either side, rad, 0 … π
     * @param range how far it sees
     * @param filter which bodies count, see and hide, or null
     * @return nearest centre first
     * @throws IllegalArgumentException if a number is not finite or out of its range
     */
    public List<Body> visible(
            double x, double y, double direction, double halfAngle, double range, Predicate<? super Body> filter) {
        Check.finite("direction", direction);
        Check.between("halfAngle", halfAngle, 0, Math.PI);
        Check.notNegative("range", range);
        double cos = Trig.cos(direction);
        double sin = Trig.sin(direction);
        double edge = Trig.cos(halfAngle);
        List<Body> found = new ArrayList<>();
        for (Body body : within(x, y, range, filter)) {
            double dx = body.getX() - x;
            double dy = body.getY() - y;
            double far = Math.sqrt(dx * dx + dy * dy);
            boolean inField = far <= range && dx * cos + dy * sin >= edge * far;
            if (inField && (far == 0 || rayCast(x, y, dx, dy, far, filter).body() == body)) {
                found.add(body);
            }
        }
        found.sort(Comparator.comparingDouble(b -> square(b, x, y)));
        return found;
    }

    private static double square(Body b, double x, double y) {
        return (b.getX() - x) * (b.getX() - x) + (b.getY() - y) * (b.getY() - y);
    }
}
