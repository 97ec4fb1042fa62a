// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import sim.physics.motion.Body;
import sim.physics.motion.State;
import sim.physics.motion.Ties;

/** Which bodies collide: those whose categories allow it and that no author has excluded as a pair. */
public final class CollisionFilter implements Serializable {
    private static final long serialVersionUID = 1L;

    private final List<Body> excludedA = new ArrayList<>();
    private final List<Body> excludedB = new ArrayList<>();

    /** Null while nothing ties bodies together. */
    private Ties ties;

    /** Makes a filter that lets all bodies collide. */
    public CollisionFilter() {
        // nothing is excluded
    }

    /**
     * Whether two bodies collide.
     *
     * @param a a body
     * @param b another body
     * @return true unless a category, an exclusion or a joint forbids it
     */
    public boolean allows(Body a, Body b) {
        return (a.getCategory() & b.getCollidesWith()) != 0
                && (b.getCategory() & a.getCollidesWith()) != 0
                && find(a, b) < 0
                && (ties == null || !ties.areTied(a, b));
    }

    /** Whether two bodies of a state do not collide. Where all bodies do, they are not looked at: they lie far off in memory. */
    boolean forbids(State state, int a, int b) {
        boolean isOpen = ties == null && excludedA.isEmpty() && !state.isGrouped();
        return !isOpen && !allows(state.body(a), state.body(b));
    }

    /**
     * Sets what ties bodies together: those may overlap.
     *
     * @param ties null for nothing
     */
    public void setTies(Ties ties) {
        this.ties = ties;
    }

    /**
     * Lets two bodies collide or pass through one another.
     *
     * @param a a body
     * @param b another body
     * @param collide false to exclude the pair
     */
    public void set(Body a, Body b, boolean collide) {
        int k = find(a, b);
        if (collide && k >= 0) {
            excludedA.remove(k);
            excludedB.remove(k);
        } else if (!collide && k < 0) {
            excludedA.add(a);
            excludedB.add(b);
        }
    }

    /**
     * Forgets a body that has been removed.
     *
     * @param body any
     */
    public void forget(Body body) {
        for (int k = excludedA.size() - 1; k >= 0; k--) {
            if (excludedA.get(k) == body || excludedB.get(k) == body) {
                excludedA.remove(k);
                excludedB.remove(k);
            }
        }
    }

    private int find(Body a, Body b) {
        for (int k = 0; k < excludedA.size(); k++) {
            boolean same = excludedA.get(k) == a && excludedB.get(k) == b;
            if (same || excludedA.get(k) == b && excludedB.get(k) == a) {
                return k;
            }
        }
        return -1;
    }
}
