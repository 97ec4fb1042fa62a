// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import sim.physics.internal.IntList;
import sim.physics.internal.Team;

/**
 * Integrates groups of driven bodies over a step in several threads, before {@link Motion#advance} makes use of that, group by
 * group. A group's motion depends on the group alone, so nothing is different from one after the other. What would be
 * different if bodies were near is left to the group's turn, and so is what an integration throws.
 *
 * <p>Each thread has a motion of its own, for the workspace that a method uses from call to call; the arrays, of which each
 * group has its own part, are the same. They have room for all bodies before the work begins.
 */
public final class SharedMotion implements Team.Work, Serializable {
    private static final long serialVersionUID = 1L;

    /** Bodies from which on it pays. */
    private static final int FEWEST_SHARED = 512;

    private final Motion motion;
    private final State state;
    private final Trajectories trajectories;

    /** Null for the calling thread alone. */
    private Team team;

    private transient Motion[] helpers;

    /** The first bodies of the groups. */
    private transient int[] firsts;

    private transient Ahead ahead;

    /** Whether some group goes from state to state in this step. */
    private transient boolean isAnyLate;

    /**
     * Makes the shared part of a motion.
     *
     * @param motion moves the bodies
     * @param state the state vectors
     * @param trajectories takes their paths
     */
    public SharedMotion(Motion motion, State state, Trajectories trajectories) {
        this.motion = motion;
        this.state = state;
        this.trajectories = trajectories;
    }

    /**
     * Sets which threads share the work of integrating many bodies.
     *
     * @param team null for the calling thread alone
     */
    public void setTeam(Team team) {
        this.team = team;
        helpers = null;
    }

    /**
     * Integrates those groups of driven bodies that may be shared over the step that begins, if it pays.
     *
     * @return false if nothing was done
     */
    public boolean advance() {
        IntList driven = motion.driven();
        if (team == null || !team.pays(driven.size, FEWEST_SHARED) || !mayBeShared()) {
            return false;
        }
        wake(driven.size);
        int count = 0;
        isAnyLate = !motion.late().isEmpty();
        for (int k = 0; k < driven.size; k++) {
            int body = driven.values[k];
            int known = isAnyLate ? motion.late().shares(body) : 0;
            IntList group = known > 0 ? null : motion.companions(body);
            if (known > 0 || group.values[0] == body && mayBeShared(group)) {
                firsts[count++] = body;
            }
            k += Math.max(1, known > 0 ? known : driven.common(k, group)) - 1; // the others of a group are mostly next
        }
        if (count < 2) {
            return false;
        }
        makeRoom();
        int failed = team.run(this, count);
        if (failed >= 0) {
            ahead.fail(firsts[failed], team.failure());
        }
        for (int k = failed + 1; failed >= 0 && k < count; k++) { // as if nobody had come to these
            IntList group = motion.companions(firsts[k]);
            ahead.forget(firsts[k]);
            if (!motion.late().takeBack(group)) {
                motion.drivenMotion.undo(group);
            }
        }
        motion.drivenMotion.setAhead(ahead);
        return true;
    }

    /**
     * Whether {@link Motion#advance} will only make use of what threads have done with a group, be bodies near or not.
     *
     * @param body index of the group's first body
     * @return false if it may integrate the group itself
     */
    public boolean isDone(int body) {
        return motion.drivenMotion.isDone(body);
    }

    /** Whether nothing that an author wrote is called by an integration, or it may be by any thread. */
    private boolean mayBeShared() {
        Integrator integrator = motion.getIntegrator();
        return motion.generators.concurrent
                && integrator.isConcurrent()
                && !integrator.isAdaptive()
                && !motion.drivenMotion.isObserved();
    }

    private boolean mayBeShared(IntList group) {
        int first = group.values[0];
        boolean isAtStart = isAnyLate && motion.late().has(first) || trajectories.offset(first) == 0;
        return isAtStart
                && !motion.drivenMotion.probed.doesCount(group) // that has been its step
                && (motion.isTiedGroup(group)
                        ? motion.ties.mayBeShared(group)
                        : motion.drivenMotion.hasOneBeginning(first));
    }

    /** No array grows any more when this is done. */
    private void makeRoom() {
        ahead.begin(state.size());
        state.f();
        trajectories.unfold();
        if (motion.getIntegrator() instanceof Rattle || motion.getIntegrator() instanceof SymplecticEuler) {
            state.ensureCarry().ensure(state.x().length);
        }
        for (int k = 1; k < helpers.length; k++) {
            helpers[k].time = motion.time;
            helpers[k].work.match(motion.work);
            helpers[k].setIntegrator(motion.getIntegrator());
            if (helpers[k].ties == null && motion.ties != null) {
                helpers[k].setTies(motion.ties.helper());
            }
            helpers[k].drivenMotion.match(motion.drivenMotion, helpers[k].ties, motion.ties);
        }
    }

    private void wake(int bodies) {
        if (helpers == null) {
            helpers = new Motion[team.size()];
            helpers[0] = motion;
            for (int k = 1; k < helpers.length; k++) {
                helpers[k] = new Motion(motion);
            }
            firsts = new int[bodies];
            ahead = new Ahead();
        }
        if (firsts.length < bodies) {
            firsts = new int[Math.max(bodies, 2 * firsts.length)];
        }
    }

    @Override
    public void work(int worker, int item) {
        Motion helper = helpers[worker];
        IntList group = helper.companions(firsts[item]);
        boolean isLate = isAnyLate && motion.late().has(firsts[item]);
        if (!isLate || !motion.late().advanceAhead(group, helper)) {
            helper.work.beginGroup();
            helper.drivenMotion.advanceAhead(group, isLate, ahead);
            ahead.charge(firsts[item], helper.work.spentApart());
        }
    }
}
