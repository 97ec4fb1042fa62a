// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.Predicate;
import sim.physics.internal.Check;
import sim.physics.internal.Trig;
import sim.physics.motion.Body;
import sim.physics.motion.State;
import sim.physics.shape.Shape;

/**
 * Answers questions about where bodies are: what a robot senses. Between steps, answers are about the places that the bodies'
 * getters give. Within a step, in a listener, bodies that have no part in the collision are still where the step began. All
 * shapes are exact. Among equals, the body of the lower block comes first.
 *
 * <p>The first questions after a step look at the circles around all bodies, which takes some nanoseconds for each. A grid of
 * cells is laid from the tenth question on, or from the first if the last step had as many. Questions then look only at bodies in
 * the cells concerned. The answers are the same, to the bit. Bodies that {@link Body#setPosition} or {@link Body#setAngle} moves,
 * or that are added or removed, are noticed at once. Within a step, and among few bodies, questions look at all of them.
 *
 * <p>A filter says which bodies count, for example {@code body -> body != this}. With null, all count. A filter may ask questions
 * itself.
 */
public final class Queries {
    private final State state;
    final Cells cells;
    private final RayWalk ray;
    private final SweepWalk sweep;
    private final Surroundings surroundings;
    private final Outline outline = new Outline();
    private final Stencil stencil = new Stencil();

    /** Whether a question is being answered: filters that ask are answered by another. */
    private boolean busy;

    private Queries inner;

    /**
     * Creates queries.
     *
     * @param state state that holds the bodies
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
        sweep = new SweepWalk(census, cells);
        surroundings = new Surroundings(census, cells);
    }

    /** What answers the next question; busy from now on. */
    private Queries begin() {
        if (busy) {
            inner = inner == null ? new Queries(state) : inner;
            return inner.begin();
        }
        busy = true;
        return this;
    }

    /**
     * Returns the first body that a ray enters.
     *
     * @param x x of the start
     * @param y y of the start
     * @param directionX x of the direction, of any length
     * @param directionY y of the direction
     * @param range length of the ray, may be infinite
     * @param filter says which bodies count; null for all
     * @return the hit, or null if there is none
     * @throws IllegalArgumentException if a number is not finite, the direction is zero, or the range negative
     */
    public Hit rayCast(
            double x, double y, double directionX, double directionY, double range, Predicate<? super Body> filter) {
        return cast(x, y, directionX, directionY, range, filter, null).hit();
    }

    /**
     * Finds the first body that a ray enters, without garbage.
     *
     * @param x x of the start
     * @param y y of the start
     * @param directionX x of the direction, of any length
     * @param directionY y of the direction
     * @param range length of the ray, may be infinite
     * @param filter says which bodies count; null for all
     * @param into the object that takes the answer
     * @return true if there is such a body, false if there is none
     * @throws IllegalArgumentException if a number is not finite, the direction is zero, or the range negative
     */
    public boolean rayCast(
            double x, double y, double directionX, double directionY, double range, Predicate<? super Body> filter, RayHit into) {
        Objects.requireNonNull(into, "into");
        return cast(x, y, directionX, directionY, range, filter, null).into(into);
    }

    /** The walk that has cast a ray; its answer holds until the next question. */
    private RayWalk cast(
            double x, double y, double directionX, double directionY, double range, Predicate<? super Body> filter, List<Hit> all) {
        Queries free = begin();
        try {
            free.ray.cast(x, y, directionX, directionY, range, filter, all);
        } finally {
            free.busy = false;
        }
        return free.ray;
    }

    /**
     * Returns all bodies that a ray enters, each as if it were alone.
     *
     * @param x x of the start
     * @param y y of the start
     * @param directionX x of the direction, of any length
     * @param directionY y of the direction
     * @param range length of the ray, may be infinite
     * @param filter says which bodies count; null for all
     * @return a list of hits, nearest first
     * @throws IllegalArgumentException if a number is not finite, the direction is zero, or the range negative
     */
    public List<Hit> rayCastAll(
            double x, double y, double directionX, double directionY, double range, Predicate<? super Body> filter) {
        List<Hit> hits = new ArrayList<>();
        cast(x, y, directionX, directionY, range, filter, hits);
        hits.sort(Walk.NEARER);
        return hits;
    }

