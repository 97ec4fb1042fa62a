// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import sim.physics.collision.CollisionDetection;
import sim.physics.internal.IntList;
import sim.physics.motion.Motion;
import sim.physics.motion.State;
import sim.physics.motion.Ties;
import sim.physics.motion.Trajectories;

/** The bodies of a heap: those that lie on one another with a body, and those that move together with them; and what moves them. */
final class HeapMembers implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Part of a step that is hardly any of it. */
    private static final double BEGUN = 1e-3;

    private final State state;
    private final Trajectories trajectories;
    private final Motion motion;
    private final CollisionDetection detection;
    private final HeapBodies by;
    private final LastingPairs lasting;
    private final BodyScale scales;
    private final HeapPull pulls;
    private final IntList heap = new IntList();
    private final IntList pairs = new IntList();

    /** Bodies that were found without being brought to an instant. */
    private final IntList reached = new IntList();

    private boolean driven;
    private boolean rubbed;
    private boolean tied;
    private boolean coupled;
    private boolean struck;
    private boolean turned;
    private boolean parted;
    private boolean borne;
    private double bending;
    private double paidUntil;
    private final double[] fall = new double[State.BLOCK];

    private Ties ties;

    HeapMembers(
            State state,
            Trajectories trajectories,
            Motion motion,
            CollisionDetection detection,
            HeapBodies by,
            LastingPairs lasting,
            BodyScale scales,
            HeapPull pulls) {
        this.state = state;
        this.trajectories = trajectories;
        this.motion = motion;
        this.detection = detection;
        this.by = by;
        this.lasting = lasting;
        this.scales = scales;
        this.pulls = pulls;
    }

    void setTies(Ties those) {
        ties = those;
    }

    /** Null while nothing ties bodies together. */
    Ties ties() {
        return ties;
    }

    /** Those that were found last; live. */
    IntList bodies() {
        return heap;
    }

    /** Finds the heap of a body, brings its bodies to an instant and gives them their places in it. */
    void find(int seed, double tau) {
        heap.clear();
        driven = false;
        rubbed = false;
        tied = false;
        coupled = false;
        struck = false;
        turned = false;
        parted = false;
        borne = false;
        bending = 0;
        pulls.stand();
        paidUntil = trajectories.h();
        boolean begun = true;
        include(seed);
        for (int k = 0; k < heap.size; k++) {
            int body = heap.values[k];
            motion.bring(body, tau);
            detection.unplan(body);
            if (by.paidUntil[body] > tau) {
                struck = true;
                begun &= by.isHalf[body] && tau <= BEGUN * trajectories.h() && isPulled(body);
            }
            for (int m = 0; m < detection.pairs().countOf(body); m++) {
                int pair = detection.pairs().of(body, m);
                int other = detection.pairs().other(pair, body);
                if (lasting.has(pair)) {
                    borne |= state.body(other).isImmobile();
                    bending = Math.max(bending, scales.bending(body, other));
                    if (!state.body(other).isImmobile() && by.place[other] == 0) {
                        include(other);
                    }
                }
            }
        }
        if (struck) {
            resume(tau, begun);
        }
    }

    /**
     * Lets bodies that have got what is to move them for a time which is not over go on with all of it; or, if the step has hardly begun, as
     * when a corner's two sides are touched one after the other, takes that back, and the heap is solved for the first time then.
     */
    private void resume(double tau, boolean isBegun) {
        struck = !isBegun;
        for (int k = 0; k < heap.size; k++) {
            int body = heap.values[k];
            if (!(by.paidUntil[body] > tau)) {
                continue;
            }
            int o = body * Trajectories.STRIDE + Trajectories.VX;
            if (isBegun) {
                by.unpay(body, tau, trajectories.data(), o);
                by.paidUntil[body] = 0;
                by.isHalf[body] = false;
            } else {
                paidUntil = Math.min(paidUntil, by.paidUntil[body]);
                turned |= by.complete(body, trajectories.data(), o, isPulled(body));
            }
        }
    }

    private boolean isPulled(int body) {
        motion.fall(body, fall, 0);
        return fall[0] != 0 || fall[1] != 0 || fall[2] != 0;
    }

    /** Since when the bodies of a body's heap are all on their present courses; it is found without being moved. */
    double since(int seed) {
        reached.clear();
        reach(seed);
        double last = 0;
        for (int k = 0; k < reached.size; k++) {
            int body = reached.values[k];
            last = Math.max(last, trajectories.since(body));
            for (int m = 0; m < detection.pairs().countOf(body); m++) {
                int pair = detection.pairs().of(body, m);
                if (lasting.has(pair)) {
                    reach(detection.pairs().other(pair, body));
                }
            }
        }
        for (int k = 0; k < reached.size; k++) {
            by.place[reached.values[k]] = 0;
        }
        return last;
    }

    private void reach(int body) {
        by.ensure(body);
        if (state.body(body).isImmobile() || by.place[body] > 0) {
            return;
        }
        IntList group = trajectories.isDriven(body) ? motion.companions(body) : null;
        for (int k = 0; k < (group == null ? 1 : group.size); k++) {
            int one = group == null ? body : group.values[k];
            by.ensure(one);
            by.place[one] = 1;
            reached.add(one);
        }
    }

    /** Includes a body, and those that move with it. */
    private void include(int body) {
        boolean byOthers = motion.ground().isDrivenByOthers(body);
        rubbed |= motion.ground().rubs(body) || byOthers && motion.ground().isRough();
        driven |= byOthers;
        if (!trajectories.isDriven(body)) {
            includeOne(body);
            return;
        }
        coupled |= motion.groups().isCoupled(body);
        IntList group = motion.companions(body);
        for (int k = 0; k < group.size; k++) {
            tied |= motion.isTied(group.values[k]);
            if (!motion.isTied(group.values[k])) {
                includeOne(group.values[k]);
            } else if (ties.island(group.values[k]).values[0] == group.values[k]) {
                includeAll(ties.island(group.values[k]));
            }
        }
    }

    /** Bodies that are tied together get consecutive numbers. */
    private void includeAll(IntList island) {
        for (int k = 0; k < island.size; k++) {
            includeOne(island.values[k]);
        }
    }

    private void includeOne(int body) {
        by.ensure(body);
        if (by.place[body] > 0) {
            return; // a spring between what is tied and what is not, which came first
        }
        heap.add(body);
        by.place[body] = heap.size;
        by.isDirty[body] = false;
    }

    /** The number of a body in the heap, −1 of a fixed one. */
    int number(int body) {
        return state.body(body).isImmobile() ? -1 : by.place[body] - 1;
    }

    /** The pairs by which those that were found last lie on one another or on fixed bodies, each once; valid until the next call. */
    IntList pairs(double tau) {
        pairs.clear();
        for (int k = 0; k < heap.size; k++) {
            int body = heap.values[k];
            for (int m = 0; m < detection.pairs().countOf(body); m++) {
                int pair = detection.pairs().of(body, m);
                int other = detection.pairs().other(pair, body);
                if (lasting.has(pair) && (state.body(other).isImmobile() || by.place[other] > k + 1)) {
                    if (state.body(other).isImmobile()) {
                        trajectories.bring(other, tau);
                    }
                    pairs.add(pair);
                }
            }
        }
        return pairs;
    }

    /**
     * Ends the lasting of pairs that have pressed no more and have parted, so that what has left the heap flies freely.
     *
     * @param part gap as of which they have, relative to the smaller body
     * @param left takes the bodies, which are to be found again, if there is such a pair
     * @return whether there is
     */
    boolean split(double tau, double part, IntList left) {
        IntList all = pairs(tau);
        boolean yes = false;
        for (int k = 0; k < all.size; k++) {
            if (lasting.hasParted(all.values[k], tau, part)) {
                lasting.end(all.values[k]);
                yes = true;
            }
        }
        for (int k = 0; k < heap.size && yes; k++) {
            by.place[heap.values[k]] = 0;
            by.isDirty[heap.values[k]] = true; // until it is found
            left.add(heap.values[k]);
        }
        return yes;
    }

    /** A pair of these has parted: it bears nothing from now on, and lasts no more if that ends. */
    void part(int pair, double tau, boolean ends) {
        lasting.relax(pair, tau);
        if (ends) {
            lasting.end(pair);
            parted = true;
        }
    }

    /** Lets the heap be looked at again then. If a pair has parted, one of its bodies may not be found from another one any more: so all are. */
    void plan(double until) {
        for (int k = 0; k < (parted ? heap.size : 1); k++) {
            detection.plan(heap.values[k], until);
        }
    }

    /** Whether authors' forces or ties drive a body of the heap. */
    boolean isDriven() {
        return driven;
    }

    /** Whether one rubs on the plane, or is driven over one on which others rub. */
    boolean isRubbed() {
        return rubbed;
    }

    /** Whether one is tied to others. */
    boolean isTied() {
        return tied;
    }

    /** Whether forces couple one to others, which ties do not. */
    boolean isCoupled() {
        return coupled;
    }

    /** Whether the velocity of one was to hold for longer. */
    boolean isStruck() {
        return struck;
    }

    /** Whether some of these have just been given what they were to have at the end of that time. */
    boolean areTurned() {
        return turned;
    }

    /**
     * Whether those that nothing drives get what contacts give them evenly over a time, as driven ones do: normals turn with them. Impulses at an
     * instant follow that only by making them part, and where no force takes it back that is energy. Nor does a field that all of them fall in.
     */
    boolean areFollowed() {
        return bending > 0 && (!pulls.isOnAny(heap) || !borne && !LargeHeaps.isLarge(heap.size) && pulls.fallWith(heap));
    }

    /** Until when all of these were to hold, at most to the end of the step. */
    double paidUntil() {
        return paidUntil;
    }

    /** How fast they turn and slide on one another at most, as a rate at which a contact bends out of its tangent. */
    double bending() {
        return bending;
    }
}
