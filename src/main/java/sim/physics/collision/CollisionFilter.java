// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.State;
import sim.physics.motion.Ties;

/** Which bodies collide: those whose categories allow it and that no author has excluded as a pair. */
public final class CollisionFilter implements Serializable {
    private static final long serialVersionUID = 2L;

    /** By body those with which its author has excluded it, in ascending order; null for none, and empty if nobody ever was. */
    private IntList[] excluded = {};


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
     * @return true unless a category, an exclusion or a joint forbids it, or neither can be moved
     */
    public boolean allows(Body a, Body b) {
        return (a.getCategory() & b.getCollidesWith()) != 0
                && (b.getCategory() & a.getCollidesWith()) != 0
                && (a.isDynamic() || b.isDynamic())
                && !isExcluded(a.index(), b.index())
                && (ties == null || !ties.areTied(a, b));
    }

    /** Whether two bodies of a state do not collide. Where all bodies do, they are not looked at: they lie far off in memory. */
    boolean forbids(State state, int a, int b) {
        boolean isOpen = ties == null && excluded.length == 0 && !state.isGrouped();
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
        set(a.index(), b.index(), !collide);
        set(b.index(), a.index(), !collide);
    }

    private void set(int body, int other, boolean exclude) {
        if (exclude && excluded.length <= body) {
            excluded = Arrays.copyOf(excluded, Growth.length(excluded.length, body + 1));
        }
        if (isExcluded(body, other) == exclude) {
            return;
        }
        if (exclude) {
            excluded[body] = excluded[body] == null ? new IntList() : excluded[body];
            excluded[body].insert(other);
            return;
        }
        excluded[body].takeOut(other);
        if (excluded[body].size == 0) {
            excluded[body] = null;
        }
    }

    /**
     * Forgets a body that is about to be removed.
     *
     * @param body one that is in its engine still
     */
    public void forget(Body body) {
        int index = body.index();
        IntList others = index < excluded.length ? excluded[index] : null;
        for (int k = 0; others != null && k < others.size; k++) {
            set(others.values[k], index, false);
        }
        if (others != null) {
            excluded[index] = null;
        }
    }

    private boolean isExcluded(int body, int other) {
        IntList others = body < excluded.length ? excluded[body] : null;
        return others != null && Arrays.binarySearch(others.values, 0, others.size, other) >= 0;
    }
}
