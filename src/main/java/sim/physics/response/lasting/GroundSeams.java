// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.CollisionDetection;
import sim.physics.collision.broad.Pairs;
import sim.physics.collision.narrow.Manifold;
import sim.physics.internal.IntList;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;

/**
 * Seams under a side that lies on fixed bodies laid edge to edge: where one of them ends another one goes on. No point of the side's contact is there, as
 * there is none where the ground is one body: what is borne at its outer points does not sink between them. As points the seams would be supports that
 * nobody needs, which pass under the side as it slides, and next to nothing decides which of them bear it.
 */
final class GroundSeams implements Serializable {
    private static final long serialVersionUID = 1L;

    /** By how much edges are out of line, or corners apart, that go on, relative to the body that lies on them. */
    private static final double FLUSH = 1e-9;

    /** Values per end of a ground: where it is, relative to the body's centre, and where the ground is at the other point. */
    private static final int STRIDE = 4;

    private final State state;
    private final Trajectories trajectories;
    private final CollisionDetection detection;
    private final Pairs pairs;

    /** The body whose seams are known. */
    private int body = -1;

    /** The ends of its grounds, a pair and a point in one number; where they are; and those of them that are seams. */
    private final IntList ends = new IntList();

    private double[] data = {};
    private final IntList seams = new IntList();
    private transient Manifold manifold;

    GroundSeams(State state, Trajectories trajectories, CollisionDetection detection) {
        this.state = state;
        this.trajectories = trajectories;
        this.detection = detection;
        this.pairs = detection.pairs();
    }

    /** Forgets what was found, as bodies may have moved. */
    void forget() {
        body = -1;
    }

    /**
     * Whether a point of a pair is at a seam of grounds on which its body lies.
     *
     * @param point 0 or 1
     */
    boolean has(int pair, int point, double tau) {
        int a = pairs.first(pair);
        int b = pairs.second(pair);
        if (state.body(a).isFixed() == state.body(b).isFixed()) {
            return false;
        }
        int own = state.body(a).isFixed() ? b : a;
        if (own != body) {
            body = own;
            find(tau);
        }
        return seams.contains(2 * pair + point);
    }

    private void find(double tau) {
        ends.clear();
        seams.clear();
        int grounds = 0;
        for (int m = 0; m < pairs.countOf(body); m++) {
            grounds += isGround(pairs.of(body, m)) ? 1 : 0;
        }
        for (int m = 0; m < pairs.countOf(body) && grounds > 1; m++) {
            if (isGround(pairs.of(body, m))) {
                take(pairs.of(body, m), tau);
            }
        }
    }

    private boolean isGround(int pair) {
        return detection.marks().isLasting(pair) && !detection.marks().isIgnored(pair) && state.body(pairs.other(pair, body)).isFixed();
    }

    /** Takes in where the grounds of a pair end, and finds whether there others go on that have been taken in before. */
    private void take(int pair, double tau) {
        double radius = trajectories.radius(body);
        Manifold m = manifold == null ? new Manifold() : manifold;
        manifold = m;
        detection.narrowPhase().contact(pair, tau, m, HeapGaps.flat(radius, radius + trajectories.radius(pairs.other(pair, body))));
        boolean isOnGround = m.owner == (pairs.first(pair) == body ? 1 : 0);
        int known = ends.size;
        for (int k = 0; k < 2 && m.count == 2 && !m.isAtEnds; k++) {
            if (m.isEnd[k] != isOnGround) {
                continue; // a corner of the body
            }
            int o = STRIDE * ends.size;
            data = data.length < o + STRIDE ? Arrays.copyOf(data, 2 * (o + STRIDE)) : data;
            place(pair, k, isOnGround, o);
            place(pair, 1 - k, isOnGround, o + 2);
            for (int other = 0; other < known; other++) {
                if (goesOn(ends.values[other] / 2, pair, STRIDE * other, o)) {
                    seams.add(ends.values[other]);
                    seams.add(2 * pair + k);
                }
            }
            ends.add(2 * pair + k);
        }
    }

    /** Where the ground is at a point: there, or beyond the gap from an edge of the body. */
    private void place(int pair, int k, boolean isOnGround, int at) {
        boolean isFirst = pairs.first(pair) == body;
        double away = isOnGround ? 0 : isFirst ? manifold.gaps[k] : -manifold.gaps[k];
        data[at] = (isFirst ? manifold.rAx[k] : manifold.rBx[k]) + away * manifold.nx;
        data[at + 1] = (isFirst ? manifold.rAy[k] : manifold.rBy[k]) + away * manifold.ny;
    }

    /** Whether an end is where one of another pair is, and the grounds go on from there in a line, with surfaces that are alike. */
    private boolean goesOn(int one, int other, int o, int p) {
        double size = FLUSH * trajectories.radius(body);
        double dx = data[p] - data[o];
        double dy = data[p + 1] - data[o + 1];
        if (part(one) != part(other) || dx * dx + dy * dy > size * size || !areAlike(pairs.other(one, body), pairs.other(other, body))) {
            return false;
        }
        double ux = data[o + 2] - data[o];
        double uy = data[o + 3] - data[o + 1];
        double vx = data[p + 2] - data[p];
        double vy = data[p + 3] - data[p + 1];
        double longer = Math.sqrt(Math.max(ux * ux + uy * uy, vx * vx + vy * vy));
        return ux * vx + uy * vy < 0 && Math.abs(ux * vy - uy * vx) <= size * longer;
    }

    private int part(int pair) {
        return pairs.first(pair) == body ? pairs.firstPart(pair) : pairs.secondPart(pair);
    }

    private boolean areAlike(int a, int b) {
        return state.friction(a) == state.friction(b) && state.restitution(a) == state.restitution(b) && state.beltSpeed(a) == state.beltSpeed(b);
    }
}
