// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import sim.physics.internal.IntList;
import sim.physics.motion.State;
import sim.physics.motion.Touched;

/**
 * Lets tied bodies follow what authors have set of some of them, where joints yield: what joints were open by, and what they had of velocities that
 * they do not allow, stays as it was. So what is set to what it was changes nothing, and what is set in each step is not closed in each step.
 */
public final class SetBodies implements Serializable {
    private static final long serialVersionUID = 1L;

    /** By how much more than before a joint may be open, for what is set to have left it as it was. */
    private static final double MORE = 2;

    /** Changes of velocities, by blocks of the state. */
    private double[] change = {};

    /** Places or velocities of the island as they are set. */
    private double[] now = {};

    /** How far joints were open: of each, lengths and angles. */
    private double[] gaps = {};

    /**
     * Gives an island the velocities that joints let it have when those of some bodies have been set.
     *
     * @param constraints all
     * @param island the bodies
     * @param state the state vectors
     * @return false if joints are others, or have been opened, so that they have to be closed: then nothing has been done
     */
    public boolean follow(Constraints constraints, IntList island, State state) {
        Touched touched = state.touched();
        for (int k = 0; k < island.size; k++) {
            if (touched.isRetied(island.values[k])) {
                return false;
            }
        }
        change = change.length < state.x().length ? new double[state.x().length] : change;
        now = now.length < State.BLOCK * island.size ? new double[State.BLOCK * island.size] : now;
        if (putBack(island, state.touched(), state.x(), false) && areOpened(joints(constraints, island, state), island, state)) {
            return false;
        }
        if (putBack(island, state.touched(), state.v(), true)) {
            give(constraints, island, state.v());
        }
        return true;
    }

    /** Puts places or velocities back to where they were, and keeps those of now; false if they are the same. */
    private boolean putBack(IntList island, Touched touched, double[] values, boolean areVelocities) {
        boolean any = false;
        for (int k = 0, at = 0; k < island.size; k++) {
            int body = island.values[k];
            for (int c = 0, s = State.BLOCK * body; c < State.BLOCK; c++, s++, at++) {
                now[at] = values[s];
                values[s] = touched.before(body, c, values, areVelocities);
                any |= values[s] != now[at];
            }
        }
        return any;
    }

    /** An island in which no motor or stop acts. */
    private static Island joints(Constraints constraints, IntList island, State state) {
        return constraints.of[island.values[0]].island().switches.evaluateReleased(state);
    }

    /** Puts bodies to where they are now; returns whether their joints are more open than they were before. */
    private boolean areOpened(Island joints, IntList island, State state) {
        int n = joints.constraints.length;
        gaps = gaps.length < 2 * n ? new double[2 * n] : gaps;
        joints.evaluate(state);
        for (int k = 0; k < n; k++) {
            gaps[2 * k] = Slack.gap(joints, k, false);
            gaps[2 * k + 1] = Slack.gap(joints, k, true);
        }
        for (int k = 0; k < State.BLOCK * island.size; k++) {
            state.x()[slot(island, k)] = now[k];
        }
        joints.evaluate(state);
        boolean are = false;
        for (int k = 0; k < n && !are; k++) {
            are = Slack.gap(joints, k, false) > Math.max(MORE * gaps[2 * k], Admissible.CLOSED * joints.constraints[k].getSize())
                    || Slack.gap(joints, k, true) > Math.max(MORE * gaps[2 * k + 1], Admissible.CLOSED);
        }
        return are;
    }

    /** Gives the velocities, of what was set, that joints allow. */
    private void give(Constraints constraints, IntList island, double[] v) {
        int n = State.BLOCK * island.size;
        for (int k = 0; k < n; k++) {
            int s = slot(island, k);
            change[s] = now[k] - v[s];
        }
        constraints.prepareImpact(island);
        constraints.reply(island.values[0], change);
        for (int k = 0; k < n; k++) {
            v[slot(island, k)] += change[slot(island, k)];
        }
    }

    private static int slot(IntList island, int k) {
        return State.BLOCK * island.values[k / State.BLOCK] + k % State.BLOCK;
    }
}
