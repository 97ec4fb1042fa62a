// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import sim.physics.internal.DisjointSets;
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.State;

/**
 * Sorts constraints into islands: those that are connected through movable bodies; and says what is
 * true of some of them together.
 */
final class Grouping {
    /** Ratio of masses from which a coarse tolerance lets light bodies vibrate about a heavy one as far as it reaches. */
    private static final double UNLIKE = 1e7;

    private Grouping() {}

    /** Forms the groups anew that changes concern; returns the group of each body. */
    static TiedGroup[] renew(List<TiedGroup> groups, Register register, State state, TiedGroup[] of) {
        TiedGroup[] by = of.length < state.size() ? Arrays.copyOf(of, Math.max(2 * of.length, state.size())) : of;
        LinkedHashSet<Constraint> open = new LinkedHashSet<>();
        touchOpen(register, state); // before anything changes, as constraints of authors may throw
        for (Constraint c : register.changed) {
            open.addAll(dissolve(c.getBodyA(), register, state, by));
            open.addAll(dissolve(c.getBodyB(), register, state, by));
            open.add(c);
        }
        open.retainAll(register.all());
        register.changed.clear();
        if (register.isSomeDissolved) {
            groups.removeIf(group -> group.isDissolved);
            register.isSomeDissolved = false;
        }
        for (TiedGroup group : groups(register.inOrder(open), register.sets(state.size()))) {
            groups.add(group);
            group.forget(); // what acts is decided anew: a motor that acted in the island of before keeps another speed than its own here
            for (int k = 0; k < group.bodies.size; k++) {
                by[group.bodies.values[k]] = group;
            }
        }
        return by;
    }

    /** Notes the bodies of changed constraints that do not hold as they are. */
    private static void touchOpen(Register register, State state) {
        for (Constraint c : register.changed) {
            if (register.all().contains(c) && !isReshaped(c.getBodyA(), state) && !isReshaped(c.getBodyB(), state) && !Admissible.holds(c)) {
                touch(c.getBodyA(), state);
                touch(c.getBodyB(), state);
            }
        }
    }

    /** Whether a body has another shape, as one that grows has in each step: its constraints have other sizes then, and are as closed as they were. */
    private static boolean isReshaped(Body body, State state) {
        return body != null && state.touched().isReshaped(body.index());
    }

    /** A body has to be moved, or to move otherwise, for a constraint to hold. */
    private static void touch(Body body, State state) {
        if (body != null && !body.isImmobile()) {
            state.touch(body.index());
            state.touched().move(body.index());
        }
    }

    /**
     * Removes the constraints of a body that leaves, and dissolves the islands that they are in; returns the bodies of those and of
     * constraints that were in none yet.
     */
    static IntList cut(Body body, Register register, State state, TiedGroup[] of) {
        IntList concerned = new IntList();
        for (Constraint c : register.of(body)) {
            cut(c.getBodyA(), register, state, of, concerned);
            cut(c.getBodyB(), register, state, of, concerned);
            register.remove(c);
        }
        if (isMovable(body) && body.index() < of.length && of[body.index()] != null) {
            cut(body, register, state, of, concerned); // its last constraint has been removed just before
        }
        return concerned;
    }

    private static void cut(Body end, Register register, State state, TiedGroup[] of, IntList concerned) {
        if (!isMovable(end) || end.state() != state) {
            return;
        }
        concerned.add(end.index());
        IntList tied = end.index() < of.length && of[end.index()] != null ? of[end.index()].bodies : new IntList();
        for (int k = 0; k < tied.size; k++) {
            concerned.add(tied.values[k]);
        }
        register.changed.addAll(dissolve(end, register, state, of));
    }

