// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import sim.physics.collision.CollisionDetection;
import sim.physics.collision.narrow.Manifold;
import sim.physics.internal.IntList;
import sim.physics.motion.Motion;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;

/**
 * The second half of what forces and contacts give the bodies of a heap. In the first one, at the start of a solution's time,
 * they get what makes their straight ways end where no pair is too deep; in this one, where these have ended, what makes no
 * closed pair approach: the method RATTLE (Andersen 1983, <i>Rattle: a velocity version of the Shake algorithm</i>) with
 * contacts that open and rub. So places and velocities are of second order in the time, while bodies move straight in it.
 */
final class HeapEnd implements Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;
    private final Trajectories trajectories;
    private final Motion motion;
    private final CollisionDetection detection;
    private final ContactPoints points;
    private final HeapBodies by;
    private final HeapSystem system;
    private final HeapMembers members;
    private final BodyScale scales;
    private final ContactLedger ledger;
    private final GroundSeams seams;
    private final ContactPoint point = new ContactPoint();
    private final double[] fall = new double[State.BLOCK];

    /** Two numbers for each pair. */
    private final IntList origin = new IntList();

    private transient Manifold manifold;

    HeapEnd(
            State state,
            Trajectories trajectories,
            Motion motion,
            CollisionDetection detection,
            ContactPoints points,
            HeapBodies by,
            HeapSystem system,
            HeapMembers members,
            BodyScale scales,
            ContactLedger ledger,
            GroundSeams seams) {
        this.state = state;
        this.trajectories = trajectories;
        this.motion = motion;
        this.detection = detection;
        this.points = points;
        this.by = by;
        this.system = system;
        this.members = members;
        this.scales = scales;
        this.ledger = ledger;
        this.seams = seams;
    }

    /** Whether the time of a body's solution is over, and the body has only half of what it gets in it. */
    boolean isDue(int body, double tau) {
        return by.isHalf[body] && by.paidUntil[body] <= tau;
    }

    /** Gives the second half to the heap that was found last, whose bodies are where their ways have ended; notes them, and that they have no place in it any more. */
    void complete(double tau, IntList changed) {
        IntList heap = members.bodies();
        manifold = manifold == null ? new Manifold() : manifold;
        system.clear();
        origin.clear();
        seams.forget();
        double scale = 0;
        for (int k = 0; k < heap.size; k++) {
            scale = Math.max(scale, enter(k, heap.values[k], tau));
        }
        IntList pairs = members.pairs(tau);
        for (int k = 0; k < pairs.size; k++) {
            collect(pairs.values[k], tau);
        }
        if (heap.size <= FreeHeap.FEW) {
            HeapStart.temper(system);
        }
        if (!system.solveSqueezed()) {
            system.solve(Math.max(scale, scales.fastest(heap, system.v)), true);
        }
        if (HeapEnergy.isWedged(system, system.free())) {
            system.unwedge(false);
            system.solve(scale, false);
        }
        for (int p = 0; p < system.size(); p++) {
            double nx = system.pressing().nx(p);
            double ny = system.pressing().ny(p);
            ledger.strike(origin.values[p] / 2, origin.values[p] % 2, nx, ny, system.normalImpulse(p), system.tangentImpulse(p));
        }
        for (int k = 0; k < heap.size; k++) {
            int body = heap.values[k];
            if (isDue(body, tau)) {
                by.isHalf[body] = false;
                by.paidUntil[body] = 0;
            }
            System.arraycopy(system.v, 3 * k, trajectories.data(), body * Trajectories.STRIDE + Trajectories.VX, State.BLOCK);
            by.place[body] = 0;
            changed.add(body);
        }
    }

    /** Half of the time of a body's solution, if that is over. */
    private double half(int body, double tau) {
        return isDue(body, tau) ? 0.5 * (by.paidUntil[body] - by.paidFrom[body]) : 0;
    }

    /** Takes a body in with what forces give it; returns how fast that is. */
    private double enter(int k, int body, double tau) {
        double[] w = state.w().values();
        system.enter(k, w[State.BLOCK * body], w[State.BLOCK * body + State.THETA]);
        motion.fall(body, fall, 0);
        double half = half(body, tau);
        for (int c = 0; c < State.BLOCK; c++) {
            system.v[3 * k + c] = trajectories.data()[body * Trajectories.STRIDE + Trajectories.VX + c] + fall[c] * half;
        }
        return half * (Math.sqrt(fall[0] * fall[0] + fall[1] * fall[1]) + scales.radius(body) * Math.abs(fall[2]));
    }

    /** Takes in the points of a pair that are closed: what has pressed in the first half presses in the second. */
    private void collect(int pair, double tau) {
        int a = detection.pairs().first(pair);
        int b = detection.pairs().second(pair);
        boolean isOfB = by.place[a] == 0 || by.place[b] != 0 && by.place[b] < by.place[a]; // a place of 0 is that of a fixed one
        double half = half(isOfB ? b : a, tau);
        double size = scales.size(a, b);
        detection.narrowPhase().contact(pair, tau, manifold, HeapGaps.flat(size, scales.radius(a) + scales.radius(b)));
        boolean presses = ledger.force(pair, 0, false) > 0 || ledger.force(pair, 1, false) > 0;
        int swap = isOther(pair, size) ? 1 : 0;
        for (int k = 0; k < 2; k++) { // k was that or, if the two have changed places, the other one in the first half
            int noted = k ^ swap;
            double fn = ledger.force(pair, noted, false);
            double ft = ledger.force(pair, noted, true);
            ledger.strike(pair, noted, -half * fn, -half * ft); // which it was taken to bear for all of the time
            if (k >= manifold.count || manifold.isAtEnds || seams.has(pair, k, tau)) {
                continue;
            }
            points.load(manifold, pair, k, point);
            double bend = Math.max(scales.bend(manifold, point, a, b, 2 * half), GapBend.most(manifold, k, point, 2 * half));
            double none = 2 * (HeapGaps.depth(false, size) + bend);
            if (manifold.gaps[k] <= none || fn > 0 || presses && manifold.gaps[k] == manifold.gap) {
                int p = system.size();
                system.add(by.place[a] - 1, by.place[b] - 1, point);
                system.bound(p, 0);
                system.start(p, half * fn, half * ft);
                system.tolerance().bear(HeapGaps.fairSpeed(size, 2 * half));
                origin.add(2 * pair + noted);
            }
        }
    }

    /**
     * Whether the only point of a pair that has pressed is the second one of its two now, or was: points are counted along an edge, and a
     * corner that comes near on the other side is another first one.
     */
    private boolean isOther(int pair, double size) {
        int pressed = ledger.force(pair, 1, false) > 0 ? 1 : 0;
        boolean isOne = !(ledger.force(pair, 1 - pressed, false) > 0);
        return isOne && manifold.count == 2 && manifold.gaps[pressed] - manifold.gaps[1 - pressed] > HeapGaps.fairDepth(size);
    }
}