    /**
     * Returns the first body that a shape meets which moves straight on from where it is put, without turning: how far there is
     * room for it.
     *
     * <p>A shape that overlaps a body where it is put meets it at distance 0. What it only touches there, to rounding, it meets if
     * it moves into it: what lies on a floor may move along it.
     *
     * @param shape any shape
     * @param x x of its centre at the start
     * @param y y of its centre at the start
     * @param angle angle of the shape, rad
     * @param directionX x of the direction, of any length
     * @param directionY y of the direction
     * @param range how far it moves, length, may be infinite
     * @param filter says which bodies count; null for all
     * @return the hit, or null if there is none
     * @throws IllegalArgumentException if a number is not finite, the direction is zero, or the range negative
     */
    public Hit shapeCast(
            Shape shape, double x, double y, double angle,
            double directionX, double directionY, double range, Predicate<? super Body> filter) {
        return cast(shape, x, y, angle, directionX, directionY, range, filter, null).hit();
    }

    /**
     * Returns the first body that a body would meet if it moved straight on from where it is, without turning. The body need not be
     * in the engine, nor collide with anything. The rest is as for {@linkplain #shapeCast(Shape, double, double, double, double,
     * double, double, Predicate) a shape}.
     *
     * @param body any body; it does not meet itself
     * @param directionX x of the direction, of any length
     * @param directionY y of the direction
     * @param range how far it moves, length, may be infinite
     * @param filter says which bodies count; null for all
     * @return the hit, or null if there is none
     * @throws IllegalArgumentException if a number is not finite, the direction is zero, or the range negative
     */
    public Hit shapeCast(Body body, double directionX, double directionY, double range, Predicate<? super Body> filter) {
        Objects.requireNonNull(body, "body");
        Predicate<Body> others = other -> other != body && (filter == null || filter.test(other));
        return shapeCast(body.getShape(), body.getX(), body.getY(), body.getAngle(), directionX, directionY, range, others);
    }

    /**
     * Finds the first body that a shape meets which moves straight on, without garbage. The rest is as for
     * {@linkplain #shapeCast(Shape, double, double, double, double, double, double, Predicate) the one that is returned}.
     *
     * @param shape any shape
     * @param x x of its centre at the start
     * @param y y of its centre at the start
     * @param angle angle of the shape, rad
     * @param directionX x of the direction, of any length
     * @param directionY y of the direction
     * @param range how far it moves, length, may be infinite
     * @param filter says which bodies count; null for all
     * @param into the object that takes the answer
     * @return true if there is such a body, false if there is none
     * @throws IllegalArgumentException if a number is not finite, the direction is zero, or the range negative
     */
    public boolean shapeCast(
            Shape shape, double x, double y, double angle,
            double directionX, double directionY, double range, Predicate<? super Body> filter, RayHit into) {
        Objects.requireNonNull(into, "into");
        return cast(shape, x, y, angle, directionX, directionY, range, filter, null).into(into);
    }

    /** The walk that has cast a shape; its answer holds until the next question. */
    private SweepWalk cast(
            Shape shape, double x, double y, double angle,
            double directionX, double directionY, double range, Predicate<? super Body> filter, List<Hit> all) {
        Objects.requireNonNull(shape, "shape");
        Check.finite("angle", angle);
        Queries free = begin();
        try {
            free.sweep.cast(shape, x, y, angle, directionX, directionY, range, filter, all);
        } finally {
            free.busy = false;
        }
        return free.sweep;
    }

    /**
     * Returns all bodies that a shape meets which moves straight on from where it is put, each as if it were alone.
     *
     * @param shape any shape
     * @param x x of its centre at the start
     * @param y y of its centre at the start
     * @param angle angle of the shape, rad
     * @param directionX x of the direction, of any length
     * @param directionY y of the direction
     * @param range how far it moves, length, may be infinite
     * @param filter says which bodies count; null for all
     * @return a list of hits, nearest first
     * @throws IllegalArgumentException if a number is not finite, the direction is zero, or the range negative
     */
    public List<Hit> shapeCastAll(
            Shape shape, double x, double y, double angle,
            double directionX, double directionY, double range, Predicate<? super Body> filter) {
        List<Hit> hits = new ArrayList<>();
        cast(shape, x, y, angle, directionX, directionY, range, filter, hits);
        hits.sort(Walk.NEARER);
        return hits;
    }

