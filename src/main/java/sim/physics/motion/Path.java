// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;

/**
 * The cubic paths of bodies over a step: x(d) = x0 + d (v0 + d (a + d j)). By the body's block, 3 per body; plus the
 * workspace that integrators share.
 */
public final class Path implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Part of the velocities below which what the ends say of the third derivative is rounding. */
    static final double ROUNDING = 0x1p-49;

    /** Half the second derivatives, 3n. */
    double[] a = {};

    /** A sixth of the third derivatives, 3n. */
    double[] j = {};

    /** Accelerations at a stage, 3n. */
    double[] stage = {};

    /** Positions and velocities at the start, and their weighted sums, 3n each. */
    double[] x0 = {};

    double[] v0 = {};
    double[] sumX = {};
    double[] sumV = {};

    /** Accelerations at the start, 3n, and whether they are known. */
    double[] first = {};

    boolean knowsFirst;

    /** Whether the next step of RK4 begins where they are those of its first stage. */
    boolean isAtStart;

    /** The step that such a method would make next, by the first body of a group; 0: not known. */
    double[] next = {};

    /** The same by the last step alone, wherever that had to end. */
    double[] proposed = {};

    /** The longest step that it would have made lately, and when. */
    double[] pace = {};

    double[] paceTime = {};

    /** The greatest speed and acceleration of late, in tolerances. */
    double[] speed = {};

    double[] push = {};

    /** The part of errors that ties let pass, in the mean of late; 0: not known. */
    double[] freedom = {};

    /** The length of the last step. */
    double[] made = {};

    /** Number of steps since then that were much shorter. */
    int[] hasty = {};

    /** Null unless a method that chooses by stiffness is used. */
    Stiffness stiffness;

    /** How long explicit steps may be for what is fast to die away. */
    final StableStep stable = new StableStep();

    /** Their stages. */
    final Stages stages = new Stages();

    /** Makes room for no body. */
    public Path() {
        // grows with the state
    }

    void ensure(int length) {
        if (a.length < length) {
            a = Arrays.copyOf(a, length);
            j = Arrays.copyOf(j, length);
            stage = Arrays.copyOf(stage, length);
            x0 = Arrays.copyOf(x0, length);
            v0 = Arrays.copyOf(v0, length);
            sumX = Arrays.copyOf(sumX, length);
            sumV = Arrays.copyOf(sumV, length);
            first = Arrays.copyOf(first, length);
            next = Arrays.copyOf(next, length / State.BLOCK);
            proposed = Arrays.copyOf(proposed, next.length);
            pace = Arrays.copyOf(pace, next.length);
            speed = Arrays.copyOf(speed, next.length);
            push = Arrays.copyOf(push, next.length);
            freedom = Arrays.copyOf(freedom, next.length);
            made = Arrays.copyOf(made, next.length);
            hasty = Arrays.copyOf(hasty, next.length);
            paceTime = Arrays.copyOf(paceTime, next.length);
        }
    }

    /** Shares the arrays of another one, but for the workspace of methods that choose their steps. */
    void match(Path other) {
        a = other.a;
        j = other.j;
        stage = other.stage;
        x0 = other.x0;
        v0 = other.v0;
        sumX = other.sumX;
        sumV = other.sumV;
        first = other.first;
        next = other.next;
    }

    /** Forgets how long the last steps of a group were, which say nothing of the next ones. */
    void forgetSteps(int first) {
        next[first] = 0;
        proposed[first] = 0;
        made[first] = 0;
    }

    /** Takes the accelerations of the stage for those at the start, unless these are known. */
    void takeFirst(IntList bodies) {
        for (int k = 0; k < bodies.size && !knowsFirst; k++) {
            System.arraycopy(stage, State.BLOCK * bodies.values[k], first, State.BLOCK * bodies.values[k], State.BLOCK);
        }
        knowsFirst = true;
    }

    /** Takes the accelerations at the start for those of the stage, if that is where a step begins. */
    boolean putFirst(IntList bodies) {
        boolean yes = isAtStart && knowsFirst;
        for (int k = 0; k < bodies.size && yes; k++) {
            System.arraycopy(first, State.BLOCK * bodies.values[k], stage, State.BLOCK * bodies.values[k], State.BLOCK);
        }
        isAtStart = false;
        return yes;
    }

    /** Keeps where the bodies are at the start. */
    void start(State state, IntList bodies) {
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            System.arraycopy(state.x(), b, x0, b, State.BLOCK);
            System.arraycopy(state.v(), b, v0, b, State.BLOCK);
        }
    }

    /** The cubics from there to where they are now. */
    void join(State state, IntList bodies, double h) {
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int end = b + State.BLOCK; b < end; b++) {
                cubic(b, (state.x()[b] - x0[b]) / h, v0[b], state.v()[b], h);
            }
        }
    }

    /** The cubics from places and velocities to where bodies are now; the last is the reciprocal of the time. */
    void join(IntList bodies, double[] fromX, double[] fromV, State state, double per) {
        double[] x = state.x();
        double[] v = state.v();
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            cubicPer(b, (x[b] - fromX[b]) * per, fromV[b], v[b], per);
            cubicPer(b + 1, (x[b + 1] - fromX[b + 1]) * per, fromV[b + 1], v[b + 1], per);
            cubicPer(b + 2, (x[b + 2] - fromX[b + 2]) * per, fromV[b + 2], v[b + 2], per);
        }
    }

    /** The same where the ends are too near for a difference of places: by the accelerations at the start, which are known; none if there is no time. */
    void joinBriefly(IntList bodies, double[] fromV, State state, double h) {
        for (int k = 0; k < bodies.size && h != 0; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int end = b + State.BLOCK; b < end; b++) {
                a[b] = 0.5 * first[b];
                j[b] = ((state.v()[b] - fromV[b]) / h - first[b]) / (3 * h);
            }
        }
    }

    /** The path is a straight line. */
    void straight(int b) {
        a[b] = 0;
        j[b] = 0;
    }

    /** The cubic through both ends; the last is the reciprocal of the step. */
    void cubicPer(int b, double mean, double start, double end, double per) {
        double bend = start + end - 2 * mean;
        if (Math.abs(bend) <= ROUNDING * (Math.abs(start) + Math.abs(end))) {
            a[b] = 0.5 * per * (end - start);
            j[b] = 0;
            return;
        }
        a[b] = per * (3 * mean - 2 * start - end);
        j[b] = per * per * bend;
    }

    /** The cubic through both ends, given the mean velocity of the step and the velocities at its ends. */
    void cubic(int b, double mean, double start, double end, double h) {
        double bend = start + end - 2 * mean;
        if (Math.abs(bend) <= ROUNDING * (Math.abs(start) + Math.abs(end))) {
            a[b] = (end - start) / (2 * h); // a short step, whose third derivative is lost in rounding
            j[b] = 0;
            return;
        }
        a[b] = (3 * mean - 2 * start - end) / h;
        j[b] = bend / (h * h);
    }
}
