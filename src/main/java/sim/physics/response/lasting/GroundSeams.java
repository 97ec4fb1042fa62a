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
import sim.physics.motion.Steering;
import sim.physics.motion.Trajectories;

/**
 * Seams under a side that lies on bodies laid edge to edge which are fixed, or which their authors move alike: where one of them ends another one goes
 * on. No point of the side's contact is there, as there is none where the ground is one body: what is borne at its outer points does not sink between
 * them. As points the seams would be supports that nobody needs, which pass under the side as it slides, and next to nothing decides which of them bear it.
 *
 * <p>A corner of the body that comes to a seam is borne by the ground that it is on, and not by the corner of the next one, from which the gap that is
 * kept in heaps parts it in any direction.
 */
final class GroundSeams implements Serializable {
    private static final long serialVersionUID = 1L;

    /** By how much edges are out of line, or corners apart, that go on, relative to the body that lies on them. */
    private static final double FLUSH = 1e-9;

    /** What a point is: an end of the ground, a corner of the body, both, or a corner of the one and of the other beside one another. */
    private static final int END = 0;

    private static final int BODY = 1;
    private static final int BOTH = 2;
    private static final int BESIDE = 3;

    /** Values per point: where the ground is there, relative to the body's centre, and at the other point of its pair. */
    private static final int STRIDE = 4;

    private final State state;
    private final Trajectories trajectories;
    private final CollisionDetection detection;
    private final Pairs pairs;

    /** The body whose seams are known. */
    private int body = -1;

    /** The points of its grounds: a pair and a point in one number, what they are, and where. */
    private final IntList points = new IntList();

    private final IntList kinds = new IntList();
    private double[] data = {};

    /** Those at seams; and those of both at which the body's corner goes on to the next ground. */
    private final IntList seams = new IntList();

    private final IntList passed = new IntList();
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
     * Whether a point of a pair is at a seam of grounds on which its body lies, and is none.
     *
     * @param point 0 or 1
     */
    boolean has(int pair, int point, double tau) {
        int a = pairs.first(pair);
        int b = pairs.second(pair);
        if (state.body(a).isDynamic() == state.body(b).isDynamic()) {
            return false;
        }
        int own = state.body(a).isDynamic() ? a : b;
        if (own != body) {
            body = own;
            find(tau);
        }
        return seams.contains(2 * pair + point);
    }

    /** Says which corner is followed of a point for which {@link #has} was asked: the body's own one where it goes on to the next ground. */
    void follow(int pair, int point, Manifold m) {
        if (passed.contains(2 * pair + point)) {
            m.follow(point, pairs.first(pair) == body);
        }
    }

    private void find(double tau) {
        points.clear();
        kinds.clear();
        seams.clear();
        passed.clear();
        int grounds = 0;
        for (int m = 0; m < pairs.countOf(body); m++) {
            grounds += isGround(pairs.of(body, m)) ? 1 : 0;
        }
        for (int m = 0; m < pairs.countOf(body) && grounds > 1; m++) {
            if (isGround(pairs.of(body, m)) && detection.marks().isLasting(pairs.of(body, m))) {
                take(pairs.of(body, m), tau);
            }
        }
        for (int m = 0; m < pairs.countOf(body) && kinds.contains(BOTH); m++) {
            if (isGround(pairs.of(body, m)) && !detection.marks().isLasting(pairs.of(body, m))) {
                take(pairs.of(body, m), tau);
            }
        }
    }

    private boolean isGround(int pair) {
        return !detection.marks().isIgnored(pair) && !state.body(pairs.other(pair, body)).isDynamic();
    }

