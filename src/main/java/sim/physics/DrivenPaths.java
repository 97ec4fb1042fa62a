// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import java.io.Serializable;
import sim.physics.collision.CollisionDetection;
import sim.physics.internal.IntList;
import sim.physics.internal.Team;
import sim.physics.internal.Work;
import sim.physics.motion.AdaptiveIntegrator;
import sim.physics.motion.Motion;
import sim.physics.motion.SharedMotion;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;
import sim.physics.response.lasting.Heaps;

/**
 * Gives driven bodies their paths, and tells detection of them: of all when a step begins, and of those whom an event has
 * concerned when it is over. A group of bodies that move together gets its paths at once.
 */
final class DrivenPaths implements Serializable {
    private static final long serialVersionUID = 1L;

    private final Trajectories trajectories;
    private final Motion motion;
    private final SharedMotion sharedMotion;
    private final CollisionDetection detection;
    private final Heaps heaps;
    private final Work work;
    private final Admission admission;

    /** Groups of driven bodies that are to follow new paths; and which those are. */
    private final IntList groups = new IntList();

    private final IslandRounds noted = new IslandRounds();

    /** Driven bodies whose new paths detection has not been told of. */
    private final IntList entering = new IntList();

    /** Those of them that do not stand still, where some may. */
    private final IntList moving = new IntList();

    /** Null unless the engine is audited. */
    private Audit audit;

    /** Null while the stepping thread does all the work. */
    private Team team;

    /** How detection is told of new paths: of a body and its pairs, of a body, or later of all bodies. */
    private enum Entry {
        BODY_AND_PAIRS,
        BODY,
        TOGETHER
    }

    DrivenPaths(
            State state,
            Trajectories trajectories,
            Motion motion,
            CollisionDetection detection,
            Heaps heaps,
            Admission admission,
            Work work) {
        this.trajectories = trajectories;
        this.motion = motion;
        this.detection = detection;
        this.heaps = heaps;
        this.admission = admission;
        this.work = work;
        sharedMotion = new SharedMotion(motion, state, trajectories);
    }

    void setAudit(Audit those) {
        audit = those;
    }

    void setTeam(Team those) {
        team = those;
        sharedMotion.setTeam(those);
    }

    /** Gives all driven bodies new paths from the start of the step on, but for those that stand still as they did. */
    void followAll() {
        work.apart(isFixed());
        IntList driven = motion.driven();
        boolean isShared = sharedMotion.advance();
        boolean mayStay = !heaps.isEmpty(); // and nobody is late
        entering.clear();
        moving.clear();
        try {
            for (int k = 0; k < driven.size; k++) {
                int body = driven.values[k];
                int passed = motion.late().has(body) ? motion.late().advance(body) : 0;
                if (passed > 0) {
                    k += passed - 1;
                    continue;
                }
                if (motion.companions(body).values[0] != body) {
                    continue;
                }
                if (mayStay && stays(motion.companions(body))) {
                    detection.setPathEnd(motion.companions(body), trajectories.h());
                } else if (isShared && sharedMotion.isDone(body)) {
                    work.beginGroup();
                    publish(body, motion.advance(body, detection), Entry.TOGETHER);
                    detection.endPath(body);
                    work.endGroup(motion.companions(body).size);
                } else {
                    enter(); // it may depend on where the others before it go
                    follow(body, Entry.BODY);
                }
                k += Math.max(1, driven.common(k, motion.companions(body))) - 1; // the others of its group are mostly next
            }
        } catch (Work.Spent e) {
            work.endWithGroup();
            throw e;
        } finally {
            enter(); // also if a group cannot go on
        }
        detection.lookAtGathered(mayStay && moving.size < driven.size ? moving : driven);
        work.apart(false);
    }

    /** Whether the method's steps are of fixed length: those that the step begins with may be shared by threads. */
    private boolean isFixed() {
        return !(motion.getIntegrator() instanceof AdaptiveIntegrator);
    }

    /** Whether bodies that move together stand still and have paths that say so; takes note of those that do not. */
    private boolean stays(IntList group) {
        if (motion.areStaying(group)) {
            return true;
        }
        for (int k = 0; k < group.size; k++) {
            moving.add(group.values[k]);
        }
        return false;
    }

    private void enter() {
        if (entering.size > 0) {
            detection.enter(entering);
            entering.clear();
        }
    }

    /** Gives a driven body, and those that move with it, new paths from their anchors on. */
    void follow(int body) {
        follow(body, Entry.BODY_AND_PAIRS);
    }

    private void follow(int body, Entry entry) {
        work.beginGroup();
        publish(body, motion.advance(body, detection), entry);
        if (motion.isCoarse() && detection.hasNeighbours(motion.companions(body))) {
            publish(body, motion.advance(body, null), entry); // on its way it comes near others
        }
        detection.endPath(body);
        work.endGroup(motion.companions(body).size);
    }

    /** Tells of the new paths of a driven body, and of those that move with it. */
    private void publish(int body, double end, Entry entry) {
        double until = Math.min(end, heaps.until(body));
        IntList group = motion.companions(body);
        double tau = trajectories.offset(body);
        detection.setPathEnd(group, until);
        if (entry == Entry.BODY) {
            detection.enter(group, tau);
        }
        for (int k = 0; entry != Entry.BODY && k < group.size; k++) {
            if (entry == Entry.TOGETHER) {
                entering.add(group.values[k]);
            } else {
                detection.moved(group.values[k], tau, false, -1);
            }
        }
        for (int k = 0; audit != null && k < group.size; k++) {
            audit.noted(group.values[k], tau);
        }
    }

    /** Takes note that a driven body, and those that move with it, are to follow new paths. */
    void note(int body) {
        IntList group = motion.companions(body);
        if (noted.isFirst(group)) {
            groups.add(group.values[0]);
        }
    }

    /** Lets the groups that were noted follow new paths. */
    void followNoted() {
        for (int k = 0; k < groups.size; k++) {
            if (trajectories.isDriven(groups.values[k])) { // or a listener has removed it
                follow(groups.values[k]);
                work.spend(motion.companions(groups.values[k]).size, detection.narrowPhase().evaluations());
            }
        }
        forgetNoted();
    }

    void forgetNoted() {
        groups.clear();
        noted.begin();
    }

    /** Something happens in the step, or the paths are asked for: groups that have been moved without paths get them now. */
    void makeLate() {
        if (motion.late().isEmpty()) {
            return;
        }
        admission.forgetAnswers();
        work.apart(isFixed());
        work.beginGroup();
        IntList made = motion.late().make(team);
        work.apart(false);
        for (int k = 0; k < made.size; k++) {
            publish(made.values[k], trajectories.h(), Entry.BODY);
            detection.endPath(made.values[k]);
        }
    }
}
