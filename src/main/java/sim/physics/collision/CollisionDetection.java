// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.io.Serializable;
import sim.physics.collision.broad.BodyNotes;
import sim.physics.collision.broad.Boxes;
import sim.physics.collision.broad.BroadPhase;
import sim.physics.collision.broad.Pairs;
import sim.physics.collision.narrow.NarrowPhase;
import sim.physics.internal.IntList;
import sim.physics.internal.Team;
import sim.physics.internal.Tolerances;
import sim.physics.internal.Work;
import sim.physics.motion.Body;
import sim.physics.motion.Motion;
import sim.physics.motion.Neighbours;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;

/**
 * Finds the impacts of a step in time order, the write-up's chapter <i>Collision Detection</i>, in continuous time.
 *
 * <p>A body is put into a box with some room to move; the broad phase sees the body again when it leaves the box. A
 * pair whose boxes overlap is looked at once by the narrow phase, which says until when the two cannot touch; it is
 * looked at again in that step, or when one of the two changes its course. So the cost of a step grows with what
 * happens in it and not with the number of bodies.
 */
public final class CollisionDetection implements Pairs.Listener, Neighbours, Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;
    private final Trajectories trajectories;

    /** A pair's time is said by {@link Watch}. */
    private final Pairs pairs = new Pairs();

    private final PairSearch search;
    private final Companions companions;
    private final Enclosures enclosures;
    private final CollisionFilter filter = new CollisionFilter();

    private final PathEnds pathEnds = new PathEnds();
    private final EventQueue queue = new EventQueue(pairs, pathEnds);
    private final Watch watch;

    private final BodyNotes notes;
    private double pathEnd;

    private final PairMarks marks;
    private final IntList together = new IntList();

    /** Pairs that were let pass, and are so no more since the step began. */
    private final IntList parted = new IntList();

    /** Bodies whose pairs are looked at together, while the step begins. */
    private final IntList gathered = new IntList();

    private boolean gathers;
    private long step;
    private double h;

    /**
     * Makes the collision detection of an engine.
     *
     * @param state the state vectors
     * @param trajectories the motion of the bodies
     * @param broadPhase an empty broad phase
     */
    public CollisionDetection(State state, Trajectories trajectories, BroadPhase broadPhase) {
        this.state = state;
        this.trajectories = trajectories;
        this.enclosures = new Enclosures(this, state, trajectories, pairs, broadPhase);
        Boxes boxes = enclosures.boxes();
        notes = boxes.notes();
        NarrowPhase narrowPhase = new NarrowPhase(pairs, trajectories, enclosures.shapes(), boxes);
        marks = new PairMarks(pairs, new Clearances(pairs, trajectories, narrowPhase));
        this.search = new PairSearch(pairs, trajectories, marks, narrowPhase);
        this.watch = new Watch(this, pairs, marks, search, queue, enclosures.order());
        this.companions = new Companions(state, trajectories, boxes, pairs, marks, narrowPhase);
        pairs.setListener(this);
    }

    /** {@return the filter that decides which bodies collide, live} */
    public CollisionFilter filter() {
        return filter;
    }

    /** {@return the pairs whose boxes overlap, live} */
    public Pairs pairs() {
        return pairs;
    }

    /** {@return the narrow phase} */
    public NarrowPhase narrowPhase() {
        return search.narrowPhase();
    }

    /**
     * Sets who counts what looks at the pairs of a body cost, and may end the step between two of them.
     *
     * @param those never null
     */
    public void setWork(Work those) {
        watch.setWork(those);
    }

    /**
     * Takes a body in; its trajectory is set.
     *
     * @param body index
     * @param tau offset in the present step
     */
    public void add(int body, double tau) {
        Body view = state.body(body);
        enclosures.prepare(body, view);
        trajectories.setRadius(body, view.getShape().boundingRadius());
        pairs.ensure(state.size());
        pairs.setParts(body, view.getShape().partCount());
        notes.set(body, BodyNotes.KNOWN, true);
        notes.set(body, BodyNotes.IDLE, false);
        pathEnds.clear(body);
        enclosures.enclose(body, tau, step, h);
        watch.clearList();
        enclosures.add(body);
        marks.recall(body);
        watch.lookAtList(tau);
    }

    /**
     * Forgets a body.
     *
     * @param body index
     */
    public void remove(int body) {
        notes.set(body, BodyNotes.KNOWN, false);
        pathEnds.clear(body);
        enclosures.remove(body);
    }

    /**
     * Puts another broad phase in the place of the present one.
     *
     * @param replacement an empty broad phase
     */
    public void setBroadPhase(BroadPhase replacement) {
        enclosures.setBroadPhase(replacement);
        for (int i = 0; i < state.size(); i++) {
            if (knows(i)) {
                enclosures.add(i);
            }
        }
    }

    /**
     * Begins a step.
     *
     * @param number the number of the step
     * @param length its length h, time
     */
    public void begin(long number, double length) {
        step = number;
        h = length;
        queue.begin(length);
        watch.begin(number, length);
        marks.clearances().begin();
    }

    /** Ends the passing of pairs that are apart where the step begins. */
    public void part() {
        marks.part(parted);
        for (int k = 0; k < parted.size; k++) {
            filter(parted.values[k]);
        }
    }

    private void filter(int pair) {
        marks.filter(pair, filter.forbids(state, pairs.first(pair), pairs.second(pair)));
        attend(pair);
    }

    /** Looks at the bodies that leave their boxes in the step that has begun, and at the pairs that may touch in it. */
    public void look() {
        watch.clearList();
        enclosures.renew(step, h);
        for (int k = 0; k < parted.size; k++) {
            watch.list(parted.values[k]);
        }
        watch.look();
    }

    /**
     * Sets which threads share the work of looking at many bodies and pairs.
     *
     * @param team null for the calling thread alone
     */
    public void setTeam(Team team) {
        watch.setTeam(team);
        enclosures.setTeam(team);
    }

    /**
     * Takes note that a body has a new trajectory from an instant on.
     *
     * @param body index
     * @param tau offset in the present step
     * @param teleported whether its position changed too
     * @param except a pair that need not be looked at, or −1
     */
    public void moved(int body, double tau, boolean teleported, int except) {
        if (teleported) {
            marks.clearances().forgetAll(body);
        }
        enclosures.moved(body, tau, teleported, step, h);
        watch.clearList();
        if (notes.has(body, BodyNotes.IDLE)) {
            return;
        }
        if (gathers && !trajectories.areStraight()) {
            gathered.add(body);
            return;
        }
        boolean straight = trajectories.areStraight() && narrowPhase().isContinuous() && marks.areShallow();
        boolean watched = straight ? watch.lookAround(body, tau, except) : watch.lookAtAll(body, tau, except);
        notes.set(body, BodyNotes.IDLE, !watched);
    }

    /**
     * Takes note that a pair has collided and what its bodies' new trajectories are: if that says for how long it is apart,
     * it need not be looked at.
     *
     * @param pair its number
     * @param tau offset in the present step
     * @return whether it says so
     */
    public boolean parts(int pair, double tau) {
        if (!narrowPhase().isContinuous() || marks.isUnseen(pair) || marks.depth(pair) > 0) {
            return false;
        }
        double until = narrowPhase().partUntil(pair, tau);
        boolean isLong = until > tau && until >= h;
        if (isLong) {
            watch.plan(pair, PairSearch.LATER, until);
        }
        return isLong;
    }

    /**
     * Lets the pairs of bodies that get new trajectories at the start of the step wait until all have theirs. Those that
     * wait still, because an author's force has failed in the last step, do so on.
     */
    public void gather() {
        if (!gathers) {
            gathered.clear();
        }
        gathers = true;
    }

    /**
     * Looks at the pairs that have waited, and at those of other bodies, at each once.
     *
     * @param others indices of bodies that have entered new trajectories
     */
    public void lookAtGathered(IntList others) {
        gathers = false;
        notes.addWithout(BodyNotes.IDLE, others, gathered);
        if (gathered.size > 0) {
            lookAround(gathered);
        }
    }

    /**
     * Takes note that bodies have new trajectories, as {@link #moved} does, but leaves their pairs to
     * {@link #lookAtGathered}.
     *
     * @param bodies indices
     * @param tau offset in the present step
     */
    public void enter(IntList bodies, double tau) {
        enclosures.moved(bodies, tau, step, h);
        watch.clearList();
    }

    /**
     * Does that for many bodies that are driven from the start of the step on, in their order.
     *
     * @param bodies indices
     */
    public void enter(IntList bodies) {
        enclosures.moved(bodies, step, h);
        watch.clearList();
    }

    /**
     * Looks at the pairs of all bodies that enter new trajectories where the step begins, at each once.
     *
     * @param bodies indices
     */
    private void lookAround(IntList bodies) {
        watch.clearList();
        for (int m = 0; m < bodies.size; m++) {
            int body = bodies.values[m];
            if (notes.has(body, BodyNotes.IDLE)) {
                continue;
            }
            boolean watched = false;
            for (int k = 0; k < pairs.countOf(body); k++) {
                int pair = pairs.of(body, k);
                watched |= !marks.isUnseen(pair);
                watch.list(pair);
            }
            notes.set(body, BodyNotes.IDLE, !watched);
        }
        watch.lookAtList(0);
    }

    /**
     * Applies the filter again to the pairs of a body; they are looked at when it has moved.
     *
     * @param body index
     * @param tau offset in the present step
     * @param isPut whether it may be elsewhere than it was: what is let pass is so no more where it is apart
     * @return whether it needs a new box wherever it is: its last one did not follow it while it could collide with nobody
     */
    public boolean refilter(int body, double tau, boolean isPut) {
        boolean wasAloof = notes.has(body, BodyNotes.ALOOF);
        enclosures.admit(body, state.body(body));
        for (int k = 0; k < pairs.countOf(body); k++) {
            int p = pairs.of(body, k);
            if (isPut && marks.passes(p) && narrowPhase().gap(p, tau) > 0) {
                marks.endPassing(p);
            }
            filter(p);
        }
        return wasAloof && !notes.has(body, BodyNotes.ALOOF);
    }

    /** {@return what is known of pairs: whether they are let pass, rest on one another, or lie on one another; live} */
    public PairMarks marks() {
        return marks;
    }

    /**
     * Says whether the bodies of a pair rest on one another, so that they need not be looked at.
     *
     * @param pair its number
     * @param yes whether they do
     */
    public void hold(int pair, boolean yes) {
        marks.hold(pair, yes);
        attend(pair);
        pairs.setTime(pair, Double.NaN);
    }

    /**
     * Plans an event at which a body that is not driven is to be looked at.
     *
     * @param body index
     * @param tau offset in the present step
     */
    public void plan(int body, double tau) {
        pathEnds.plan(body, tau);
        queue.add(tau, ~body);
    }

    /**
     * Forgets that event.
     *
     * @param body index
     */
    public void unplan(int body) {
        pathEnds.forget(body);
    }

    /**
     * {@return whether a body has been taken in} It is from add to remove.
     *
     * @param body index
     */
    public boolean knows(int body) {
        return notes.knows(body);
    }

    /**
     * Says until when the paths of driven bodies hold, before they are {@link #moved}.
     *
     * @param bodies indices
     * @param tau offset in the present step
     */
    public void setPathEnd(IntList bodies, double tau) {
        pathEnds.setHoldsUntil(bodies, tau);
    }

    /**
     * Plans an event at which the path of a driven body ends, if that is before the step does.
     *
     * @param body index
     */
    public void endPath(int body) {
        double until = pathEnds.holdsUntil(body);
        if (until < h) {
            plan(body, until);
        } else {
            pathEnds.forget(body);
        }
    }

    /** Until when in the step what is known of the paths of a pair's bodies holds. */
    double pathEnd(int pair) {
        return trajectories.areStraight() ? h : Math.min(end(pairs.first(pair)), end(pairs.second(pair)));
    }

    /** Until when in the step what is known of a body's path holds. */
    double end(int body) {
        return trajectories.isDriven(body) ? Math.min(h, pathEnds.holdsUntil(body)) : h;
    }

    @Override
    public boolean hasNeighbours(IntList bodies) {
        for (int k = 0; k < bodies.size; k++) {
            if (!notes.has(bodies.values[k], BodyNotes.ALOOF) && marks.hasNeighbours(bodies.values[k])) {
                return true;
            }
        }
        return false;
    }

    @Override
    public boolean areAloof(IntList bodies) {
        return notes.areAll(BodyNotes.ALOOF, bodies);
    }

    /** {@return whether there is an event left in the present step: an impact or the end of a path} */
    public boolean hasEvent() {
        return queue.hasNext();
    }

    /**
     * Takes the next event off the queue if it is the end of a path.
     *
     * @return index of the body, or −1 if the next event is an impact
     */
    public int takePathEnd() {
        int item = queue.firstItem();
        if (item >= 0) {
            return -1;
        }
        pathEnd = queue.firstTime();
        queue.removeFirst();
        pathEnds.forget(~item);
        return ~item;
    }

    /** {@return when the path ended that {@link #takePathEnd()} took, offset in the present step} */
    public double pathEnd() {
        return pathEnd;
    }

    /** {@return when the next event is, offset in the present step} */
    public double nextTime() {
        return queue.firstTime();
    }

    /**
     * Takes the next impact off the queue, with those that are simultaneous.
     *
     * @param motion says which bodies move together; asked about driven ones only
     * @return the pairs that touch; valid until the next call
     */
    public IntList nextImpacts(Motion motion) {
        together.clear();
        double tau = queue.firstTime();
        double until = tau + Tolerances.SIMULTANEOUS * h;
        while (hasEvent() && queue.firstTime() <= until && queue.firstItem() >= 0) {
            int pair = queue.firstItem();
            queue.removeFirst();
            pairs.setTime(pair, Double.NaN);
            together.add(pair);
        }
        companions.gather(together, tau, hasEvent() ? queue.firstTime() : Double.POSITIVE_INFINITY, motion);
        return together;
    }

    @Override
    public void pairBegan(int pair) {
        watch.add(pair);
        marks.begin(pair, filter.forbids(state, pairs.first(pair), pairs.second(pair)));
        attend(pair);
    }

    private void attend(int pair) {
        notes.set(pairs.first(pair), BodyNotes.IDLE, false);
        notes.set(pairs.second(pair), BodyNotes.IDLE, false);
    }

    @Override
    public void pairEnded(int pair) {
        watch.remove(pair);
    }
}
