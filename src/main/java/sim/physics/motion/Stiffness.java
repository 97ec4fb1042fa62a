// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;

/**
 * Whether the steps of an explicit method are held small by its stability and not by the motion: two evaluations at the end
 * of a step say how fast the fastest change is (Shampine 1977; Hairer and Wanner, <i>Solving Ordinary Differential
 * Equations II</i>, 2nd edition, IV.2).
 */
final class Stiffness implements Serializable {
    private static final long serialVersionUID = 1L;

    /** The step times the rate of the fastest change from which a step may be held by it. */
    private static final double BOUND = 5;

    /** And below which it is not, so that an explicit method is cheaper. */
    private static final double SMOOTH = 1;

    /** Steps that ask for the other method before it is taken, and steps in a row that make it forget them. */
    private static final int STEPS = 15;

    private static final int CALM = 6;

    private final Path path;

    /** The last stage, at the end of the step, by block. */
    private double[] x = {};

    private double[] v = {};
    private double[] a = {};

    /** Steps that asked for the other method, and that did not since; whether the implicit one is used; by first body. */
    private int[] count = {};

    private int[] calm = {};

    private boolean[] isStiff = {};
    private double[] length = {};

    Stiffness(Path path) {
        this.path = path;
    }

    /** Whether a group wants the implicit method. */
    boolean isStiff(IntList bodies) {
        ensure();
        return isStiff[bodies.values[0]];
    }

    private void ensure() {
        int n = path.stage.length;
        if (x.length < n) {
            x = Arrays.copyOf(x, n);
            v = Arrays.copyOf(v, n);
            a = Arrays.copyOf(a, n);
            count = Arrays.copyOf(count, n / State.BLOCK);
            calm = Arrays.copyOf(calm, n / State.BLOCK);
            isStiff = Arrays.copyOf(isStiff, n / State.BLOCK);
            length = Arrays.copyOf(length, n / State.BLOCK);
        }
    }

    /** Keeps the last stage of an explicit step. */
    void keep(State state, IntList bodies, double[] acceleration) {
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            System.arraycopy(state.x(), b, x, b, State.BLOCK);
            System.arraycopy(state.v(), b, v, b, State.BLOCK);
            System.arraycopy(acceleration, b, a, b, State.BLOCK);
        }
    }

    /** Looks at an explicit step's end, where the next one begins. */
    void look(IntList bodies, Stages s) {
        int first = bodies.values[0];
        double h = length[first];
        double slope = 0;
        double way = 0;
        for (int k = 0, m = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int end = b + State.BLOCK; b < end; b++, m++) {
                slope = Math.max(slope, s.weight[m] * Math.abs(s.a0[m] - a[b]));
                double off = Math.max(Math.abs(s.x0[m] - x[b]), h * Math.abs(s.v0[m] - v[b]));
                way = Math.max(way, s.weight[m] * off);
            }
        }
        ask(first, h > 0 && h * h * slope > BOUND * way);
        length[first] = 0;
    }

    /** Notes that an explicit step was made. */
    void stepped(IntList bodies, double h) {
        length[bodies.values[0]] = Math.abs(h);
    }

    /** Looks at an implicit step. */
    void look(IntList bodies, double stiffness) {
        ask(bodies.values[0], stiffness < SMOOTH);
    }

    private void ask(int first, boolean change) {
        count[first] += change ? 1 : 0;
        calm[first] = change ? 0 : calm[first] + 1;
        if (calm[first] == CALM) {
            count[first] = 0;
        }
        if (count[first] >= STEPS) {
            isStiff[first] = !isStiff[first];
            count[first] = 0;
        }
    }
}
