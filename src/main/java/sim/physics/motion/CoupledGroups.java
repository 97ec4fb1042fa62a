// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.List;
import sim.physics.internal.DisjointSets;
import sim.physics.internal.IntList;

/**
 * Which driven bodies move together since forces couple them: the connected components of forces that couple bodies and of the
 * islands of ties (union–find, Tarjan 1975). Bodies that ties alone hold together are left to these, and so is an island of
 * which forces couple nothing but its own bodies.
 */
public final class CoupledGroups implements Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;
    private final Generators generators;
    private final IntList changed = new IntList();

    /** The group of each body, null if none; and whether ties have part in it. */
    private IntList[] of = {};

    private boolean[] isTied = {};

    /** What is to replace them; null if nothing is. */
    private transient IntList[] next;

    private boolean[] isTiedNext;

    /** The islands that the groups were made of. */
    private long grouping = -1;

    /** Only while groups are made. */
    private transient int[] parent;

    CoupledGroups(State state, Generators generators) {
        this.state = state;
        this.generators = generators;
    }

    /** {@return whether some force couples bodies, be they tied to one another or not, or has until the last change} */
    public boolean mayCouple() {
        return generators.coupled || generators.isCouplingNew;
    }

    /**
     * Whether forces couple a body to others that ties do not.
     *
     * @param body index
     * @return false if it moves alone, or with those that it is tied to
     */
    public boolean isCoupled(int body) {
        return of(body) != null;
    }

    /** The bodies that move together with a body, itself included, in ascending order; null if no force couples it to others. */
    IntList of(int body) {
        return body < of.length ? of[body] : null;
    }

    /** Whether ties have part in the group of a body that has one. */
    boolean isTied(int body) {
        return isTied[body];
    }

    /**
     * Takes note that a body has been written, or that a generator was added that may act on it, or removed.
     *
     * @param body of the state
     */
    public void review(Body body) {
        generators.review(body);
    }

    /**
     * A body is about to be removed; it moves with nobody any more from the next groups on.
     *
     * @param body index
     */
    public void leave(int body) {
        generators.leave(body);
        generators.isCouplingNew |= of(body) != null;
    }

    /**
     * The only bodies that a generator acts on.
     *
     * @param generator one that was added
     * @return those that it named then; null if it is asked about all
     */
    public List<Body> bodies(ForceGenerator generator) {
        return generators.bodies(generator);
    }

    /**
     * Whether the forces on bodies depend on nothing but their state.
     *
     * @param bodies indices
     * @return true also where none act
     */
    public boolean areAutonomous(IntList bodies) {
        return generators.areAutonomous(state, bodies);
    }

    /** Asks the generators again what may change, at the start of a step. */
    public void begin() {
        generators.askAgain();
    }

    /**
     * Makes the groups anew where that is needed, after all bodies that changes concern have been reviewed. They hold from
     * {@link #commit()} on.
     *
     * @param ties may be null
     * @return the bodies whose groups change; valid until the next call
     */
    public IntList renew(Ties ties) {
        generators.settle();
        changed.clear();
        long now = ties == null ? -1 : ties.grouping();
        if (!generators.isCouplingNew && (now == grouping || !generators.coupled)) {
            return changed;
        }
        generators.isCouplingNew = false;
        grouping = now;
        next = new IntList[generators.coupled ? state.size() : 0];
        isTiedNext = new boolean[next.length];
        if (generators.coupled) {
            form(ties);
        }
        for (int k = 0; k < Math.max(of.length, next.length); k++) {
            if (of(k) != (k < next.length ? next[k] : null) && state.size() > k && state.body(k) != null) {
                changed.add(k);
            }
        }
        return changed;
    }

    /** Lets the groups that were made last hold from now on. */
    public void commit() {
        if (next != null) {
            of = next;
            isTied = isTiedNext;
            next = null;
            isTiedNext = null;
        }
    }

    private void form(Ties ties) {
        int n = state.size();
        parent = new int[n];
        for (int k = 0; k < n; k++) {
            parent[k] = moves(k, ties) ? k : -1;
        }
        for (int k = 0; ties != null && k < n; k++) {
            if (parent[k] >= 0 && ties.isTied(k)) {
                DisjointSets.join(parent, k, ties.island(k).values[0]);
            }
        }
        boolean[] isOpen = new boolean[n];
        couple(isOpen);
        IntList[] lists = new IntList[n];
        for (int k = 0; k < n; k++) {
            if (parent[k] >= 0) {
                int root = DisjointSets.find(parent, k);
                lists[root] = lists[root] == null ? new IntList() : lists[root];
                lists[root].add(k);
                isOpen[root] |= isOpen[k];
                isTiedNext[root] |= ties != null && ties.isTied(k);
            }
        }
        for (int root = 0; root < n; root++) {
            if (lists[root] != null && isGroup(lists[root], ties, isOpen[root])) {
                assign(same(lists[root]), isTiedNext[root]);
            }
        }
        parent = null;
    }

    /** Whether something moves a body that could be coupled. */
    private boolean moves(int body, Ties ties) {
        Body view = state.body(body);
        return view != null && !view.isImmobile() && (generators.drive(view) || ties != null && ties.isTied(body));
    }

    /** Joins what forces couple, and marks one body of each of those whose generators do not say which bodies they couple. */
    private void couple(boolean[] isOpen) {
        List<Generators.Entry> driving = generators.driving();
        for (int k = 0; k < driving.size(); k++) {
            Generators.Entry entry = driving.get(k);
            entry.first = -1;
            for (int m = 0; entry.isCoupled && entry.couples != null && m < entry.couples.size(); m++) {
                Body body = entry.couples.get(m);
                if (body != null && body.state() == state && parent[body.index()] >= 0) {
                    couple(entry, body.index());
                }
            }
        }
        for (int k = 0; k < parent.length; k++) {
            if (parent[k] < 0) {
                continue;
            }
            for (Generators.Entry entry : generators.acting(state.body(k))) {
                if (entry.isCoupled && entry.couples == null) {
                    couple(entry, k);
                    isOpen[k] = true;
                }
            }
        }
    }

    private void couple(Generators.Entry entry, int body) {
        if (entry.first < 0) {
            entry.first = body;
        } else {
            DisjointSets.join(parent, entry.first, body);
        }
    }

    /** Whether a component is more than a body that moves alone, or an island. */
    private static boolean isGroup(IntList component, Ties ties, boolean isOpen) {
        int first = component.values[0];
        if (ties == null || !ties.isTied(first)) {
            return component.size > 1;
        }
        return isOpen || ties.island(first).size < component.size;
    }

    /** The group as it is so far, if nothing has changed. */
    private IntList same(IntList component) {
        IntList old = of(component.values[0]);
        boolean isSame = old != null && old.size == component.size;
        for (int k = 0; isSame && k < component.size; k++) {
            isSame = old.values[k] == component.values[k];
        }
        return isSame ? old : component;
    }

    private void assign(IntList group, boolean tied) {
        for (int k = 0; k < group.size; k++) {
            next[group.values[k]] = group;
            isTiedNext[group.values[k]] = tied;
        }
    }

    /**
     * The bodies at the ends of a body's springs.
     *
     * @param body in this engine still
     * @param leaves whether the springs go with it
     * @return also the body
     */
    public List<Body> springEnds(Body body, boolean leaves) {
        return generators.springEnds(body, leaves);
    }
}
