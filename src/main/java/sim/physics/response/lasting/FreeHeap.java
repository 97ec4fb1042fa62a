// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.CollisionDetection;
import sim.physics.collision.narrow.Manifold;
import sim.physics.internal.IntList;
import sim.physics.motion.Motion;
import sim.physics.motion.State;

/**
 * Heaps of bodies that nothing drives or ties. Where their solution is not found, points that are hardly open count as closed;
 * and one that is nearly right is kept. Then their bodies may be 10⁻⁴ of their size deep in one another, and part again when a
 * solution is found.
 */
final class FreeHeap implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Solutions for which points that are hardly open count as closed, once without that there was none. */
    private static final int RELENTS = 1000;

    /** Speed at which open points may be taken for closed, relative to the error that is good enough: 1e-5 of a size a step. */
    private static final double HOVER = 1e7;

    /** Bodies in a heap at most in which it is looked at how its points share a load, and when they strike: piles take up to twice the time. */
    static final int FEW = 12;

    /**
     * Part of its energy that a heap under forces may gain in the first half of a time, as it is lifted for the bends of its ways, which the
     * second half takes back; and times that something has happened to a body after which it is also lent when that is done at once. Fast
     * bodies that slide on one another as they turn would else close again and again.
     */
    private static final double LENT = 1e-4;

    private static final int OFTEN = 10;

    /** Part of a time that a shorter one is, for which a heap is solved that cannot be lifted for all of it. */
    static final double SHORTER = 0.25;

    /** How many shortest times rounding may take for longer. */
    static final double SHORTEST = 1.5;

    /** Part of the speed at which points approach with which they hop: no rounding may make that more. */
    static final double HOP = 0.99;

    /** Speed that is none, relative to that which the forces give in the time of a solution; and in a heap that is solved roughly. */
    private static final double STILL = 1e-7;

    private static final double STANDS = 1e-5;

    /** The same while a pair is deeper than it is to be: what is regained of it in a step is a fifth, and the rest would stay. */
    private static final double STILL_REGAINS = 1e-8;

    /** Speed that forces give a heap that has stopped, relative to what they would without contacts, from which nothing holds it. */
    private static final double SLIPS = 1e-3;

    /** Speed of a point that slides, relative to that which forces give in a time, from which it is looked at when it stops within that. */
    static final double SLIDES = 1 / 16.0;

    /** Part of a time that is the half of it, but for rounding: what stops then may have stopped before. */
    static final double STUCK = 0.501;

    /** Part of that time for which it surely slides. */
    static final double SOON = 0.25;

    /** Times that a heap may not be solved in a step, before little work is spent on it. */
    private static final int FAILURES = 3;

    /** Part of the squares of impulses that those of others are which are much less. */
    private static final double LESS = 1 / 16.0;

    private final CollisionDetection detection;
    private final HeapBodies by;
    private final HeapSystem system;
    private final HeapNotes notes;
    private final BodyScale scales;
    private final StraightGaps straight;
    private double[] kept = {};

    FreeHeap(
            CollisionDetection detection,
            HeapBodies by,
            HeapSystem system,
            HeapNotes notes,
            BodyScale scales) {
        this.detection = detection;
        this.by = by;
        this.system = system;
        this.notes = notes;
        this.scales = scales;
        this.straight = new StraightGaps(system);
    }

    /** Begins to take in the points of a heap. */
    void begin(IntList heap) {
        for (int k = 0; k < heap.size; k++) {
            if (by.failures[heap.values[k]] >= FAILURES) {
                system.spare();
            }
        }
    }

    /** Takes note of a point that has been taken in; it may start from what its last forces give in a part of the time. */
    void take(int p, double size, double time, double given, boolean isKnown) {
        if (isKnown) {
            notes.start(p, given);
        }
        system.tolerance().bear(system.tolerance().isRough() ? HeapGaps.fairSpeedOfMany(size, time) : HeapGaps.fairSpeed(size, time));
    }

    /**
     * Takes in where a point is, whose bodies go straight on for a time.
     *
     * @param depth that it may have
     * @param bend what turning and sliding may take of its gap at most
     * @return what they take, as it is known which way the gap bends; the most of what comes so near that it may strike
     */
    double follow(int p, Manifold manifold, int k, ContactPoint point, double depth, double bend, double size, double time) {
        straight.set(p, manifold, k, depth);
        double curvature = GapBend.curvature(manifold, k, point);
        boolean mayStrike = -point.opening * time > 2 * (depth + bend) + HeapGaps.fairDepth(size);
        return mayStrike || Double.isNaN(curvature) ? bend : Math.min(bend, GapBend.reserve(curvature, manifold.gaps[k] - depth, time));
    }

    /** For how much of a time bodies are given what forces and contacts give them when it begins. */
    static double given(double time, boolean isHalf) {
        return isHalf ? 0.5 * time : time;
    }

    /**
     * When the first point stops sliding if it goes on as has been found for half of a time. From then on friction may hold, or act the other way.
     *
     * @param before the velocities at the beginning
     * @param least speed that matters
     * @param shortest the shortest time
     * @return duration, infinite if there is none
     */
    double firstStop(double[] before, double time, double least, double shortest) {
        double first = Double.POSITIVE_INFINITY;
        for (int p = 0; p < system.contacts(); p++) {
            double now = system.tangent(p);
            double slip = now - system.tangent(p, system.v) + system.tangent(p, before);
            double left = slip > 0 ? now : -now;
            double size = Math.abs(slip);
            if (size > least && system.normalImpulse(p) > 0 && left < size) {
                first = Math.min(first, Math.max(shortest, 0.5 * time * size / (size - left)));
            }
        }
        return first;
    }

    /** Whether a heap whose bodies have a speed at most stands still, against what forces give in the time. */
    boolean isStill(double fastest, double given) {
        HeapTolerance tolerance = system.tolerance();
        return fastest <= (tolerance.isRough() ? STANDS : tolerance.isDeep() ? STILL_REGAINS : STILL) * given;
    }

    /**
     * Stops a heap that stands still from now on, and finds what holds it against a pull; nothing else depends on that.
     *
     * @return false if nothing holds it, as it has come to the end of its way up a slope: nothing is changed
     */
    boolean bear(IntList heap, Motion motion, double scale, double time, double pull, boolean isHalf) {
        if (pull == 0) {
            return true; // what has stopped it is noted, and nothing has to hold it
        }
        double[] last = Arrays.copyOf(system.v, 3 * heap.size);
        double none = STILL * pull * time;
        double[] fall = new double[State.BLOCK];
        for (int k = 0; k < heap.size; k++) {
            motion.fall(heap.values[k], fall, 0);
            for (int c = 0; c < State.BLOCK; c++) {
                system.v[3 * k + c] = fall[c] * time;
            }
        }
        for (int p = 0; p < system.size(); p++) {
            system.bound(p, system.bound(p) < -none ? system.bound(p) : 0);
        }
        system.solve(scale, true);
        if (scales.fastest(heap, system.v) > SLIPS * pull * time) {
            System.arraycopy(last, 0, system.v, 0, last.length);
            return false;
        }
        notes.hold(time, given(time, isHalf));
        Arrays.fill(system.v, 0, 3 * heap.size, 0);
        return true;
    }

    /** Solves a heap whose points have been taken in, for half of a time or all of it; false if the impulses are not nearly right. */
    boolean solve(IntList heap, double scale, double time, boolean isHalf) {
        if (system.solveSqueezed()) {
            return true;
        }
        int relents = 0;
        for (int k = 0; k < heap.size; k++) {
            relents = Math.max(relents, by.relents[heap.values[k]] - 1);
        }
        if (relents > 0) {
            relent();
        }
        if (isHalf && heap.size <= FEW) {
            HeapStart.leaveNoneOut(system);
            HeapStart.temper(system);
        }
        boolean done = system.solve(scale, true);
        if (!done && relents <= 0 && !system.isSpared()) {
            relents = RELENTS;
            system.again();
            relent();
            done = system.solve(scale, true);
        }
        for (int k = 0; k < heap.size; k++) {
            by.relents[heap.values[k]] = relents;
            by.failures[heap.values[k]] += done ? 0 : 1;
        }
        if (done && isHalf && straight.lift(time)) {
            system.again();
            done = system.solve(scale, true);
        }
        soften(time);
        return done;
    }

    /**
     * Takes points that are open by next to nothing for closed. Where more points touch than the bodies have freedoms, in a
     * pile of discs, not all of them can close at once, and which do would take long to find.
     */
    private void relent() {
        for (int p = 0; p < system.contacts(); p++) {
            double least = system.bound(p);
            system.bound(p, least < 0 && least > -HOVER * system.tolerance().enough() ? 0 : least);
        }
    }

    /**
     * Whether a heap that may not be lifted is to be solved for a shorter time: what lifts it for the bends of its ways is less then. Without forces
     * nothing is lent, and no time would be short enough.
     */
    boolean isShort(IntList heap, HeapPull pulls) {
        return by.mostTurns(heap) > OFTEN && pulls.isOnAny(heap);
    }

    /**
     * The last resort, where so much has happened in a step that this would not end: points that are too deep part as fast as they approached,
     * which neither gives energy nor takes any. While their bodies turn towards one another they hop, as deep as it takes. All of that
     * are impulses that contacts may give, so nothing is lost of what nothing opposes.
     */
    boolean hop(IntList heap, double[] before, double[] from, double scale, double time) {
        system.again();
        system.regainNothing();
        for (int p = 0; p < system.contacts(); p++) {
            double speed = -system.normal(p, before);
            system.bound(p, speed > 0 && notes.gap(p) < 0 ? HOP * speed : system.bound(p));
        }
        boolean done = system.solve(scale, true);
        soften(time);
        return by.afford(heap, HeapEnergy.gained(system, from), 0) ? done : regainNothing(scale, time);
    }

    /** Whether a heap has lost as much energy before in the step as it has gained now, but for what it is lent. */
    boolean affords(IntList heap, HeapPull pulls, double[] from, boolean isHalf) {
        boolean isLent = (isHalf || by.mostTurns(heap) > OFTEN) && pulls.isOnAny(heap);
        return by.afford(heap, HeapEnergy.gained(system, from), isLent ? LENT * HeapEnergy.of(system, from) : 0);
    }

    /** Solves without regaining gaps, which is to add no energy. */
    boolean regainNothing(double scale, double time) {
        boolean done = system.solve(scale, false);
        soften(time);
        return done;
    }

    /**
     * Solves a heap again in which friction locks what would have to part: no gap is regained, and points bear the least that holds them. If that is not much
     * less, all is as it was.
     *
     * @return whether impulses are right or nearly so
     */
    boolean giveWay(double scale, double time, boolean wasDone) {
        kept = system.impulses(kept);
        double most = HeapEnergy.squares(system);
        system.startFromNothing();
        system.again();
        system.regainNothing();
        boolean done = system.share.solve(system) || system.solve(scale, false);
        if (HeapEnergy.squares(system) > LESS * most) {
            system.put(kept);
            return wasDone;
        }
        notes.deepen(detection, scales);
        soften(time);
        return done;
    }

    private void soften(double time) {
        if (system.tolerance().error() > 0 && !system.tolerance().isRough()) {
            notes.soften(detection, scales, system.tolerance().error(), time);
        }
    }
}
