// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.constraint.Onset;
import sim.physics.internal.DisjointSets;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;
import sim.physics.motion.State;

/** How near two bodies may come to one another in a step. */
final class Speeds implements Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;
    private final Poses poses;

    private final NearPairs near;

    /** What motors may give. */
    private final Onset onset;

    /** Whether the means are known. */
    private boolean areKnown;

    /** By body: parents in the sets of those that are awake and whose boxes meet, −1 for others; the ground that it is next to, −1 for none. */
    private int[] parents = {};

    private int[] grounds = {};

    /** By the least body of each set: how many have been counted, −1 if one of them is next to a ground; and the mean of their velocities. */
    private int[] counts = {};

    private double[] means = {};

    Speeds(State state, Poses poses, NearPairs near, Onset onset) {
        this.state = state;
        this.poses = poses;
        this.near = near;
        this.onset = onset;
    }

    /** Begins a step: the bodies have other velocities. */
    void begin() {
        areKnown = false;
    }

    /**
     * Finds mean velocities, against which bodies that bounce come towards others: who watches from elsewhere sees the same, and it matters to nobody what
     * moves far away. Next to what no force moves they are the velocity of that.
     */
    private void average() {
        areKnown = true;
        if (parents.length < state.size()) {
            parents = new int[Growth.length(parents.length, state.size())];
            grounds = new int[parents.length];
            counts = new int[parents.length];
            means = new double[2 * parents.length];
        }
        Arrays.fill(parents, 0, state.size(), -1);
        IntList awake = poses.awake;
        for (int k = 0; k < awake.size; k++) {
            int body = awake.values[k];
            parents[body] = poses.isGround(body) ? -1 : body;
            grounds[body] = -1;
            counts[body] = 0;
            means[2 * body] = 0;
            means[2 * body + 1] = 0;
        }
        for (int k = 0; k < near.order.size(); k++) {
            int pair = near.order.pair(k);
            if (!near.is(pair, NearPairs.FORBIDDEN)) {
                join(near.pairs().first(pair), near.pairs().second(pair));
            }
        }
        for (int k = 0; k < awake.size; k++) {
            hold(awake.values[k]);
        }
        for (int k = 0; k < awake.size; k++) {
            count(awake.values[k]);
        }
    }

    private void join(int first, int second) {
        if (parents[first] >= 0 && parents[second] >= 0) {
            DisjointSets.join(parents, first, second);
        } else if (parents[first] >= 0) {
            grounds[first] = grounds[first] < 0 ? second : grounds[first];
        } else if (parents[second] >= 0) {
            grounds[second] = grounds[second] < 0 ? first : grounds[second];
        }
    }

    /** Takes note of the ground that a body is next to. */
    private void hold(int body) {
        int ground = grounds[body];
        if (ground < 0) {
            return;
        }
        int root = DisjointSets.find(parents, body);
        boolean isFirst = counts[root] == 0;
        counts[root] = -1;
        if (isFirst && state.w().values()[State.BLOCK * ground] > 0) {
            means[2 * root] = state.v()[State.BLOCK * ground];
            means[2 * root + 1] = state.v()[State.BLOCK * ground + 1];
        }
    }

    private void count(int body) {
        if (parents[body] < 0) {
            return;
        }
        double[] v = state.v();
        int root = DisjointSets.find(parents, body);
        if (counts[root] >= 0) {
            counts[root]++;
            means[2 * root] += (v[State.BLOCK * body] - means[2 * root]) / counts[root];
            means[2 * root + 1] += (v[State.BLOCK * body + 1] - means[2 * root + 1]) / counts[root];
        }
    }

    /**
     * The way by which two bodies may come nearer.
     *
     * @param bounces whether they may bounce: then each may do so off a third one first
     * @param a accelerations by forces
     * @param h the step
     */
    double way(int first, int second, boolean bounces, double[] a, double h) {
        if (bounces && !areKnown) {
            average();
        }
        double bounced = bounces ? speed(first) + speed(second) : 0;
        return h * (Math.max(bounced, speed(first, second, a, h)) + onset.of(first) + onset.of(second));
    }

    private double speed(int first, int second, double[] a, double h) {
        double[] v = state.v();
        int i = State.BLOCK * first;
        int k = State.BLOCK * second;
        double x = Math.abs(v[k] - v[i]) + h * Math.abs(a[k] - a[i]);
        double y = Math.abs(v[k + 1] - v[i + 1]) + h * Math.abs(a[k + 1] - a[i + 1]);
        double turn = Math.abs(v[i + 2]) * poses.hull(first).bounding + Math.abs(v[k + 2]) * poses.hull(second).bounding;
        return Math.sqrt(x * x + y * y) + turn;
    }

    private double speed(int body) {
        double[] v = state.v();
        int b = State.BLOCK * body;
        int root = parents[body] < 0 ? -1 : DisjointSets.find(parents, body);
        double x = root < 0 ? 0 : v[b] - means[2 * root];
        double y = root < 0 ? 0 : v[b + 1] - means[2 * root + 1];
        return Math.sqrt(x * x + y * y) + Math.abs(v[b + 2]) * poses.hull(body).bounding;
    }
}
