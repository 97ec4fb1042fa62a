// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.broad.Boxes;
import sim.physics.collision.broad.BroadPhase;
import sim.physics.collision.broad.CellGrid;
import sim.physics.collision.broad.Departures;
import sim.physics.collision.broad.Pairs;
import sim.physics.collision.narrow.NarrowPhase;
import sim.physics.collision.narrow.ShapeTable;
import sim.physics.internal.Agenda;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;
import sim.physics.internal.Tolerances;
import sim.physics.motion.Body;
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
public final class CollisionDetection implements Pairs.Listener, Serializable {
    private static final long serialVersionUID = 1L;

    /** 1 less the rounding of an instant of a later step. */
    private static final double ALMOST = 1 - 0x1p-51;

    private final State state;
    private final Trajectories trajectories;
    private final ShapeTable shapes = new ShapeTable();
    private final Boxes boxes = new Boxes();
    private final Room room;
    /**
     * A pair's time is that of its impact in the present step. If it is to be looked at in a later step: minus the offset in
     * that step up to which it is known to be apart. NaN if nothing is known.
     */
    private final Pairs pairs = new Pairs();

    private final NarrowPhase narrowPhase;
    private final Companions companions;
    private BroadPhase broadPhase;
    private final CollisionFilter filter = new CollisionFilter();

    private final Agenda bodyAgenda = new Agenda();
    private final Agenda pairAgenda = new Agenda();
    private final EventQueue queue = new EventQueue();

    private final PathEnds pathEnds = new PathEnds();
    private boolean[] known = new boolean[8];
    /** Bodies none of whose pairs need be looked at. */
    private boolean[] idle = new boolean[8];
    private double pathEnd;

