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

    /** How much longer steps would be if they were not held for vibrations to die away, from which they are too short. */
    private static final double HELD = 2;

    /** The same is asked of groups of up to that many coordinates: dense systems of more cost more than short steps. */
    private static final int MOST_COORDINATES = 120;

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

    /** Number of coordinates of the step before: others than these are not compared with them. */
    private int[] size = {};
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
            size = Arrays.copyOf(size, n / State.BLOCK);
        }
    }

    /** Keeps the last stage of an explicit step, of a method that may ask nothing else since there are more bodies. */
    void keep(IntList bodies, Stages s) {
        ensure();
        for (int m = 0; m < s.size; m++) {
            int at = slot(bodies, m);
            x[at] = s.x[m];
            v[at] = s.v[m];
            a[at] = s.a[m];
        }
        size[bodies.values[0]] = s.size;
    }

    /** Where a coordinate of a group is kept: its bodies' blocks are its own. */
    private static int slot(IntList bodies, int m) {
        return State.BLOCK * bodies.values[m / State.BLOCK] + m % State.BLOCK;
    }

    /** Looks at an explicit step's end, where the next one begins. */
    void look(IntList bodies, Stages s) {
        int first = bodies.values[0];
        double h = size[first] == s.size ? length[first] : 0;
        for (int m = 0; m < s.size; m++) {
            s.offX[m] = s.a0[m] - a[slot(bodies, m)];
        }
        double slope = s.norm(s.offX);
        for (int m = 0; m < s.size; m++) {
            s.offX[m] = s.x0[m] - x[slot(bodies, m)];
            s.offV[m] = s.v0[m] - v[slot(bodies, m)];
        }
        double way = s.norm(s.offX, s.offV, h);
        boolean isHeld = s.held > HELD && s.size <= MOST_COORDINATES;
        ask(first, isHeld || h > 0 && h * h * slope > BOUND * way);
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
