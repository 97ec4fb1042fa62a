// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.constraint.TieRows;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;
import sim.physics.motion.SpringRows;
import sim.physics.motion.State;
import sim.physics.motion.Steering;

/**
 * Bodies that move as their authors say and that nothing can move while a step is solved, as if they were fixed in a frame of their own: what lies on one
 * of them knows nothing of what else does. Their course is given, so that they are as heavy as can be, W = 0.
 *
 * <p>What they give others is work, which the books of energy must know of. For bodies that touch but one of them, or several that go as one, there is none
 * in its frame. One that turns, and one that something touches, or is tied to, which touches another ground, too, are heavy only.
 */
final class Grounds implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int BLOCK = State.BLOCK;

    private final State state;
    private final Poses poses;

    /** Those that nothing can move now, in ascending order, and what they weigh else. */
    final IntList held = new IntList();

    /** Those of them that joints or stiff springs tie. */
    final IntList tied = new IntList();

    private double[] weights = {};

    /** Where they are, and their velocities, while they are elsewhere. */
    private double[] places = {};

    private double[] speeds = {};

    /** Scratch: what is tied. */
    private boolean[] areTied = {};

    Grounds(State state, Poses poses) {
        this.state = state;
        this.poses = poses;
    }

    /**
     * Lets nothing move those that may be a ground, until {@link #release}.
     *
     * @param isBooked whether books of energy are kept
     * @param areRubbed whether friction with the plane acts, which is another ground to all
     */
    void hold(TieRows ties, SpringRows springs, boolean isBooked, boolean areRubbed) {
        release();
        if (poses.steered.size == 0 || isBooked && areRubbed) {
            return;
        }
        int n = state.x().length / BLOCK;
        areTied = areTied.length < n ? new boolean[n] : areTied;
        Arrays.fill(areTied, false);
        if (isBooked) {
            ties.mark(areTied);
            springs.mark(areTied);
        }
        for (int k = 0; k < poses.steered.size; k++) {
            int body = poses.steered.values[k];
            if (!Steering.turns(state.body(body))) {
                hold(body);
            }
        }
    }

    private void hold(int body) {
        int o = BLOCK * held.size;
        if (weights.length <= o) {
            int length = BLOCK * Growth.length(o / BLOCK, held.size + 1);
            weights = Arrays.copyOf(weights, length);
            places = new double[length];
            speeds = new double[length];
        }
        held.add(body);
        if (areTied[body]) {
            tied.add(body);
        }
        double[] w = state.w().values();
        System.arraycopy(w, BLOCK * body, weights, o, BLOCK);
        Arrays.fill(w, BLOCK * body, BLOCK * body + BLOCK, 0);
    }

    /** Whether a body is one of them. */
    boolean has(int body) {
        return held.size > 0 && state.w().values()[BLOCK * body] == 0 && !state.body(body).isImmobile();
    }

    /** Lets a body be moved that is one of them. */
    void release(int body) {
        int k = 0;
        while (held.values[k] != body) {
            k++;
        }
        System.arraycopy(weights, BLOCK * k, state.w().values(), BLOCK * body, BLOCK);
        System.arraycopy(weights, BLOCK * k + BLOCK, weights, BLOCK * k, BLOCK * (held.size - 1 - k));
        held.takeOut(body);
        if (areTied[body]) {
            tied.takeOut(body);
        }
    }

    /** Lets all of them be moved. */
    void release() {
        for (int k = 0; k < held.size; k++) {
            System.arraycopy(weights, BLOCK * k, state.w().values(), BLOCK * held.values[k], BLOCK);
        }
        held.clear();
        tied.clear();
    }

    /** Notes where they are, and their velocities. */
    void note() {
        for (int k = 0; k < held.size; k++) {
            System.arraycopy(state.x(), BLOCK * held.values[k], places, BLOCK * k, BLOCK);
            System.arraycopy(state.v(), BLOCK * held.values[k], speeds, BLOCK * k, BLOCK);
        }
    }

    /** Puts them where they were, at rest. */
    void takeBack(double[] where) {
        for (int k = 0; k < held.size; k++) {
            int b = BLOCK * held.values[k];
            System.arraycopy(where, b, state.x(), b, BLOCK);
            Arrays.fill(state.v(), b, b + BLOCK, 0);
        }
    }

    /** Gives them the velocities back that were noted. */
    void bringBack() {
        for (int k = 0; k < held.size; k++) {
            System.arraycopy(speeds, BLOCK * k, state.v(), BLOCK * held.values[k], BLOCK);
        }
    }

    /** Puts them back where they were when that was noted. */
    void putBack() {
        for (int k = 0; k < held.size; k++) {
            System.arraycopy(places, BLOCK * k, state.x(), BLOCK * held.values[k], BLOCK);
        }
    }
}