    /**
     * Finds the distances at which the rays of a fan meet bodies. The rays are evenly spread over an angle.
     *
     * @param x x of the start
     * @param y y of the start
     * @param from angle of the first ray, rad
     * @param to angle of the last ray, rad
     * @param range length of the rays
     * @param filter says which bodies count; null for all
     * @param distances array that takes one distance per ray, which is the range if the ray meets nothing
     * @throws IllegalArgumentException if a number is not finite, or the range negative
     */
    public void fan(
            double x, double y, double from, double to, double range, Predicate<? super Body> filter, double[] distances) {
        Check.finite("x", x);
        Check.finite("y", y);
        Check.finite("to - from", Check.finite("to", to) - Check.finite("from", from));
        Objects.requireNonNull(distances, "distances");
        double step = distances.length < 2 ? 0 : (to - from) / (distances.length - 1);
        for (int k = 0; k < distances.length; k++) {
            double angle = from + k * step;
            cells.announce(distances.length - 1 - k);
            distances[k] = cast(x, y, Trig.cos(angle), Trig.sin(angle), range, filter, null).distance;
        }
    }

    /**
     * Returns the distance of a point from a body's surface.
     *
     * @param body any body
     * @param x x of the point
     * @param y y of the point
     * @return length; 0 if the point is inside
     */
    public double distance(Body body, double x, double y) {
        Objects.requireNonNull(body, "body");
        outline.of(body);
        return outline.distance(Check.finite("x", x), Check.finite("y", y));
    }

    /**
     * Returns the bodies that are within a distance of a point.
     *
     * @param x x of the point
     * @param y y of the point
     * @param distance greatest distance, length; 0 for the bodies at that point
     * @param filter says which bodies count; null for all
     * @return a list, in the order of the bodies' blocks
     * @throws IllegalArgumentException if a number is not finite or the distance negative
     */
    public List<Body> within(double x, double y, double distance, Predicate<? super Body> filter) {
        List<Body> found = new ArrayList<>();
        within(x, y, distance, filter, found);
        return found;
    }

    /**
     * Finds the bodies that are within a distance of a point, without garbage if the list has room.
     *
     * @param x x of the point
     * @param y y of the point
     * @param distance greatest distance, length; 0 for the bodies at that point
     * @param filter says which bodies count; null for all
     * @param into the list to which they are added, in the order of their blocks
     * @throws IllegalArgumentException if a number is not finite or the distance negative
     */
    public void within(double x, double y, double distance, Predicate<? super Body> filter, List<? super Body> into) {
        Check.finite("x", x);
        Check.finite("y", y);
        Check.notNegative("distance", distance);
        Objects.requireNonNull(into, "into");
        Queries free = begin();
        try {
            free.surroundings.within(x, y, distance, filter, into);
        } finally {
            free.busy = false;
        }
    }

    /**
     * Returns the bodies that are nearest to a point.
     *
     * @param x x of the point
     * @param y y of the point
     * @param count number of bodies at most, not negative
     * @param filter says which bodies count; null for all
     * @return a list, nearest first
     * @throws IllegalArgumentException if a number is not finite or the count negative
     */
    public List<Body> nearest(double x, double y, int count, Predicate<? super Body> filter) {
        List<Body> found = new ArrayList<>();
        nearest(x, y, count, filter, found);
        return found;
    }

    /**
     * Finds the bodies that are nearest to a point, without garbage if the list has room.
     *
     * @param x x of the point
     * @param y y of the point
     * @param count number of bodies at most, not negative
     * @param filter says which bodies count; null for all
     * @param into the list to which they are added, nearest first
     * @throws IllegalArgumentException if a number is not finite or the count negative
     */
    public void nearest(double x, double y, int count, Predicate<? super Body> filter, List<? super Body> into) {
        Check.finite("x", x);
        Check.finite("y", y);
        if (count < 0) {
            throw new IllegalArgumentException("count is " + count + ": it must not be negative");
        }
        Objects.requireNonNull(into, "into");
        Queries free = begin();
        try {
            free.surroundings.nearest(x, y, count, filter, into);
        } finally {
            free.busy = false;
        }
    }

    /**
     * Returns the bodies that meet a box whose sides are parallel to the axes.
     *
     * @param lowX left side of the box
     * @param lowY lower side of the box
     * @param highX right side of the box, not less than the left one
     * @param highY upper side of the box, not less than the lower one
     * @param filter says which bodies count; null for all
     * @return a list, in the order of the bodies' blocks
     * @throws IllegalArgumentException if a number is not finite, or the sides are the wrong way round
     */
    public List<Body> inBox(double lowX, double lowY, double highX, double highY, Predicate<? super Body> filter) {
        List<Body> found = new ArrayList<>();
        inBox(lowX, lowY, highX, highY, filter, found);
        return found;
    }

