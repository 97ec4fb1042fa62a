// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.CollisionDetection;
import sim.physics.internal.IntList;
import sim.physics.motion.Motion;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;

/**
 * Heaps with bodies that rub on the plane on which they lie: boxes that robots push, seen from above. The friction of the
 * plane is solved for together with that of the contacts, as an impulse at the end of the solution's time (Moreau 1988), and
 * then acts on the bodies evenly, as the contacts do: for that time they follow parabolas, and no integrator is needed.
 *
 * <p>A body that the plane can hold is as good as fixed. What slides is slowed down by the friction of the motion that it
 * has in the end.
 */
final class RubbedHeap implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Times that the friction of the plane and the contacts are solved for by turns. */
    private static final int TURNS = 8;

    /** Times that are left at least after a body at rest has been torn off: in a row that is pushed one after the other is. */
    private static final int MORE = 3;

    /** Change of the friction of the plane, relative to itself, at which they are right. */
    private static final double SAME = 3e-3;

    /** The same at which it is kept from then on: if it were found anew in each turn, points would follow its last digits. */
    private static final double RIGHT = 1e-3;

    /** Change of a velocity, relative to the largest one, at which points are where they were taken to be. */
    private static final double SETTLED = 1e-8;

    /** The same in units of the error that is good enough for contacts. */
    private static final double ENOUGH = 10;

    /** How many times faster than at the start and than at first bodies are where the turns lead nowhere. */
    private static final double WILD = 10;

    /** Part of a step in which bodies gain as much as they will in the next one. */
    private static final double LONG = 0.5;

    /** Speed of a body that is none, relative to that which the plane takes from it in the time. */
    private static final double NONE = 1e-9;

    private final Trajectories trajectories;
    private final Motion motion;
    private final HeapBodies by;
    private final HeapSystem system;
    private final HeapNotes notes;
    private final BodyScale scales;
    private final HeapGround ground;
    private final HeapTurn turning;

    /** Velocities at the start, without the heap at the end, the same with the plane alone, and momenta that the contacts give; 3 per body. */
    private double[] before = {};

    private double[] free = {};
    private double[] alone = {};
    private double[] there = {};
    private double[] momenta = {};

    /** The largest speed without contacts, or that the plane takes in the time. */
    private double usual;

    RubbedHeap(Trajectories trajectories, Motion motion, HeapBodies by, HeapSystem system, HeapNotes notes, BodyScale scales, HeapTurn turning) {
        this.trajectories = trajectories;
        this.motion = motion;
        this.by = by;
        this.system = system;
        this.notes = notes;
        this.scales = scales;
        this.turning = turning;
        this.ground = new HeapGround(motion.ground());
    }

    /** Velocities at the end of the time that the plane gives, without contacts. */
    double[] alone() {
        return alone;
    }

    /** Lets solutions hold for no longer than a time, at first. */
    double hold(IntList heap, double time) {
        by.hold(heap, time);
        return time;
    }

    /** Takes from bodies what forces have given them for the time that is left. */
    void unpay(IntList heap, double tau) {
        for (int k = 0; k < heap.size; k++) {
            int body = heap.values[k];
            by.unpay(body, tau, trajectories.data(), body * Trajectories.STRIDE + Trajectories.VX);
            by.paidUntil[body] = 0;
        }
    }

    /** Solves for the velocities at the end of a time; those of the start are in the system. Points are followed as their bodies turn. */
    boolean solve(IntList heap, double tau, double length, double scale) {
        begin(heap, tau, length);
        for (int p = 0; p < system.size(); p++) {
            notes.start(p, length);
        }
        boolean right = true;
        boolean isFound = false;
        double missed = Double.POSITIVE_INFINITY;
        double most = Math.max(scale, usual);
        double settled = Math.max(SETTLED * scale, ENOUGH * system.tolerance().enough());
        turning.begin(heap, length, true, true);
        turning.foresee(system.v, heap.size);
        for (int turn = 0, turns = TURNS; turn < turns; turn++) {
            double change = isFound ? 0 : rub();
            if (turn > 0 && change <= SAME && missed <= settled) {
                break;
            }
            isFound |= turn > 0 && change <= RIGHT && !ground.isNew();
            turns = ground.isNew() ? Math.max(turns, turn + 1 + MORE) : turns;
            if (turn > 0) {
                turning.bound(system.v, length, true);
            }
            right = push(heap, scale);
            double fastest = scales.fastest(heap, system.v);
            if (turn > 0 && !(fastest <= WILD * most)) {
                return solveStraight(heap, scale);
            }
            most = Math.max(most, fastest);
            turning.aim(system.v, length);
            missed = missed(heap);
            if (isFound && missed <= settled) {
                break;
            }
        }
        if (ground.stop(system)) {
            right = push(heap, scale);
        }
        settle(heap);
        return right;
    }

    /**
     * Solves along the normals of now, from no impulses: where points are wedged, a place that bodies do not get to may ask for more, and
     * that for a place that is farther away.
     */
    private boolean solveStraight(IntList heap, double scale) {
        straighten();
        turning.forget();
        boolean right = push(heap, scale);
        settle(heap);
        return right;
    }

    private void straighten() {
        system.straighten();
        system.startFromNothing();
        system.restart();
    }

    /** Finds the friction of the plane under the impulses of the contacts; returns by how much it has changed, relative to itself. */
    private double rub() {
        system.momenta(momenta);
        return ground.find(system, free, momenta);
    }

    /** Solves for the impulses of the contacts, beside what the plane gives; as far as turning changes what these do, with those of before. */
    private boolean push(IntList heap, double scale) {
        ground.apply(system, free);
        System.arraycopy(system.v, 0, alone, 0, 3 * heap.size);
        system.pushAlone(system.v);
        system.unpush();
        return system.solveInTurn(scale);
    }

    /** Gives the bodies what the impulses do where points are in the middle of the time. */
    private void settle(IntList heap) {
        System.arraycopy(alone, 0, system.v, 0, 3 * heap.size);
        system.pushAlone(system.v);
    }

    /** By how much velocities are others than they are found to be, as points were not where the impulses had them. */
    private double missed(IntList heap) {
        System.arraycopy(alone, 0, there, 0, 3 * heap.size);
        system.pushAlone(there);
        double most = 0;
        for (int k = 0; k < heap.size; k++) {
            most = Math.max(most, scales.change(heap.values[k], system.v, there, 3 * k));
        }
        return most;
    }

    /** Solves without regaining gaps, evenly; along the normals of now where the turns lead nowhere. */
    boolean regainNothing(IntList heap, double length, double scale) {
        boolean right = true;
        boolean isStraight = false;
        double missed = Double.POSITIVE_INFINITY;
        for (int turn = 0; turn < TURNS && missed > SETTLED * scale; turn++) {
            startAgain(heap);
            right = system.solve(scale, true);
            if (isStraight) {
                break;
            }
            if (!(scales.fastest(heap, system.v) <= WILD * Math.max(scale, usual))) {
                straighten();
                isStraight = true;
                continue;
            }
            turning.turn(system.v, length, false);
            missed = missed(heap);
        }
        settle(heap);
        return right;
    }

    /** Solves a heap again in which friction locks what would have to part: no gap is regained, and points bear the least that holds them. */
    boolean giveWay(IntList heap, double scale, CollisionDetection detection) {
        straighten();
        boolean right = false;
        double change = Double.POSITIVE_INFINITY;
        for (int turn = 0; turn < TURNS && change > SAME; turn++) {
            change = turn == 0 ? change : rub();
            ground.apply(system, free);
            System.arraycopy(system.v, 0, alone, 0, 3 * heap.size);
            system.renew();
            system.startFromNothing();
            system.regainNothing();
            right = system.share.solve(system) || system.solve(scale, false);
        }
        settle(heap);
        notes.deepen(detection, scales);
        return right;
    }

    /** The same at once, along the normals of now. Points that are too deep go on to part as they do, if that gives no energy. */
    boolean hop(IntList heap, IntList deep, double scale) {
        system.straighten();
        startAgain(heap);
        for (int k = 0; k < deep.size; k++) {
            double speed = system.normal(deep.values[k], before);
            if (speed > 0) {
                system.bound(deep.values[k], speed);
            }
        }
        boolean right = system.solve(scale, true);
        if (!by.afford(heap, HeapEnergy.gained(system, alone), 0)) {
            startAgain(heap);
            right = system.solve(scale, true);
        }
        settle(heap);
        return right;
    }

    private void startAgain(IntList heap) {
        settle(heap);
        system.unpush();
        system.regainNothing();
    }

    private void begin(IntList heap, double tau, double length) {
        int n = 3 * heap.size;
        if (before.length < n) {
            before = new double[2 * n];
            free = new double[2 * n];
            alone = new double[2 * n];
            there = new double[2 * n];
            momenta = new double[2 * n];
        }
        System.arraycopy(system.v, 0, before, 0, n);
        ground.begin(heap.size, length);
        usual = 0;
        for (int k = 0; k < heap.size; k++) {
            int body = heap.values[k];
            boolean rubs = motion.ground().rubs(body);
            if (rubs && scales.speed(body, before, 3 * k) <= NONE * length * motion.ground().deceleration(body)) {
                Arrays.fill(before, 3 * k, 3 * k + 3, 0); // the rounding of what has met it
            }
            motion.ground().accelerate(body, tau, free, 3 * k);
            for (int c = 3 * k; c < 3 * k + 3; c++) {
                free[c] = before[c] + length * free[c];
            }
            if (rubs) {
                ground.enter(k, body, system, before, 3 * k);
                usual = Math.max(usual, length * motion.ground().deceleration(body));
            }
        }
        usual = Math.max(usual, scales.fastest(heap, free));
    }

    /** Gives the bodies back the masses that they have, and keeps what they gain in the time, as they will in the next one. */
    void end(IntList heap, double time) {
        if (time >= LONG * trajectories.h()) { // in less, what it takes to regain a gap is no force that goes on
            turning.keep(heap, system.v, time);
        }
        ground.end(system);
    }

    /**
     * Whether no body of the heap has moved, or does so now, or is pushed. Where generators of authors act this is not known
     * beyond the solution: their forces may change with time, and nobody else would ask for them again.
     */
    boolean isStill(IntList heap) {
        for (int k = 0; k < heap.size; k++) {
            if (motion.ground().isDrivenByOthers(heap.values[k])) {
                return false;
            }
        }
        for (int k = 0; k < 3 * heap.size; k++) {
            if (before[k] != 0 || system.v[k] != 0 || free[k] != 0) {
                return false;
            }
        }
        return true;
    }

    /** Lets a body get its new velocity evenly over a time, or at once if the heap stops. */
    void publish(int k, int body, double length, boolean halts, double[] fall) {
        double[] d = trajectories.data();
        if (halts) {
            System.arraycopy(system.v, 3 * k, before, 3 * k, State.BLOCK);
        }
        System.arraycopy(before, 3 * k, d, body * Trajectories.STRIDE + Trajectories.VX, State.BLOCK);
        motion.ground().carry(body);
        motion.fall(body, fall, 0);
        motion.support(
                body,
                (system.v[3 * k] - before[3 * k]) / length - fall[0],
                (system.v[3 * k + 1] - before[3 * k + 1]) / length - fall[1],
                (system.v[3 * k + 2] - before[3 * k + 2]) / length - fall[2]);
    }
}
