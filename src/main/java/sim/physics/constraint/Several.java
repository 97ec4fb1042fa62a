// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import sim.physics.internal.IntList;

/** The islands of a group of bodies which forces couple to one another; of the last one that was asked for. */
final class Several implements Serializable {
    private static final long serialVersionUID = 1L;

    private transient IntList bodies;
    private transient List<Island> islands;

    /**
     * The islands that some bodies are in, which have all bodies of each, in ascending order of their first bodies; valid until
     * others are asked for.
     */
    List<Island> of(IntList group, TiedGroup[] of) {
        if (bodies == group) {
            return islands;
        }
        islands = islands == null ? new ArrayList<>() : islands;
        islands.clear();
        for (int k = 0; k < group.size; k++) {
            int body = group.values[k];
            TiedGroup one = body < of.length ? of[body] : null;
            if (one != null && one.bodies.values[0] == body) {
                islands.add(one.island());
            }
        }
        bodies = group;
        return islands;
    }

    /** Islands have been formed anew. */
    void forget() {
        bodies = null;
    }
}
