// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.narrow;

import sim.physics.internal.Tolerances;

/**
 * Finds when two moving bodies touch first, in continuous time and rotation included, so that nothing tunnels.
 *
 * <p>It is conservative advancement (Mirtich 1996) of second order. Along the normal of the closest features the gap
 * of every vertex obeys
 *
 * <pre>
 *   g(τ + s)  ≥  g + g' s − M s²/2
 * </pre>
 *
 * <p>with M a bound of |g''| from the speeds, spins and accelerations. Up to the first root of the right side no vertex
 * can touch; the bodies are moved on by that much and looked at again. The bound is safe for any M, and as the gap
 * shrinks the step becomes Newton's, so it converges quadratically, and always from the side where the bodies are
 * apart.
 */
final class TimeOfImpact {
    /** Steps of the search with surfaces that nearly touch after which a little penetration is let be. */
    private static final int PATIENCE = 200;

    /** The same after which progress is forced, whatever it makes of that. */
    private static final int MOST_CLOSE = 100 * PATIENCE;

    /** Steps of the search after which a body that turns many times on its way is looked at as its bounding circle first. */
    private static final int FAST = 30;

    /** The same after which a body turns too often for any search to follow it, as none means: progress is forced. */
    private static final int ENDLESS = 1 << 20;

    /** The same where it turns that far on its way, rad: it would take more than those. */
    private static final int HOPELESS = 1 << 13;

    private static final double FAR = 0x1p17;
    private static final double LARGE = 0x1p-10;

    /** The gap of close steps, and that penetration, relative to the smaller body. */
    private static final double CLOSE = 1e-6;

    private static final double LEEWAY = 1e-10;

    private static final double INFINITE = Double.POSITIVE_INFINITY;

    /** Parts of the step by which a search moves on that rounding has stopped; a contact is believed after them. */
    private static final double[] NUDGE = {1e-13, 1e-12, 1e-11, 1e-10};

    /** Way to the end of a search, relative to the tolerance of gaps, that is none: approaches as slow do not count. */
    private static final double NO_WAY = 0x1p-7;

    /** Way that bodies graze one another without approaching, relative to their sizes, from which that is no contact. */
    private static final double GRAZE = 1e-12;

    /** Depth at which one of two lies on the edge of the other, relative to their sizes: what came to rest far from here is as deep as rounding is there. */
    private static final double STEP = 1e-12;

    private static final int NUDGES = NUDGE.length;

    private final Pose pose;
    private final ClosestFeatures features;

    /** Whether the bodies touch and approach at the instant that {@link #search} returned. */
    boolean touching;

    /** Code of the closest features at that instant. */
    int code;

    /** Number of poses looked at since the engine was made; a count of work. */
    long evaluations;

    private double tolerance;

    /** Time left to the end of the search. */
    private double horizon;

    private double slowness;

    /** Penetration that does not matter because the search has got stuck, length. */
    private double leeway;

    /** Speed, relative to the tolerance of gaps, that matters nowhere up to the end of the search. */
    private double standstill;

    /** Whether vertices beyond the ends of an edge count as those over it. */
    private boolean wholeLine;

    private double s;

    /** Bounds of |g‴| and of |g⁗|, or infinite if they are not known; and the present g‴, where the latter is. */
    private double third;

    private double fourth;
    private double jerk;

    TimeOfImpact(Pose pose, ClosestFeatures features) {
        this.pose = pose;
        this.features = features;
    }

    /**
     * Searches for the first contact of the loaded pair with approaching surfaces.
     *
     * @param start offset τ to start from; the bodies are known not to touch before
     * @param end offset at which the search may stop
     * @param cached features that were closest last time
     * @return offset of the contact if {@link #touching}, else an offset up to which they do not touch, ≥ end
     */
    double search(double start, double end, int cached) {
        double tau = start;
        code = cached;
        touching = false;
        standstill = NO_WAY / (end - start);
        double known = pose.until(end);
        int stuck = 0;
        double size = Math.min(pose.a.core + pose.a.rounding(), pose.b.core + pose.b.rounding());
        int patience = (pose.a.maxOmega + pose.b.maxOmega) * (end - start) > FAR ? HOPELESS : ENDLESS;
        int close = 0; // steps that were far from it were long, and get on by themselves
        for (int k = 0; ; k++) {
            pose.moveTo(tau);
            pose.turn();
            evaluations++;
            code = features.find(code);
            tolerance = Tolerances.GAP * pose.extent;
            horizon = end - tau;
            close += features.gap < CLOSE * size ? 1 : 0;
            leeway = close > PATIENCE ? LEEWAY * size : 0;
            advance();
            if (touching) {
                return tau;
            }
            s = k > FAST ? Math.max(s, asCircle()) : s;
            double forced = k > patience ? LARGE * (end - start) : close > MOST_CLOSE ? end * Tolerances.FORCED_PROGRESS : 0;
            double next = tau + Math.max(s, forced);
            if (!(next < end)) {
                return Math.min(next, known);
            }
            if (next == tau) {
                if (stuck == NUDGES) {
                    touching = true;
                    return tau;
                }
                next = tau + end * NUDGE[stuck++]; // surfaces that touch and do not approach yet
            }
            tau = next;
        }
    }

