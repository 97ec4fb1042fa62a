// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.broad;

import java.io.Serializable;

/** Whether an engine uses a broad phase. */
final class Claim implements Serializable {
    private static final long serialVersionUID = 1L;

    private boolean isTaken;

    Claim() {
        // nobody's yet
    }

    void take(BroadPhase of) {
        if (isTaken) {
            throw new IllegalStateException("broadPhase is a " + of.getClass().getSimpleName()
                    + " that an engine uses or has used: it knows that one's bodies, make a new one");
        }
        isTaken = true;
    }
}
