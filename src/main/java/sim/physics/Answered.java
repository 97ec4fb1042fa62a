// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import java.io.Serializable;
import sim.physics.constraint.Constraints;
import sim.physics.internal.IntList;
import sim.physics.motion.Motion;
import sim.physics.motion.State;

/**
 * Of which island somebody has asked last what its constraints do. As long as nothing was written the answer for all of them is there: each
 * question would solve for the whole island.
 */
final class Answered implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Null if there is none, or its forces may be others at any time. */
    private transient IntList island;

    private transient double time;
    private transient long writes;
    private transient long version;

    /** Accelerations. */
    private transient double[] work;

    Answered() {
        // nothing yet
    }

    /** Whether what was found is so still. */
    boolean holds(IntList bodies, Constraints constraints, State state, double now) {
        return bodies == island && now == time && state.writes() == writes && constraints.version() == version;
    }

    /** Finds what the constraints of an island do. */
    void evaluate(IntList bodies, Constraints constraints, Motion motion, State state, double now) {
        island = null;
        tell(bodies, constraints, state);
        int length = state.x().length;
        work = work == null || work.length < length ? new double[length] : work; // of its island it is all written
        motion.lastAcceleration(bodies, now, work);
        if (constraints.isAutonomous(bodies) && motion.groups().areAutonomous(bodies)) {
            island = bodies;
            time = now;
            writes = state.writes();
            version = constraints.version();
        }
    }

    /** Tells the constraints of bodies that were written: they may have other masses. */
    private static void tell(IntList bodies, Constraints constraints, State state) {
        boolean isTold = false;
        for (int k = 0; k < bodies.size && !isTold; k++) {
            int body = bodies.values[k];
            isTold = state.isTouched(body) && !state.isOnlyPushed(body);
            if (isTold) {
                constraints.touched(state.body(body));
            }
        }
    }

    void forget() {
        island = null;
    }
}
