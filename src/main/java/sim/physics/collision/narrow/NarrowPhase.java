// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

import java.io.Serializable;
import sim.physics.collision.broad.Boxes;
import sim.physics.collision.broad.Pairs;
import sim.physics.internal.Tolerances;
import sim.physics.motion.Trajectories;

/**
 * Exact collision detection for the pairs that the broad phase found: the time of their first contact, and the points
 * where they touch.
 *
 * <p>Each pair keeps its closest features from one look to the next; they are believed only if they still hold the
 * certificate of {@link ClosestFeatures}.
 */
public final class NarrowPhase implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Length of a side that lies on another one which is none, relative to the bodies' sizes. */
    private static final double ENDS = 1e-12;

    private final Pairs pairs;
    private final Trajectories trajectories;
    private final ShapeTable shapes;
    private final Boxes boxes;
    private final BoundingCircles circles;

    private transient Pose pose;
    private transient ClosestFeatures features;
    private transient SeparatingLine separatingLine;
    private transient TimeOfImpact timeOfImpact;
    private transient Bisection bisection;
    private double flushLimit;
    private boolean touching;
    private boolean apart;
    private double clearance;
    private boolean continuous = true;

    /**
     * Makes a narrow phase.
     *
     * @param pairs the possibly colliding pairs
     * @param trajectories the motion of the bodies
     * @param shapes their shapes
     * @param boxes their boxes; those of fixed bodies fit
     */
    public NarrowPhase(Pairs pairs, Trajectories trajectories, ShapeTable shapes, Boxes boxes) {
        this.pairs = pairs;
        this.trajectories = trajectories;
        this.shapes = shapes;
        this.boxes = boxes;
        circles = new BoundingCircles(trajectories, shapes, boxes);
    }

    /**
     * Makes one for another thread, which looks at pairs while this one looks at others.
     *
     * @return does what this one does after {@link #match}
     */
    public NarrowPhase twin() {
        return new NarrowPhase(pairs, trajectories, shapes, boxes);
    }

    /**
     * Does from now on what another one does.
     *
     * @param other where this one comes from
     */
    public void match(NarrowPhase other) {
        continuous = other.continuous;
    }

    /**
     * Takes over the count of work that another one has done.
     *
     * @param twin made by {@link #twin()}
     */
    public void take(NarrowPhase twin) {
        if (twin.timeOfImpact != null) {
            wake();
            timeOfImpact.evaluations += twin.evaluations();
            twin.timeOfImpact.evaluations = 0;
            twin.separatingLine.evaluations = 0;
        }
    }

    /**
     * Forgets what was known of a pair number, for a pair that begins.
     *
     * @param pair its number
     */
    public void forget(int pair) {
        pairs.setCode(pair, ClosestFeatures.NO_FEATURES);
    }

    /**
     * Looks for the first contact of a pair.
     *
     * @param pair its number
     * @param tau offset in the present step from which on to look; the bodies do not penetrate then
     * @param start what {@link #boundingCircles(int, double)} has just returned for it, finite
     * @param end offset at which the search may stop
     * @return offset of the first contact with approaching surfaces if {@link #isTouching()}, else an offset up to
     *     which there is none: at least {@code end}, infinite if there never is one on the present trajectories
     */
    public double firstContact(int pair, double tau, double start, double end) {
        apart = false;
        clearance = Double.NaN;
        if (!continuous) {
            wake();
            load(pair);
            double found = bisection.search(tau, end);
            touching = bisection.touching;
            return found;
        }
        if (touching || start >= end) {
            apart = start >= end;
            return start;
        }
        wake();
        int i = pairs.first(pair);
        int j = pairs.second(pair);
        double found = separatingLine.search(
                i, shapes.base(i, pairs.firstPart(pair)), j, shapes.base(j, pairs.secondPart(pair)), start, end, pairs.code(pair));
        pairs.setCode(pair, separatingLine.code);
        touching = separatingLine.touching;
        if (separatingLine.undecided) {
            load(pair);
            found = timeOfImpact.search(found, end, pairs.code(pair));
            pairs.setCode(pair, timeOfImpact.code);
            touching = timeOfImpact.touching;
            clearance = touching ? Double.NaN : features.gap;
        }
        if (separatingLine.clean || !mayGraze(pair)) {
            return found;
        }
        load(pair);
        return beyondGrazes(pair, found, end);
    }

    /** Turns to the two parts that a pair is of. */
    private void load(int pair) {
        int i = pairs.first(pair);
        int j = pairs.second(pair);
        pose.load(i, shapes.base(i, pairs.firstPart(pair)), j, shapes.base(j, pairs.secondPart(pair)));
    }

    private boolean mayGraze(int pair) {
        return touching && !(isCircle(pairs.first(pair)) | isCircle(pairs.second(pair)));
    }

    /** Goes on from an instant at which two polygons touch for as long as they only graze one another. */
    private double beyondGrazes(int pair, double tau, double end) {
        double t = tau;
        while (touching) {
            double next = timeOfImpact.graze(t, end);
            touching = timeOfImpact.touching;
            if (touching || !(next < end)) {
                return next;
            }
            t = timeOfImpact.search(next, end, pairs.code(pair));
            pairs.setCode(pair, timeOfImpact.code);
            touching = timeOfImpact.touching;
        }
        return t;
    }

    /**
     * Looks for the instant at which a pair that lies on one another is deeper than it may be.
     *
     * @param pair its number
     * @param tau offset in the present step from which on to look
     * @param start what {@link #boundingCircles(int, double)} has just returned for it, finite
     * @param end offset at which the search may stop
     * @param slack penetration that is let be, length
     * @return as {@link #firstContact(int, double, double, double)}
     */
    public double firstContact(int pair, double tau, double start, double end, double slack) {
        if (!continuous) {
            return firstContact(pair, tau, start, end);
        }
        wake();
        apart = false;
        load(pair);
        pose.rounding -= slack;
        pose.lies = true;
        double found = timeOfImpact.search(tau, end, pairs.code(pair));
        pairs.setCode(pair, timeOfImpact.code);
        touching = timeOfImpact.touching;
        return mayGraze(pair) ? beyondGrazes(pair, found, end) : found;
    }

    /**
     * Chooses between impacts in continuous time and the write-up's bisection over the step.
     *
     * @param continuous true at first
     */
    public void setContinuous(boolean continuous) {
        this.continuous = continuous;
    }

    /** {@return whether impacts are found in continuous time; false for bisection} */
    public boolean isContinuous() {
        return continuous;
    }

    /** {@return how far a pair is apart where the last call of {@link #firstContact} looked last; NaN if that is not known} */
    public double clearance() {
        return clearance;
    }

    /** {@return whether the last call of {@link #firstContact} found a contact: then the offset it returned is that of a contact} */
    public boolean isTouching() {
        return touching;
    }

    /**
     * Whether the last call of {@link #firstContact} found that not even the bounding circles touch before the end, on
     * paths that hold for longer than the step.
     *
     * @return true if the offset it returned holds whatever the shapes are
     */
    public boolean isApart() {
        return apart;
    }

    /**
     * When the bounding circles of two bodies on parabolas of equal acceleration meet: the root of a quadratic. For
     * two circles that is the contact itself.
     *
     * @param pair its number
     * @param tau offset in the present step from which on to look
     * @return an offset up to which the bodies are apart, infinite if they never meet on their present paths
     */
    public double boundingCircles(int pair, double tau) {
        touching = false;
        if (!continuous) {
            return tau;
        }
        double start = circles.meet(pairs.first(pair), pairs.second(pair), tau);
        touching = circles.touching;
        return start;
    }

    /**
     * The same as {@link #boundingCircles} for a pair whose circles overlap.
     *
     * @param pair its number
     * @param tau offset in the present step from which on to look
     * @return as above
     */
    public double boundingCirclesWithin(int pair, double tau) {
        int i = pairs.first(pair);
        int j = pairs.second(pair);
        touching = false;
        return circles.hide(i, j) ? tau : boundingCircles(pair, tau);
    }

    /**
     * Until when a pair that has just collided is apart, if both move uniformly or fall alike; after {@link #contact}, which
     * has placed both, and after their velocities at this instant, their anchor, have changed.
     *
     * @param pair its number
     * @param tau offset in the present step
     * @return offset in the present step, infinite if they never touch again on their present paths, {@code tau} if it is
     *     not known
     */
    public double partUntil(int pair, double tau) {
        int i = pairs.first(pair);
        int j = pairs.second(pair);
        if (!trajectories.areStraight() && !CentrePath.areFree(trajectories, i, j)) {
            return tau;
        }
        if (isCircle(i) && isCircle(j)) {
            return circles.part(i, j, tau) ? Double.POSITIVE_INFINITY : tau;
        }
        if (pose == null || !pose.isOf(i, shapes.base(i, pairs.firstPart(pair)), j, shapes.base(j, pairs.secondPart(pair)), tau)) {
            return tau;
        }
        return tau + Rebound.time(pose, features, trajectories.data(), i * Trajectories.STRIDE, j * Trajectories.STRIDE);
    }

    /**
     * Takes it that the circles of a pair meet, as {@link #boundingCirclesOf} has found.
     *
     * @param pair its number
     */
    public void meets(int pair) {
        touching = isCircle(pairs.first(pair)) & isCircle(pairs.second(pair));
    }

    /**
     * The same for all pairs of a body at once, where nobody has ever been accelerated.
     *
     * @param body index
     * @param tau offset in the present step from which on to look
     * @return for each of {@link Pairs#of}: an offset up to which the two are apart; NaN if the pair has to be looked at
     */
    public double[] boundingCirclesOf(int body, double tau) {
        return circles.meetAll(body, pairs, tau);
    }

    /**
     * Whether a body is a circle.
     *
     * @param body index
     * @return false for polygons
     */
    public boolean isCircle(int body) {
        return shapes.isCircle(body);
    }

    /**
     * Distance of the surfaces of a pair.
     *
     * @param pair its number
     * @param tau offset in the present step
     * @return length, negative if they penetrate
     */
    public double gap(int pair, double tau) {
        place(pair, tau);
        return features.gap;
    }

    /**
     * Whether a pair touches, but for the rounding of its bodies' coordinates.
     *
     * @param pair its number
     * @param tau offset in the present step
     * @return false if there is a gap
     */
    public boolean touches(int pair, double tau) {
        place(pair, tau);
        return features.gap <= roundingOfGap();
    }

    /** {@return how fast the centres of the pair that was looked at last approach one another along its normal} */
    public double approach() {
        return -(pose.ux * features.nx + pose.uy * features.ny);
    }

    /** {@return what rounding of coordinates may make of the gap of the pair that was looked at last, length} */
    public double roundingOfGap() {
        return 4 * Tolerances.GAP * pose.extent;
    }

    /**
     * Where a pair touches.
     *
     * @param pair its number
     * @param tau offset in the present step
     * @param contact filled with the points and the normal
     */
    public void contact(int pair, double tau, Manifold contact) {
        if (trajectories.areStraight() && circles.contact(pairs.first(pair), pairs.second(pair), tau, contact)) {
            return;
        }
        contact(pair, tau, contact, Tolerances.FLUSH);
    }

    /**
     * Where a pair touches, or nearly does.
     *
     * @param pair its number
     * @param tau offset in the present step
     * @param contact filled with the points and the normal
     * @param flush height of an edge's other end from which it does not touch, relative to the bodies
     */
    public void contact(int pair, double tau, Manifold contact, double flush) {
        place(pair, tau);
        flushLimit = flush * pose.size;
        contact.begin(features, pose);
        if ((features.featureB & 1) != 0) {
            alongEdge(pose.b, features.featureB >> 1, pose.a, features.featureA >> 1, contact);
        } else if ((features.featureA & 1) != 0) {
            alongEdge(pose.a, features.featureA >> 1, pose.b, features.featureB >> 1, contact);
        } else {
            int i = features.featureA >> 1;
            addSurfacePoint(pose.a.vx[i], pose.a.vy[i], pose.a.rounding(), contact);
        }
        if (contact.count == 1) {
            exactLevers(contact);
        }
    }

    private void place(int pair, double tau) {
        wake();
        load(pair);
        pose.moveTo(tau);
        pose.turn();
        pairs.setCode(pair, features.find(pairs.code(pair)));
    }

    /** The point where a vertex touches an edge, or the stretch along which the vertex's edge lies on it. */
    private void alongEdge(Pose.Placed owner, int edge, Pose.Placed other, int deepest, Manifold contact) {
        int flush = flushNeighbour(owner, edge, other, deepest);
        boolean isStruck = flush < 0 && flushLimit == Tolerances.FLUSH * pose.size && contact.gap <= Tolerances.GAP * pose.extent;
        int vertex = isStruck ? StruckCorner.of(pose, owner, edge, other, deepest, -side(other)) : deepest;
        if (flush < 0 && (vertex == deepest || owner.isOver(edge, other, vertex))) {
            addCorner(owner, edge, other, vertex, contact);
        } else {
            addStretch(owner, edge, other, deepest, flush < 0 ? vertex : flush, contact);
        }
    }

    private void addCorner(Pose.Placed owner, int edge, Pose.Placed other, int vertex, Manifold contact) {
        double at = owner.along(edge, other, vertex);
        contact.room = Math.min(at, owner.length(edge) - at);
        addSurfacePoint(other.vx[vertex], other.vy[vertex], side(other) * other.rounding(), contact);
        if (other.n > 1 && flushLimit > Tolerances.FLUSH * pose.size) {
            addNear(owner, edge, other, (vertex + 1) % other.n, contact);
            addNear(owner, edge, other, (vertex + other.n - 1) % other.n, contact);
        }
    }

    private void addStretch(Pose.Placed owner, int edge, Pose.Placed other, int vertex, int flush, Manifold contact) {
        double ex = owner.normalX(edge);
        double ey = owner.normalY(edge);
        double at = owner.along(edge, other, vertex);
        double to = owner.along(edge, other, flush);
        double from = Math.max(0, Math.min(at, to));
        double end = Math.min(owner.length(edge), Math.max(at, to));
        double slope = (owner.height(edge, other, flush) - owner.height(edge, other, vertex)) / (to - at);
        contact.gaps[0] = contact.gap + slope * (from - at);
        contact.gaps[1] = contact.gap + slope * (end - at);
        contact.stretch(Math.min(at, to), Math.max(at, to), owner.length(edge), ENDS * pose.size);
        double x = owner.vx[edge];
        double y = owner.vy[edge];
        contact.add(x - ey * from, y + ex * from, pose.px, pose.py);
        if (end > from) {
            contact.add(x - ey * end, y + ex * end, pose.px, pose.py);
        }
    }

    private void addNear(Pose.Placed owner, int edge, Pose.Placed other, int vertex, Manifold contact) {
        double height = owner.height(edge, other, vertex);
        contact.addNear(other.vx[vertex], other.vy[vertex], pose.px, pose.py, height);
    }

    /** The neighbour of a vertex that lies on the edge's line too, or −1. */
    private int flushNeighbour(Pose.Placed owner, int edge, Pose.Placed other, int vertex) {
        if (other.n == 1) {
            return -1;
        }
        int next = (vertex + 1) % other.n;
        int previous = (vertex + other.n - 1) % other.n;
        double own = owner.height(edge, other, vertex);
        double atNext = Math.abs(owner.height(edge, other, next) - own);
        double atPrevious = Math.abs(owner.height(edge, other, previous) - own);
        if (Math.min(atNext, atPrevious) > flushLimit) {
            return -1;
        }
        return atNext <= atPrevious ? next : previous;
    }

    /** +1 for body A, whose surface lies along the normal, −1 for body B. */
    private int side(Pose.Placed body) {
        return body == pose.a ? 1 : -1;
    }

    private void addSurfacePoint(double x, double y, double rounding, Manifold contact) {
        contact.add(x + rounding * contact.nx, y + rounding * contact.ny, pose.px, pose.py);
    }

    /** A circle's lever arm is its radius along the normal, exactly, so that it gets no spin by rounding. */
    private void exactLevers(Manifold contact) {
        if (pose.a.isRound()) {
            contact.rAx[0] = pose.a.rounding() * contact.nx;
            contact.rAy[0] = pose.a.rounding() * contact.ny;
        }
        if (pose.b.isRound()) {
            contact.rBx[0] = -pose.b.rounding() * contact.nx;
            contact.rBy[0] = -pose.b.rounding() * contact.ny;
        }
    }

    /**
     * Number of poses at which closest features were looked for; an exact count of the work done.
     *
     * @return since the engine was made or restored
     */
    public long evaluations() {
        return timeOfImpact == null ? 0 : timeOfImpact.evaluations + separatingLine.evaluations;
    }

    private void wake() {
        if (pose == null) {
            pose = new Pose(shapes, trajectories);
            features = new ClosestFeatures(pose);
            separatingLine = new SeparatingLine(shapes, trajectories, pose, features);
            timeOfImpact = new TimeOfImpact(pose, features);
            bisection = new Bisection(pose, features);
        }
    }
}
