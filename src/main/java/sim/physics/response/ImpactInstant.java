// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import sim.physics.collision.CollisionDetection;
import sim.physics.collision.broad.Pairs;
import sim.physics.collision.narrow.Manifold;
import sim.physics.internal.IntList;
import sim.physics.internal.Tolerances;
import sim.physics.motion.Motion;
import sim.physics.motion.Trajectories;
import sim.physics.response.lasting.Heaps;

/**
 * The instant of an impact: brings the bodies of pairs there, finds where they touch, and moves it to where driven ones do. What happens
 * because of the impact happens then, too: whoever was brought back from there would go back with the velocity that he has after it.
 */
final class ImpactInstant implements Serializable {
    private static final long serialVersionUID = 1L;

    private final Trajectories trajectories;
    private final Motion motion;
    private final CollisionDetection detection;
    private final Pairs pairs;
    private final ContactLoader loader;
    private final Heaps heaps;
    private final Bounces bounces;
    private final Impact impact;
    private transient Manifold manifold;

    /** From when on the courses of the bodies hold that are brought there. */
    private double since;

    private double at;

    ImpactInstant(
            Trajectories trajectories, Motion motion, CollisionDetection detection, ContactLoader loader, Heaps heaps, Bounces bounces, Impact impact) {
        this.trajectories = trajectories;
        this.motion = motion;
        this.detection = detection;
        this.pairs = detection.pairs();
        this.loader = loader;
        this.heaps = heaps;
        this.bounces = bounces;
        this.impact = impact;
    }

    /** Begins with the pairs that touch, before any of their bodies is brought there; returns where they are to touch. */
    Manifold begin(IntList touching, double tau) {
        manifold = manifold == null ? new Manifold() : manifold;
        at = tau;
        since = 0;
        for (int k = 0; k < touching.size; k++) {
            int pair = touching.values[k];
            since = isDriven(pair) ? Math.max(since, Math.max(since(pairs.first(pair)), since(pairs.second(pair)))) : since;
        }
        return manifold;
    }

    /** Offset in the present step. */
    double at() {
        return at;
    }

    private boolean isDriven(int pair) {
        return trajectories.isDriven(pairs.first(pair)) || trajectories.isDriven(pairs.second(pair));
    }

    /** Whether ties may all but hold the two where they touch: where the gap is zero is anywhere then, and their heap is left at the instant of the search. */
    private boolean isTied(int pair) {
        return motion.isTied(pairs.first(pair)) || motion.isTied(pairs.second(pair));
    }

    /** From which offset in the step on the motion of a body has been smooth, and of all that it lies on. */
    private double since(int body) {
        return heaps.has(body) ? heaps.since(body) : motion.smoothSince(body);
    }

    /** Brings the bodies of a pair to an instant, and finds where they touch. */
    void locate(int pair, double tau) {
        motion.bring(pairs.first(pair), tau);
        motion.bring(pairs.second(pair), tau);
        detection.narrowPhase().contact(pair, tau, manifold);
    }

    /** Loads the impact of a point. */
    void load(int a, int b, int point) {
        loader.load(manifold, a, b, point, impact);
        impact.restitution = impact.sticky ? 0 : impact.restitution;
        impact.exclude(heaps.toCome(a, impact.nx, impact.ny, impact.leverA) - heaps.toCome(b, impact.nx, impact.ny, impact.leverB));
    }

    /**
     * The search found the contact on the dense output of driven bodies, which is not quite where the integrator brings
     * them: moves the instant a little, to where the gap is zero, by Newton's method.
     *
     * @return whether they do touch and approach; if not, they go on from where they were brought
     */
    boolean polish(int pair, int a, int b) {
        if (!isDriven(pair)) {
            return true;
        }
        double h = Math.min(motion.pace(a), motion.pace(b));
        double latest = detection.hasEvent() ? detection.nextTime() : trajectories.h();
        double t = at;
        for (int k = 0; k < 3; k++) {
            double speed = impact.normalVelocity();
            double next = t - manifold.gap / speed;
            boolean settled = Math.abs(manifold.gap) <= -speed * Tolerances.SIMULTANEOUS * t;
            boolean near = Math.abs(next - at) <= Tolerances.POLISH * h;
            if (settled || !(speed < 0 && near && next >= since && next <= latest)) {
                break; // or else other events lie between
            }
            double most = Math.max(0.5 * Math.abs(manifold.gap), -speed * Tolerances.REST * h);
            locate(pair, next);
            load(a, b, 0);
            if (!(impact.normalVelocity() < 0 && Math.abs(manifold.gap) <= most)) {
                locate(pair, t); // a graze, where Newton's method leads astray
                load(a, b, 0);
                break;
            }
            t = next;
        }
        at = isTied(pair) ? at : t;
        boolean touch = impact.normalVelocity() < 0 && manifold.gap <= Math.max(-impact.normalVelocity() * Tolerances.REST * h, bounces.rounding(a, b));
        return touch || bounces.misses(pair);
    }

    /** The same for several pairs that touch at once: none of them is deep then. */
    void polish(IntList touching) {
        int deepest = -1;
        double gap = 0;
        for (int k = 0; k < touching.size; k++) {
            int pair = touching.values[k];
            if (!isDriven(pair) || heaps.lasts(pair) || isTied(pair)) {
                continue;
            }
            locate(pair, at);
            if (manifold.gap < Math.min(gap, -bounces.rounding(pairs.first(pair), pairs.second(pair)))) {
                deepest = pair;
                gap = manifold.gap;
            }
        }
        if (deepest >= 0) {
            locate(deepest, at);
            load(pairs.first(deepest), pairs.second(deepest), 0);
            polish(deepest, pairs.first(deepest), pairs.second(deepest));
        }
    }
}
