// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;

/** What bears bodies at rest: contacts, which accelerate them, or static friction. */
final class Rest implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Accelerations that contacts at rest give to bodies, 3n. */
    double[] support = new double[24];

    /** Bodies at rest that static friction holds. */
    boolean[] held = new boolean[8];

    Rest() {
        // grows with the bodies
    }

    void ensure(int bodies) {
        if (support.length < State.BLOCK * bodies) {
            support = Arrays.copyOf(support, 2 * State.BLOCK * bodies);
            held = Arrays.copyOf(held, 2 * bodies);
        }
    }

    void support(int body, double ax, double ay, double alpha) {
        support[State.BLOCK * body] = ax;
        support[State.BLOCK * body + 1] = ay;
        support[State.BLOCK * body + 2] = alpha;
    }

    /** Ends a body's rest; false if it did not rest. */
    boolean release(int body) {
        int b = State.BLOCK * body;
        boolean rested = held[body] || support[b] != 0 || support[b + 1] != 0 || support[b + 2] != 0;
        support(body, 0, 0, 0);
        held[body] = false;
        return rested;
    }
}
