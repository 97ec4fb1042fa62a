// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static sim.physics.stepping.ContactRows.AX;
import static sim.physics.stepping.ContactRows.AY;
import static sim.physics.stepping.ContactRows.BX;
import static sim.physics.stepping.ContactRows.BY;
import static sim.physics.stepping.ContactRows.FRICTION;
import static sim.physics.stepping.ContactRows.NORMAL;
import static sim.physics.stepping.ContactRows.PAIR;
import static sim.physics.stepping.ContactRows.STRIDE;
import static sim.physics.stepping.ContactRows.TANGENT;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import sim.physics.constraint.PressedTrees;
import sim.physics.internal.IntList;
import sim.physics.internal.Softness;
import sim.physics.motion.State;

/**
 * The contacts of what bears loads with its joints ({@link PressedTrees}). In turns with them, what is light under what is heavy takes as many turns as the ratio of the
 * two. So when contacts have had theirs, those that press keep their speeds, and joints are solved with them: what would pull is left out, and what would rub more
 * than it may.
 */
final class PressingContacts implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Solutions in which a contact may be left out. */
    private static final int ROUNDS = 4;

    /** What counts as all that friction can give. */
    private static final double ALL = 1 - 1e-9;

    /** Of a point: its pair, its place, its bond, and whether its child is the second body. */
    private static final int SIZE = 4;

    private final State state;
    private final Poses poses;
    private final PressedTrees trees;
    private final ContactRows rows;

    /** By tree: its points. */
    private final List<IntList> points = new ArrayList<>();

    private boolean any;

    PressingContacts(State state, Poses poses, PressedTrees trees, ContactRows rows) {
        this.state = state;
        this.poses = poses;
        this.trees = trees;
        this.rows = rows;
    }

    /** Begins a step. */
    void begin() {
        any = trees.begin();
        for (int tree = 0; any && tree < trees.count(); tree++) {
            if (tree == points.size()) {
                points.add(new IntList());
            }
            points.get(tree).clear();
        }
        for (int k = 0; any && k < rows.count; k++) {
            int tree = Math.max(trees.treeOf(rows.first(k)), trees.treeOf(rows.second(k)));
            if (tree >= 0) {
                add(k, tree);
            }
        }
        if (any) {
            trees.make();
        }
    }

    private void add(int k, int tree) {
        int a = rows.first(k);
        int b = rows.second(k);
        boolean isSecond = !poses.isGround(b);
        IntList those = points.get(tree);
        for (int p = rows.begin(k); p < rows.end(k); p += STRIDE) {
            those.add(k);
            those.add(p);
            those.add(trees.add(tree, isSecond ? b : a, isSecond && !poses.isGround(a) ? a : -1));
            those.add(isSecond ? 1 : 0);
        }
    }

    /** Takes note of what contacts have given when joints were closed after the move: along their normals of before it. */
    void note() {
        if (any && trees.areClosed()) {
            for (int tree = 0; tree < trees.count(); tree++) {
                IntList those = points.get(tree);
                for (int n = 0; n < those.size; n += SIZE) {
                    note(those.values, n);
                }
            }
        }
    }

    private void note(int[] those, int n) {
        double[] d = trees.values();
        int bond = those[n + 2];
        int second = PressedTrees.begin(bond) + (those[n + 3] == 1 ? PressedTrees.CHILD : PressedTrees.PARENT);
        double normal = trees.takeClosed(bond, 0);
        double tangent = trees.takeClosed(bond, 1);
        int o = ContactRows.TURNED * those[n];
        for (int axis = 0; axis < 2; axis++) {
            double given = d[second + axis] * normal + d[second + State.BLOCK + axis] * tangent;
            rows.turned[o + axis] += given;
            rows.turned[o + 2 + axis] += given; // what is taken back if the substep is made again
        }
    }

    /** Solves all such trees. */
    void solve(Softness softness, double h) {
        for (int tree = 0; any && tree < trees.count(); tree++) {
            if (trees.isPressed(tree)) {
                solve(tree, softness, h);
            }
        }
    }

    private void solve(int tree, Softness softness, double h) {
        IntList those = points.get(tree);
        for (int n = 0; n < those.size; n += SIZE) {
            read(those.values, n);
        }
        trees.read(tree, softness, h);
        boolean isFound = trees.solve(tree, h);
        for (int round = 1; isFound && round < ROUNDS && drops(those); round++) {
            isFound = trees.solve(tree, h);
        }
        if (isFound) {
            trees.give(tree);
            for (int n = 0; n < those.size; n += SIZE) {
                book(those.values, n);
            }
        }
    }

    /** Takes J of a point: of its normal if it presses, and of its tangent if it sticks. */
    private void read(int[] those, int n) {
        double[] d = trees.values();
        double[] q = rows.points;
        int pair = PAIR * those[n];
        int p = those[n + 1];
        int o = PressedTrees.begin(those[n + 2]);
        Arrays.fill(d, o, PressedTrees.begin(those[n + 2] + 1), 0);
        if (q[p + NORMAL] > 0) {
            boolean isSecond = those[n + 3] == 1;
            int first = o + (isSecond ? PressedTrees.PARENT : PressedTrees.CHILD);
            int second = o + (isSecond ? PressedTrees.CHILD : PressedTrees.PARENT);
            double nx = rows.normals[pair];
            double ny = rows.normals[pair + 1];
            put(d, first, -nx, -ny, q[p + AX], q[p + AY]);
            put(d, second, nx, ny, q[p + BX], q[p + BY]);
            if (Math.abs(q[p + TANGENT]) < ALL * rows.normals[pair + FRICTION] * q[p + NORMAL]) {
                put(d, first + State.BLOCK, ny, -nx, q[p + AX], q[p + AY]);
                put(d, second + State.BLOCK, -ny, nx, q[p + BX], q[p + BY]);
            }
        }
    }

    private static void put(double[] d, int o, double x, double y, double armX, double armY) {
        d[o] = x;
        d[o + 1] = y;
        d[o + 2] = armX * y - armY * x;
    }

    /** Leaves out what would pull, and friction that would be more than there is; whether there was such a thing. */
    private boolean drops(IntList those) {
        double[] d = trees.values();
        boolean any = false;
        for (int n = 0; n < those.size; n += SIZE) {
            int p = those.values[n + 1];
            int o = PressedTrees.begin(those.values[n + 2]);
            double given = d[o + PressedTrees.GIVEN];
            double normal = rows.points[p + NORMAL] + given;
            boolean pulls = given != 0 && normal < 0;
            double rubbed = d[o + PressedTrees.GIVEN + 1];
            boolean slips = rubbed != 0 && Math.abs(rows.points[p + TANGENT] + rubbed) * ALL > rows.normals[PAIR * those.values[n] + FRICTION] * normal;
            if (pulls || slips) {
                any = true;
                int from = pulls ? 0 : State.BLOCK;
                Arrays.fill(d, o + PressedTrees.CHILD + from, o + PressedTrees.CHILD + 2 * State.BLOCK, 0);
                Arrays.fill(d, o + PressedTrees.PARENT + from, o + PressedTrees.PARENT + 2 * State.BLOCK, 0);
            }
        }
        return any;
    }

    /** Takes note of what a point has given, as far as it may; what is more than that is taken back. */
    private void book(int[] those, int n) {
        int k = those[n];
        int p = those[n + 1];
        int o = PressedTrees.begin(those[n + 2]) + PressedTrees.GIVEN;
        double[] q = rows.points;
        double normal = q[p + NORMAL] + trees.values()[o];
        double tangent = q[p + TANGENT] + trees.values()[o + 1];
        q[p + NORMAL] = Math.max(0, normal);
        double most = rows.normals[PAIR * k + FRICTION] * q[p + NORMAL];
        q[p + TANGENT] = Math.max(-most, Math.min(most, tangent));
        if (q[p + NORMAL] != normal || q[p + TANGENT] != tangent) {
            rows.give(k, p, state.v(), q[p + NORMAL] - normal, q[p + TANGENT] - tangent);
        }
    }
}
