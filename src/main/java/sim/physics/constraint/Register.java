// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import sim.physics.internal.Growth;
import sim.physics.motion.Body;

/** The constraints of an engine, those that changes have come to since islands were formed, and by bodies which are theirs. */
final class Register implements Serializable {
    private static final long serialVersionUID = 1L;

    /** The islands that were kept when something was tried. */
    transient Formation formation;

    /** In the order of adding, each with a number that grows. */
    private final Map<Constraint, Long> numbers = new LinkedHashMap<>();

    private long added;

    final LinkedHashSet<Constraint> changed = new LinkedHashSet<>();

    /** Whether islands have been dissolved since islands were formed. */
    boolean isSomeDissolved;

    /** Only while islands are formed: sets of bodies. */
    private transient int[] sets;

    /** By fixed body, and by movable body, its constraints; null until somebody asks: who never removes a body needs no more. */
    private transient Map<Body, LinkedHashSet<Constraint>> ofFixed;

    private transient Map<Body, LinkedHashSet<Constraint>> ofMovable;

    void add(Constraint constraint) {
        numbers.put(constraint, added++);
        changed.add(constraint);
        list(ofFixed, true, constraint);
        list(ofMovable, false, constraint);
    }

    /** All constraints, in the order of adding. */
    Set<Constraint> all() {
        return numbers.keySet();
    }

    /** Some constraints in the order of adding, whenever they come to be told. */
    List<Constraint> inOrder(Collection<Constraint> some) {
        List<Constraint> those = new ArrayList<>(some);
        those.sort(Comparator.comparing(numbers::get));
        return those;
    }

    boolean remove(Constraint constraint) {
        if (numbers.remove(constraint) == null) {
            return false;
        }
        changed.add(constraint);
        unlist(constraint.getBodyA(), constraint);
        unlist(constraint.getBodyB(), constraint);
        return true;
    }

    /** Room for sets of bodies, by index. */
    int[] sets(int bodies) {
        if (sets == null || sets.length < bodies) {
            sets = new int[Growth.length(sets == null ? 0 : sets.length, bodies)];
        }
        return sets;
    }

    /** The constraints of a body, as a copy in the order of adding. */
    List<Constraint> of(Body body) {
        if (numbers.isEmpty()) {
            return List.of();
        }
        if (map(body) == null) {
            index(body.isFixed());
        }
        Collection<Constraint> those = map(body).get(body);
        return those == null ? List.of() : new ArrayList<>(those);
    }

    private Map<Body, LinkedHashSet<Constraint>> map(Body body) {
        return body.isFixed() ? ofFixed : ofMovable;
    }

    private void index(boolean fixed) {
        Map<Body, LinkedHashSet<Constraint>> map = new IdentityHashMap<>();
        for (Constraint constraint : all()) {
            list(map, fixed, constraint);
        }
        ofFixed = fixed ? map : ofFixed;
        ofMovable = fixed ? ofMovable : map;
    }

    private static void list(Map<Body, LinkedHashSet<Constraint>> map, boolean fixed, Constraint constraint) {
        list(map, fixed, constraint.getBodyA(), constraint);
        list(map, fixed, constraint.getBodyB(), constraint);
    }

    private static void list(
            Map<Body, LinkedHashSet<Constraint>> map, boolean fixed, Body body, Constraint constraint) {
        if (map != null && body != null && body.isFixed() == fixed) {
            map.computeIfAbsent(body, b -> new LinkedHashSet<>(4)).add(constraint);
        }
    }

    private void unlist(Body body, Constraint constraint) {
        Map<Body, LinkedHashSet<Constraint>> map = body == null ? null : map(body);
        LinkedHashSet<Constraint> those = map == null ? null : map.get(body);
        if (those != null && those.remove(constraint) && those.isEmpty()) {
            map.remove(body);
        }
    }
}
