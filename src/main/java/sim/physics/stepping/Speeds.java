// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import sim.physics.constraint.Onset;
import sim.physics.motion.State;

/** How near two bodies may come to one another in a step. */
final class Speeds implements Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;
    private final Poses poses;

    /** What motors may give. */
    private final Onset onset;

    /** The mean velocity of what is awake. */
    private double meanX;

    private double meanY;

    Speeds(State state, Poses poses, Onset onset) {
        this.state = state;
        this.poses = poses;
        this.onset = onset;
    }

    /** Finds the mean velocity, against which bodies that bounce come towards others: whoever watches from elsewhere sees the same. */
    void average() {
        double[] v = state.v();
        meanX = 0;
        meanY = 0;
        for (int k = 0; k < poses.awake.size; k++) {
            meanX += v[State.BLOCK * poses.awake.values[k]] / poses.awake.size;
            meanY += v[State.BLOCK * poses.awake.values[k] + 1] / poses.awake.size;
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
        double x = v[b] - meanX;
        double y = v[b + 1] - meanY;
        return Math.sqrt(x * x + y * y) + Math.abs(v[b + 2]) * poses.hull(body).bounding;
    }
}
