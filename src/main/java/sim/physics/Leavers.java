// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import sim.physics.motion.Body;

/** Bodies that are to leave when the collision that is being handled is over, each once, in the order in which that was said. */
final class Leavers implements Serializable {
    private static final long serialVersionUID = 1L;

    private final List<Body> inOrder = new ArrayList<>();

    /** The same, to be asked; null while it is not known. */
    private transient Set<Body> known;

    void add(Body body) {
        if (known == null) {
            known = Collections.newSetFromMap(new IdentityHashMap<>());
            known.addAll(inOrder);
        }
        if (known.add(body)) {
            inOrder.add(body);
        }
    }

    boolean isEmpty() {
        return inOrder.isEmpty();
    }

    int size() {
        return inOrder.size();
    }

    Body get(int k) {
        return inOrder.get(k);
    }

    void clear() {
        inOrder.clear();
        known = null;
    }
}
