// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.CollisionDetection;
import sim.physics.internal.IntList;
import sim.physics.motion.Motion;
import sim.physics.motion.State;
import sim.physics.motion.Ties;
import sim.physics.motion.Trajectories;

/**
 * Bodies that lie on one another: stacks, heaps, and what is jammed in a corner. Pairs whose bounces have become too many
 * and too short in a step are <i>lasting</i>, until they part. At the start of each step the bodies that lasting pairs
 * connect get the velocities with which none of these pairs is deeper than closed at its end (Moreau 1988, <i>Unilateral
 * contact and dry friction in finite freedom dynamics</i>), and keep them for the step, unless something strikes them; so a
 * heap costs some sweeps over its points in place of thousands of bounces. What nothing drives or ties gets half of what acts
 * on it then, and half at the end of the step ({@link HeapEnd}): that is of second order in the step, and all else of first, where
 * flight is exact. The search for impacts watches the bodies all the while, so that they do not penetrate here either.
 *
 * <p>What stands still is let be, exactly where it is.
 */
public final class Heaps implements Serializable {
    private static final long serialVersionUID = 2L;

    /** How many times deeper than it is a pair may be from then on. */
    private static final double DEEPER = 2;

    private final State state;
    private final Trajectories trajectories;
    private final Motion motion;
    private final CollisionDetection detection;
    private final HeapBodies by = new HeapBodies();
    private final Heap heap;
    private final HeapCalm calm;
    private final Collapse collapse;
    private final LargeHeaps large;
    private final IntList members = new IntList();

    /** Bodies to which something has happened, and those whose courses have changed. */
    private final IntList dirty = new IntList();

    private final IntList changed = new IntList();

    private final Standing standing;
    private final Joining joining;

    /**
     * Makes the heaps of an engine, none at first.
     *
     * @param state the state vectors
     * @param trajectories the motion of the bodies
     * @param motion says what forces give the bodies, and takes what contacts give them
     * @param detection where the pairs come from
     * @param points loads the points at which they touch
     * @param resting lets go of bodies that come to lie in a heap
     * @param ledger where it is noted what the points bear
     */
    public Heaps(
            State state,
            Trajectories trajectories,
            Motion motion,
            CollisionDetection detection,
            ContactPoints points,
            RestingContacts resting,
            ContactLedger ledger) {
        this.state = state;
        this.trajectories = trajectories;
        this.motion = motion;
        this.detection = detection;
        this.heap = new Heap(state, trajectories, motion, detection, points, by, ledger);
        this.collapse = new Collapse(state, trajectories, motion, detection, points, by, heap);
        this.large = heap.large;
        this.standing = new Standing(state, trajectories, motion, detection, points, heap.scales);
        this.joining = new Joining(state, trajectories, motion, detection, resting, by, heap, standing, members, dirty);
        this.calm = new HeapCalm(trajectories, motion, detection, heap);
    }

    /**
     * Whether no body lies in a heap.
     *
     * @return true if there is nothing to do
     */
    public boolean isEmpty() {
        return members.size == 0;
    }

    /**
     * Whether a body lies in a heap.
     *
     * @param body index
     * @return false for fixed bodies
     */
    public boolean has(int body) {
        return by.has(body);
    }

    /**
     * Bodies in heaps.
     *
     * @return live; some may not lie in one any more
     */
    public IntList members() {
        return members;
    }

    /**
     * Sets what ties bodies together.
     *
     * @param ties null for nothing
     */
    public void setTies(Ties ties) {
        heap.setTies(ties);
    }

    /**
     * Whether two bodies may lie on one another: driven ones not if they have been struck too often in this step.
     *
     * @param a index
     * @param b index
     * @return false also where they turn too fast
     */
    public boolean mayLie(int a, int b) {
        return mayLie(a) && mayLie(b);
    }

    private boolean mayLie(int body) {
        return !(by.knows(body) && trajectories.step() < by.givenUp[body])
                && (!isDriven(body) || calm.isCalm(motion.companions(body), body));
    }

    /** Whether a body moves together with others: ties or forces couple them, and what happens to one happens to all. */
    private boolean movesWithOthers(int body) {
        return motion.isTied(body) || motion.groups().isCoupled(body);
    }

    /**
     * Lets two bodies lie on one another again that were to lie on nothing for some steps: bounces cost even more.
     *
     * @param a index
     * @param b index
     * @return false if they may not for another reason
     */
    public boolean resume(int a, int b) {
        by.resume(a);
        by.resume(b);
        return mayLie(a, b);
    }

    /** Whether so much has happened to a body in this step that it is to lie on nothing. */
    private boolean isTooOften(int body) {
        return by.hasTooMany(body, isDriven(body), movesWithOthers(body) ? motion.companions(body).size : 0);
    }