    /**
     * The time that surely passes before the circle around a body meets the line of the closest edge of another one, if that
     * edge does not turn; 0 if it does, or they have met.
     */
    private double asCircle() {
        boolean isEdgeOfB = (features.featureB & 1) != 0;
        Pose.Placed owner = isEdgeOfB ? pose.b : pose.a;
        Pose.Placed other = isEdgeOfB ? pose.a : pose.b;
        int feature = isEdgeOfB ? features.featureB : features.featureA;
        if ((feature & 1) == 0 || owner.maxOmega != 0 || owner.maxAlpha != 0) {
            return 0;
        }
        int side = isEdgeOfB ? -1 : 1;
        double ex = owner.normalX(feature >> 1);
        double ey = owner.normalY(feature >> 1);
        double height = (other.cx - owner.vx[feature >> 1]) * ex + (other.cy - owner.vy[feature >> 1]) * ey;
        double gap = height - other.core - pose.rounding;
        double pull = pose.accelerationIsConstant ? -side * (pose.ax * ex + pose.ay * ey) : pose.maxAcceleration;
        return gap > 0 ? GapBound.root(gap, side * (pose.ux * ex + pose.uy * ey), Math.max(0, pull)) : 0;
    }

    /**
     * Whether bodies that touch only graze one another: there is an edge that has all of the other body on its line or
     * beyond it, and no vertex there comes nearer, as between a box that slides over tiles and the tile ahead, which it
     * meets corner to corner. That holds however fast they approach along other normals.
     *
     * @param tau offset at which the loaded pair touches
     * @param end offset at which the search may stop
     * @return offset up to which it surely does; τ if they collide
     */
    double graze(double tau, double end) {
        pose.moveTo(tau);
        pose.turn();
        tolerance = Tolerances.GAP * pose.extent;
        horizon = end - tau;
        double speed = speed();
        slowness = Tolerances.APPROACH * speed;
        wholeLine = true;
        double most = Math.max(beyond(pose.a, pose.b, 1), beyond(pose.b, pose.a, -1));
        wholeLine = false;
        touching = !(most * speed > GRAZE * pose.size);
        return touching ? tau : tau + most;
    }

    /** The longest time for which all of a body surely stays beyond an edge of the other one; 0 if it does not. */
    private double beyond(Pose.Placed owner, Pose.Placed other, int side) {
        double most = 0;
        for (int edge = 0; edge < owner.n && owner.n > 1; edge++) {
            double ex = owner.normalX(edge);
            double ey = owner.normalY(edge);
            int k = other.support(-ex, -ey);
            double height = (other.vx[k] - owner.vx[edge]) * ex + (other.vy[k] - owner.vy[edge]) * ey;
            if (height - pose.rounding >= -Math.max(tolerance, STEP * pose.size)) {
                s = INFINITE;
                touching = false;
                advanceToEdge(owner, edge, other, k, side);
                most = touching ? most : Math.max(most, s);
            }
        }
        return most;
    }

    private double speed() {
        return Math.sqrt(pose.ux * pose.ux + pose.uy * pose.uy)
                + pose.a.maxOmega * pose.a.core
                + pose.b.maxOmega * pose.b.core;
    }

    /** Finds s, the time that surely passes before a contact, or notices that there is one. */
    private void advance() {
        slowness = Math.max(Tolerances.APPROACH * speed(), standstill * tolerance);
        s = INFINITE;
        if ((features.featureB & 1) != 0) {
            advanceToEdge(pose.b, features.featureB >> 1, pose.a, features.featureA >> 1, -1);
        } else if ((features.featureA & 1) != 0) {
            advanceToEdge(pose.a, features.featureA >> 1, pose.b, features.featureB >> 1, 1);
        } else {
            advanceToVertex();
            s = touching || s >= horizon || !pose.isPushed() ? s : TurningLine.time(pose, features, s, horizon);
        }
    }

