// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.CollisionDetection;
import sim.physics.internal.IntList;

/** Where the points of the heap that is being solved come from, and what they bear, to the ledger and from it. */
final class HeapNotes implements Serializable {
    private static final long serialVersionUID = 1L;

    private final HeapSystem system;
    private final ContactLedger ledger;

    /** Two numbers for each pair. */
    private final IntList origin = new IntList();

    /** Gaps by point. */
    private double[] gaps = {};

    HeapNotes(HeapSystem system, ContactLedger ledger) {
        this.system = system;
        this.ledger = ledger;
    }

    void clear() {
        origin.clear();
    }

    void add(int pair, int point, double gap) {
        gaps = origin.size < gaps.length ? gaps : Arrays.copyOf(gaps, 2 * gaps.length + 2);
        gaps[origin.size] = gap;
        origin.add(2 * pair + point);
    }

    /** The gap of a point. */
    double gap(int p) {
        return gaps[p];
    }

    /** Adds what tells each point from others. */
    void name(IntList names) {
        for (int p = 0; p < system.contacts(); p++) {
            names.add(origin.values[p]);
        }
    }

    /** Lets all pairs be as deep as they are, and as much deeper as they may be else. */
    void letBe(CollisionDetection detection) {
        for (int p = 0; p < system.contacts(); p++) {
            int pair = origin.values[p] / 2;
            double depth = detection.marks().depth(pair);
            detection.marks().setDepth(pair, gaps[p] < 0 ? depth - gaps[p] : depth);
        }
    }

    /** Lets pairs that are too deep be deeper: the times between their hops grow evenly then, which takes the least depth for as many of them. */
    void deepen(CollisionDetection detection, BodyScale scales) {
        for (int p = 0; p < system.contacts(); p++) {
            int pair = origin.values[p] / 2;
            double size = scales.size(detection.pairs().first(pair), detection.pairs().second(pair));
            detection.marks().setDepth(pair, Math.max(detection.marks().depth(pair), HeapGaps.deeper(gaps[p], size)));
        }
    }

    /** Starts a point from its last forces. */
    void start(int p, double time) {
        int pair = origin.values[p] / 2;
        int k = origin.values[p] % 2;
        system.start(p, time * ledger.start(pair, k, false), time * ledger.start(pair, k, true));
    }

    /** Lets the pairs of all points be deeper by what velocities that are wrong by an error may make them in a time. */
    void soften(CollisionDetection detection, BodyScale scales, double error, double time) {
        for (int p = 0; p < system.contacts(); p++) {
            int pair = origin.values[p] / 2;
            double size = scales.size(detection.pairs().first(pair), detection.pairs().second(pair));
            detection.marks().setDepth(pair, HeapGaps.depth(detection.marks().depth(pair), size, error, time));
        }
    }

    /** Notes the forces from which the next solution is to start, if they are right. */
    void note(double time, boolean right) {
        for (int p = 0; p < system.contacts(); p++) {
            double fn = right ? system.normalImpulse(p) / time : 0;
            double ft = right ? system.tangentImpulse(p) / time : 0;
            ledger.setStart(origin.values[p] / 2, origin.values[p] % 2, fn, ft);
        }
    }

    /**
     * Notes the forces that the points bear evenly over a time, or impulses at once if that is 0.
     *
     * @param isEven whether their bodies turn meanwhile: they are pushed along other normals than those at the start
     */
    void press(double time, boolean isEven) {
        for (int p = 0; p < system.contacts(); p++) {
            int pair = origin.values[p] / 2;
            double fn = time > 0 ? system.normalImpulse(p) / time : 0;
            ledger.press(pair, origin.values[p] % 2, fn, time > 0 ? system.tangentImpulse(p) / time : 0);
        }
        if (time == 0) {
            strike(1);
        }
        if (isEven) {
            turn();
        }
    }

    /**
     * Notes what the points bear for a time on bodies that have been stopped at its beginning.
     *
     * @param given the time for which the forces were noted that have stopped them, which was more than what holds them
     */
    void hold(double time, double given) {
        for (int p = 0; p < system.contacts(); p++) {
            int pair = origin.values[p] / 2;
            int point = origin.values[p] % 2;
            ledger.strike(pair, point, given * ledger.force(pair, point, false), given * ledger.force(pair, point, true));
        }
        press(time, false);
        strike(-given / time);
    }

    /** Notes along which normals, and where, the forces act that the points bear for a time. */
    private void turn() {
        PointRows rows = system.pressing();
        for (int p = 0; p < system.contacts(); p++) {
            boolean isFirst = p == 0 || origin.values[p - 1] / 2 != origin.values[p] / 2;
            int side = rows.body(p, 0) < 0 ? 1 : 0;
            double nx = rows.nx(p);
            double ny = rows.ny(p);
            double arm = rows.arm(p, side);
            double lever = rows.lever(p, side);
            ledger.turn(origin.values[p] / 2, origin.values[p] % 2, isFirst, nx, ny, arm * nx + lever * ny, arm * ny - lever * nx);
        }
    }

    /** Notes what the second body of a point gets by it beside its impulses: evenly over a time, or at once if that is 0. */
    void lack(int p, double x, double y, double time) {
        ledger.lack(origin.values[p] / 2, x, y, time);
    }

    /** Notes that the impulses of the points have acted at once, that many times. */
    void strike(double times) {
        for (int p = 0; p < system.contacts(); p++) {
            int pair = origin.values[p] / 2;
            double jn = times * system.normalImpulse(p);
            ledger.strike(pair, origin.values[p] % 2, jn, times * system.tangentImpulse(p));
        }
    }
}
