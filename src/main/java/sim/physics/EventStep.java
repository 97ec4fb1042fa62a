// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import java.io.Serializable;
import sim.physics.collision.CollisionDetection;
import sim.physics.collision.broad.BroadPhase;
import sim.physics.collision.broad.CellGrid;
import sim.physics.constraint.Constraints;
import sim.physics.constraint.Strength;
import sim.physics.internal.IntList;
import sim.physics.internal.Squeezed;
import sim.physics.internal.Team;
import sim.physics.internal.Work;
import sim.physics.motion.Motion;
import sim.physics.motion.State;
import sim.physics.motion.Steering;
import sim.physics.motion.Trajectories;
import sim.physics.response.CollisionResponse;

/**
 * What a step by events consists of, in the order in which the engine asks for it: {@link #begin}, {@link #drive}, then
 * {@link #handleEvent} as often as there is one, and {@link #finish}, or {@link #breakOff}.
 */
final class EventStep implements Serializable {
    private static final long serialVersionUID = 2L;

    /** Number of bodies from which the broad phase of a new engine is a {@link CellGrid}. */
    private static final int CROWD = 50;

    /** Work that an event costs beside looks, accelerations and heaps. */
    private static final int EVENT = 8;

    /** Events after which it is looked whether bodies are squeezed. */
    private static final int MANY = 32;

    private final State state;
    private final Trajectories trajectories;
    private final Work work;
    private final Motion motion;
    private final CollisionDetection detection;
    private final CollisionResponse response;
    private final Admission admission;
    private final Breakage breakage;
    private final DrivenPaths paths;
    private final Steering steering;

    /** Driven bodies whose applied forces have ended with the step before. */
    private final IntList changed = new IntList();

    /** Null until the first constraint is added. */
    private Constraints constraints;

    /** Null unless the engine is audited. */
    private Audit audit;

    /** Where tied bodies were when the step began. */
    private final StepStart start = new StepStart();

    /** Whether there have been listeners, force generators but uniform fields, or rules of authors, which may ask or write within a step. */
    private boolean asksAuthors;

    private boolean broadPhaseIsChosen;

    /** Whether what an author has added or written is being let in. */
    private boolean isAdmitting;

    /** Length of the step, the time at which it began, and the offset in it of what is being handled. */
    private double timeStep;

    private double time;
    private double instant;

    /** Number of events of the step. */
    private int events;

    EventStep(
            State state,
            Trajectories trajectories,
            Work work,
            Motion motion,
            CollisionDetection detection,
            CollisionResponse response,
            Admission admission,
            Steering steering) {
        this.state = state;
        this.trajectories = trajectories;
        this.work = work;
        this.motion = motion;
        this.detection = detection;
        this.response = response;
        this.admission = admission;
        this.steering = steering;
        breakage = new Breakage(state, trajectories, motion, detection, response.resting(), response.heaps());
        detection.setWork(work);
        paths = new DrivenPaths(state, trajectories, motion, detection, response.heaps(), admission, work);
    }

    void setConstraints(Constraints those) {
        constraints = those;
        response.setTies(those);
    }

    void setAudit(Audit those) {
        audit = those;
        paths.setAudit(those);
    }

    void setTeam(Team those) {
        paths.setTeam(those);
        detection.setTeam(those);
    }

    /** An author's code may ask or write within a step from now on. */
    void askAuthors() {
        asksAuthors = true;
    }

    void setBroadPhase(BroadPhase broadPhase) {
        broadPhaseIsChosen = true;
        detection.setBroadPhase(broadPhase);
    }

    /** Finds which joints bear too much now that the step is over, where that is not known before. */
    void judgeJoints(double now) {
        breakage.end(constraints, admission, now);
    }

    /** Offset in the step up to which it has been made. */
    double instant() {
        return instant;
    }

    /** Whether joints that cannot be closed are the author's affair, and not that of a pose in which nobody can tell how bodies go on. */
    boolean isRefusal() {
        return audit != null || isAdmitting || start.isTooLong(state, constraints, motion.generators(), timeStep);
    }

    /** Whether what has failed is what an author has added or written. */
    boolean isAdmitting() {
        return isAdmitting;
    }

    /** Groups of driven bodies that have been moved without paths get them: somebody looks at these. */
    void makeLatePaths() {
        paths.makeLate();
    }

    /**
     * Begins the step; bodies that were added or set since the last one start from where they were put.
     *
     * @param number of steps before
     * @param limit of its work
     */
    void begin(long number, double length, double now, long limit) {
        instant = 0;
        timeStep = length;
        time = now;
        state.setPresence(null, true);
        work.begin(limit, detection.narrowPhase().evaluations());
        boolean isKept = constraints != null || steering.isAny();
        state.settle(asksAuthors || audit != null || isKept || state.touchedCount() > 0);
        if (isKept) {
            start.keep(state);
        }
        events = 0;
        trajectories.begin(number, length);
        detection.begin(number, length);
        detection.part();
        motion.begin(now);
    }

