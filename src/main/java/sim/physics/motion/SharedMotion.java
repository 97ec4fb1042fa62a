// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import sim.physics.internal.IntList;
import sim.physics.internal.Team;

/**
 * Integrates groups of bodies over a step in several threads. A group's motion depends on the group alone, so nothing is
 * different from one after the other; the paths are published in the order of the groups, by one thread.
 */
final class SharedMotion implements Team.Work, Serializable {
    private static final long serialVersionUID = 1L;

    /** Bodies from which on it pays. */
    private static final int FEWEST_SHARED = 512;

    private final Motion motion;
    private final Team team;
    private transient Motion[] twins;

    /** The first bodies of the groups. */
    private transient int[] firsts;

    SharedMotion(Motion motion, Team team) {
        this.motion = motion;
        this.team = team;
    }

    /** Integrates the groups that may be shared; false if that does not pay. */
    boolean advance(IntList driven) {
        if (!team.pays(driven.size, FEWEST_SHARED) || motion.getIntegrator().isAdaptive()) {
            return false;
        }
        wake(driven.size);
        int count = 0;
        for (int k = 0; k < driven.size; k++) {
            int body = driven.values[k];
            IntList group = motion.companions(body);
            if (group.values[0] == body && motion.mayBeShared(group)) {
                firsts[count++] = body;
            }
        }
        if (count < 2) {
            return false;
        }
        motion.drivenMotion.expectShared();
        for (int k = 1; k < twins.length; k++) {
            twins[k].match(motion);
        }
        int failed = team.run(this, count);
        if (failed >= 0) {
            motion.drivenMotion.setFailure(firsts[failed], team.failure());
        }
        for (int k = failed + 1; failed >= 0 && k < count; k++) { // as if nobody had come to these
            motion.drivenMotion.undoShared(motion.companions(firsts[k]));
        }
        return true;
    }

    private void wake(int bodies) {
        if (twins == null) {
            twins = new Motion[team.size()];
            twins[0] = motion;
            for (int k = 1; k < twins.length; k++) {
                twins[k] = new Motion(motion);
            }
            firsts = new int[bodies];
        }
        if (firsts.length < bodies) {
            firsts = new int[Math.max(bodies, 2 * firsts.length)];
        }
    }

    @Override
    public void work(int worker, int item) {
        Motion twin = twins[worker];
        int first = firsts[item];
        motion.drivenMotion.advanceShared(twin.companions(first), twin.drivenMotion);
    }
}
