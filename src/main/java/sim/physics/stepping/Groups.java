// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.constraint.TieRows;
import sim.physics.internal.DisjointSets;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;
import sim.physics.motion.SpringRows;
import sim.physics.motion.State;
import sim.physics.motion.Steering;

/**
 * Groups of movable bodies that joints, stiff springs and contacts connect, and in which there is one of the first two, what may bounce,
 * what moving surfaces drive, or what is crushed.
 */
final class Groups implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int BLOCK = State.BLOCK;

    private final State state;
    /** Those of them in which nothing acts but trees of joints. */
    final TreeGroups trees = new TreeGroups();

    private final Grounds grounds;

    /** Number of groups, and the first body of each. */
    int count;

    int[] firsts = {};

    /** Whether there is more in them than contacts that do not bounce. */
    boolean[] areBooked = {};

    /** Whether nothing outside takes or gives momentum but forces: they touch nothing that cannot move, and nothing ties or rubs them there. */
    boolean[] areFree = {};

    /** The block of a body of each group that moves as its author says, −1 for none. */
    int[] anchors = {};

    /** Whether that body is of no group, as nothing can move it ({@link Grounds}). */
    boolean[] areHeld = {};

    /** By the body that stands for its set: what does not move and is touched by one of it, −1 for nothing; and whether there is another kind of that. */
    private int[] groundOf = {};

    /** Where the bodies of a group begin, and where the last one's end. */
    int[] begins = {};

    private int[] ends = {};

    /** Number of bodies in them; of each, group by group, its block, its mass and its moment, 0 for what cannot turn, and whether its author moves it. */
    int bodies;

    boolean[] areSteered = {};

    int[] blocks = {};
    double[] masses = {};

    /** The group of a body, by its index. */
    int[] slots = {};

    /** By body: parents of the sets of joints and springs, and of those of this step. */
    private int[] tiedParents = {};

    private int[] parents = {};

    /** The movable bodies with joints and springs, in ascending order. */
    private final IntList tied = new IntList();

    /** By body: whether it has joints. */
    private boolean[] joined = {};

    /** By body: whether it is tied to what cannot move. */
    private boolean[] areFastened = {};

    /** Those that are tied to what their authors move, each with that. */
    private final IntList fastened = new IntList();

    /** What is tied and nothing can move, as it was when ties were looked at last. */
    private final IntList held = new IntList();

    /** Whether friction with the plane acts, and whether there were bodies that nothing could move but their authors did. */
    private boolean rubs;

    private boolean haveGrounds;

    /** The rows of those in which something has met in this substep, as {@link Impacts} has found. */
    final IntList struck = new IntList();

    private boolean[] marks = {};
    private final IntList found = new IntList();

    /** The bodies of the rows for which these groups were found; with them whether one may bounce, or is driven. */
    private int[] known = {};

    private int knownRows = -1;

    Groups(State state, Grounds grounds) {
        this.state = state;
        this.grounds = grounds;
    }

    /**
     * Finds them.
     *
     * @param isNew whether joints, springs or bodies are others than the last time
     * @param areRubbed whether friction with the plane acts on bodies
     */
    void find(ContactRows rows, TieRows ties, SpringRows springs, boolean isNew, boolean areRubbed) {
        if (isNew || parents.length < state.size() || !known(grounds.tied)) {
            tie(ties, springs);
        } else if (areRubbed == rubs && !haveGrounds && grounds.held.size == 0 && areKnown(rows)) {
            return;
        }
        rubs = areRubbed;
        note(rows);
        do {
            System.arraycopy(tiedParents, 0, parents, 0, state.size());
            join(rows, state, parents);
        } while (haveGrounds() && releases(rows, ties, springs));
        for (int k = 0; k < found.size; k++) {
            marks[found.values[k]] = false;
        }
        found.clear();
        count = 0;
        for (int k = 0; k < tied.size; k++) {
            watch(tied.values[k]);
        }
        for (int k = 0; k < rows.count; k++) {
            if (rows.mayBounce(k) || rows.isFast(k) || rows.pairs[ContactRows.INTS * k + ContactRows.UNLIKE] != 0) {
                watch(rows.first(k));
                watch(rows.second(k));
            }
        }
        Arrays.fill(areBooked, 0, count, true);
        int booked = count;
        for (int k = 0; k < rows.count; k++) {
            if (rows.isDriven(k) || rows.pairs[ContactRows.INTS * k + ContactRows.SUNK] != 0) {
                watch(rows.first(k));
                watch(rows.second(k));
            }
        }
        Arrays.fill(areBooked, booked, count, false);
        for (int k = 0; found.size > 0 && k < rows.count; k++) {
            follow(rows.first(k));
            follow(rows.second(k));
        }
        sort();
        free(rows);
    }

    /** Whether there are bodies that nothing can move, but their authors do: which of them, or of what is fixed, others touch, is to be found. */
    private boolean haveGrounds() {
        haveGrounds = grounds.held.size > 0;
        if (haveGrounds) {
            Arrays.fill(groundOf, 0, state.size(), -1);
        }
        return haveGrounds;
    }

    /** Lets those be moved that something touches, or is tied to, which touches another ground, too, or is tied to one; whether there are any. */
    private boolean releases(ContactRows rows, TieRows ties, SpringRows springs) {
        int before = grounds.held.size;
        for (int k = 0; k < fastened.size; k += 2) {
            meet(DisjointSets.find(parents, fastened.values[k]), fastened.values[k + 1]);
        }
        for (int k = 0; k < rows.count; k++) {
            boolean isFirst = isMovable(rows.first(k));
            if (isFirst != isMovable(rows.second(k))) {
                meet(DisjointSets.find(parents, isFirst ? rows.first(k) : rows.second(k)), isFirst ? rows.second(k) : rows.first(k));
            }
        }
        for (int k = 0; k < tied.size; k++) {
            int ground = groundOf[DisjointSets.find(parents, tied.values[k])];
            if (areFastened[tied.values[k]] && ground >= 0) {
                release(ground);
            }
        }
        if (!known(grounds.tied)) {
            tie(ties, springs);
        }
        return grounds.held.size < before;
    }

    /** Whether those that are tied and that nothing can move are the same as when ties were looked at last. */
    private boolean known(IntList heldNow) {
        boolean yes = heldNow.size == held.size;
        for (int k = 0; yes && k < held.size; k++) {
            yes = held.values[k] == heldNow.values[k];
        }
        return yes;
    }

    private void meet(int root, int ground) {
        int other = groundOf[root];
        if (other < 0) {
            groundOf[root] = ground;
        } else if (other != ground && !Steering.goAsOne(state.body(other), state.body(ground))) {
            release(other);
            release(ground);
        }
    }

    private void release(int ground) {
        if (grounds.has(ground)) {
            grounds.release(ground);
        }
    }

    private void free(ContactRows rows) {
        Arrays.fill(areFree, 0, count, !rubs);
        Arrays.fill(areHeld, 0, count, false);
        for (int k = 0; k < tied.size; k++) {
            areFree[slots[tied.values[k]]] &= !areFastened[tied.values[k]];
        }
        for (int k = 0; k < fastened.size; k += 2) {
            stand(slots[fastened.values[k]], fastened.values[k + 1]);
        }
        for (int k = 0; k < rows.count; k++) {
            if (!isMovable(rows.first(k)) || !isMovable(rows.second(k))) {
                int body = isMovable(rows.first(k)) ? rows.first(k) : rows.second(k);
                int ground = isMovable(rows.first(k)) ? rows.second(k) : rows.first(k);
                if (marks[body] && grounds.has(ground)) {
                    stand(slots[body], ground);
                } else {
                    areFree[slots[body]] &= !marks[body]; // else it is of no group
                }
            }
        }
    }

    /** Lets a group be seen from a ground. */
    private void stand(int group, int ground) {
        areHeld[group] = true;
        anchors[group] = BLOCK * ground;
    }

    /** Whether a pair is of a group. */
    boolean has(int row, ContactRows rows) {
        return marks[rows.first(row)] || marks[rows.second(row)];
    }

    /** Whether one of the bodies of a pair is moved by its author. */
    boolean isOnMovedGround(int row, ContactRows rows) {
        return grounds.has(rows.first(row)) || grounds.has(rows.second(row));
    }

    /** The group of a pair: what is fixed has none. */
    int of(int row, ContactRows rows) {
        return slots[isMovable(rows.first(row)) ? rows.first(row) : rows.second(row)];
    }

    /**
     * Adds what moving surfaces have given bodies, or taken.
     *
     * @param which impulses along tangents
     * @param given takes twice the energy, by group
     */
    void drive(ContactRows rows, int which, double[] given) {
        for (int k = 0; k < rows.count; k++) {
            for (int p = rows.begin(k); rows.isDriven(k) && p < rows.end(k); p += ContactRows.STRIDE) {
                given[of(k, rows)] -= 2 * rows.points[p + which] * rows.normals[ContactRows.PAIR * k + ContactRows.BELT];
            }
        }
    }

    /** Marks the groups with joints and springs, and those with joints. */
    void markTied(boolean[] those, boolean[] areJoined) {
        for (int k = 0; k < tied.size; k++) {
            those[slots[tied.values[k]]] = true;
            areJoined[slots[tied.values[k]]] |= joined[tied.values[k]];
        }
    }

    /** {@return whether friction with the plane acts} */
    boolean areRubbed() {
        return rubs;
    }

    /** Clears what is said of the groups with joints and springs. */
    void clearTied(boolean[] those) {
        for (int k = 0; k < tied.size; k++) {
            those[slots[tied.values[k]]] = false;
        }
    }

    /** Finds them anew in the next step: masses may be others. */
    void forget() {
        knownRows = -1;
    }

    private boolean areKnown(ContactRows rows) {
        boolean yes = rows.count == knownRows;
        for (int k = 0; yes && k < rows.count; k++) {
            yes = known[2 * k] == code(rows, k) && known[2 * k + 1] == rows.second(k);
        }
        return yes;
    }

    private void note(ContactRows rows) {
        knownRows = rows.count;
        if (known.length < 2 * knownRows) {
            known = new int[2 * Growth.length(known.length / 2, knownRows)];
        }
        for (int k = 0; k < knownRows; k++) {
            known[2 * k] = code(rows, k);
            known[2 * k + 1] = rows.second(k);
        }
    }

    private static int code(ContactRows rows, int k) {
        int unlike = rows.pairs[ContactRows.INTS * k + ContactRows.UNLIKE];
        int sunk = rows.pairs[ContactRows.INTS * k + ContactRows.SUNK];
        return rows.first(k) << 5 | 16 * sunk | (rows.mayBounce(k) ? 1 : 0) | (rows.isDriven(k) ? 2 : 0) | (rows.isFast(k) ? 4 : 0) | 8 * unlike;
    }

    /** Puts the bodies in the order of their groups. */
    private void sort() {
        double[] w = state.w().values();
        Arrays.fill(begins, 0, count + 1, 0);
        Arrays.fill(anchors, 0, count, -1);
        for (int k = 0; k < found.size; k++) {
            begins[slots[found.values[k]] + 1]++;
        }
        for (int g = 0; g < count; g++) {
            begins[g + 1] += begins[g];
        }
        System.arraycopy(begins, 1, ends, 0, count);
        bodies = found.size;
        for (int k = bodies - 1; k >= 0; k--) {
            int body = found.values[k];
            int o = --ends[slots[body]];
            blocks[o] = BLOCK * body;
            areSteered[o] = !state.body(body).isDynamic();
            if (areSteered[o]) {
                anchors[slots[body]] = BLOCK * body;
            }
            masses[2 * o] = 1 / w[BLOCK * body];
            masses[2 * o + 1] = w[BLOCK * body + 2] > 0 ? 1 / w[BLOCK * body + 2] : 0;
        }
    }

    private void tie(TieRows ties, SpringRows springs) {
        allocate(state.x().length / BLOCK);
        Arrays.fill(marks, false);
        Arrays.setAll(tiedParents, k -> k);
        joined = new boolean[marks.length];
        ties.mark(joined);
        System.arraycopy(joined, 0, marks, 0, marks.length);
        springs.mark(marks);
        fasten(ties, springs);
        ties.join(tiedParents);
        springs.join(tiedParents);
        tied.clear();
        found.clear();
        for (int k = 0; k < state.size(); k++) {
            if (marks[k] && isMovable(k)) {
                tied.add(k);
            }
        }
        Arrays.fill(marks, false);
    }

    /** Finds who is tied to what does not move: of what its author moves, that is kept. */
    private void fasten(TieRows ties, SpringRows springs) {
        Arrays.fill(areFastened, false);
        held.clear();
        for (int k = 0; k < grounds.tied.size; k++) {
            held.add(grounds.tied.values[k]);
        }
        found.clear();
        fastened.clear();
        ties.findFastened(found);
        springs.findFastened(found);
        for (int k = 0; k < found.size; k += 2) {
            int ground = found.values[k + 1];
            if (ground >= 0 && grounds.has(ground)) {
                fastened.add(found.values[k]);
                fastened.add(ground);
            } else {
                areFastened[found.values[k]] = true;
            }
        }
    }

    private void allocate(int n) {
        if (parents.length != n) {
            tiedParents = new int[n];
            parents = new int[n];
            firsts = new int[n];
            areBooked = new boolean[n];
            areFree = new boolean[n];
            anchors = new int[n];
            areHeld = new boolean[n];
            groundOf = new int[n];
            areSteered = new boolean[n];
            areFastened = new boolean[n];
            blocks = new int[n];
            begins = new int[n + 1];
            ends = new int[n];
            slots = new int[n];
            masses = new double[2 * n];
            marks = new boolean[n];
        }
    }

    boolean isMovable(int body) {
        return isMovable(state, body);
    }

    static boolean isMovable(State state, int body) {
        return state.w().values()[BLOCK * body] > 0;
    }

    /** Joins the sets of movable bodies that touch one another. */
    static void join(ContactRows rows, State state, int[] parents) {
        for (int k = 0; k < rows.count; k++) {
            if (isMovable(state, rows.first(k)) && isMovable(state, rows.second(k))) {
                DisjointSets.join(parents, rows.first(k), rows.second(k));
            }
        }
    }

    /** Takes a body in, and the group that it is of. */
    private void watch(int body) {
        if (marks[body] || !isMovable(body)) {
            return;
        }
        int root = DisjointSets.find(parents, body);
        if (!marks[root]) {
            firsts[count] = root;
            slots[root] = count++;
            take(root, slots[root]);
        }
        if (body != root) {
            take(body, slots[root]);
        }
    }

    /** Takes in a body that touches those of a group. */
    private void follow(int body) {
        int root = DisjointSets.find(parents, body);
        if (!marks[body] && marks[root]) {
            take(body, slots[root]);
        }
    }

    private void take(int body, int group) {
        marks[body] = true;
        slots[body] = group;
        found.add(body);
    }
}