    /**
     * Finds the bodies that meet a box whose sides are parallel to the axes, without garbage if the list has room.
     *
     * @param lowX left side of the box
     * @param lowY lower side of the box
     * @param highX right side of the box, not less than the left one
     * @param highY upper side of the box, not less than the lower one
     * @param filter says which bodies count; null for all
     * @param into the list to which they are added, in the order of their blocks
     * @throws IllegalArgumentException if a number is not finite, or the sides are the wrong way round
     */
    public void inBox(
            double lowX, double lowY, double highX, double highY, Predicate<? super Body> filter, List<? super Body> into) {
        Surroundings.check(lowX, lowY, highX, highY);
        Objects.requireNonNull(into, "into");
        Queries free = begin();
        try {
            free.surroundings.inBox(lowX, lowY, highX, highY, filter, into);
        } finally {
            free.busy = false;
        }
    }

    /**
     * Returns the bodies that a shape touches or overlaps where it is put. This tells what is in a zone, or whether there is
     * room for a body.
     *
     * @param shape any shape
     * @param x x of its centre
     * @param y y of its centre
     * @param angle angle of the shape, rad
     * @param filter says which bodies count; null for all
     * @return a list, in the order of the bodies' blocks
     * @throws IllegalArgumentException if a number is not finite
     */
    public List<Body> overlapping(Shape shape, double x, double y, double angle, Predicate<? super Body> filter) {
        List<Body> found = new ArrayList<>();
        overlapping(shape, x, y, angle, filter, found);
        return found;
    }

    /**
     * Returns the bodies that a body touches or overlaps where it is. The body need not be in the engine, nor collide with
     * anything: a body that is in no collision group is a sensor that may be tied to others.
     *
     * @param body any body; it is not among the answers
     * @param filter says which bodies count; null for all
     * @return a list, in the order of the bodies' blocks
     */
    public List<Body> overlapping(Body body, Predicate<? super Body> filter) {
        Objects.requireNonNull(body, "body");
        Predicate<Body> others = other -> other != body && (filter == null || filter.test(other));
        return overlapping(body.getShape(), body.getX(), body.getY(), body.getAngle(), others);
    }

    /**
     * Finds the bodies that a shape touches or overlaps where it is put, without garbage if the list has room.
     *
     * @param shape any shape
     * @param x x of its centre
     * @param y y of its centre
     * @param angle angle of the shape, rad
     * @param filter says which bodies count; null for all
     * @param into the list to which they are added, in the order of their blocks
     * @throws IllegalArgumentException if a number is not finite
     */
    public void overlapping(
            Shape shape, double x, double y, double angle, Predicate<? super Body> filter, List<? super Body> into) {
        Objects.requireNonNull(shape, "shape");
        Check.finite("x", x);
        Check.finite("y", y);
        Check.finite("angle", angle);
        Objects.requireNonNull(into, "into");
        Queries free = begin();
        try {
            free.stencil.put(shape, x, y, angle);
            free.surroundings.overlapping(free.stencil, filter, into);
        } finally {
            free.busy = false;
        }
    }

    /**
     * Returns the bodies whose centres lie in a field of view and which are not hidden. A body is hidden if the line of sight to
     * its centre enters another body that counts before it.
     *
     * @param x x of the eye
     * @param y y of the eye
     * @param direction direction in which the eye looks, rad
     * @param halfAngle angle of the field to either side, rad, 0 … π
     * @param range distance that the eye can see
     * @param filter says which bodies count, both to be seen and to hide others; null for all
     * @return a list, with the nearest centre first
     * @throws IllegalArgumentException if a number is not finite or out of its range
     */
    public List<Body> visible(
            double x, double y, double direction, double halfAngle, double range, Predicate<? super Body> filter) {
        Check.finite("direction", direction);
        Check.between("halfAngle", halfAngle, 0, Math.PI);
        Check.notNegative("range", range);
        List<Body> near = within(x, y, range, filter);
        List<Body> found = new ArrayList<>();
        cells.announce(near.size());
        Sight sight = new Sight(x, y, direction, halfAngle, range);
        for (Body body : near) {
            if (sight.holds(body) && (sight.far == 0 || cast(x, y, sight.dx, sight.dy, sight.far, filter, null).body == body)) {
                found.add(body);
            }
        }
        cells.announce(0);
        found.sort(sight);
        return found;
    }
}
