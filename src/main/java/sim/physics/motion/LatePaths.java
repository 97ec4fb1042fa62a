// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.util.Arrays;
import sim.physics.internal.IntList;

/**
 * Groups of tied bodies that collide with nobody, whose anchors and paths nobody looks at while nothing happens in a step: they
 * are moved from state to state, and get anchors and paths only when something does happen, then the same as others at once. They
 * get them before they are saved, too.
 */
public final class LatePaths {
    private final Motion motion;
    private final State state;
    private final Trajectories trajectories;

    /** First bodies of the groups that are late in this step, in ascending order. */
    private final IntList late = new IntList();

    /** Those that had gone through the step when they got their paths. */
    private final IntList made = new IntList();

    /** How many of the late ones have begun the step, and how many have gone through it. */
    private int begun;

    private int done;

    /** By body: whether it is the first one of a group that is late. */
    private boolean[] isLate = {};

    /** The first body of the group that was found last to have no quick way; −1 when that has been made use of. */
    private int refused = -1;

    /** Where groups that have begun the step were at its start, 3n each. */
    private double[] startX = {};

    private double[] startV = {};

    LatePaths(Motion motion, State state, Trajectories trajectories) {
        this.motion = motion;
        this.state = state;
        this.trajectories = trajectories;
    }

    /** Begins a step, in which no group is late. */
    void begin() {
        for (int k = 0; k < late.size; k++) {
            isLate[late.values[k]] = false;
        }
        late.clear();
        begun = 0;
        done = 0;
        refused = -1;
    }

    /**
     * Anchors driven bodies at the start of a step where the last one left them, but for groups that may be late.
     *
     * @param neighbours who knows which
     */
    public void anchorOthers(Neighbours neighbours) {
        ensure();
        IntList driven = motion.driven();
        for (int k = 0; k < driven.size; k++) {
            int first = driven.values[k];
            IntList group = motion.companions(first);
            if (group.values[0] != first) {
                continue; // with the others of its group, as they are not side by side
            }
            if (motion.isTiedGroup(group) && neighbours.areAloof(group)) {
                isLate[first] = true;
                late.add(first);
            } else {
                GroupPaths.anchor(trajectories, group, state.x(), state.v());
            }
            k += driven.common(k, group) - 1;
        }
    }

    private void ensure() {
        int n = state.x().length;
        if (startX.length < n) {
            startX = new double[n];
            startV = new double[n];
            isLate = Arrays.copyOf(isLate, n / State.BLOCK);
        }
    }

    /**
     * Whether the group of a body is late.
     *
     * @param body index of its first body
     * @return false if it has its anchors
     */
    public boolean has(int body) {
        return late.size > 0 && isLate[body];
    }

    /** {@return whether no group is late} */
    public boolean isEmpty() {
        return late.size == 0;
    }

    /**
     * Moves a group through the step, without a path.
     *
     * @param group late, the next one in order
     * @return false if it has no quick way; then it is where it was, and not late any more
     */
    public boolean advance(IntList group) {
        copy(group, state.x(), startX);
        copy(group, state.v(), startV);
        begun++;
        if (motion.drivenMotion.leapsBlindly(group)) {
            done++;
            return true;
        }
        begun--;
        System.arraycopy(late.values, begun + 1, late.values, begun, late.size - 1 - begun);
        late.size--;
        isLate[group.values[0]] = false;
        refused = group.values[0];
        GroupPaths.anchor(trajectories, group, state.x(), state.v());
        return false;
    }

    /** Whether a group has been refused just now. */
    boolean takeRefused(int first) {
        boolean yes = first == refused;
        refused = -1;
        return yes;
    }

    /**
     * Gives all groups that are late their anchors, and those that have gone through the step their paths.
     *
     * @return the first bodies of the latter; valid until the next call
     */
    public IntList make() {
        made.clear();
        for (int k = 0; k < late.size; k++) {
            IntList group = motion.companions(late.values[k]);
            if (k < begun) {
                GroupPaths.anchor(trajectories, group, startX, startV);
            } else {
                GroupPaths.anchor(trajectories, group, state.x(), state.v());
            }
            if (k < done) {
                motion.drivenMotion.lead(group);
                made.add(late.values[k]);
            }
        }
        begin();
        return made;
    }

    private static void copy(IntList group, double[] from, double[] to) {
        if (group.isRow()) {
            int b = State.BLOCK * group.values[0];
            System.arraycopy(from, b, to, b, State.BLOCK * group.size);
            return;
        }
        for (int k = 0; k < group.size; k++) {
            int b = State.BLOCK * group.values[k];
            System.arraycopy(from, b, to, b, State.BLOCK);
        }
    }
}
