// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import sim.physics.internal.IntList;
import sim.physics.motion.Motion;
import sim.physics.motion.State;

/** What all but the heap does to bodies. */
final class HeapPull implements Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;
    private final Motion motion;
    private final double[] fall = new double[State.BLOCK];

    HeapPull(State state, Motion motion) {
        this.state = state;
        this.motion = motion;
    }

    /** The acceleration that a body has. */
    double of(int body) {
        if (state.body(body).isFixed()) {
            return 0;
        }
        motion.fall(body, fall, 0);
        return Math.sqrt(fall[0] * fall[0] + fall[1] * fall[1]);
    }

    /** The greatest acceleration of some bodies. */
    double most(IntList bodies) {
        double most = 0;
        for (int k = 0; k < bodies.size; k++) {
            most = Math.max(most, of(bodies.values[k]));
        }
        return most;
    }

    /** Whether a force acts on one of some bodies. */
    boolean isOnAny(IntList bodies) {
        boolean yes = false;
        for (int k = 0; k < bodies.size && !yes; k++) {
            motion.fall(bodies.values[k], fall, 0);
            yes = fall[0] != 0 || fall[1] != 0 || fall[2] != 0;
        }
        return yes;
    }

    /** Lets a body go on without acceleration. */
    void endFor(int body) {
        motion.fall(body, fall, 0);
        motion.support(body, -fall[0], -fall[1], -fall[2]);
    }
}