    /**
     * The vertices of one body against an edge of the other, in the frame of the edge.
     *
     * @param side +1 if the other body is B, −1 if it is A
     */
    private void advanceToEdge(Pose.Placed owner, int edge, Pose.Placed other, int closest, int side) {
        double ex = owner.normalX(edge);
        double ey = owner.normalY(edge);
        double offset = owner.offset(edge) + pose.rounding;
        double bound = boundNearEdge(owner, other, side * ex, side * ey);
        double relative = other.omega - owner.omega;
        double twist = other.alpha - owner.alpha;
        double pull = side * (pose.ax * ex + pose.ay * ey) + side * owner.alpha * (pose.py * ex - pose.px * ey);
        double closestAlong = 0;
        double closestRate = 0;
        for (int j = 0; j < other.n; j++) {
            int k = j == 0 ? closest : j <= closest ? j - 1 : j; // the closest vertex first
            double qx = other.vx[k] - owner.cx;
            double qy = other.vy[k] - owner.cy;
            double rx = other.vx[k] - other.cx;
            double ry = other.vy[k] - other.cy;
            double g = qx * ex + qy * ey - offset;
            double wx = side * pose.ux - other.omega * ry + owner.omega * qy;
            double wy = side * pose.uy + other.omega * rx - owner.omega * qx;
            double curvature = pull + twist * (rx * ey - ry * ex) + side * 2 * owner.omega * (pose.uy * ex - pose.ux * ey)
                    - relative * relative * (rx * ex + ry * ey)
                    - owner.omega * owner.omega * ((qx - rx) * ex + (qy - ry) * ey);
            double rate = wx * ex + wy * ey;
            jerk = fourth < INFINITE ? jerk(owner, other, side, ex, ey, k) : 0;
            double along = (other.vy[k] - owner.vy[edge]) * ex - (other.vx[k] - owner.vx[edge]) * ey;
            if (j == 0) {
                closestAlong = along;
                closestRate = rate;
            }
            double onEdge = Math.max(0, Math.min(owner.length(edge), along));
            // where edges lie flush, one beyond the end that does not rise: what counts is the end of the stretch
            boolean isOutside = !wholeLine && j > 0 && g <= tolerance && onEdge != along && rate <= slowness;
            if (isOutside && rate < -slowness) {
                advanceFlush(owner, along < 0 ? edge : (edge + 1) % owner.n, other, closest, k, -side);
                return;
            }
            if (isOutside) {
                double share = (onEdge - closestAlong) / (along - closestAlong);
                double least = closestRate + share * (rate - closestRate);
                limitSlowly(g, least, 2 * Math.max(bound, boundOfEnd(owner, other, side * ex, side * ey)));
            } else {
                limit(g, rate, bound, curvature);
            }
            if (touching) {
                return;
            }
        }
    }

    /**
     * A vertex comes down on the line of an edge beyond its end, from where it lies flush: that line parts the bodies no
     * more, but the line of the vertex's own edge does, which rises over the end.
     *
     * @param end the vertex at that end
     * @param closest the other end of the vertex's edge, and the vertex
     */
    private void advanceFlush(Pose.Placed owner, int end, Pose.Placed other, int closest, int vertex, int side) {
        int edge = vertex == (closest + 1) % other.n ? closest : vertex;
        s = INFINITE;
        wholeLine = true;
        advanceToEdge(other, edge, owner, end, side);
        wholeLine = false;
    }

    /** The present g‴ of a vertex over an edge, under constant accelerations. */
    private double jerk(Pose.Placed owner, Pose.Placed other, int side, double ex, double ey, int k) {
        double rx = other.vx[k] - other.cx;
        double ry = other.vy[k] - other.cy;
        double spin = owner.omega;
        double relative = other.omega - spin;
        double ofCentres = -3 * spin * owner.alpha * (pose.px * ex + pose.py * ey)
                - spin * spin * spin * (pose.py * ex - pose.px * ey)
                + 3 * owner.alpha * (pose.uy * ex - pose.ux * ey)
                - 3 * spin * spin * (pose.ux * ex + pose.uy * ey)
                + 3 * spin * (pose.ay * ex - pose.ax * ey);
        return side * ofCentres
                - 3 * relative * (other.alpha - owner.alpha) * (rx * ex + ry * ey)
                - relative * relative * relative * (rx * ey - ry * ex);
    }

