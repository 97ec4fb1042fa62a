// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import sim.physics.internal.IntList;
import sim.physics.motion.State;

/** Finds what hangs together by joints, beginning with what hangs in the world, and whether that has loops: of a joint, the motor of its angle, too, if that is a pin. */
final class TieForest {
    private static final int BLOCK = State.BLOCK;

    /** A joint of a body that can move and of another one, −1 for none that can; its place among pins, and that of its other constraint, −1 for none; and what cannot move, −1 for the world. */
    static final class Bond {
        int child;
        int parent;
        final int pin;
        final int ground;
        int tie;
        private boolean isUsed;

        Bond(int child, int parent, int ground, int pin, int tie) {
            this.child = child;
            this.parent = parent;
            this.ground = ground;
            this.pin = pin;
            this.tie = tie;
        }

        /** Whether this is no joint, but the body of a tree that nothing holds. */
        boolean isRoot() {
            return pin < 0 && tie < 0;
        }

        /** One of a body that nothing holds. */
        static Bond root(int body) {
            return new Bond(body, -1, -1, -1, -1);
        }
    }

    private final State state;
    private final TieEquations equations;
    private final List<Bond> all = new ArrayList<>();

    /** The bonds of each body. */
    private final Map<Integer, List<Bond>> around = new HashMap<>();

    private final Set<Integer> seen = new HashSet<>();

    /** What was found: trees, each from the root on; of those with loops, the bonds that close them come last. */
    final List<List<Bond>> trees = new ArrayList<>();

    /** Of each, whether it has loops. */
    final List<Boolean> haveLoops = new ArrayList<>();

    TieForest(State state, TieEquations equations, PinImpulses pins, int awakePins) {
        this.state = state;
        this.equations = equations;
        Map<Long, Bond> pinned = new HashMap<>();
        for (int k = 0; k < awakePins; k++) {
            Bond bond = put(pins.block(k, 0), pins.block(k, 1), k, -1);
            if (bond != null) {
                pinned.putIfAbsent(key(bond.child, bond.parent), bond);
            }
        }
        for (int k = 0; k < equations.count(); k++) {
            int first = equations.blocks[2 * k];
            int second = equations.blocks[2 * k + 1];
            if (equations.kinds[k] == TieEquations.Kind.JOINT) {
                put(first, second, -1, k);
            } else if (equations.kinds[k] == TieEquations.Kind.MOTOR && equations.isTurn(k)) {
                Bond bond = pinned.get(key(free(first), free(second)));
                if (bond != null && bond.tie < 0) {
                    bond.tie = k;
                }
            }
        }
    }

    private static long key(int a, int b) {
        return (long) Math.min(a, b) << Integer.SIZE | Math.max(a, b) & 0xFFFFFFFFL;
    }

    /** What is fixed, and steered bodies, which their drives hold, go where they go. */
    private int free(int block) {
        return block >= 0 && state.w().values()[block] > 0 && state.body(block / BLOCK).isDynamic() ? block : -1;
    }

    private Bond put(int first, int second, int pin, int tie) {
        int a = free(first);
        int b = free(second);
        if (a < 0 && b < 0) {
            return null;
        }
        Bond bond = a < 0 ? new Bond(b, -1, first, pin, tie) : new Bond(a, b, b < 0 ? second : -1, pin, tie);
        all.add(bond);
        around.computeIfAbsent(bond.child, k -> new ArrayList<>()).add(bond);
        if (bond.parent >= 0) {
            around.computeIfAbsent(bond.parent, k -> new ArrayList<>()).add(bond);
        }
        return bond;
    }

    /**
     * Looks for them.
     *
     * @param few joints that a tree has at least
     */
    void find(int few) {
        for (Bond bond : all) {
            if (bond.parent < 0 && !seen.contains(bond.child)) {
                bond.isUsed = true;
                walk(bond, few);
            }
        }
        for (Bond bond : all) {
            if (!seen.contains(bond.child)) {
                walk(Bond.root(bond.child), few + 1);
            }
        }
    }

    private void walk(Bond root, int few) {
        List<Bond> tree = new ArrayList<>();
        List<Bond> closing = new ArrayList<>();
        tree.add(root);
        seen.add(root.child);
        for (int n = 0; n < tree.size(); n++) {
            int body = tree.get(n).child;
            for (Bond bond : around.get(body)) {
                if (bond.isUsed) {
                    continue;
                }
                bond.isUsed = true;
                int other = bond.child == body ? bond.parent : bond.child;
                if (other < 0 || !seen.add(other)) {
                    closing.add(bond);
                    continue;
                }
                bond.child = other;
                bond.parent = body;
                tree.add(bond);
            }
        }
        if (tree.size() + closing.size() >= few) {
            if (!closing.isEmpty() && tree.get(0).isRoot()) {
                tree.remove(0);
            }
            tree.addAll(closing);
            trees.add(tree);
            haveLoops.add(!closing.isEmpty());
        }
    }

    /** By tree: the stops of its bodies. */
    int[][] stops() {
        Map<Integer, Integer> treeOf = new HashMap<>();
        List<IntList> found = new ArrayList<>();
        for (int t = 0; t < trees.size(); t++) {
            found.add(new IntList());
            for (Bond bond : trees.get(t)) {
                treeOf.put(bond.child, t);
            }
        }
        for (int k = 0; k < equations.count(); k++) {
            for (int end = 2 * k; equations.kinds[k] == TieEquations.Kind.STOP && end < 2 * k + 2; end++) {
                Integer tree = treeOf.get(equations.blocks[end]);
                if (tree != null) {
                    found.get(tree).add(k);
                }
            }
        }
        int[][] stops = new int[trees.size()][];
        Arrays.setAll(stops, t -> Arrays.copyOf(found.get(t).values, found.get(t).size));
        return stops;
    }
}