    /** The groups, in the order of their first constraints; with room for sets of bodies. */
    static List<TiedGroup> groups(Collection<Constraint> constraints, int[] parent) {
        for (Constraint c : constraints) { // a few of very many bodies, it may be
            single(parent, c.getBodyA());
            single(parent, c.getBodyB());
        }
        for (Constraint c : constraints) {
            if (isMovable(c.getBodyA()) && isMovable(c.getBodyB())) {
                DisjointSets.join(parent, c.getBodyA().index(), c.getBodyB().index());
            }
        }
        Map<Integer, List<Constraint>> sets = new LinkedHashMap<>();
        for (Constraint c : constraints) {
            Body body = isMovable(c.getBodyA()) ? c.getBodyA() : c.getBodyB();
            sets.computeIfAbsent(DisjointSets.find(parent, body.index()), k -> new ArrayList<>()).add(c);
        }
        List<TiedGroup> groups = new ArrayList<>();
        for (List<Constraint> set : sets.values()) {
            groups.add(new TiedGroup(bodies(set), set));
        }
        return groups;
    }

    private static void single(int[] parent, Body body) {
        if (isMovable(body)) {
            parent[body.index()] = body.index();
        }
    }

    /** Lets the group of a body be one no more; returns its constraints. */
    private static List<Constraint> dissolve(Body body, Register register, State state, TiedGroup[] of) {
        boolean isThere = isMovable(body) && body.state() == state && body.index() < of.length;
        TiedGroup group = isThere ? of[body.index()] : null;
        if (group == null) {
            return List.of();
        }
        group.isDissolved = true;
        register.isSomeDissolved = true;
        for (int k = 0; k < group.bodies.size; k++) {
            of[group.bodies.values[k]] = null;
        }
        return group.constraints;
    }

    private static boolean isMovable(Body body) {
        return body != null && !body.isImmobile();
    }

    private static IntList bodies(List<Constraint> group) {
        TreeSet<Integer> found = new TreeSet<>();
        for (Constraint c : group) {
            if (isMovable(c.getBodyA())) {
                found.add(c.getBodyA().index());
            }
            if (isMovable(c.getBodyB())) {
                found.add(c.getBodyB().index());
            }
        }
        IntList list = new IntList();
        found.forEach(list::add);
        return list;
    }

    /** Whether the motion of islands depends on their state alone: no author's code has part in it, and nothing switches. */
    static boolean areAutonomous(List<Island> islands) {
        boolean yes = true;
        for (int k = 0; yes && k < islands.size(); k++) {
            Island one = islands.get(k);
            yes = one.isOwn && one.switches.isEmpty() && !one.passage.creep.isOn();
        }
        return yes;
    }

    /**
     * The least length in which a joint bends the way of a body; where masses are unlike enough that joints are as good as stiff springs,
     * the size of the bodies, which these throw about by whatever steps leave of them.
     */
    static double bend(List<Island> islands, double[] w) {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < islands.size(); k++) {
            least = islands.get(k).spread(w) > UNLIKE ? Math.min(least, islands.get(k).leastSize) : least;
            List<Constraint> joints = islands.get(k).inOrder;
            for (int m = 0; m < joints.size(); m++) {
                least = joints.get(m) instanceof Joint joint ? Math.min(least, joint.bend()) : least;
            }
        }
        return least;
    }

    /** Whether some of the joints can break. */
    static boolean isBreakable(List<Constraint> constraints) {
        return constraints.stream().anyMatch(k -> k instanceof Joint joint && joint.isBreakable());
    }

    /**
     * Whether some of the constraints of a body are with another one and let the two overlap. Motors and stops, which may stand beside
     * a joint, say so only where there is none.
     */
    static boolean letOverlap(List<Constraint> constraints, int[] around, int from, int to, Body other) {
        boolean byJoint = false;
        boolean joined = false;
        boolean bySwitch = false;
        for (int m = from; m < to; m++) {
            Constraint k = constraints.get(around[m]);
            if (k.getBodyA() != other && k.getBodyB() != other) {
                continue;
            }
            if (k instanceof Switched s) {
                bySwitch |= !s.isCollideConnected();
            } else {
                joined = true;
                byJoint |= !(k instanceof Joint joint && joint.isCollideConnected());
            }
        }
        return joined ? byJoint : bySwitch;
    }
}
