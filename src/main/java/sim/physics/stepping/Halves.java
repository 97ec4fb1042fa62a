// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import sim.physics.internal.IntList;
import sim.physics.motion.State;
import sim.physics.motion.Steering;
import sim.physics.motion.SteppedForces;

/**
 * The halves of a substep: of forces, and of the impulses of the substep before, one half acts before the bodies move, the other one after, along
 * levers as they are then. With what joints ask for in both places that is the method of Andersen (<i>Rattle: a velocity version of the Shake
 * algorithm</i>, 1983), of second order and without a drift of energy, as far as the impulses are found. All of them at once, before the move,
 * would bend no path until it is too late: joints would take energy from all that turns.
 */
final class Halves implements Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;
    private final Poses poses;
    private final SteppedForces forces;

    /** Velocities before; later, the half of what is given; later, accelerations before. */
    private double[] half = {};

    private double[] mean = {};

    Halves(State state, Poses poses, SteppedForces forces) {
        this.state = state;
        this.poses = poses;
        this.forces = forces;
    }

    /** Finds accelerations: those of forces, and of courses, on which forces do nothing. */
    void load(double[] a, double time) {
        forces.load(poses.awake, time, a);
        for (int k = 0; k < poses.steered.size; k++) {
            Steering.accelerate(state.body(poses.steered.values[k]), a);
        }
    }

    /** Adds what forces give, all of it for now. */
    void accelerate(double[] a, double d) {
        double[] v = state.v();
        if (half.length < a.length) {
            half = new double[a.length];
        }
        for (int k = 0; k < poses.awake.size; k++) {
            int b = State.BLOCK * poses.awake.values[k]; // three by three, as a loop of three costs more than what it does
            half[b] = v[b];
            half[b + 1] = v[b + 1];
            half[b + 2] = v[b + 2];
            v[b] += d * a[b];
            v[b + 1] += d * a[b + 1];
            v[b + 2] += d * a[b + 2];
        }
    }

    /** {@return the velocities of before: what is added to these, too, is not halved; after a reload, the accelerations of before} */
    double[] before() {
        return half;
    }

    /** Takes half of what has been given off again. */
    void halve() {
        double[] v = state.v();
        for (int k = 0; k < poses.awake.size; k++) {
            int b = State.BLOCK * poses.awake.values[k];
            half[b] = 0.5 * (v[b] - half[b]);
            half[b + 1] = 0.5 * (v[b + 1] - half[b + 1]);
            half[b + 2] = 0.5 * (v[b + 2] - half[b + 2]);
            v[b] -= half[b];
            v[b + 1] -= half[b + 1];
            v[b + 2] -= half[b + 2];
        }
    }

    /** Moves the bodies, and gives the other half. */
    void move(double d) {
        double[] x = state.x();
        double[] v = state.v();
        for (int k = 0; k < poses.awake.size; k++) {
            int b = State.BLOCK * poses.awake.values[k];
            x[b] += d * v[b];
            x[b + 1] += d * v[b + 1];
            x[b + 2] += d * v[b + 2];
            v[b] += half[b];
            v[b + 1] += half[b + 1];
            v[b + 2] += half[b + 2];
        }
    }

    /** {@return accelerations in the mean of a substep in which forces have been reloaded} */
    double[] mean(double[] a) {
        if (mean.length < a.length) {
            mean = new double[a.length];
        }
        System.arraycopy(a, 0, mean, 0, a.length);
        for (int k = 0; k < poses.awake.size; k++) {
            int b = State.BLOCK * poses.awake.values[k];
            mean[b] = 0.5 * (half[b] + a[b]);
            mean[b + 1] = 0.5 * (half[b + 1] + a[b + 1]);
            mean[b + 2] = 0.5 * (half[b + 2] + a[b + 2]);
        }
        return mean;
    }

    /** Finds the forces once more where these bodies have moved on, and returns those of before. */
    double[] loadAgain(IntList bodies, double[] a, double time) {
        System.arraycopy(a, 0, half, 0, a.length);
        if (forces.areCoupled()) {
            load(a, time);
        } else {
            forces.load(bodies, time, a);
        }
        return half;
    }

    /** Forces that change within the step: their second half is that of where the bodies have gone. */
    void reload(double[] a, double time, double d) {
        double[] v = state.v();
        System.arraycopy(a, 0, half, 0, a.length);
        load(a, time);
        for (int k = 0; k < poses.awake.size; k++) {
            int b = State.BLOCK * poses.awake.values[k];
            v[b] += 0.5 * d * (a[b] - half[b]);
            v[b + 1] += 0.5 * d * (a[b + 1] - half[b + 1]);
            v[b + 2] += 0.5 * d * (a[b + 2] - half[b + 2]);
        }
    }
}
