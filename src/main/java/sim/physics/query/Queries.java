// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.function.Predicate;
import sim.physics.internal.Check;
import sim.physics.internal.Trig;
import sim.physics.motion.Body;
import sim.physics.motion.State;
import sim.physics.shape.Shape;

/**
 * Where bodies are: what a robot senses. Answers are about the places that the bodies' getters give, between steps; within a
 * step, in a listener, those of bodies that have no part in the collision are still of the step's start. All shapes are
 * exact. Among equals the body of the lower block comes first.
 *
 * <p>The first questions after a step look at the circles around all bodies, some nanoseconds for each. From the tenth on,
 * and from the first if so many came last time, a grid of cells is laid, and questions look at bodies of the cells
 * concerned only. The answers are the same, to the bit. What {@link Body#setPosition} and {@link Body#setAngle} move, and
 * what is added or removed, is noticed at once. Within a step, and among few bodies, all are looked at.
 *
 * <p>A filter says which bodies count, {@code body -> body != this} for one; null for all. It may ask questions itself.
 */
public final class Queries {
    private static final Comparator<Hit> NEARER =
            Comparator.comparingDouble(Hit::distance).thenComparingInt(hit -> hit.body().index());

    private final State state;
    final Cells cells;
    private final RayWalk ray;
    private final Surroundings surroundings;
    private final Outline outline = new Outline();
    private final Stencil stencil = new Stencil();

    /** Whether a question is being answered: filters that ask are answered by another. */
    private boolean busy;

    private Queries inner;

    /**
     * Makes queries.
     *
     * @param state the bodies
     */
    public Queries(State state) {
        this(state, Cells.FEW, Cells.LAYING);
    }

    /**
     * Makes queries that choose otherwise, to compare both ways.
     *
     * @param few up to so many bodies all are looked at
     * @param laying the question, counted since all bodies may have moved, that lays the grid
     */
    Queries(State state, int few, int laying) {
        this.state = Objects.requireNonNull(state, "state");
        Census census = new Census(state);
        cells = new Cells(census, few, laying);
        ray = new RayWalk(census, cells);
        surroundings = new Surroundings(census, cells);
    }

    private Queries inner() {
        inner = inner == null ? new Queries(state) : inner;
        return inner;
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
        RayWalk answer = cast(x, y, directionX, directionY, range, filter, null);
        if (answer.body == null) {
            return null;
        }
        double d = answer.distance;
        return new Hit(answer.body, answer.hitX(), answer.hitY(), answer.nx, answer.ny, d);
    }

    /**
     * The first body that a ray enters, without garbage.
     *
     * @param x start
     * @param y start
     * @param directionX of any length
     * @param directionY of any length
     * @param range length of the ray, may be infinite
     * @param filter which bodies count, or null
     * @param into takes the answer
     * @return false if there is none
     * @throws IllegalArgumentException if a number is not finite, the direction is zero, or the range negative
     */
    public boolean rayCast(
            double x,
            double y,
            double directionX,
            double directionY,
            double range,
            Predicate<? super Body> filter,
            RayHit into) {
        Objects.requireNonNull(into, "into");
        RayWalk answer = cast(x, y, directionX, directionY, range, filter, null);
        if (answer.body == null) {
            into.set(null, 0, 0, 0, 0, range);
            return false;
        }
        into.set(answer.body, answer.hitX(), answer.hitY(), answer.nx, answer.ny, answer.distance);
        return true;
    }