    /** Motion, (5)–(15): driven bodies get their paths over the step; all others are on their way already. */
    void drive() {
        paths.forgetNoted();
        boolean isFree = response.isFree() && constraints == null && audit == null;
        if (isFree && !admission.isNeeded() && !motion.isPushed()) {
            response.begin(); // nobody has changed anything, and all go on as they did
            return;
        }
        changed.clear();
        detection.gather();
        if (mayBeLate()) {
            motion.late().anchorOthers(detection);
        } else {
            motion.anchorDriven();
        }
        motion.endApplied(changed);
        motion.groups().begin();
        breakage.begin(constraints, admission);
        letIn(0); // all driven bodies follow new paths anyway
        while (breakage.breakJoints(constraints, time)) {
            letIn(0);
        }
        motion.releaseDriven();
        if (audit != null) {
            audit.open();
        }
        for (int k = 0; k < changed.size; k++) {
            unpushed(changed.values[k]);
            moved(changed.values[k], 0, -1);
        }
        response.begin();
        if (!response.resting().isEmpty()) {
            response.resting().begin();
            settle(0);
        }
        if (!response.heaps().isEmpty()) {
            response.heaps().begin();
            settleHeaps(0);
        }
        paths.followAll();
        paths.forgetNoted();
    }

    /** Whether driven bodies that collide with nobody may be moved without anybody's looking at their paths. */
    private boolean mayBeLate() {
        return constraints != null
                && audit == null
                && !motion.groups().mayCouple()
                && response.resting().isEmpty()
                && response.heaps().isEmpty();
    }

    /** A force acts no more which was applied to a body for the step before: what bore the body with it bears something else now. */
    private void unpushed(int body) {
        if (response.resting().rests(body)) {
            response.resting().again(body);
        }
        response.heaps().struck(body);
    }

    /** Lets in what authors have changed since the last look; returns the driven bodies among those. */
    private IntList letIn(double tau) {
        if (!broadPhaseIsChosen && state.bodyCount() >= CROWD) {
            setBroadPhase(new CellGrid());
        }
        if (!admission.areOnlyPushes() || motion.groups().mayCouple()) {
            paths.makeLate();
            motion.late().forget();
        }
        isAdmitting = true;
        IntList admitted = admission.admit(tau);
        isAdmitting = false;
        if (motion.groups().mayCouple()) {
            paths.makeLate(); // forces couple what they did not couple before
        }
        return admitted;
    }

    /** The same within a step: driven bodies are noted, to follow new paths. */
    private void admit(double tau) {
        IntList driven = letIn(tau);
        for (int k = 0; k < driven.size; k++) {
            paths.note(driven.values[k]);
        }
    }

    private void setInstant(double tau) {
        instant = tau;
        response.ledger().setNow(tau);
    }

    /** Handles the next event: an impact, or the end of a path before the step is over. */
    void handleEvent() {
        work.spend(EVENT, detection.narrowPhase().evaluations());
        admission.isWithin = true;
        paths.makeLate();
        motion.keepEnds();
        events++;
        if (events % MANY == 0) {
            look(instant);
        }
        int body = detection.takePathEnd();
        if (body >= 0) {
            goOn(body);
        } else {
            respond();
        }
    }

    /** Looks whether bodies are squeezed, where some are moved by their author; not in an audit, which must have all events. */
    private void look(double tau) {
        boolean areAny = audit == null && steering.isSqueezing(tau, timeStep, events > 0, 0);
        if (areAny && (constraints == null || steering.isSqueezing(tau, timeStep, events > 0, Strength.of(constraints)))) {
            throw new Squeezed();
        }
    }

    /** Collision response, (16)–(24), at the next impact; then the bodies concerned go on. */
    private void respond() {
        double tau = detection.nextTime();
        setInstant(tau);
        IntList touching = detection.nextImpacts(motion);
        int pair = touching.size == 1 ? touching.values[0] : -1;
        if (pair >= 0 && !asksAuthors && bounce(pair, tau)) {
            return;
        }
        admission.setNow(tau);
        if (asksAuthors) {
            state.setPresence(admission, true);
        }
        IntList deflected = response.respond(touching, tau, time + tau);
        double at = response.instant();
        response.ledger().setNow(at);
        state.setPresence(null, true);
        tellDeflected(deflected);
        boolean parts = pair >= 0 && detection.parts(pair, tau);
        for (int k = 0; k < deflected.size; k++) {
            int body = deflected.values[k];
            if (trajectories.isDriven(body)) {
                paths.note(body);
            } else {
                moved(body, trajectories.offset(body), parts || k == 1 ? pair : -1);
            }
        }
        if (admission.isNeeded()) {
            admit(tau); // first: what listeners have written is in the vectors that others use for their work
        }
        if (!response.resting().isEmpty()) {
            settle(at);
        }
        if (!response.heaps().isEmpty()) {
            settleHeaps(at);
        }
        paths.followNoted();
    }

    /** The same for an impact that is plain, of which nobody is told; false if it is not. */
    private boolean bounce(int pair, double tau) {
        IntList deflected = response.bounce(pair, tau);
        if (deflected.size == 0) {
            return false;
        }
        boolean parts = detection.parts(pair, tau);
        moved(deflected.values[0], tau, parts ? pair : -1);
        if (deflected.size > 1) {
            moved(deflected.values[1], tau, pair);
        }
        return true;
    }

