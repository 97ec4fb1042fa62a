// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import java.io.Serializable;
import java.util.List;
import sim.physics.collision.CollisionDetection;
import sim.physics.collision.Overlaps;
import sim.physics.constraint.Constraint;
import sim.physics.constraint.Constraints;
import sim.physics.constraint.Formation;
import sim.physics.constraint.KeptTurns;
import sim.physics.constraint.Reaction;
import sim.physics.internal.IntList;
import sim.physics.internal.Tolerances;
import sim.physics.motion.Body;
import sim.physics.motion.CoupledGroups;
import sim.physics.motion.Motion;
import sim.physics.motion.Presence;
import sim.physics.motion.Reach;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;
import sim.physics.motion.Writings;
import sim.physics.response.lasting.Heaps;
import sim.physics.response.lasting.RestingContacts;
import sim.physics.stepping.TimeStepping;

/**
 * Lets into the motion what authors have changed: bodies that were added, written or removed, and constraints that were
 * made or cut, between steps or by a listener in the middle of one.
 */
final class Admission implements Presence, Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;
    private final Trajectories trajectories;
    private final Motion motion;
    private final CollisionDetection detection;
    private final RestingContacts resting;
    private final Heaps heaps;
    private final Leavers leaving = new Leavers();

    /** Null until the first constraint is added. */
    private Constraints constraints;

    /** Driven bodies that were admitted last: their paths are to be made. */
    private final IntList driven = new IntList();

    /** Offset in the present step of the collision that is being handled. */
    private double now;

    /** Whether changes are let in that were made within the step, so that the vectors do not hold how bodies move. */
    boolean isWithin;

    /** Null unless the engine is audited. */
    private Audit audit;

    /** Null unless bodies are moved by time stepping. */
    private TimeStepping stepped;

    private final IslandRounds rounds = new IslandRounds();
    private final Answered answered = new Answered();
    private final WrittenBlocks written;

    Admission(State state, Trajectories trajectories, Motion motion, CollisionDetection detection, RestingContacts resting, Heaps heaps) {
        this.resting = resting;
        this.heaps = heaps;
        this.state = state;
        this.trajectories = trajectories;
        this.motion = motion;
        this.detection = detection;
        written = new WrittenBlocks(state);
    }

    void setConstraints(Constraints those) {
        constraints = those;
        motion.setTies(those);
        detection.filter().setTies(those);
    }

    void setAudit(Audit those) {
        audit = those;
    }

    /** Sets what moves the bodies, between steps: from now on it, and not events, is told of changes. All bodies start anew from where they are. */
    void setStepped(TimeStepping those) {
        for (int k = 0; k < state.size(); k++) {
            if (state.body(k) != null) {
                forget(k);
                state.touch(k);
            }
        }
        stepped = those;
    }

    /** Sets the instant at which listeners are called. */
    void setNow(double tau) {
        now = tau;
    }

    @Override
    public void bring(int index) {
        if (detection.knows(index)) {
            trajectories.publish(index, now, state);
        }
    }

    boolean isNeeded() {
        return state.touchedCount() > 0 || !leaving.isEmpty() || constraints != null && constraints.isChanged();
    }

    /** Whether nothing is to be let in but forces. */
    boolean areOnlyPushes() {
        boolean yes = leaving.isEmpty() && (constraints == null || !constraints.isChanged());
        for (int k = 0; yes && k < state.touchedCount(); k++) {
            yes = state.isOnlyPushed(state.touched(k));
        }
        return yes;
    }

    /** Bodies to be removed at the next {@link #admit(double)}. */
    Leavers leaving() {
        return leaving;
    }

    /**
     * Lets all changes in; bodies start anew from where their blocks of the state vectors say.
     *
     * @param tau offset in the present step; at 0 the vectors hold where all bodies are
     * @return driven bodies that start anew; valid until the next call
     */
    IntList admit(double tau) {
        driven.clear();
        letIn(tau);
        if (leaving.end(state)) {
            letIn(tau);
        }
        return driven;
    }

    private void letIn(double tau) {
        stirOnFixed(tau);
        if (constraints != null) {
            tellConstraints(tau);
        }
        if (tau > 0 && (constraints != null || motion.groups().mayCouple() || !leaving.isEmpty())) {
            bringOthers(tau);
        }
        for (int k = 0; k < leaving.size(); k++) {
            cutSprings(leaving.get(k));
        }
        if (constraints != null) {
            regroup(tau);
        }
        regroupCoupled(tau);
        if (trajectories.data().length == 0) {
            state.trim();
        }
        state.touched().sort();
        for (int k = 0; k < state.touchedCount(); k++) {
            int index = state.touched(k);
            trajectories.ensure(state.size()); // also for the block of a body that was removed before its first step
            if (state.body(index) != null) {
                admit(index, tau);
            }
        }
        state.clearTouched();
        for (int k = 0; k < leaving.size(); k++) {
            drop(leaving.get(k));
        }
    }

    private void admit(int index, double tau) {
        if (audit != null && stepped == null) {
            audit.written(index, tau);
        }
        if (state.touched().isReshaped(index)) {
            detection.marks().keep(index);
            forget(index); // it is taken in as it is now
        }
        if (stepped != null) {
            stepped.admit(index);
            return;
        }
        if (state.body(index).isImmobile() && state.isOnlyPushed(index) && detection.knows(index)) {
            return; // what it bears has been told
        }
        boolean isThere = trajectories.isAt(index, tau, state, 0); // forces are set in each step, and change no contact
        if (isThere && isAtRestStill(index, tau)) {
            resting.again(index);
        } else {
            resting.forget(index);
        }
        if (heaps.has(index) && trajectories.isAt(index, tau, state, Tolerances.LIES_ON) && !state.touched().isTurned(index)) {
            heaps.struck(index);
        } else {
            heaps.forget(index);
        }
        boolean isDriven = trajectories.isDriven(index);
        motion.admit(index, tau);
        if (isWithin) {
            heaps.keepPaid(index);
        }
        if (trajectories.isDriven(index)) {
            resting.forget(index); // it was at rest until it was tied, or a spring was put on it
        }
        boolean isKnown = detection.knows(index);
        boolean staysDriven = isDriven && trajectories.isDriven(index);
        if (isKnown && !(staysDriven && isOnlyPushed(index, tau))) { // else its path is told with those of all driven bodies
            boolean isOutOfBox = detection.refilter(index, tau, !isThere);
            heaps.letPass(index);
            detection.moved(index, tau, isDriven || !isThere || isOutOfBox || state.body(index).isImmobile(), -1);
        } else if (!isKnown) {
            detection.add(index, tau);
        }
        if (trajectories.isDriven(index)) {
            driven.add(index);
        }
        if (audit != null) {
            audit.admitted(index, tau);
        }
    }

    /** Whether forces are applied to a body from the start of the step on, and nothing else of it is new. */
    private boolean isOnlyPushed(int index, double tau) {
        return tau == 0 && state.isOnlyPushed(index);
    }

    /** Whether a body at rest, which is where it was, moves as it did, and nothing is new but the forces on it, or its friction. */
    private boolean isAtRestStill(int index, double tau) {
        return resting.rests(index) && (state.isPushed(index) || state.isOnlyPushed(index)) && trajectories.movesAs(index, tau, state);
    }

    /** Cuts the constraints of bodies that leave, and tells the others of bodies that were written. */
    private void tellConstraints(double tau) {
        for (int k = 0; k < leaving.size(); k++) {
            constraints.removeAll(leaving.get(k));
        }
        for (int k = 0; k < state.touchedCount(); k++) {
            Body body = state.body(state.touched(k));
            if (body != null && !isOnlyPushed(body.index(), tau)) {
                constraints.touched(body);
            }
        }
    }

    /** Forms islands anew where constraints have changed, and closes the joints of bodies that were written. */
    private void regroup(double tau) {
        if (constraints.isChanged()) {
            IntList concerned = constraints.concerned();
            for (int k = 0; k < concerned.size; k++) {
                bring(concerned.values[k], tau);
                state.touch(concerned.values[k]); // not only pushed: what ties it now may not allow its velocity
            }
            constraints.regroup();
        }
        close(tau);
    }

    /** Closes the joints of the islands that have bodies that start anew; their bodies all start anew then. */
    private void close(double tau) {
        rounds.begin();
        for (int k = 0; k < state.touchedCount(); k++) {
            int index = state.touched(k);
            boolean mayBeOpen = stepped == null ? !isOnlyPushed(index, tau) : state.touched().isMoved(index); // substeps go on with another mass
            if (mayBeOpen && state.body(index) != null && motion.isTied(index) && rounds.isFirst(constraints.island(index))) {
                IntList island = constraints.island(index);
                for (int m = 0; m < island.size; m++) {
                    bring(island.values[m], tau);
                }
                if (stepped == null) {
                    constraints.assemble(island, Reach.ANYWHERE);
                } else {
                    stepped.assemble(island);
                }
            }
        }
    }

    /** Brings a body that was not written to the present instant, and lets it start anew from there. */
    private void bring(int index, double tau) {
        if (!state.isTouched(index)) {
            publish(index, tau);
            state.touch(index);
        }
    }

    private void publish(int index, double tau) {
        if (isWithin) { // also at its first instant: what lies in a heap has got already what it is to have in the step
            motion.bring(index, tau);
            trajectories.publish(index, tau, state);
        }
    }

    /** What rests or lies on bodies that nothing moves feels it when these have another surface, begin to move, or come to a stand. */
    private void stirOnFixed(double tau) {
        for (int k = 0, n = state.touchedCount(); k < n; k++) {
            int index = state.touched(k);
            boolean isSurface = state.isOnlyPushed(index) && state.body(index) != null && state.body(index).isImmobile();
            if ((isSurface || state.touched().isTurned(index)) && detection.knows(index)) {
                stirOn(index, tau);
            }
        }
    }

    private void stirOn(int index, double tau) {
        for (int m = 0; m < detection.pairs().countOf(index); m++) {
            int other = detection.pairs().other(detection.pairs().of(index, m), index);
            if (!state.isTouched(other) && (resting.rests(other) || heaps.has(other))) {
                publish(other, tau);
                state.stir(other);
            }
        }
    }

    /** All that rests or lies on something feels forces anew. */
    void stirAll() {
        if (stepped != null) {
            stepped.sleep().wakeAll();
        }
        for (int k = 0; k < state.size(); k++) {
            if (resting.rests(k) || heaps.has(k)) {
                state.stir(k);
            }
        }
    }

    /** Brings those that move together with bodies that were written or leave, but not these themselves. */
    private void bringOthers(double tau) {
        int writtenBodies = state.touchedCount();
        written.keep(writtenBodies);
        for (int k = 0; k < writtenBodies; k++) {
            bringCompanions(state.touched(k), tau);
        }
        for (int k = 0; k < leaving.size(); k++) {
            bringCompanions(leaving.get(k).index(), tau);
            for (Body end : motion.groups().springEnds(leaving.get(k), false)) {
                if (end.state() == state && end != leaving.get(k)) {
                    bringCompanions(end.index(), tau);
                    bring(end.index(), tau);
                }
            }
        }
        written.putBack(writtenBodies);
    }

    private void bringCompanions(int index, double tau) {
        if (state.body(index) == null || !motion.isTied(index) && !motion.groups().isCoupled(index)) {
            return;
        }
        IntList group = motion.companions(index);
        for (int k = 0; k < group.size; k++) {
            bring(group.values[k], tau);
        }
    }

    /** Finds out which forces act on bodies that start anew, and what moves together from now on. */
    private void regroupCoupled(double tau) {
        CoupledGroups groups = motion.groups();
        for (int k = 0; tau > 0 && motion.groups().mayCouple() && k < state.touchedCount(); k++) {
            bringCompanions(state.touched(k), tau); // those of bodies whose ties have changed; they are there already
        }
        for (int k = 0; k < state.touchedCount(); k++) {
            Body body = state.body(state.touched(k));
            if (body != null) {
                groups.review(body);
            }
        }
        for (int k = 0; k < leaving.size(); k++) {
            groups.leave(leaving.get(k).index());
        }
        IntList concerned = groups.renew(constraints);
        for (int k = 0; k < concerned.size; k++) {
            bring(concerned.values[k], tau);
        }
        groups.commit();
    }

    /** Removes the springs of a body that leaves; those at their other ends start anew without, from where the vectors say. */
    private void cutSprings(Body body) {
        for (Body end : motion.groups().springEnds(body, true)) {
            if (end.state() == state && end != body) {
                state.touch(end.index());
            }
        }
    }

    /** What a constraint does now, between steps. */
    Reaction reaction(Constraint constraint, double time) {
        if (constraints.isChanged()) {
            regroup();
        }
        Body body = constraint.getBodyA().isImmobile() ? constraint.getBodyB() : constraint.getBodyA();
        answer(constraints.island(body.index()), time);
        return constraints.reaction(constraint);
    }

    /** Finds what the constraints of an island do now, between steps. */
    void answer(IntList island, double time) {
        if (!answered.holds(island, constraints, state, time)) {
            if (motion.groups().mayCouple()) {
                regroupCoupled(0);
            } else {
                for (int k = 0; k < island.size; k++) {
                    motion.groups().review(state.body(island.values[k])); // not all that was written: others are asked about, too
                }
            }
            answered.evaluate(island, constraints, motion, state, time);
        }
    }

    /** Something else than what is written may have changed what constraints do. */
    void forgetAnswers() {
        answered.forget();
    }

    /** Forms islands anew between steps, when the vectors hold where all bodies are. */
    void regroup() {
        touchAll(constraints.concerned());
        constraints.regroup();
    }

    private void touchAll(IntList bodies) {
        for (int k = 0; k < bodies.size; k++) {
            state.touch(bodies.values[k]);
        }
    }

    /** Adds constraints between steps and closes them; if that cannot be, all is as before. */
    void assemble(Constraint... those) {
        Writings writings = new Writings(state);
        Formation formation = Formation.keep(constraints, those);
        for (Constraint c : those) {
            constraints.add(c);
        }
        regroup();
        IslandPlaces before = new IslandPlaces(state, constraints, those);
        try {
            before.assemble();
        } catch (RuntimeException e) { // also what a constraint of an author throws
            before.putBack();
            formation.putBack(those);
            writings.putBack();
            throw e;
        }
    }

    /** What finds and parts overlaps between steps; it knows which bodies joints let overlap, also the newest. */
    Overlaps overlaps() {
        if (constraints != null && constraints.isChanged()) {
            regroup();
        }
        return new Overlaps(detection.filter());
    }

    /** Parts overlapping bodies between steps. */
    int separate(List<Body> bodies) {
        Separation separation = new Separation(overlaps(), bodies, new KeptTurns(constraints, state));
        Writings writings = new Writings(state);
        try {
            return separation.run(constraints == null ? null : () -> {
                state.touched().forgetBefore();
                close(0);
                state.placedAll();
            });
        } catch (RuntimeException e) {
            writings.putBack();
            throw e;
        }
    }

    /** Removes a body, with its constraints if that has not been done yet. */
    void drop(Body body) {
        cutSprings(body);
        if (constraints != null) {
            touchAll(constraints.cut(body)); // they form islands anew when all that is written between steps is let in
        }
        int index = body.index();
        motion.groups().leave(index);
        if (audit != null) {
            audit.removed(index);
        }
        forget(index);
        heaps.drop(index);
        detection.filter().forget(body);
        state.remove(body);
    }

    private void forget(int index) {
        if (stepped != null) {
            stepped.remove(index);
        }
        if (detection.knows(index)) {
            resting.forget(index);
            heaps.forget(index);
            detection.remove(index);
            motion.remove(index);
        }
    }
}
