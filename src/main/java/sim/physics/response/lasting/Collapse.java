// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import sim.physics.collision.CollisionDetection;
import sim.physics.collision.narrow.Manifold;
import sim.physics.internal.IntList;
import sim.physics.internal.Tolerances;
import sim.physics.motion.Drive;
import sim.physics.motion.Motion;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;

/**
 * Bodies that collapse on one another: a light one between a heavy one that comes and a wall meets both without end in a
 * finite time, if bounces lose energy, and each impact by itself stops nothing. All points of what touches are one problem of
 * velocities then, after which none approaches. What forces press together hops, with energy that it has lost in that.
 */
final class Collapse implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Gap at which bodies touch that have collapsed, relative to the smaller one. */
    private static final double NEAR = 1e-6;

    /** Energy that hops may give, relative to that of their speeds: one body may hop on another one. */
    private static final double PAID = 4;

    /** Error of velocities that is none, relative to them. */
    private static final double EXACT = 1e-10;

    private final State state;
    private final Trajectories trajectories;
    private final Motion motion;
    private final CollisionDetection detection;
    private final ContactPoints points;
    private final HeapBodies by;
    private final Heap heap;
    private final Drive drive;
    private final HeapSystem system = new HeapSystem();
    private final IntList bodies = new IntList();
    private final ContactPoint point = new ContactPoint();
    private transient Manifold manifold;

    /** Twice the energy that hops may give, since the forces for which they are made take it back; friction on a plane does not. */
    private double allowance;

    /** Twice the energy that has been lost in a step, and its number. */
    private double lost;

    private double step;

    Collapse(
            State state,
            Trajectories trajectories,
            Motion motion,
            CollisionDetection detection,
            ContactPoints points,
            HeapBodies by,
            Heap heap) {
        this.state = state;
        this.trajectories = trajectories;
        this.motion = motion;
        this.detection = detection;
        this.points = points;
        this.by = by;
        this.heap = heap;
        this.drive = new Drive(motion, trajectories);
    }

    /** Does what {@link Heaps#stop} says. */
    boolean stop(int pair, double tau, double hop, IntList changed) {
        boolean done = find(pair, tau);
        if (done) {
            gather(tau, Math.min(hop / trajectories.h(), 0.5 * hop / Tolerances.RATTLE_SIZE * pull(tau) * trajectories.h()));
            solve(changed);
        }
        for (int k = 0; k < bodies.size; k++) {
            by.place[bodies.values[k]] = 0;
        }
        return done;
    }

    /** Finds the bodies that touch one another; false if one of them is moved by more than its own velocity. */
    private boolean find(int pair, double tau) {
        bodies.clear();
        include(detection.pairs().first(pair));
        include(detection.pairs().second(pair));
        boolean alone = true;
        for (int k = 0; k < bodies.size && alone; k++) {
            int body = bodies.values[k];
            alone = !motion.isTied(body) && (trajectories.isDriven(body) || !by.has(body));
            for (int m = 0; m < detection.pairs().countOf(body); m++) {
                int next = detection.pairs().of(body, m);
                if (touch(next, tau)) {
                    include(detection.pairs().other(next, body));
                }
            }
        }
        return alone;
    }

    private void include(int body) {
        by.ensure(body);
        if (!state.body(body).isImmobile() && by.place[body] == 0) {
            bodies.add(body);
            by.place[body] = bodies.size;
        }
    }

    /** The greatest acceleration that forces give to one of the bodies, in parts of its size. */
    private double pull(double tau) {
        double most = 0;
        for (int k = 0; k < bodies.size; k++) {
            int body = bodies.values[k];
            if (trajectories.isDriven(body)) {
                motion.bring(body, tau);
                drive.find(body);
                most = Math.max(most, drive.acceleration() / heap.scales.radius(body) + drive.turning());
            } else {
                most = Math.max(most, heap.pulls.of(body) / heap.scales.radius(body));
            }
        }
        return most;
    }

    private boolean touch(int pair, double tau) {
        return !detection.marks().isIgnored(pair) && detection.narrowPhase().gap(pair, tau) <= NEAR * size(pair);
    }

    private double size(int pair) {
        return heap.scales.size(detection.pairs().first(pair), detection.pairs().second(pair));
    }

    private void gather(double tau, double hop) {
        manifold = manifold == null ? new Manifold() : manifold;
        system.clear();
        allowance = 0;
        lost = step == trajectories.step() ? lost : 0;
        step = trajectories.step();
        double[] w = state.w().values();
        for (int k = 0; k < bodies.size; k++) {
            int body = bodies.values[k];
            motion.bring(body, tau);
            system.enter(k, w[State.BLOCK * body], w[State.BLOCK * body + State.THETA]);
            System.arraycopy(trajectories.data(), body * Trajectories.STRIDE + Trajectories.VX, system.v, 3 * k, State.BLOCK);
        }
        for (int k = 0; k < bodies.size; k++) {
            int body = bodies.values[k];
            for (int m = 0; m < detection.pairs().countOf(body); m++) {
                int pair = detection.pairs().of(body, m);
                int other = detection.pairs().other(pair, body);
                by.ensure(other);
                if ((state.body(other).isImmobile() || by.place[other] > k + 1) && touch(pair, tau)) {
                    add(pair, tau, hop);
                }
            }
        }
    }

    private void add(int pair, double tau, double hop) {
        int a = detection.pairs().first(pair);
        int b = detection.pairs().second(pair);
        double size = size(pair);
        motion.bring(a, tau);
        motion.bring(b, tau);
        detection.narrowPhase().contact(pair, tau, manifold, NEAR * size / (heap.scales.radius(a) + heap.scales.radius(b)));
        double least = hop * size;
        for (int k = 0; k < manifold.count; k++) {
            if (manifold.gaps[k] <= NEAR * size) {
                points.load(manifold, pair, k, point);
                system.add(number(a), number(b), point);
                system.bound(system.size() - 1, least);
                allowance += PAID * least * least * (mass(a) + mass(b));
            }
        }
    }

    private double mass(int body) {
        return state.body(body).isDynamic() ? state.body(body).getMass() : 0;
    }

    private int number(int body) {
        return state.body(body).isImmobile() ? -1 : by.place[body] - 1;
    }

    private void solve(IntList changed) {
        double speed = 0;
        for (int k = 0; k < bodies.size; k++) {
            speed = Math.max(speed, heap.scales.speed(bodies.values[k], system.v, 3 * k));
        }
        system.tolerance().allow(EXACT * speed);
        boolean right = system.solve(speed, true) && gains() <= lost + (motion.ground().isRough() ? 0 : allowance);
        if (!right) {
            system.startFromNothing();
            right = system.solve(speed, false) && gains() <= EXACT * HeapEnergy.of(system, system.free());
        }
        if (!right) {
            system.solveSoftly(speed);
        }
        lost = Math.max(0, lost - gains());
        for (int k = 0; k < bodies.size; k++) {
            int body = bodies.values[k];
            System.arraycopy(system.v, 3 * k, trajectories.data(), body * Trajectories.STRIDE + Trajectories.VX, State.BLOCK);
            changed.add(body);
        }
    }

    private double gains() {
        return HeapEnergy.gained(system, system.free());
    }
}
