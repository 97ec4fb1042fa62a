// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import sim.physics.collision.CollisionDetection;
import sim.physics.collision.narrow.Manifold;
import sim.physics.internal.IntList;
import sim.physics.motion.Motion;
import sim.physics.motion.State;
import sim.physics.motion.Ties;

/**
 * What meets at the instant at which a point of a heap strikes. A box that is made of parts, or falls on tiles, strikes with all corners of
 * its edge at once, at seams and at the end; and it is the end that bears it, whichever comes first by rounding.
 */
final class HeapMeeting implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Gap that is none, in parts of the depth that is allowed: what lies in a heap is off its ground by as much. */
    static final double NEAR = 4;

    private final State state;
    private final Motion motion;
    private final CollisionDetection detection;
    private final ContactPoints points;
    private final HeapBodies by;
    private final LastingPairs lasting;
    private final ContactPoint point = new ContactPoint();
    private transient Manifold manifold;

    HeapMeeting(
            State state, Motion motion, CollisionDetection detection, ContactPoints points, HeapBodies by, LastingPairs lasting) {
        this.state = state;
        this.motion = motion;
        this.detection = detection;
        this.points = points;
        this.by = by;
        this.lasting = lasting;
    }

    /**
     * Lets pairs of struck bodies with fixed ones and others of the heap last that close within a time.
     *
     * @param struck numbers of bodies in the heap
     * @param ties null if nothing ties bodies of the heap together
     * @return false if there are none
     */
    boolean join(IntList heap, IntList struck, Ties ties, double tau, double time) {
        boolean yes = false;
        for (int k = 0; k < struck.size; k++) {
            int body = heap.values[struck.values[k]];
            if (ties == null || !motion.isTied(body)) {
                yes |= join(body, tau, time);
                continue;
            }
            IntList island = ties.island(body);
            for (int m = 0; m < island.size; m++) {
                yes |= join(island.values[m], tau, time);
            }
        }
        return yes;
    }

    private boolean join(int body, double tau, double time) {
        boolean yes = false;
        for (int m = 0; m < detection.pairs().countOf(body); m++) {
            int pair = detection.pairs().of(body, m);
            int other = detection.pairs().other(pair, body);
            boolean isWithin = state.body(other).isImmobile() || by.knows(other) && by.place[other] > 0;
            if (isWithin && !detection.marks().isUnseen(pair) && !lasting.has(pair) && !detection.marks().isIgnored(pair)
                    && (points.areForeseen() || lieOnOneAnother(body, other)) && meets(pair, tau, time)) {
                lasting.begin(pair);
                yes = true;
            }
        }
        return yes;
    }

    private boolean lieOnOneAnother(int body, int other) {
        for (int m = 0; m < detection.pairs().countOf(body); m++) {
            int pair = detection.pairs().of(body, m);
            if (detection.pairs().other(pair, body) == other && lasting.has(pair)) {
                return true;
            }
        }
        return false;
    }

    private boolean meets(int pair, double tau, double time) {
        manifold = manifold == null ? new Manifold() : manifold;
        LastingPairs.look(detection, pair, tau, manifold);
        double depth = lasting.depth(pair);
        boolean yes = false;
        for (int k = 0; k < manifold.count; k++) {
            points.load(manifold, pair, k, point);
            yes |= point.opening < 0 && manifold.gaps[k] <= NEAR * depth - point.opening * time;
        }
        return yes;
    }
}