    /** Like {@link #limit}, without a bound of the third derivative. */
    private void limitSlowly(double gap, double rate, double bound) {
        double known = third;
        third = INFINITE;
        limit(gap, rate, bound, 0);
        third = known;
    }

    /** Bound M of |g''| of the end of an edge over the flush edge of the other body. */
    private double boundOfEnd(Pose.Placed owner, Pose.Placed other, double nx, double ny) {
        double known = third;
        double knownOfFourth = fourth;
        double bound = boundNearEdge(other, owner, nx, ny);
        third = known;
        fourth = knownOfFourth;
        return bound;
    }

    /** Bound M of |g''| of the vertices of one body over a spinning edge of the other, until they part. */
    private double boundNearEdge(Pose.Placed owner, Pose.Placed other, double nx, double ny) {
        third = INFINITE;
        fourth = INFINITE;
        if (pose.isLinear()) {
            return boundInFrame(owner, other);
        }
        double turning = other.maxOmega * other.maxOmega + other.maxAlpha;
        if (owner.maxOmega == 0 && owner.maxAlpha == 0) {
            // the normal stands still: only the acceleration along it counts
            double along = pose.accelerationIsConstant ? -(pose.ax * nx + pose.ay * ny) : pose.maxAcceleration;
            if (pose.isQuadratic()) {
                third = thirdOfSpin(owner, other);
                fourth = pose.isPushed() ? fourthOfSpin(owner, other) : INFINITE;
            }
            return Math.max(0, along + turning * other.core);
        }
        double distance = Math.sqrt(pose.px * pose.px + pose.py * pose.py);
        double speed = Math.sqrt(pose.ux * pose.ux + pose.uy * pose.uy);
        double reach = Math.max(distance, pose.bounding);
        if (pose.maxAcceleration > 0) {
            // limit the look ahead so that the distance stays bounded
            double ahead = Math.min(
                    (distance + pose.bounding) / Math.max(speed, Double.MIN_NORMAL),
                    Math.sqrt((distance + pose.bounding) / pose.maxAcceleration));
            s = Math.min(s, ahead);
            speed += pose.maxAcceleration * ahead;
            reach = distance + speed * ahead;
        }
        if (pose.isQuadratic()) {
            double spin = owner.maxOmega;
            double square = owner.maxAlpha + spin * spin;
            third = thirdOfSpin(owner, other)
                    + 3 * spin * pose.maxAcceleration
                    + 3 * square * speed
                    + spin * (3 * owner.maxAlpha + spin * spin) * reach;
            fourth = !pose.isPushed() ? INFINITE : fourthOfSpin(owner, other)
                    + 6 * square * pose.maxAcceleration
                    + 4 * spin * (3 * owner.maxAlpha + spin * spin) * speed
                    + GapBound.fourthOfTurn(spin, owner.maxAlpha) * reach;
        }
        return pose.maxAcceleration
                + turning * other.core
                + 2 * owner.maxOmega * (speed + other.maxOmega * other.core)
                + (owner.maxOmega * owner.maxOmega + owner.maxAlpha) * (reach + other.core);
    }

    /** The part of a bound of |g‴| that comes from the spin of a body relative to the edge, under constant accelerations. */
    private double thirdOfSpin(Pose.Placed owner, Pose.Placed other) {
        double relative = other.maxOmega + owner.maxOmega;
        double twist = Math.abs(other.alpha - owner.alpha);
        return relative * (3 * twist + relative * relative) * other.core;
    }

    /** The same of |g⁗|. */
    private static double fourthOfSpin(Pose.Placed owner, Pose.Placed other) {
        return GapBound.fourthOfTurn(other.maxOmega + owner.maxOmega, Math.abs(other.alpha - owner.alpha)) * other.core;
    }

