// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.util.Arrays;
import sim.physics.internal.IntList;
import sim.physics.internal.Team;

/**
 * Groups of tied bodies that collide with nobody, whose anchors and paths nobody looks at while nothing happens in a step: they
 * are moved from state to state, and get anchors and paths only when something does happen, then the same as others at once. They
 * get them before they are saved, too.
 */
public final class LatePaths implements Team.Work {
    /** How far a late group is in the step: it has got its anchors, has not begun, is on its way, has gone through it. */
    private static final byte PROMPT = 0;

    private static final byte LATE = 1;
    private static final byte BEGUN = 2;
    private static final byte DONE = 3;

    /** A thread has taken it through the step before it was its turn. */
    private static final byte AHEAD = 4;

    /** Driven bodies from which on it pays to share what is made for them late. */
    private static final int FEWEST_SHARED = 512;

    private final Motion motion;
    private final State state;
    private final Trajectories trajectories;

    /** First bodies of the groups that may be late, and all bodies of the others that are driven. */
    private final IntList candidates = new IntList();

    private final IntList others = new IntList();

    /** Whether these are out of date, or have been made of other islands. */
    private boolean isStale = true;

    private long grouping;

    /** First bodies of the groups that are late in this step. */
    private final IntList late = new IntList();

    /** Those that had gone through the step when they got their paths. */
    private final IntList made = new IntList();

    /** By first body of a group: one of those. */
    private byte[] progress = {};

    /** The same: how many of the driven bodies from that one on are certainly of the group; and that, or 0 if threads may not share it. */
    private int[] rows = {};

    private int[] sharedRows = {};

    /** The first body of the group that was found last to have no quick way; −1 when that has been made use of. */
    private int refused = -1;

    /** What moving a group ahead has cost, by its first body. */
    private long[] cost = {};

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
            progress[late.values[k]] = PROMPT;
        }
        late.clear();
        refused = -1;
    }

    /** Nobody is late any more: bodies are put back to where the step began. */
    public void drop() {
        begin();
        forget();
    }

    /** Bodies have been written, or are driven from now on, or no longer, or are tied otherwise: other groups may be late. */
    public void forget() {
        isStale = true;
    }

    /**
     * Anchors driven bodies at the start of a step where the last one left them, but for groups that may be late.
     *
     * @param neighbours who knows which
     */
    public void anchorOthers(Neighbours neighbours) {
        if (isStale || grouping != motion.ties.grouping()) {
            gather(neighbours);
        }
        for (int k = 0; k < candidates.size; k++) {
            progress[candidates.values[k]] = LATE;
            late.add(candidates.values[k]);
        }
        GroupPaths.anchor(trajectories, others, state.x(), state.v());
    }

    private void gather(Neighbours neighbours) {
        int n = state.x().length;
        if (startX.length < n) {
            startX = new double[n];
            startV = new double[n];
            progress = Arrays.copyOf(progress, n / State.BLOCK);
            rows = Arrays.copyOf(rows, n / State.BLOCK);
            sharedRows = Arrays.copyOf(sharedRows, n / State.BLOCK);
            cost = Arrays.copyOf(cost, n / State.BLOCK);
        }
        candidates.clear();
        others.clear();
        IntList driven = motion.driven();
        for (int k = 0; k < driven.size; k++) {
            IntList group = motion.companions(driven.values[k]);
            boolean isAloof = motion.isTiedGroup(group) && neighbours.areAloof(group);
            if (!isAloof) {
                others.add(driven.values[k]);
            } else if (group.values[0] == driven.values[k]) {
                candidates.add(driven.values[k]);
                rows[driven.values[k]] = group.isRow() ? group.size : 1;
                sharedRows[driven.values[k]] = motion.ties.mayBeShared(group) ? rows[driven.values[k]] : 0;
            }
        }
        grouping = motion.ties.grouping();
        isStale = false;
    }

    /**
     * Whether the group of a body is late, and has not had its turn in the step.
     *
     * @param body index of its first body
     * @return false if it has its anchors
     */
    public boolean has(int body) {
        return late.size > 0 && (progress[body] == LATE || progress[body] == AHEAD);
    }

    /** {@return whether no group is late} */
    public boolean isEmpty() {
        return late.size == 0;
    }

    /** {@return the number of groups that are late and have gone through the step} */
    public int count() {
        int found = 0;
        for (int k = 0; k < late.size; k++) {
            found += progress[late.values[k]] == DONE ? 1 : 0;
        }
        return found;
    }

    /**
     * Moves a group through the step, without a path, or finds that a thread has done so.
     *
     * @param first index of its first body; it is late
     * @return how many driven bodies from the first on need not be looked at any more; 0 if the group has no quick way: then it
     *     is where it was, and not late any more
     */
    public int advance(int first) {
        IntList group = motion.companions(first);
        if (progress[first] == AHEAD || leaps(group, motion)) {
            progress[first] = DONE;
            motion.work.beginGroup();
            motion.work.takeOver(cost[first]);
            motion.work.endGroup(group.size);
            return rows[first];
        }
        refused = first;
        return 0;
    }

    /** How many driven bodies from the first one on are of a late group that a thread may move; 0 if the group is none. */
    int shares(int first) {
        return has(first) ? sharedRows[first] : 0;
    }

    /** Does that before it is the group's turn, in the thread of a motion. */
    boolean advanceAhead(IntList group, Motion by) {
        boolean yes = leaps(group, by);
        progress[group.values[0]] = yes ? AHEAD : PROMPT;
        return yes;
    }

    private boolean leaps(IntList group, Motion by) {
        int first = group.values[0];
        GroupPaths.copy(group, state.x(), startX);
        GroupPaths.copy(group, state.v(), startV);
        progress[first] = BEGUN;
        by.work.beginGroup();
        if (by.drivenMotion.leapsBlindly(group)) {
            cost[first] = by.work.spentApart();
            return true;
        }
        progress[first] = PROMPT;
        GroupPaths.anchor(trajectories, group, state.x(), state.v());
        return false;
    }

    /** Puts a group back to where it was, as if no thread had come to it; false if it is not late any more. */
    boolean takeBack(IntList group) {
        int first = group.values[0];
        if (late.size > 0 && (progress[first] == AHEAD || progress[first] == BEGUN)) {
            GroupPaths.copy(group, startX, state.x());
            GroupPaths.copy(group, startV, state.v());
            progress[first] = LATE;
        }
        return has(first);
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
     * @param team shares that, if it pays; null for the calling thread alone
     * @return the first bodies of the latter; valid until the next call
     */
    public IntList make(Team team) {
        made.clear();
        for (int k = 0; k < late.size; k++) {
            if (progress[late.values[k]] == DONE) {
                made.add(late.values[k]);
            }
        }
        motion.drivenMotion.ensure(); // no array grows any more
        if (team != null && late.size > 1 && team.pays(motion.driven().size, FEWEST_SHARED)) {
            if (team.run(this, late.size) >= 0) {
                Team.rethrow(team.failure());
            }
        } else {
            for (int k = 0; k < late.size; k++) {
                work(0, k);
            }
        }
        begin();
        return made;
    }

    /** Does that for a group. */
    @Override
    public void work(int worker, int item) {
        int first = late.values[item];
        IntList group = motion.companions(first);
        byte how = progress[first];
        if (how == LATE) {
            GroupPaths.anchor(trajectories, group, state.x(), state.v());
        } else if (how != PROMPT) {
            GroupPaths.anchor(trajectories, group, startX, startV);
        }
        if (how == DONE) {
            motion.drivenMotion.lead(group);
        }
    }
}
