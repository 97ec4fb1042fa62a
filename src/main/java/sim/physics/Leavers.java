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
import sim.physics.motion.State;

/** Bodies that are to leave when the collision that is being handled is over, each once, in the order in which that was said. */
final class Leavers implements Serializable {
    private static final long serialVersionUID = 2L;

    private final List<Body> inOrder = new ArrayList<>();

    /** The same, to be asked; null while it is not known. */
    private transient Set<Body> known;

    /** Those of them that have been added again since: they come back then. */
    private final List<Body> back = new ArrayList<>();

    /** A body leaves, and does not come back. */
    void add(Body body) {
        back.removeIf(one -> one == body);
        known();
        if (known.add(body)) {
            inOrder.add(body);
        }
    }

    private void known() {
        if (known == null) {
            known = Collections.newSetFromMap(new IdentityHashMap<>());
            known.addAll(inOrder);
        }
    }

    /** Whether a body leaves, be it to come back or not. */
    boolean has(Body body) {
        if (!inOrder.isEmpty()) {
            known();
        }
        return !inOrder.isEmpty() && known.contains(body);
    }

    /** Takes note that a body that leaves comes back. */
    void takeBack(Body body) {
        back.add(body);
    }

    /** Whether a body that leaves comes back. */
    boolean comesBack(Body body) {
        for (int k = 0; k < back.size(); k++) {
            if (back.get(k) == body) {
                return true;
            }
        }
        return false;
    }

    /** All have left: those that come back do so now, and begin anew; returns whether there are any. */
    boolean end(State state) {
        List<Body> coming = back.isEmpty() ? List.of() : new ArrayList<>(back);
        clear();
        for (int k = 0; k < coming.size(); k++) {
            if (coming.get(k).state().isOwn()) {
                state.add(coming.get(k));
            }
        }
        return !coming.isEmpty();
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
        back.clear();
        known = null;
    }
}
