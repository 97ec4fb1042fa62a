// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.IdentityHashMap;
import java.util.List;

/** What is known of how the trees of constraints are solved, while others are taken, and while their bodies sleep. */
final class KnownTrees implements Serializable {
    private static final long serialVersionUID = 1L;

    /** At once, or that with what touches the tree; else the number of steps for which it is solved in turns. */
    static final int AT_ONCE = -1;

    static final int PRESSED = -2;

    private IdentityHashMap<Constraint, Integer> all = new IdentityHashMap<>();

    void put(Constraint constraint, int how) {
        all.put(constraint, how);
    }

    /** What is known of a constraint; 0 if nothing is. */
    int of(Constraint constraint) {
        return all.getOrDefault(constraint, 0);
    }

    /** Forgets all but some constraints. */
    void keep(List<Constraint> some) {
        IdentityHashMap<Constraint, Integer> kept = new IdentityHashMap<>();
        for (Constraint one : some) {
            if (all.containsKey(one)) {
                kept.put(one, all.get(one));
            }
        }
        all = kept;
    }
}