    /** Whether the integrator moves a body also when it lies on others. */
    private boolean isDriven(int body) {
        return trajectories.isDriven(body) && (movesWithOthers(body) || !motion.ground().isRough());
    }

    /** Ends the lasting of all pairs of a body, and of those that move with it, for some steps. */
    private void giveUp(int body) {
        if (!trajectories.isDriven(body)) {
            by.giveUp(body, trajectories.step(), false);
            motion.support(body, 0, 0, 0);
            motion.ground().resume(body);
            part(body);
            return;
        }
        IntList group = motion.companions(body);
        for (int k = 0; k < group.size; k++) {
            int one = group.values[k];
            by.giveUp(one, trajectories.step(), movesWithOthers(one));
            motion.support(one, 0, 0, 0);
            part(one);
        }
    }

    /**
     * Whether a pair lasts.
     *
     * @param pair number of the pair
     * @return false also if it is ignored
     */
    public boolean lasts(int pair) {
        return heap.lasting.has(pair);
    }

    /**
     * What forces press two bodies together at most.
     *
     * @param a index
     * @param b index
     * @return an acceleration
     */
    public double pull(int a, int b) {
        return heap.pulls.of(a) + heap.pulls.of(b);
    }

    /**
     * Radius of the smaller one of two bodies, of which one may be fixed.
     *
     * @param a index
     * @param b index
     * @return length
     */
    public double size(int a, int b) {
        return heap.scales.size(a, b);
    }

    /**
     * Since when the bodies of a heap are all on their present courses.
     *
     * @param body index of one of them
     * @return offset in the present step
     */
    public double since(int body) {
        return heap.members.since(body);
    }

    /**
     * The velocity of a point that a body of a heap has got for the time that is left, which forces are to take from it again.
     *
     * @param body index
     * @param nx the direction asked for, of length 1
     * @param ny its other component
     * @param lever of an impulse along it on the body
     * @return along the direction
     */
    public double toCome(int body, double nx, double ny, double lever) {
        return isEmpty() ? 0 : by.toCome(body, trajectories, nx, ny, lever);
    }

    /**
     * Lets a pair last.
     *
     * @param pair number of the pair
     */
    public void add(int pair) {
        joining.add(pair);
    }

    /**
     * Ends a pair's lasting.
     *
     * @param pair number of the pair
     */
    public void end(int pair) {
        heap.lasting.end(pair);
    }

    /**
     * Stops bodies that meet ever more often and ever faster, with all that touch them: none of them approaches another one then.
     *
     * @param pair that meets once more, whose bodies are where they meet
     * @param tau offset in the present step
     * @param hop way that they are to part in a step, as forces bring them back, relative to their size
     * @param moved takes the bodies whose velocities have changed
     * @return false if that cannot be done
     */
    public boolean stop(int pair, double tau, double hop, IntList moved) {
        return collapse.stop(pair, tau, hop, moved);
    }

    /** Begins a step: all heaps that move are to be solved. */
    public void begin() {
        int kept = 0;
        for (int k = 0; k < members.size; k++) {
            int body = members.values[k];
            if (!by.lies[body] || state.body(body) == null) {
                by.lies[body] = false;
                continue;
            }
            members.values[kept++] = body;
            by.begin(body);
            if (!by.isStill[body] || heap.stirs(body)) {
                joining.mark(body);
            }
        }
        members.size = kept;
        for (int k = 0; k < kept; k++) {
            int body = members.values[k];
            if (by.isDirty[body] && !large.isRough(body)) {
                joining.bear(body);
            }
        }
        IntList near = large.foresee(members);
        for (int k = 0; k < near.size; k++) {
            add(near.values[k]);
        }
    }

    /**
     * Takes note that a body's velocity has changed at an impact, and with it its course.
     *
     * @param body index
     */
    public void struck(int body) {
        if (!has(body)) {
            return;
        }
        keepPaid(body);
        by.turns[body]++;
        standing.loosen(body, heap.lasting);
        if (isTooOften(body)) {
            giveUp(body);
        } else {
            joining.mark(body);
        }
    }

    /**
     * Lets forces give a body in a heap nothing that it has got already.
     *
     * @param body index
     */
    public void keepPaid(int body) {
        if (has(body) && by.paidUntil[body] > 0 && !trajectories.isDriven(body)) {
            heap.pulls.endFor(body);
        }
    }

    /**
     * Until when the velocity of a body in a heap was found.
     *
     * @param body index
     * @return offset in the present step; infinite outside heaps
     */
    public double until(int body) {
        return by.has(body) && by.paidUntil[body] > 0 ? by.paidUntil[body] : Double.POSITIVE_INFINITY;
    }