    /**
     * The same for bodies that move and spin uniformly, in the frame that turns with the edge: there a vertex goes round
     * its centre with the relative spin, and the centre on a straight line goes round the edge's body. Bounds g‴ too.
     */
    private double boundInFrame(Pose.Placed owner, Pose.Placed other) {
        double spin = Math.abs(owner.omega);
        double relative = Math.abs(other.omega - owner.omega);
        double turning = relative * relative * other.core;
        if (spin == 0) {
            third = relative * turning;
            return turning;
        }
        double speed = Math.sqrt(pose.ux * pose.ux + pose.uy * pose.uy);
        // the bounding circles overlap until they part for good, so the centres stay this close
        double reach = Math.max(Math.sqrt(pose.px * pose.px + pose.py * pose.py), pose.bounding);
        third = relative * turning + spin * spin * (3 * speed + spin * reach);
        return turning + spin * (2 * speed + spin * reach);
    }

    /** The vertices of both bodies along the line between the two closest ones, which is held still. */
    private void advanceToVertex() {
        double nx = features.nx;
        double ny = features.ny;
        Pose.Placed a = pose.a;
        Pose.Placed b = pose.b;
        double along = pose.accelerationIsConstant ? -(pose.ax * nx + pose.ay * ny) : pose.maxAcceleration;
        double bound = Math.max(
                0,
                along
                        + (a.maxOmega * a.maxOmega + a.maxAlpha) * a.core
                        + (b.maxOmega * b.maxOmega + b.maxAlpha) * b.core);
        double approach = pose.ux * nx + pose.uy * ny;
        int i = features.featureA >> 1;
        int j = features.featureB >> 1;
        third = INFINITE;
        limit(features.gap, approach + spin(b, j, nx, ny) - spin(a, i, nx, ny), bound, 0);
        if (s == INFINITE && a.maxOmega + b.maxOmega > 0) {
            s = horizon; // these two part for ever, but not so others
        }
        // other vertices may come first: look for a pair that would have crossed by then
        while (!touching && s < INFINITE && (a.n > 1 || b.n > 1)) {
            int first = lead(a, nx, ny);
            int second = lead(b, -nx, -ny);
            if (first == i && second == j) {
                return;
            }
            i = first;
            j = second;
            double g = (b.vx[j] - a.vx[i]) * nx + (b.vy[j] - a.vy[i]) * ny - pose.rounding;
            double before = s;
            limit(Math.max(g, 2 * tolerance), approach + spin(b, j, nx, ny) - spin(a, i, nx, ny), bound, 0);
            if (s == before) {
                return;
            }
        }
    }

    /** The vertex that would be farthest along a direction after the time s at its present velocity. */
    private int lead(Pose.Placed body, double nx, double ny) {
        int best = 0;
        double most = -INFINITE;
        for (int k = 0; k < body.n; k++) {
            double d = body.vx[k] * nx + body.vy[k] * ny + s * spin(body, k, nx, ny);
            if (d > most) {
                most = d;
                best = k;
            }
        }
        return best;
    }

    /** Velocity of a vertex along n that comes from its body's spin: θ̇ r⊥ · n, (21). */
    private static double spin(Pose.Placed body, int k, double nx, double ny) {
        return body.omega * ((body.vx[k] - body.cx) * ny - (body.vy[k] - body.cy) * nx);
    }

    /**
     * Lowers s to the first root of g + g' s − M s²/2, or notices a contact. Where the present g″ and a bound T of |g‴|
     * are known, −g″ + T S/3 is as good as M up to a time S, and often smaller; where more is known see {@link GapBound}.
     */
    private void limit(double gap, double rate, double bound, double curvature) {
        double g = gap;
        if (g <= tolerance) {
            if (rate < -slowness || rate < -0.1 * slowness && g < -Tolerances.DEEP * pose.size) {
                touching = true;
                return;
            }
            double rise = rate * rate + 2 * bound * g;
            if (rate > slowness && rise > 0) {
                s = Math.min(s, bound == 0 ? INFINITE : (rate + Math.sqrt(rise)) / bound); // back at gap zero
                return;
            }
            g = Math.max(0, g) + tolerance; // touching and sliding: let it go as far as can do no harm
        }
        g = Math.max(g, leeway);
        if (g + s * (rate - 0.5 * s * bound) >= 0 && s < INFINITE) {
            return; // the bound is concave: it is not negative before s
        }
        double root = GapBound.root(g, rate, bound);
        if (third < INFINITE && root < s) {
            root = GapBound.ahead(g, rate, curvature, third, jerk, fourth, root, Math.min(s, horizon));
            root = rate < 0 ? root : Math.max(root, GapBound.rise(rate, curvature, third));
        }
        s = Math.min(s, root);
    }
}
