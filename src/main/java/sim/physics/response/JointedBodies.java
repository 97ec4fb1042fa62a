// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import sim.physics.internal.IntList;
import sim.physics.internal.Tolerances;
import sim.physics.motion.Motion;
import sim.physics.motion.State;
import sim.physics.motion.Ties;
import sim.physics.motion.Trajectories;

/** Prepares the islands of colliding bodies for their impulses, (47)–(54), and cleans up after them. */
final class JointedBodies implements Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;
    private final Trajectories trajectories;
    private final Motion motion;
    private final Ties ties;

    JointedBodies(State state, Trajectories trajectories, Motion motion, Ties ties) {
        this.state = state;
        this.trajectories = trajectories;
        this.motion = motion;
        this.ties = ties;
    }

    /**
     * Whether two bodies, both of them tied, are so deep in one another that no impact or heap would have left them so: they were
     * put there. Impulses at their points, which would drive each other, do not part what ties hold there.
     */
    boolean areInOneAnother(int a, int b, double gap, double size) {
        return gap < -Tolerances.PUT * size && ties.isTied(a) && ties.isTied(b);
    }

    boolean has(int a, int b) {
        return ties.isTied(a) || ties.isTied(b);
    }

    /** Puts the islands of two bodies, which were brought to the impact, to where their impulses can be found. */
    void prepare(int a, int b) {
        if (ties.isTied(a)) {
            prepare(ties.island(a));
        }
        if (ties.isTied(b) && !(ties.isTied(a) && ties.island(a) == ties.island(b))) {
            prepare(ties.island(b));
        }
    }

    private void prepare(IntList island) {
        motion.restore(island);
        ties.prepareImpact(island);
    }

    /** Takes away what rounding has left of velocities that the ties do not allow. */
    void settle(IntList changed) {
        for (int k = 0; k < changed.size; k++) {
            int body = changed.values[k];
            if (ties.isTied(body) && ties.island(body).values[0] == body) {
                IntList island = ties.island(body);
                motion.restore(island);
                ties.settle(island);
                for (int m = 0; m < island.size; m++) {
                    trajectories.anchor(island.values[m], trajectories.offset(body), state);
                }
            }
        }
    }
}