    /**
     * Takes note that the path of a body has ended, or the time for which its velocity was found.
     *
     * @param body index
     * @param tau offset in the present step
     */
    public void again(int body, double tau) {
        by.ends[body]++;
        if (large.isDone(body)) {
            return;
        }
        if (isTooOften(body) && motion.isTied(body)) {
            by.isHurried[body] = true;
            joining.mark(body);
        } else if (isTooOften(body)) {
            giveUp(body);
            changed.add(body);
        } else if (!by.isDirty[body] && tau < by.paidUntil[body] && trajectories.isDriven(body) && heap.driving.goesOn(body, tau)) {
            changed.add(body);
        } else {
            joining.mark(body);
        }
    }

    /**
     * Takes note that a lasting pair has closed within the step.
     *
     * @param pair number of the pair
     * @param gap at which it has
     * @return false if it is not to last any more
     */
    public boolean close(int pair, double gap) {
        if (large.isDone(detection.pairs().first(pair)) || large.isDone(detection.pairs().second(pair))) {
            detection.marks().setDepth(pair, HeapGaps.depthOfMany(gap, size(detection.pairs().first(pair), detection.pairs().second(pair))));
            return false;
        }
        for (int side = 0; side < 2; side++) {
            int body = side == 0 ? detection.pairs().first(pair) : detection.pairs().second(pair);
            if (has(body)) {
                by.turns[body]++;
                by.hasClosed[body] = true;
                changed.add(body); // to be looked at again in any case
                if (isTooOften(body) && motion.isTied(body)) {
                    detection.marks().setDepth(pair, Math.max(detection.marks().depth(pair), -DEEPER * gap));
                    continue; // bounces would cost more, and end nowhere where it is jammed
                }
                joining.mark(body);
                if (isTooOften(body)) {
                    giveUp(body);
                }
            }
        }
        return lasts(pair);
    }

    /**
     * Lets go of a body that was written or leaves, and of all that lies on it.
     *
     * @param body index
     */
    public void forget(int body) {
        large.forget(body);
        if (members.size == 0 || !detection.knows(body)) {
            return;
        }
        part(body);
    }

    /**
     * Lets go of what lies on a body, or bears it, and is to pass through it from now on.
     *
     * @param body index
     */
    public void letPass(int body) {
        if (has(body)) {
            joining.part(body, true);
        }
    }

    /**
     * A body leaves: what it has borne in the step is told no more.
     *
     * @param body index
     */
    public void drop(int body) {
        heap.lasting.drop(body);
    }

    private void part(int body) {
        joining.part(body, false);
        if (has(body)) {
            by.lies[body] = false;
            heap.driving.thaw(body, heap.members.ties());
        }
    }

    /**
     * Solves the heaps in which something has happened.
     *
     * @param tau offset in the present step
     * @return the bodies whose courses have changed, which the detection must be told of; valid until something else happens
     */
    public IntList settle(double tau) {
        for (int k = 0; k < dirty.size; k++) {
            int body = dirty.values[k];
            if (by.lies[body] && isDriven(body) && !calm.isCalm(motion.companions(body), HeapCalm.NONE)) {
                giveUp(body);
                changed.add(body);
            } else if (by.isDirty[body] && state.body(body) != null && by.lies[body]) {
                heap.settle(body, tau, changed, dirty);
            }
            by.isDirty[body] = false;
        }
        dirty.clear();
        return changed;
    }

    /**
     * Ends a step: bodies get the second half of what forces and contacts give them in it.
     *
     * @return the bodies whose velocities have changed; valid until the next step begins
     */
    public IntList finish() {
        changed.clear();
        for (int k = 0; k < members.size; k++) {
            int body = members.values[k];
            if (state.body(body) != null && by.has(body) && !trajectories.isDriven(body)) { // a listener may have it driven from now on
                heap.complete(body, trajectories.h(), changed);
            }
        }
        return changed;
    }

    /** {@return what solutions of heaps have cost since this was asked last, in units of {@link sim.physics.internal.Work}} */
    public long takeCost() {
        return heap.system.takeCost();
    }

    /**
     * Forgets the heap that was being solved when an author's exception ended the step, or its work was spent. Bodies give back what they have
     * got for the time that is left.
     *
     * @param tau offset in the step at which it has ended
     */
    public void breakOff(double tau) {
        Arrays.fill(by.place, 0);
        for (int k = 0; k < members.size; k++) {
            int body = members.values[k];
            if (state.body(body) != null && by.has(body) && !trajectories.isDriven(body)) {
                by.unpay(body, tau, trajectories.data(), body * Trajectories.STRIDE + Trajectories.VX);
                by.paidUntil[body] = 0;
            }
        }
    }

    /** Forgets which courses have changed. */
    public void told() {
        changed.clear();
    }
}
