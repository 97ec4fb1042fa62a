// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import sim.physics.collision.CollisionDetection;
import sim.physics.collision.broad.Pairs;
import sim.physics.collision.narrow.Manifold;
import sim.physics.internal.IntList;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;

/** Fixed bodies side by side that bear a body together, as tiles in a row do: where one ends the next one goes on. */
final class FlushGround implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Cosine between normals that are the same. */
    private static final double PARALLEL = 1 - 1e-12;

    /** Distance up to which a body of a heap lies on the ground, relative to it. */
    private static final double LYING = 1e-9;

    private final State state;
    private final Trajectories trajectories;
    private final CollisionDetection detection;
    private final GroundSeams seams;
    private final IntList found = new IntList();
    private transient Manifold manifold;

    /** The normal of the ground that was looked at last, towards the body. */
    private double nx;

    private double ny;

    /** Outermost points of the ground that bear a body, along it from the centre of mass. */
    private double first;

    private double last;

    FlushGround(State state, Trajectories trajectories, CollisionDetection detection) {
        this.state = state;
        this.trajectories = trajectories;
        this.detection = detection;
        this.seams = new GroundSeams(state, trajectories, detection);
    }

    /** The seams under what lies on it. */
    GroundSeams seams() {
        return seams;
    }

    /** Lets a body that rests lie also on what goes on flush with that, from the instant on at which it touches it. */
    void hold(int body, double tau, ContactLedger ledger) {
        Pairs pairs = detection.pairs();
        for (int k = 0; k < pairs.countOf(body); k++) {
            int pair = pairs.of(body, k);
            if (!detection.marks().isUnseen(pair) && isGround(pair, body) && touches(pair, tau) && goesOn(pair, body, tau)) {
                detection.hold(pair, true);
                ledger.begin(pair, false);
            }
        }
    }

    /**
     * Lets the bodies of a heap lie also on what goes on flush with the ground that they lie on.
     *
     * @param depth how deep bodies may be in that, relative to their size
     */
    void spread(IntList heap, double tau, double depth, LastingPairs lasting) {
        IntList onto = find(heap, tau, Math.max(LYING, HeapMeeting.NEAR * depth));
        for (int k = 0; k < onto.size; k++) {
            lasting.begin(onto.values[k]);
        }
    }

    /** The pairs of fixed ones on which they are to lie, too. They lie at a distance. */
    private IntList find(IntList heap, double tau, double near) {
        Pairs pairs = detection.pairs();
        found.clear();
        for (int k = 0; k < heap.size; k++) {
            int body = heap.values[k];
            double reach = near * trajectories.radius(body);
            for (int m = 0; m < pairs.countOf(body); m++) {
                int pair = pairs.of(body, m);
                boolean isNew = !detection.marks().isUnseen(pair) && !detection.marks().isLasting(pair) && isGround(pair, body);
                if (isNew && gap(pair, tau) < reach && goesOn(pair, body, tau)) {
                    found.add(pair);
                }
            }
        }
        return found;
    }

    private boolean goesOn(int pair, int body, double tau) {
        Pairs pairs = detection.pairs();
        boolean yes = false;
        for (int k = 0; k < pairs.countOf(body) && !yes; k++) {
            int other = pairs.of(body, k);
            if (detection.marks().isHeld(other) || detection.marks().isLasting(other) && isGround(other, body)) {
                look(pair, body, tau);
                yes = detection.narrowPhase().isCircle(body) ? meets(other, body, tau) : isSame(other, body, tau);
            }
        }
        return yes;
    }

    /** Whether a disc touches a ground where that is in line with the one that was looked at last, or ends in that line: behind a seam that is a corner. */
    private boolean meets(int pair, int body, double tau) {
        double x = nx;
        double y = ny;
        double radius = trajectories.radius(body);
        double distance = radius + manifold.gap;
        look(pair, body, tau);
        return Math.abs((radius + manifold.gap) * (x * nx + y * ny) - distance) <= LYING * radius;
    }

    /** Whether a body touches several fixed ones, all of the same normal, and nothing else, and they can bear it together. */
    boolean isShared(int body, double tau) {
        if (!hasSeveral(body)) {
            return false;
        }
        Pairs pairs = detection.pairs();
        int count = 0;
        first = Double.POSITIVE_INFINITY;
        last = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < pairs.countOf(body); k++) {
            int pair = pairs.of(body, k);
            if (detection.marks().isIgnored(pair) || !touches(pair, tau)) {
                continue;
            }
            if (!isGround(pair, body) || !isSame(pair, body, tau) && count > 0) {
                return false;
            }
            reach(pair, body);
            count++;
        }
        return count > 1 && bears(trajectories.radius(body));
    }

    /** Takes in where the pair that was looked at last bears a body: along the ground, from the centre of mass. */
    private void reach(int pair, int body) {
        boolean isFirst = detection.pairs().first(pair) == body;
        boolean isRound = isFirst ? manifold.roundA : manifold.roundB;
        for (int k = 0; k < manifold.count; k++) {
            double x = isFirst ? manifold.rAx[k] : manifold.rBx[k];
            double y = isFirst ? manifold.rAy[k] : manifold.rBy[k];
            first = Math.min(first, isRound ? -trajectories.radius(body) : x * ny - y * nx);
            last = Math.max(last, isRound ? trajectories.radius(body) : x * ny - y * nx);
        }
    }

    /** Whether the centre of mass is between the outermost points; a corner on a seam is one point, on which a body tips. */
    private boolean bears(double radius) {
        return first <= 0 && last >= 0 && last - first > LYING * radius;
    }

    private boolean hasSeveral(int body) {
        Pairs pairs = detection.pairs();
        int count = 0;
        for (int k = 0; k < pairs.countOf(body); k++) {
            count += isGround(pairs.of(body, k), body) ? 1 : 0;
        }
        return count > 1;
    }

    private boolean isGround(int pair, int body) {
        return state.body(detection.pairs().other(pair, body)).isImmobile();
    }

    /** Whether a pair touches. The features that were closest when an impact was looked for are kept. */
    private boolean touches(int pair, double tau) {
        int code = detection.pairs().code(pair);
        boolean yes = detection.narrowPhase().touches(pair, tau);
        detection.pairs().setCode(pair, code);
        return yes;
    }

    private double gap(int pair, double tau) {
        int code = detection.pairs().code(pair);
        double gap = detection.narrowPhase().gap(pair, tau);
        detection.pairs().setCode(pair, code);
        return gap;
    }

    /** Whether a pair has the normal of the one that was looked at last; looks at it. */
    private boolean isSame(int pair, int body, double tau) {
        double x = nx;
        double y = ny;
        look(pair, body, tau);
        return x * nx + y * ny > PARALLEL;
    }

    private void look(int pair, int body, double tau) {
        manifold = manifold == null ? new Manifold() : manifold;
        LastingPairs.look(detection, pair, tau, manifold);
        double side = detection.pairs().first(pair) == body ? -1 : 1;
        nx = side * manifold.nx;
        ny = side * manifold.ny;
    }
}
