// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.CollisionDetection;
import sim.physics.collision.narrow.Manifold;
import sim.physics.internal.IntList;
import sim.physics.motion.Motion;
import sim.physics.motion.Probes;
import sim.physics.motion.State;
import sim.physics.motion.Ties;
import sim.physics.motion.Trajectories;

/**
 * Heaps with bodies that the integrator drives: takes them in, lets them be pushed as {@link ForceSearch} has found, and sees whether they
 * stand still under that, and for how long it holds.
 */
final class DrivenHeap implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Error of velocities at the end of their time, relative to them, with which forces may go on until then. */
    private static final double DRIFT = 1e-5;

    private final State state;
    private final Trajectories trajectories;
    private final Motion motion;
    private final HeapBodies by;
    private final HeapSystem system;
    private final HeapNotes notes;
    private final BodyScale scales;
    private final HeapPull pulls;
    private final double[] fall = new double[State.BLOCK];

    /** Null while nothing ties bodies of the heap together. */
    private transient Ties ties;

    private final ForceSearch search;
    private final HeapSwitches switches;
    private final Probes probes;
    private final HeapTurn turning;
    private final HeapHalt halting;

    DrivenHeap(
            State state,
            Trajectories trajectories,
            Motion motion,
            HeapBodies by,
            HeapSystem system,
            HeapNotes notes,
            BodyScale scales,
            HeapPull pulls,
            Regain regain) {
        this.state = state;
        this.trajectories = trajectories;
        this.motion = motion;
        this.by = by;
        this.system = system;
        this.notes = notes;
        this.scales = scales;
        this.pulls = pulls;
        this.search = new ForceSearch(state, trajectories, motion, by, system, notes, scales, pulls, regain);
        this.switches = search.switches;
        this.probes = search.probes;
        this.turning = search.turning;
        this.halting = new HeapHalt(system, trajectories, notes);
    }

    /** Lets pairs be as deep as they are if they had to be. */
    void note(CollisionDetection detection) {
        if (search.isReleased()) {
            notes.letBe(detection);
        }
    }

    /** Takes in a point of the heap, the gap that there may be at the end, and how far forces take its bodies in a step, relative to their size. */
    void turn(int p, Manifold manifold, int k, double deepest, double roam) {
        turning.set(p, manifold, k, deepest, roam);
    }

    /** Takes from bodies what forces have given them for the time that is left: it is found anew, with those of driven ones. */
    void unpay(IntList heap, double tau, Ties those) {
        search.take(those);
        for (int k = 0; k < heap.size; k++) {
            int body = heap.values[k];
            probes.stir(body);
            motion.ground().resume(body);
            if (!trajectories.isDriven(body)) {
                by.unpay(body, tau, trajectories.data(), body * Trajectories.STRIDE + Trajectories.VX);
            }
            by.paidUntil[body] = 0;
            if (search.isFirstTied(body)) {
                motion.restore(those.island(body));
                those.prepareImpact(those.island(body));
            }
        }
    }

    /**
     * Takes in the motors and stops of tied bodies, and finds what impulses do to these, as their ties are prepared.
     *
     * @param regain has the time for which forces are to act
     * @param fall speed that they give to bodies in it
     */
    void gather(IntList heap, Ties those, Regain regain, double fall) {
        ties = those;
        search.take(those);
        switches.clear();
        for (int k = 0; k < heap.size; k++) {
            if (search.isFirstTied(heap.values[k])) {
                switches.gather(ties.switched(ties.island(heap.values[k])), regain, fall);
            }
        }
        for (int p = 0; p < system.size(); p++) {
            if ((p < system.contacts() || !switches.shares(p)) && HeapReplies.areNeeded(system, p, heap, motion)) {
                system.replies().find(system, p, heap, motion, ties, by.place);
            }
            system.measure(p);
        }
    }

    /**
     * The greatest speed that a motor alone gives to a body in a time: where no field pulls, nothing else says what speeds and forces are beside.
     * One that is as strong as can be reaches its own speed in a step.
     */
    double reach(IntList heap, double time) {
        double most = 0;
        for (int p = system.contacts(); p < system.size(); p++) {
            most = Math.max(most, switches.reach(p, heap, scales, time / trajectories.h()));
        }
        return most;
    }

    /** Speeds at which motors and stops, in their order behind the contacts, are left by what strikes them now. */
    double[] rebounds() {
        return switches.rebounds();
    }

    /**
     * Gives bodies on which no force acts what their contacts have been found to give, but no energy.
     *
     * @param before velocities at the start of the time
     */
    void settle(IntList heap, double[] before, double time) {
        turning.settle(system.v, heap.size);
        halting.gainNothing(heap, before, time);
    }

    /** Takes all motion relative to one another from them. */
    void halt(IntList heap) {
        halting.halt(heap);
    }

    /** The search for the forces of driven bodies. */
    ForceSearch search() {
        return search;
    }

    /**
     * Lets bodies be pushed evenly over a time as was found, also those that nothing drives: if these moved at once as they do
     * at its end, they would run into those that do not yet. Integrations under the same forces go for the bodies' motion.
     *
     * @param areDriven whether a body is driven; else what they get is known from their velocities
     */
    void publish(IntList heap, double time, boolean areDriven) {
        double[] pushes = areDriven ? turning.pushes(heap.size) : turning.changes(system.v, heap.size);
        search.support(heap, time, pushes);
        turning.keep(heap, system.v, time);
        if (time >= Heap.SLIVER * trajectories.h()) {
            search.history.forecast(heap.values[0]).keep(system, search.middle(heap.values[0], time), time);
        }
        for (int k = 0; k < heap.size; k++) {
            int body = heap.values[k];
            if (!trajectories.isDriven(body)) {
                motion.support(body, pushes[3 * k] / time, pushes[3 * k + 1] / time, pushes[3 * k + 2] / time);
                continue;
            }
            System.arraycopy(system.v, 3 * k, by.expected, 3 * body, State.BLOCK);
            if (search.isProbed() && search.isFirst(body)) {
                probes.keep(body, time);
            }
        }
    }

    /**
     * Lets bodies stand still from now on, if they do so at the start and at the end of a step, under forces that were found right by
     * an integration; false if they do not.
     *
     * @param none speed that is none
     */
    boolean rest(IntList heap, double time, double none) {
        double[] d = trajectories.data();
        boolean yes = search.isProbed() && !search.isReleased() && time == trajectories.h() && !pulls.isFalling();
        for (int k = 0; yes && k < heap.size; k++) {
            int body = heap.values[k];
            int o = body * Trajectories.STRIDE + Trajectories.VX;
            yes = scales.speed(body, system.v, 3 * k) <= none && scales.speed(body, d, o) <= none;
            yes &= !trajectories.isDriven(body) || probes.mayRest(body);
        }
        for (int k = 0; yes && k < heap.size; k++) {
            int body = heap.values[k];
            int o = body * Trajectories.STRIDE + Trajectories.VX;
            Arrays.fill(d, o, o + State.BLOCK, 0);
            if (trajectories.isDriven(body)) {
                probes.rest(body);
            } else {
                motion.fall(body, fall, 0);
                motion.support(body, -fall[0], -fall[1], -fall[2]);
            }
            if (search.isFirstTied(body)) {
                switches.keep(ties.switched(ties.island(body)), body);
            }
        }
        return yes;
    }

    /** Lets a body move again, and those that move with it. */
    void stir(int body) {
        probes.stir(body);
    }

    /** Lets the motors and stops of a body that lies on nothing any more decide by themselves. */
    void thaw(int body, Ties those) {
        if (motion.isTied(body)) {
            stir(body);
            those.switched(those.island(body)).thaw();
        }
    }

    /** Lets a body fall that lies on nothing any more. */
    void dissolve(int body, Ties those) {
        by.lies[body] = false;
        motion.support(body, 0, 0, 0);
        motion.ground().resume(body);
        thaw(body, those);
    }

    /** Whether something has happened to a body that stands still, or its motors or stops have been set. */
    boolean stirs(int body, Ties those) {
        return motion.isTied(body) && (!probes.rests(body) || areSet(those.island(body), body, those));
    }

    private boolean areSet(IntList island, int body, Ties those) {
        return island.values[0] == body && !switches.areKept(those.switched(island), body);
    }

    /**
     * Whether forces may go on until their time is over, where the path of a body has ended before: if what moves with it comes
     * to the velocities for which they were found. The error of one long step may be more than that of two short ones.
     */
    boolean goesOn(int body, double tau) {
        motion.bring(body, tau);
        IntList group = motion.companions(body);
        double length = by.paidUntil[body] - tau;
        boolean goesOn = probes.probe(body, length) == length;
        double most = 0;
        double error = 0;
        for (int k = 0; k < group.size; k++) {
            int one = group.values[k];
            most = Math.max(most, scales.speed(one, by.expected, State.BLOCK * one));
            for (int c = 0; c < State.BLOCK; c++) {
                fall[c] = state.v()[State.BLOCK * one + c] - by.expected[State.BLOCK * one + c];
            }
            error = Math.max(error, scales.speed(one, fall, 0));
        }
        motion.restore(group);
        goesOn &= error <= DRIFT * most;
        if (goesOn) {
            probes.keep(body, length);
        }
        return goesOn;
    }
}
