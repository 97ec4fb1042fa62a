// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.io.Serializable;
import sim.physics.collision.broad.Boxes;
import sim.physics.collision.broad.BroadPhase;
import sim.physics.collision.broad.CellGrid;
import sim.physics.collision.broad.Departures;
import sim.physics.collision.broad.Pairs;
import sim.physics.collision.narrow.ShapeTable;
import sim.physics.internal.Agenda;
import sim.physics.internal.IntList;
import sim.physics.internal.Team;
import sim.physics.motion.Body;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;

/** The boxes that bodies are in, when they leave them, and what the broad phase is told of that. */
final class Enclosures implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Bodies from which on it pays to share their boxes: of driven bodies, and of those that leave theirs. */
    private static final int FEWEST_DRIVEN = 512;

    private static final int FEWEST_LEAVING = 4096;

    private final CollisionDetection detection;
    private final State state;
    private final Trajectories trajectories;
    private final Pairs pairs;
    private final ShapeTable shapes = new ShapeTable();
    private final Boxes boxes = new Boxes();
    private final Room room;
    private final SpaceOrder order;
    private final Agenda agenda = new Agenda();
    private BroadPhase broadPhase;

    /** Null unless threads share the work. */
    private Team team;

    private transient SharedBoxes shared;

    Enclosures(
            CollisionDetection detection, State state, Trajectories trajectories, Pairs pairs, BroadPhase broadPhase) {
        this.detection = detection;
        this.state = state;
        this.trajectories = trajectories;
        this.pairs = pairs;
        this.broadPhase = broadPhase;
        room = new Room(trajectories, boxes);
        order = new SpaceOrder(boxes, pairs);
    }

    ShapeTable shapes() {
        return shapes;
    }

    Boxes boxes() {
        return boxes;
    }

    SpaceOrder order() {
        return order;
    }

    void setTeam(Team team) {
        this.team = team;
        shared = null;
    }

    /** Makes room for a body. */
    void prepare(int body, Body view) {
        shapes.set(body, view.getShape());
        admit(body, view);
        agenda.ensure(state.size());
    }

    /** Takes a body in, or takes note of what it collides with. */
    void admit(int body, Body view) {
        room.admit(body, view, state.size());
    }

    /** Tells the broad phase of a body. */
    void add(int body) {
        broadPhase.add(body, boxes, pairs);
    }

    void remove(int body) {
        broadPhase.remove(body, boxes, pairs);
        shapes.remove(body);
        agenda.schedule(body, Agenda.NEVER);
    }

    /** Puts an empty broad phase in the place of the present one; the bodies are to be added again. */
    void setBroadPhase(BroadPhase replacement) {
        broadPhase = replacement;
    }

    /** New boxes for the bodies that leave theirs in a step that begins. */
    void renew(long step, double h) {
        IntList leaving = agenda.advance(step);
        Departures departures = null;
        if (broadPhase instanceof CellGrid && order.isLong(leaving)) { // the same, but in the order of space
            departures = order.sortLeaving(leaving, state.size());
            for (int k = 0; k < leaving.size; k++) {
                departures.keep(leaving.values[k], boxes);
            }
        }
        boolean isShared = shares(leaving, FEWEST_LEAVING);
        if (isShared) {
            shared.renew(leaving, state.size(), step, h);
        }
        for (int k = 0; k < leaving.size; k++) {
            int body = leaving.values[k];
            if (isShared && !boxes.isFixed(body)) {
                shared.put(body, boxes);
                agenda.schedule(body, shared.date(k));
            } else {
                enclose(body, 0, step, h);
            }
            if (departures == null) {
                update(body, null);
            }
        }
        for (int k = 0; departures != null && k < leaving.size; k++) {
            update(leaving.values[k], departures);
        }
    }

    /**
     * Takes note that a body has a new trajectory.
     *
     * @param body index
     * @param tau offset in the present step
     * @param teleported whether its position changed too
     * @param step number of the step
     * @param h its length
     */
    void moved(int body, double tau, boolean teleported, long step, double h) {
        if (!teleported && isPassing(body) && room.holds(body, tau, detection.end(body))) {
            agenda.schedule(body, Agenda.NEVER);
        } else if (!boxes.isFixed(body) || teleported) {
            long date = teleported ? step : room.leavingDate(body, tau, step, h);
            if (date <= step) {
                enclose(body, tau, step, h);
                update(body, null);
            } else {
                agenda.schedule(body, date);
            }
        }
    }

    /** Whether a body follows another path in the next step. */
    private boolean isPassing(int body) {
        return !trajectories.areStraight() && (trajectories.isDriven(body) || state.isPushed(body));
    }

    /** The same for driven bodies that have new trajectories from the start of the step on, one after the other. */
    void moved(IntList bodies, long step, double h) {
        if (!shares(bodies, FEWEST_DRIVEN)) {
            moved(bodies, 0, step, h);
            return;
        }
        shared.enter(bodies, state.size(), step, h);
        for (int k = 0; k < bodies.size; k++) {
            int body = bodies.values[k];
            agenda.schedule(body, shared.date(k));
            if (shared.isNew(k)) {
                shared.put(body, boxes);
                update(body, null);
            }
        }
    }

    /** The same by one thread, at any instant. */
    void moved(IntList bodies, double tau, long step, double h) {
        for (int k = 0; k < bodies.size; k++) {
            int body = bodies.values[k];
            if (room.isAloof(body)) {
                agenda.schedule(body, Agenda.NEVER);
            } else {
                moved(body, tau, false, step, h);
            }
        }
    }

    /** Tells the broad phase that a body is in a new box; departures are null for one body. */
    private void update(int body, Departures departures) {
        if (departures == null) {
            broadPhase.update(body, boxes, pairs);
        } else {
            ((CellGrid) broadPhase).update(body, boxes, pairs, departures);
        }
        room.count(body, pairs.countOf(body));
    }

    private boolean shares(IntList bodies, int least) {
        if (team == null || !team.pays(bodies.size, least)) {
            return false;
        }
        shared = shared == null ? new SharedBoxes(detection, room, team) : shared;
        return true;
    }

    /** Puts a body into a new box that holds its path to the end of the step, with room to go on. */
    void enclose(int body, double tau, long step, double h) {
        if (boxes.isFixed(body)) { // its box fits its vertices
            shapes.encloseFixed(body, trajectories.data(), body * Trajectories.STRIDE, boxes);
            agenda.schedule(body, Agenda.NEVER);
            return;
        }
        agenda.schedule(body, room.enclose(body, tau, detection.end(body), step, h));
    }
}
