// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.CollisionDetection;
import sim.physics.collision.narrow.Manifold;
import sim.physics.internal.IntList;
import sim.physics.motion.Motion;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;
import sim.physics.shape.Circle;

/**
 * The heap that is being solved: finds its bodies and points, and gives it new velocities. One solution holds for a step, or
 * for as long as the bodies turn little.
 */
final class Heap implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Gap from which a lasting pair has parted, relative to the smaller body. */
    private static final double PARTED = 1e-2;

    /** Height of an edge's other end from which it is no contact, relative to the smaller body. */
    private static final double FLAT = 2e-2;

    /** Gap that is kept, relative to the smaller body, beside what turning and sliding take of it. */
    private static final double CUSHION = 1e-10;

    /** Part of a missing gap that a solution regains. */
    private static final double REGAIN = 0.2;

    /** Speed that is none, relative to that which the forces give in the time of a solution. */
    private static final double STILL = 1e-7;

    /** Turn of a body, rad, for which a solution holds; and how many there are in a step at most. */
    private static final double TURN = 0.1;

    private static final int SOLUTIONS = 1000;

    /** Times that something may happen to a body in a step before its heap stands still for the rest of it. */
    private static final int MOST = 50;

    private final State state;
    private final Trajectories trajectories;
    private final Motion motion;
    private final CollisionDetection detection;
    private final CollisionResponse response;
    private final HeapBodies by;
    private final HeapSystem system = new HeapSystem();

    /** The bodies of the heap, and where its points come from. */
    private final IntList heap = new IntList();

    private final IntList origin = new IntList();

    /** The forces of a pair's points at its last solution, four by pair. */
    private double[] forces = {};

    private final double[] fall = new double[State.BLOCK];
    private final Impact point = new Impact();
    private transient Manifold manifold;

    /** Until when the velocities are to hold, and whether those before held until now. */
    private double until;

    private boolean isFresh;
    private boolean halts;
    private double scale;

    Heap(
            State state,
            Trajectories trajectories,
            Motion motion,
            CollisionDetection detection,
            CollisionResponse response,
            HeapBodies by) {
        this.state = state;
        this.trajectories = trajectories;
        this.motion = motion;
        this.detection = detection;
        this.response = response;
        this.by = by;
    }

    boolean lasts(int pair) {
        return detection.marks().slack(pair) > 0 && !detection.marks().isIgnored(pair);
    }

    /** Lets a pair last. */
    void begin(int pair) {
        if (4 * pair >= forces.length) {
            forces = Arrays.copyOf(forces, Math.max(2 * forces.length, 4 * pair + 4));
        }
        if (!lasts(pair)) {
            double size = size(detection.pairs().first(pair), detection.pairs().second(pair));
            detection.marks().setSlack(pair, CUSHION * size);
            Arrays.fill(forces, 4 * pair, 4 * pair + 4, 0);
        }
    }

    void end(int pair) {
        detection.marks().setSlack(pair, 0);
    }

    /** Lets a body go on without acceleration: it has got already what the forces give it. */
    void coast(int body) {
        motion.fall(body, fall, 0);
        motion.support(body, -fall[0], -fall[1], -fall[2]);
    }

    /** Solves the heap of a body; notes those whose courses change. */
    void settle(int seed, double tau, IntList changed) {
        find(seed, tau);
        gather(tau);
        solve(tau);
        publish(tau, changed);
    }

    /** Finds the bodies that lie on one another with a body, and until when their velocities are to hold. */
    private void find(int seed, double tau) {
        heap.clear();
        include(seed);
        double spin = 0;
        boolean struck = false;
        double paid = trajectories.h();
        for (int k = 0; k < heap.size; k++) {
            int body = heap.values[k];
            trajectories.bring(body, tau);
            detection.unplan(body);
            struck |= by.paidUntil[body] > tau;
            paid = by.paidUntil[body] > tau ? Math.min(paid, by.paidUntil[body]) : paid;
            for (int m = 0; m < detection.pairs().countOf(body); m++) {
                int other = detection.pairs().other(detection.pairs().of(body, m), body);
                if (lasts(detection.pairs().of(body, m))) {
                    spin = Math.max(spin, bending(body, other));
                    if (!state.body(other).isFixed() && by.place[other] == 0) {
                        include(other);
                    }
                }
            }
        }
        double h = trajectories.h();
        double length = Math.max(spin * h > TURN ? TURN / spin : h, h / SOLUTIONS);
        isFresh = !struck;
        until = Math.min(paid, tau + length);
        until = h - until < 0.5 * h / SOLUTIONS ? h : until;
    }

    /** How fast two bodies turn and slide on one another, as a rate at which their contact bends out of its tangent. */
    private double bending(int a, int b) {
        double[] d = trajectories.data();
        int oa = a * Trajectories.STRIDE;
        int ob = b * Trajectories.STRIDE;
        double vx = d[ob + Trajectories.VX] - d[oa + Trajectories.VX];
        double vy = d[ob + Trajectories.VY] - d[oa + Trajectories.VY];
        double turnA = isRound(a) ? 0 : Math.abs(d[oa + Trajectories.OMEGA]);
        double turn = Math.max(turnA, isRound(b) ? 0 : Math.abs(d[ob + Trajectories.OMEGA]));
        double slide = Math.sqrt(vx * vx + vy * vy) / size(a, b);
        return Math.sqrt(turn * (turn + slide));
    }

    /** Whether a body looks the same when it turns. */
    private boolean isRound(int body) {
        return state.body(body).getShape() instanceof Circle;
    }

    private void include(int body) {
        heap.add(body);
        by.place[body] = heap.size;
        by.isDirty[body] = false;
    }

    /** Takes in the bodies of the heap and their points. */
    private void gather(double tau) {
        manifold = manifold == null ? new Manifold() : manifold;
        origin.clear();
        system.clear();
        scale = 0;
        for (int k = 0; k < heap.size; k++) {
            enter(k, tau);
        }
        for (int k = 0; k < heap.size; k++) {
            int body = heap.values[k];
            for (int m = 0; m < detection.pairs().countOf(body); m++) {
                int pair = detection.pairs().of(body, m);
                int other = detection.pairs().other(pair, body);
                if (lasts(pair) && (state.body(other).isFixed() || by.place[other] > k + 1)) {
                    if (state.body(other).isFixed()) {
                        trajectories.bring(other, tau);
                    }
                    collect(pair, tau);
                }
            }
        }
    }

    private void enter(int k, double tau) {
        int body = heap.values[k];
        double[] w = state.w().values();
        system.enter(k, w[State.BLOCK * body], w[State.BLOCK * body + State.THETA]);
        double[] d = trajectories.data();
        System.arraycopy(d, body * Trajectories.STRIDE + Trajectories.VX, system.v, 3 * k, State.BLOCK);
        motion.fall(body, fall, 0);
        double pull = Math.sqrt(fall[0] * fall[0] + fall[1] * fall[1]) + radius(body) * Math.abs(fall[2]);
        scale = Math.max(scale, pull * (until - tau));
        double time = until - Math.max(tau, by.paidUntil[body]);
        for (int c = 0; c < State.BLOCK && time > 0; c++) {
            system.v[3 * k + c] += fall[c] * time;
        }
    }

    /** Takes in the points of a pair, or finds that it has parted. */
    private void collect(int pair, double tau) {
        int a = detection.pairs().first(pair);
        int b = detection.pairs().second(pair);
        double size = size(a, b);
        detection.narrowPhase().contact(pair, tau, manifold, FLAT * size / (radius(a) + radius(b)));
        if (manifold.gap > PARTED * size) {
            if (isFresh) {
                end(pair);
            }
            return;
        }
        double left = Math.max(until - tau, 0.05 * trajectories.h() / SOLUTIONS);
        for (int k = 0; k < manifold.count; k++) {
            response.load(manifold, a, b, k, point);
            double room = CUSHION * size + bend(a, b, left);
            int p = system.size();
            system.add(number(a), number(b), point);
            origin.add(4 * pair + 2 * k);
            double gap = manifold.gaps[k];
            double least = isFresh ? room : 0.5 * room;
            system.bound(p, gap < least ? REGAIN * (room - gap) / left : (least - gap) / left);
            if (isFresh) {
                double[] f = forces;
                system.start(p, left * f[4 * pair + 2 * k], left * f[4 * pair + 2 * k + 1]);
            }
        }
    }

    private int number(int body) {
        return state.body(body).isFixed() ? -1 : by.place[body] - 1;
    }

    /** The acceleration that all but the heap gives to a body. */
    double pull(int body) {
        if (state.body(body).isFixed()) {
            return 0;
        }
        motion.fall(body, fall, 0);
        return Math.sqrt(fall[0] * fall[0] + fall[1] * fall[1]);
    }

    /** Radius of the smaller one of two bodies, of which one may be fixed. */
    double size(int a, int b) {
        double first = state.body(a).isFixed() ? Double.MAX_VALUE : radius(a);
        double second = state.body(b).isFixed() ? Double.MAX_VALUE : radius(b);
        return Math.min(first, second);
    }

    private double radius(int body) {
        return trajectories.radius(body);
    }

    /** What the turning and sliding of the loaded point's bodies may take of their gap in the step. */
    private double bend(int a, int b, double h) {
        double turnA = manifold.roundA ? 0 : h * Math.abs(point.omegaA);
        double turnB = manifold.roundB ? 0 : h * Math.abs(point.omegaB);
        double slide = h * Math.abs(point.tangentVelocity());
        double bend = 0.5 * (turnA == 0 ? 0 : turnA * turnA * radius(a)) + 0.5 * (turnB == 0 ? 0 : turnB * turnB * radius(b));
        return Math.min(bend + slide * (turnA + turnB), 1e-3 * size(a, b));
    }

    private void solve(double tau) {
        int most = 0;
        for (int k = 0; k < heap.size; k++) {
            scale = Math.max(scale, speed(k));
            most = Math.max(most, by.turns[heap.values[k]]);
        }
        boolean done = system.solve(scale, true);
        if (!affords(system.gained())) {
            done = system.solve(scale, false); // regaining gaps must not add energy
            affords(system.gained());
        }
        for (int p = 0; p < system.size() && isFresh; p++) {
            forces[origin.values[p]] = done ? system.normalImpulse(p) / (until - tau) : 0;
            forces[origin.values[p] + 1] = done ? system.tangentImpulse(p) / (until - tau) : 0;
        }
        halts = most > MOST;
        if (halts) {
            system.halt();
        }
    }

    /** Whether the bodies have lost as much energy before in the step as they would gain now; takes note of it then. */
    private boolean affords(double gain) {
        double sum = -gain;
        for (int k = 0; k < heap.size; k++) {
            sum += by.lost[heap.values[k]];
        }
        for (int k = 0; k < heap.size && sum >= 0; k++) {
            by.lost[heap.values[k]] = sum / heap.size;
        }
        return sum >= 0;
    }

    private double speed(int k) {
        double way = Math.max(Math.abs(system.v[3 * k]), Math.abs(system.v[3 * k + 1]));
        return Math.max(way, radius(heap.values[k]) * Math.abs(system.v[3 * k + 2]));
    }

    private void publish(double tau, IntList changed) {
        double pull = 0;
        double most = 0;
        for (int k = 0; k < heap.size; k++) {
            pull = Math.max(pull, pull(heap.values[k]));
            most = Math.max(most, speed(k));
        }
        boolean still = system.size() > 0 && !halts && isFresh && most <= STILL * pull * (until - tau);
        if (!still && until < trajectories.h()) {
            detection.plan(heap.values[0], until);
        }
        double[] d = trajectories.data();
        for (int k = 0; k < heap.size; k++) {
            int body = heap.values[k];
            by.place[body] = 0;
            by.isStill[body] = still;
            if (still) {
                Arrays.fill(system.v, 3 * k, 3 * k + 3, 0);
            }
            if (system.size() == 0 && isFresh) {
                by.lies[body] = false;
                motion.support(body, 0, 0, 0);
                changed.add(body);
                continue;
            }
            int o = body * Trajectories.STRIDE + Trajectories.VX;
            boolean same = by.paidUntil[body] > tau && Arrays.equals(d, o, o + 3, system.v, 3 * k, 3 * k + 3);
            by.paidUntil[body] = still ? 0 : Math.max(by.paidUntil[body], until);
            if (!same) {
                System.arraycopy(system.v, 3 * k, d, o, 3);
                coast(body);
                changed.add(body);
            }
        }
    }
}