    /** The walk that has cast a ray; its answer holds until the next question. */
    private RayWalk cast(
            double x,
            double y,
            double directionX,
            double directionY,
            double range,
            Predicate<? super Body> filter,
            List<Hit> all) {
        if (busy) {
            return inner().cast(x, y, directionX, directionY, range, filter, all);
        }
        double length = checkRay(x, y, directionX, directionY, range);
        busy = true;
        try {
            ray.cast(x, y, directionX / length, directionY / length, range, filter, all);
        } finally {
            busy = false;
        }
        return ray;
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
        List<Hit> hits = new ArrayList<>();
        cast(x, y, directionX, directionY, range, filter, hits);
        hits.sort(NEARER);
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
        Objects.requireNonNull(distances, "distances");
        double step = distances.length < 2 ? 0 : (to - from) / (distances.length - 1);
        for (int k = 0; k < distances.length; k++) {
            double angle = from + k * step;
            cells.announce(distances.length - 1 - k);
            distances[k] = cast(x, y, Trig.cos(angle), Trig.sin(angle), range, filter, null).distance;
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
        Objects.requireNonNull(body, "body");
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
        List<Body> found = new ArrayList<>();
        within(x, y, distance, filter, found);
        return found;
    }

    /**
     * The bodies that are not farther from a point than a distance, without garbage if the list has room.
     *
     * @param x point
     * @param y point
     * @param distance length; 0: the bodies at that point
     * @param filter which bodies count, or null
     * @param into gets them at its end, in the order of their blocks
     * @throws IllegalArgumentException if a number is not finite or the distance negative
     */
    public void within(double x, double y, double distance, Predicate<? super Body> filter, List<? super Body> into) {
        Check.finite("x", x);
        Check.finite("y", y);
        Check.notNegative("distance", distance);
        Objects.requireNonNull(into, "into");
        if (busy) {
            inner().within(x, y, distance, filter, into);
            return;
        }
        busy = true;
        try {
            surroundings.within(x, y, distance, filter, into);
        } finally {
            busy = false;
        }
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
        List<Body> found = new ArrayList<>();
        nearest(x, y, count, filter, found);
        return found;
    }

    /**
     * The bodies that are nearest to a point, without garbage if the list has room.
     *
     * @param x point
     * @param y point
     * @param count how many at most, not negative
     * @param filter which bodies count, or null
     * @param into gets them at its end, nearest first
     * @throws IllegalArgumentException if a number is not finite or the count negative
     */
    public void nearest(double x, double y, int count, Predicate<? super Body> filter, List<? super Body> into) {
        Check.finite("x", x);
        Check.finite("y", y);
        if (count < 0) {
            throw new IllegalArgumentException("count is " + count + ": it must not be negative");
        }
        Objects.requireNonNull(into, "into");
        if (busy) {
            inner().nearest(x, y, count, filter, into);
            return;
        }
        busy = true;
        try {
            surroundings.nearest(x, y, count, filter, into);
        } finally {
            busy = false;
        }
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
        List<Body> found = new ArrayList<>();
        inBox(lowX, lowY, highX, highY, filter, found);
        return found;
    }

    /**
     * The bodies that meet a box with sides along the axes, without garbage if the list has room.
     *
     * @param lowX its left side
     * @param lowY its lower side
     * @param highX its right side, not less than the left one
     * @param highY its upper side, not less than the lower one
     * @param filter which bodies count, or null
     * @param into gets them at its end, in the order of their blocks
     * @throws IllegalArgumentException if a number is not finite, or the sides are the wrong way round
     */
    public void inBox(
            double lowX, double lowY, double highX, double highY, Predicate<? super Body> filter, List<? super Body> into) {
        Check.finite("lowX", lowX);
        Check.finite("lowY", lowY);
        checkSides("X", lowX, Check.finite("highX", highX));
        checkSides("Y", lowY, Check.finite("highY", highY));
        Objects.requireNonNull(into, "into");
        if (busy) {
            inner().inBox(lowX, lowY, highX, highY, filter, into);
            return;
        }
        busy = true;
        try {
            surroundings.inBox(lowX, lowY, highX, highY, filter, into);
        } finally {
            busy = false;
        }
    }

    private static void checkSides(String axis, double low, double high) {
        if (high < low) {
            throw new IllegalArgumentException(
                    "high" + axis + " is " + high + ": it must not be less than low" + axis + ", " + low);
        }
    }

    /**
     * Returns the bodies that a shape touches or overlaps where it is put: what is in a zone, or whether there is room for a body.
     *
     * @param shape any
     * @param x its centre
     * @param y its centre
     * @param angle rad
     * @param filter which bodies count, or null
     * @return in the order of their blocks
     * @throws IllegalArgumentException if a number is not finite
     */
    public List<Body> overlapping(Shape shape, double x, double y, double angle, Predicate<? super Body> filter) {
        List<Body> found = new ArrayList<>();
        overlapping(shape, x, y, angle, filter, found);
        return found;
    }

    /**
     * Returns the bodies that a body touches or overlaps where it is. The body need not be in the engine, nor collide with anything: a body that is
     * in no collision group is a sensor that may be tied to others.
     *
     * @param body any; not among the answers
     * @param filter which bodies count, or null
     * @return in the order of their blocks
     */
    public List<Body> overlapping(Body body, Predicate<? super Body> filter) {
        Objects.requireNonNull(body, "body");
        Predicate<Body> others = other -> other != body && (filter == null || filter.test(other));
        return overlapping(body.getShape(), body.getX(), body.getY(), body.getAngle(), others);
    }

    /**
     * Finds the bodies that a shape touches or overlaps where it is put, without garbage if the list has room.
     *
     * @param shape any
     * @param x its centre
     * @param y its centre
     * @param angle rad
     * @param filter which bodies count, or null
     * @param into gets them at its end, in the order of their blocks
     * @throws IllegalArgumentException if a number is not finite
     */
    public void overlapping(
            Shape shape, double x, double y, double angle, Predicate<? super Body> filter, List<? super Body> into) {
        Objects.requireNonNull(shape, "shape");
        Check.finite("x", x);
        Check.finite("y", y);
        Check.finite("angle", angle);
        Objects.requireNonNull(into, "into");
        if (busy) {
            inner().overlapping(shape, x, y, angle, filter, into);
            return;
        }
        busy = true;
        try {
            stencil.put(shape, x, y, angle);
            surroundings.overlapping(stencil, filter, into);
        } finally {
            busy = false;
        }
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
        List<Body> near = within(x, y, range, filter);
        cells.announce(near.size());
        for (Body body : near) {
            double dx = body.getX() - x;
            double dy = body.getY() - y;
            double far = Math.sqrt(dx * dx + dy * dy);
            boolean inField = far <= range && dx * cos + dy * sin >= edge * far;
            if (inField && (far == 0 || cast(x, y, dx, dy, far, filter, null).body == body)) {
                found.add(body);
            }
        }
        cells.announce(0);
        found.sort(Comparator.comparingDouble(b -> square(b, x, y)));
        return found;
    }

    private static double square(Body b, double x, double y) {
        return (b.getX() - x) * (b.getX() - x) + (b.getY() - y) * (b.getY() - y);
    }
}
