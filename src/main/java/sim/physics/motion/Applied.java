// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import sim.physics.internal.IntList;

/** The bodies to which the author has applied forces for a step. Those that have left since are passed over. */
final class Applied implements Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;
    private final IntList bodies = new IntList();

    Applied(State state) {
        this.state = state;
    }

    boolean isAny() {
        return bodies.size > 0;
    }

    /** Takes a body in, if forces are applied to it. */
    void admit(int body) {
        if (state.body(body).isPushed()) {
            bodies.add(body);
        }
    }

    /** Takes the forces off the bodies. */
    void clear() {
        for (int k = 0; k < bodies.size; k++) {
            Body view = state.body(bodies.values[k]);
            if (view != null) {
                view.clearApplied();
            }
        }
    }

    /** Finds accelerations under the forces of the last step, but for bodies to which others have been applied since. */
    void again(Motion motion, IntList group, double t, double[] a) {
        recall(true);
        try {
            motion.acceleration(group, t, a);
        } finally {
            recall(false);
        }
    }

    private void recall(boolean yes) {
        for (int k = 0; k < bodies.size; k++) {
            Body view = state.body(bodies.values[k]);
            if (view != null) {
                view.recallApplied(yes);
            }
        }
    }

    /**
     * Begins a step without any: bodies that are not driven move as they do without.
     *
     * @param motion theirs
     * @param trajectories where they are
     * @param changed takes the bodies whose course changes, but for those that are about to be admitted
     */
    void end(Motion motion, Trajectories trajectories, IntList changed) {
        for (int k = 0; k < bodies.size; k++) {
            int body = bodies.values[k];
            if (state.body(body) != null && !trajectories.isDriven(body)) {
                trajectories.bring(body, 0);
                motion.course(body);
                if (!state.isTouched(body)) {
                    changed.add(body);
                }
            }
        }
        forget();
    }

    void forget() {
        bodies.clear();
    }
}