    private final SpaceOrder order = new SpaceOrder(boxes, pairs);
    private final PairMarks marks = new PairMarks(pairs);
    private final IntList fresh = new IntList();
    private final IntList together = new IntList();
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
        this.broadPhase = broadPhase;
        this.room = new Room(trajectories, boxes);
        this.narrowPhase = new NarrowPhase(pairs, trajectories, shapes, boxes);
        this.companions = new Companions(trajectories, boxes, pairs, marks, narrowPhase);
        pairs.setListener(this);
    }

    /**
     * The filter that decides which bodies collide.
     *
     * @return live
     */
    public CollisionFilter filter() {
        return filter;
    }

    /**
     * The pairs whose boxes overlap.
     *
     * @return live
     */
    public Pairs pairs() {
        return pairs;
    }

    /**
     * The narrow phase.
     *
     * @return never null
     */
    public NarrowPhase narrowPhase() {
        return narrowPhase;
    }

    /**
     * Takes a body in; its trajectory is set.
     *
     * @param body index
     * @param tau offset in the present step
     */
    public void add(int body, double tau) {
        Body view = state.body(body);
        shapes.set(body, view.getShape());
        trajectories.setRadius(body, view.getShape().boundingRadius());
        pairs.ensure(state.size());
        room.admit(body, view, state.size());
        bodyAgenda.ensure(state.size());
        if (body >= known.length) {
            known = Arrays.copyOf(known, Growth.length(known.length, state.size()));
            idle = Arrays.copyOf(idle, known.length);
        }
        known[body] = true;
        idle[body] = false;
        pathEnds.clear(body);
        enclose(body, tau);
        fresh.clear();
        broadPhase.add(body, boxes, pairs);
        examineFresh(tau);
    }

    /**
     * Forgets a body.
     *
     * @param body index
     */
    public void remove(int body) {
        known[body] = false;
        pathEnds.clear(body);
        broadPhase.remove(body, boxes, pairs);
        bodyAgenda.schedule(body, Agenda.NEVER);
    }

    /**
     * Puts another broad phase in the place of the present one.
     *
     * @param replacement an empty broad phase
     */
    public void setBroadPhase(BroadPhase replacement) {
        broadPhase = replacement;
        for (int i = 0; i < state.size(); i++) {
            if (knows(i)) {
                broadPhase.add(i, boxes, pairs);
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
        queue.clear();
    }

    /** Looks at the bodies that leave their boxes in the step that has begun, and at the pairs that may touch in it. */
    public void look() {
        fresh.clear();
        IntList leaving = bodyAgenda.advance(step);
        if (broadPhase instanceof CellGrid && order.isLong(leaving)) {
            leaveMany(leaving, (CellGrid) broadPhase);
        } else {
            for (int k = 0; k < leaving.size; k++) {
                enclose(leaving.values[k], 0);
                broadPhase.update(leaving.values[k], boxes, pairs);
            }
        }
        IntList due = pairAgenda.advance(step);
        order.sortPairs(due);
        for (int k = 0; k < due.size; k++) {
            double apart = -pairs.time(due.values[k]);
            if (pairs.first(due.values[k]) >= 0) {
                examine(due.values[k], apart > 0 ? apart : 0);
            }
        }
        examineFresh(0);
    }

    /** The same as one after the other, but in the order of space. */
    private void leaveMany(IntList leaving, CellGrid grid) {
        Departures departures = order.sortLeaving(leaving, state.size());
        for (int k = 0; k < leaving.size; k++) {
            departures.keep(leaving.values[k], boxes);
            enclose(leaving.values[k], 0);
        }
        for (int k = 0; k < leaving.size; k++) {
            grid.update(leaving.values[k], boxes, pairs, departures);
        }
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
        if (!teleported && trajectories.isDriven(body) && room.holds(body, tau, end(body))) {
            bodyAgenda.schedule(body, Agenda.NEVER); // it is looked at again in the next step anyway
        } else if (!boxes.isFixed(body) || teleported) {
            long date = teleported ? step : room.leavingDate(body, tau, step, h);
            if (date <= step) {
                enclose(body, tau);
                broadPhase.update(body, boxes, pairs);
                fresh.clear();
            } else {
                bodyAgenda.schedule(body, date);
            }
        }
        if (idle[body]) {
            return;
        }
        boolean watched = false;
        for (int k = 0; k < pairs.countOf(body); k++) {
            int pair = pairs.of(body, k);
            watched |= pair == except || !marks.isUnseen(pair);
            if (pair != except) {
                examine(pair, tau);
            }
        }
        idle[body] = !watched;
    }

    /**
     * Applies the filter again to the pairs of a body; they are looked at when it has moved.
     *
     * @param body index
     */
    public void refilter(int body) {
        room.admit(body, state.body(body), state.size());
        for (int k = 0; k < pairs.countOf(body); k++) {
            int p = pairs.of(body, k);
            marks.ignore(p, filter.forbids(state, pairs.first(p), pairs.second(p)));
            watch(p);
        }
    }

    /**
     * What is known of pairs: whether they are let pass, rest on one another, or lie on one another.
     *
     * @return live
     */
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
        watch(pair);
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
     * Whether a body has been taken in.
     *
     * @param body index
     * @return true from add to remove
     */
    public boolean knows(int body) {
        return body < known.length && known[body];
    }

    private void examineFresh(double tau) {
        for (int k = 0; k < fresh.size; k++) {
            if (pairs.first(fresh.values[k]) >= 0) {
                examine(fresh.values[k], tau);
            }
        }
        fresh.clear();
    }

    /** Looks for a pair's first contact from an instant on, and plans an impact or the next look. */
    private void examine(int pair, double tau) {
        pairs.setTime(pair, Double.NaN);
        if (marks.isUnseen(pair)) {
            pairAgenda.schedule(pair, Agenda.NEVER);
            return;
        }
        double start = narrowPhase.boundingCircles(pair, tau);
        if (start == Double.POSITIVE_INFINITY) {
            pairAgenda.schedule(pair, Agenda.NEVER);
            return;
        }
        double end = Math.min(end(pairs.first(pair)), end(pairs.second(pair)));
        double depth = marks.depth(pair);
        double t = depth > 0
                ? narrowPhase.firstContact(pair, tau, start, end, depth)
                : narrowPhase.firstContact(pair, tau, start, end);
        if (narrowPhase.isApart()) {
            schedule(pair, t);
            return;
        }
        if (narrowPhase.isTouching() && t < end) {
            pairs.setTime(pair, t);
            queue.add(t, pair);
            pairAgenda.schedule(pair, Agenda.NEVER);
            return;
        }
        boolean driven = !narrowPhase.isContinuous()
                || trajectories.isDriven(pairs.first(pair))
                || trajectories.isDriven(pairs.second(pair));
        schedule(pair, driven ? h : t);
    }

    /** Plans the next look at a pair that is apart up to an offset, which may be infinite. */
    private void schedule(int pair, double tau) {
        double later = Math.max(1, Math.floor(tau / h));
        pairs.setTime(pair, later * h - tau * ALMOST); // the search goes on from there
        pairAgenda.schedule(pair, later < 1e15 ? step + (long) later : Agenda.NEVER);
    }

    /** Puts a body into a new box that holds its path to the end of the step, with room to go on. */
    private void enclose(int body, double tau) {
        if (boxes.isFixed(body)) { // its box fits its vertices
            shapes.encloseFixed(body, trajectories.data(), body * Trajectories.STRIDE, boxes);
            bodyAgenda.schedule(body, Agenda.NEVER);
            return;
        }
        room.enclose(body, tau, end(body));
        bodyAgenda.schedule(body, Math.max(step + 1, room.leavingDate(body, tau, step, h)));
    }

    /**
     * Says until when the path of a driven body holds, before it is {@link #moved}.
     *
     * @param body index
     * @param tau offset in the present step
     */
    public void setPathEnd(int body, double tau) {
        pathEnds.setHoldsUntil(body, tau);
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

    /** Until when in the step what is known of a body's path holds. */
    private double end(int body) {
        return trajectories.isDriven(body) ? Math.min(h, pathEnds.holdsUntil(body)) : h;
    }

    /**
     * Whether some body may meet one of its neighbours.
     *
     * @param bodies indices
     * @return true if a pair of one of them is looked at
     */
    public boolean hasNeighbours(IntList bodies) {
        return marks.hasNeighbours(bodies);
    }

    /**
     * Whether there is an event left in the present step.
     *
     * @return true if there is an impact or the end of a path
     */
    public boolean hasEvent() {
        while (!queue.isEmpty()) {
            int item = queue.firstItem();
            if (queue.firstTime() == (item >= 0 ? pairs.time(item) : pathEnds.end(~item))) {
                return true;
            }
            queue.removeFirst(); // planned before a later change of course
        }
        return false;
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

    /**
     * When the path ended that {@link #takePathEnd()} took.
     *
     * @return offset in the present step
     */
    public double pathEnd() {
        return pathEnd;
    }

    /**
     * When the next event is.
     *
     * @return offset in the present step
     */
    public double nextTime() {
        return queue.firstTime();
    }

    /**
     * Takes the next impact off the queue, with those that are simultaneous.
     *
     * @return the pairs that touch; valid until the next call
     */
    public IntList nextImpacts() {
        together.clear();
        double tau = queue.firstTime();
        double until = tau + Tolerances.SIMULTANEOUS * h;
        while (hasEvent() && queue.firstTime() <= until && queue.firstItem() >= 0) {
            int pair = queue.firstItem();
            queue.removeFirst();
            pairs.setTime(pair, Double.NaN);
            together.add(pair);
        }
        companions.gather(together, tau);
        return together;
    }

    @Override
    public void pairBegan(int pair) {
        pairAgenda.ensure(pair + 1);
        narrowPhase.forget(pair);
        pairs.setTime(pair, Double.NaN);
        marks.begin(pair, filter.forbids(state, pairs.first(pair), pairs.second(pair)));
        watch(pair);
        fresh.add(pair);
    }

    private void watch(int pair) {
        idle[pairs.first(pair)] = false;
        idle[pairs.second(pair)] = false;
    }

    @Override
    public void pairEnded(int pair) {
        pairs.setTime(pair, Double.NaN);
        pairAgenda.schedule(pair, Agenda.NEVER);
    }
}