    /** Takes in the points of a pair, and compares them with those that have been taken in before. */
    private void take(int pair, double tau) {
        double radius = trajectories.radius(body);
        Manifold m = manifold == null ? new Manifold() : manifold;
        manifold = m;
        int code = pairs.code(pair);
        detection.narrowPhase().contact(pair, tau, m, HeapGaps.flat(radius, radius + trajectories.radius(pairs.other(pair, body))));
        pairs.setCode(pair, code); // as it was when its impact was looked for
        boolean isFirst = pairs.first(pair) == body;
        boolean isOnGround = m.owner == (isFirst ? 1 : 0);
        boolean isBeside = m.isAtEnds || m.count == 1 && m.owner < 0 && m.radiusA + m.radiusB == 0;
        boolean isAny = isBeside || m.count == 2 && detection.marks().isLasting(pair);
        for (int k = 0; isAny && k < (isBeside ? 1 : 2); k++) {
            int o = STRIDE * points.size;
            data = data.length < o + STRIDE ? Arrays.copyOf(data, 2 * (o + STRIDE)) : data;
            boolean isGiven = m.owner < 0 ? !isFirst : isOnGround; // a single point is given on the first body
            place(k, isFirst, isGiven, o);
            place(isBeside ? k : 1 - k, isFirst, isGiven, o + 2);
            points.add(2 * pair + k);
            kinds.add(isBeside ? BESIDE : m.isOfBoth(k) ? BOTH : m.isEnd[k] == isOnGround ? END : BODY);
            for (int other = 0; other < points.size - 1; other++) {
                compare(other, points.size - 1);
            }
        }
    }

    /** Where the ground is at a point: there, or beyond the gap from the body. */
    private void place(int k, boolean isFirst, boolean isGiven, int at) {
        double away = isGiven ? 0 : isFirst ? manifold.gaps[k] : -manifold.gaps[k];
        data[at] = (isFirst ? manifold.rAx[k] : manifold.rBx[k]) + away * manifold.nx;
        data[at + 1] = (isFirst ? manifold.rAy[k] : manifold.rBy[k]) + away * manifold.ny;
    }

    private void compare(int one, int other) {
        int a = kinds.values[one];
        int b = kinds.values[other];
        if (a == END && b == END && areOne(one, other) && areInLine(STRIDE * one, STRIDE * other)) {
            seams.add(points.values[one]);
            seams.add(points.values[other]);
        } else if (a == BESIDE && b != BESIDE && areOne(one, other)) {
            pass(one, other);
        } else if (b == BESIDE && a != BESIDE && areOne(one, other)) {
            pass(other, one);
        }
    }

    private void pass(int beside, int on) {
        seams.add(points.values[beside]);
        if (kinds.values[on] == BOTH) {
            passed.add(points.values[on]);
        }
    }

    /** Whether two points of one side are one point on grounds that are alike. */
    private boolean areOne(int one, int other) {
        int p = points.values[one] / 2;
        int q = points.values[other] / 2;
        double size = FLUSH * trajectories.radius(body);
        double dx = data[STRIDE * other] - data[STRIDE * one];
        double dy = data[STRIDE * other + 1] - data[STRIDE * one + 1];
        return p != q && part(p) == part(q) && dx * dx + dy * dy <= size * size && areAlike(pairs.other(p, body), pairs.other(q, body));
    }

    /** Whether what touches goes on from one end to the other side of the other one, in a line. */
    private boolean areInLine(int o, int p) {
        double ux = data[o + 2] - data[o];
        double uy = data[o + 3] - data[o + 1];
        double vx = data[p + 2] - data[p];
        double vy = data[p + 3] - data[p + 1];
        double longer = Math.sqrt(Math.max(ux * ux + uy * uy, vx * vx + vy * vy));
        return ux * vx + uy * vy < 0 && Math.abs(ux * vy - uy * vx) <= FLUSH * trajectories.radius(body) * longer;
    }

    private int part(int pair) {
        return pairs.first(pair) == body ? pairs.firstPart(pair) : pairs.secondPart(pair);
    }

    private boolean areAlike(int a, int b) {
        boolean areSame = state.friction(a) == state.friction(b) && state.restitution(a) == state.restitution(b);
        return areSame && state.beltSpeed(a) == state.beltSpeed(b) && Steering.goAsOne(state.body(a), state.body(b));
    }
}
