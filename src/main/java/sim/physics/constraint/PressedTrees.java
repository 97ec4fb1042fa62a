// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
import java.util.stream.IntStream;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;
import sim.physics.internal.Softness;
import sim.physics.motion.State;

/**
 * Trees of joints that bear what touches them, with loops or without, solved at once together with their contacts: after contacts have had their turns, which are
 * to keep the speeds that they have then. A contact is a bond of two rows, one along its normal and one along its tangent.
 */
public final class PressedTrees implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Where the values of a bond begin: J of the child and of the parent, by rows of three, and what was given. */
    public static final int CHILD = TreeRows.CHILD;

    /** J of the parent. */
    public static final int PARENT = TreeRows.PARENT;

    /** What the rows have been given by the last solution. */
    public static final int GIVEN = TreeRows.GIVEN;

    /** The part of what joints are open that is regained in a substep: what bears much is not lifted at once. */
    private static final double REGAINED = 0.1;

    /** How far bodies may go in a substep, relative to their size; see {@link TieTrees}. */
    private static final double FAR = 0.2;

    /** Of a contact: bond, child, parent. */
    private static final int POINT = 3;

    private final State state;
    private final TieTrees trees;
    private final TieBonds bonds;

    /** By tree: its equations; and its contacts, each by its bond and its bodies, of now and of when the equations were made. */
    private TieLoops[] loops = {};

    private IntList[] contacts = {};
    private IntList[] made = {};

    /** By body: its tree, −1 for none. */
    private int[] treeOf = {};

    private double[] impulse = {};

    /** By bond of a contact, two each: what it has given when joints were closed after the move, which nobody knows of yet. */
    private double[] closed = {};

    private boolean areClosed;

    /** How far joints of the tree that was read last are open at most. */
    private double open;

    PressedTrees(State state, TieTrees trees, TieBonds bonds) {
        this.state = state;
        this.trees = trees;
        this.bonds = bonds;
    }

    /** Takes the impulses of joints that are no pins; trees are others. */
    void gather(double[] impulse) {
        this.impulse = impulse;
        int n = trees.count();
        loops = new TieLoops[n];
        contacts = new IntList[n];
        made = new IntList[n];
    }

    /**
     * Begins a step.
     *
     * @return whether there are such trees
     */
    public boolean begin() {
        trees.press();
        if (areClosed()) {
            Arrays.fill(closed, 0); // of a step that was broken off
        }
        boolean any = false;
        for (int t = 0; t < trees.count(); t++) {
            if (trees.isPressed(t)) {
                if (!any) {
                    clear();
                }
                any = true;
                contacts[t] = contacts[t] == null ? new IntList() : contacts[t];
                contacts[t].clear();
                for (int k = trees.from(t); k < trees.end(t); k++) {
                    treeOf[bonds.child(k) / State.BLOCK] = t;
                }
            }
        }
        return any;
    }

    private void clear() {
        treeOf = treeOf.length < state.size() ? new int[state.size()] : treeOf;
        Arrays.fill(treeOf, -1);
        bonds.clearContacts();
    }

    /**
     * The tree of a body.
     *
     * @param body its index
     * @return the number of a tree that is solved with what touches it, −1 for none
     */
    public int treeOf(int body) {
        return treeOf[body];
    }

    /**
     * Adds a point of a contact.
     *
     * @param tree the tree that is touched
     * @param child a body that can move
     * @param parent the other one, −1 for one that cannot
     * @return its place among the bonds
     */
    public int add(int tree, int child, int parent) {
        int bond = bonds.addContact(State.BLOCK * child, parent < 0 ? -1 : State.BLOCK * parent);
        contacts[tree].add(bond);
        contacts[tree].add(child);
        contacts[tree].add(parent);
        return bond;
    }

    /** Makes the equations, when all contacts were added, unless they are those of the step before. */
    public void make() {
        for (int t = 0; t < trees.count(); t++) {
            if (trees.isPressed(t) && (loops[t] == null || !isSame(contacts[t], made[t]))) {
                make(t);
            }
        }
    }

    private void make(int t) {
        IntList those = contacts[t];
        made[t] = new IntList();
        for (int k = 0; k < those.size; k++) {
            made[t].add(those.values[k]);
        }
        IntStream points = IntStream.range(0, those.size / POINT).map(k -> those.values[POINT * k]);
        loops[t] = TieLoops.of(bonds, IntStream.concat(IntStream.range(trees.from(t), trees.end(t)), points).toArray());
        if (loops[t] == null) {
            trees.pause(t);
        }
    }

    private static boolean isSame(IntList one, IntList other) {
        return Arrays.equals(one.values, 0, one.size, other.values, 0, other.size);
    }

    /** {@return number of trees} */
    public int count() {
        return trees.count();
    }

    /**
     * Whether a tree is solved with what touches it.
     *
     * @param tree its number
     * @return so or not
     */
    public boolean isPressed(int tree) {
        return trees.isPressed(tree);
    }

    /**
     * The values of bonds.
     *
     * @return those of all; those of one begin at {@link #begin(int)}
     */
    public double[] values() {
        return bonds.data();
    }

    /**
     * Where the values of a bond begin.
     *
     * @param bond its place
     * @return the first one
     */
    public static int begin(int bond) {
        return TreeRows.STRIDE * bond;
    }

    /**
     * Takes what a tree's joints ask for.
     *
     * @param tree its number
     * @param softness whether places are regained
     * @param h substep
     */
    public void read(int tree, Softness softness, double h) {
        boolean regains = softness.rate() > 0;
        Softness slow = regains ? new Softness(REGAINED / h, softness.mass(), softness.impulse()) : softness;
        int from = trees.from(tree);
        int end = trees.end(tree);
        open = bonds.widest(from, end);
        bonds.read(from, end, impulse, false, slow, h);
        if (regains) {
            bonds.leave(from, end, 1 - REGAINED);
        }
    }

    /**
     * Finds how they get that, with what contacts take.
     *
     * @param tree its number, which was {@linkplain #read read} last
     * @param h substep
     * @return whether it may be given; else turns do it for some time
     */
    public boolean solve(int tree, double h) {
        loops[tree].factor(bonds.data(), state.w().values(), open);
        return solveNear(tree, h);
    }

    private boolean solveNear(int tree, double h) {
        boolean isNear = loops[tree].solveNear(bonds.data(), FAR, h);
        if (!isNear) {
            trees.pause(tree);
        }
        return isNear;
    }

    /**
     * Gives the bodies of a tree, and what touches it, what was found.
     *
     * @param tree its number
     */
    public void give(int tree) {
        loops[tree].give(state.v());
        bonds.book(trees.from(tree), trees.end(tree), impulse);
    }

    /** Brings bodies where joints wanted them, along with what touches them; see {@link TieTrees#straighten}. */
    boolean close(int tree, double h, boolean[] marks) {
        boolean isNear = solveNear(tree, h);
        if (isNear) {
            give(tree);
            loops[tree].move(state.x(), h, marks);
            note(contacts[tree]);
        }
        return isNear;
    }

    /** Notes what contacts have given when joints were closed. */
    private void note(IntList those) {
        areClosed = true;
        for (int k = 0; k < those.size; k += POINT) {
            int bond = those.values[k];
            if (closed.length <= 2 * bond + 1) {
                closed = Arrays.copyOf(closed, Growth.length(closed.length, 2 * bond + 2));
            }
            closed[2 * bond] += values()[begin(bond) + GIVEN];
            closed[2 * bond + 1] += values()[begin(bond) + GIVEN + 1];
        }
    }

    /** {@return whether contacts have given something when joints were closed, since this was asked last} */
    public boolean areClosed() {
        boolean were = areClosed;
        areClosed = false;
        return were;
    }

    /**
     * What a row of a contact has given when joints were closed, since this was asked last.
     *
     * @param bond the contact's place among the bonds
     * @param row 0 for that along its normal, 1 for the other one
     * @return the impulse
     */
    public double takeClosed(int bond, int row) {
        double given = closed.length > 2 * bond + row ? closed[2 * bond + row] : 0;
        if (given != 0) {
            closed[2 * bond + row] = 0;
        }
        return given;
    }
}