    /** Tells motion, and what bears bodies, of those that an impact has deflected. */
    private void tellDeflected(IntList deflected) {
        boolean someRest = !response.resting().isEmpty();
        boolean someLie = !response.heaps().isEmpty();
        for (int k = 0; k < deflected.size; k++) {
            if (!trajectories.areStraight()) { // else nothing has ever been driven, or borne
                motion.deflect(deflected.values[k]);
            }
            if (someRest) {
                response.resting().struck(deflected.values[k]);
            }
            if (someLie) {
                response.heaps().struck(deflected.values[k]);
            }
        }
    }

    /** A body has a new path; a pair of it that need not be looked at, or −1. */
    private void moved(int body, double tau, int except) {
        detection.moved(body, tau, false, except);
        if (audit != null) {
            audit.noted(body, tau);
        }
    }

    /** Bodies that rest on one another press on each other: new forces where something has happened. */
    private void settle(double tau) {
        IntList settled = response.resting().settle(tau);
        for (int k = 0; k < settled.size; k++) {
            moved(settled.values[k], tau, -1);
        }
    }

    /** Bodies that lie on one another push each other: new velocities where something has happened. */
    private void settleHeaps(double tau) {
        IntList settled = response.heaps().settle(tau);
        work.spend(response.heaps().takeCost());
        for (int k = 0; k < settled.size; k++) {
            if (trajectories.isDriven(settled.values[k])) {
                paths.note(settled.values[k]);
            } else if (detection.knows(settled.values[k])) { // or a listener has removed it
                moved(settled.values[k], tau, -1);
            }
        }
        response.heaps().told();
    }

    /** The path of a body has ended before the step: it has come to rest, or goes on from there. */
    private void goOn(int body) {
        double tau = detection.pathEnd();
        setInstant(tau);
        if (response.resting().rests(body)) {
            response.resting().again(body);
            settle(tau);
            return;
        }
        if (response.heaps().has(body)) {
            response.heaps().again(body, tau);
            settleHeaps(tau);
            paths.followNoted();
            return;
        }
        if (!trajectories.isDriven(body)) {
            return; // it was of a heap when this was planned, and is on its parabola again
        }
        motion.bring(body, tau);
        if (motion.ground().hold(body)) {
            moved(body, tau, -1);
        } else {
            paths.follow(body);
        }
    }

    /** The step is over: the state vectors say where bodies are, or will when somebody asks for them. */
    void finish() {
        response.ledger().setNow(timeStep);
        if (!response.heaps().isEmpty()) {
            IntList completed = response.heaps().finish();
            for (int k = 0; audit != null && k < completed.size; k++) {
                audit.noted(completed.values[k], timeStep);
            }
        }
        look(timeStep);
        if (motion.driven().size == 0) {
            state.lag(trajectories);
        } else if (motion.driven().size < state.bodyCount()) {
            trajectories.publish(timeStep, state);
        }
        if (audit == null && isThrown(timeStep)) {
            throw new Squeezed();
        }
        motion.finish();
        if (audit != null) {
            audit.close();
        }
    }

    /** Whether bodies that nothing moves have thrown out what they squeeze, in a step that is over or broken off. */
    private boolean isThrown(double tau) {
        return steering.areSomeMoving() && start.isThrown(state, steering, this::isFree, tau / timeStep, timeStep);
    }

    private boolean isFree(int body) {
        return !trajectories.isDriven(body) && (constraints == null || !constraints.isTied(body));
    }

    /** Ends the step, whether it is over or not. */
    void end() {
        work.end();
        admission.isWithin = false;
        isAdmitting = false;
        state.setPresence(null, false);
    }

    /**
     * Code of authors has thrown, or the work is spent: all bodies stay where they are at that instant, and go on from there; or from where
     * the step began, if the motion of tied ones has failed or got lost, or what is squeezed has been thrown out.
     *
     * @param isFailed whether it has failed
     * @param isRelieved whether time stepping takes over, so that it is asked whether it got lost
     */
    void breakOff(boolean isFailed, boolean isRelieved) {
        response.heaps().breakOff(instant);
        if (isFailed) {
            motion.late().drop(); // or the same happened again
        }
        paths.makeLate();
        boolean goesBack = isFailed;
        for (int k = 0; k < state.size(); k++) {
            if (state.body(k) != null && isFollowed(k)) {
                trajectories.publish(k, instant, state);
                goesBack |= isRelieved && constraints != null && constraints.isTied(k) && start.hasLost(k, state, timeStep);
            }
        }
        goesBack |= isRelieved && isThrown(instant);
        instant = goesBack ? 0 : instant;
        for (int k = 0; k < state.size(); k++) {
            if (state.body(k) != null) {
                if (goesBack && isFollowed(k)) {
                    start.restore(k, state);
                }
                state.touch(k);
            }
        }
        state.placedAll();
    }

    /** Whether a body was here when the step began, and has not been written in it. */
    private boolean isFollowed(int body) {
        return detection.knows(body) && !state.isTouched(body);
    }
}
