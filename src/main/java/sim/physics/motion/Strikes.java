// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;

/** When driven bodies were struck last: their courses have changed then. */
final class Strikes implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Times that a body is struck in consecutive steps from which on that is often. */
    private static final int OFTEN = 3;

    /** By body: the step in which it was struck last, the offset in that, and how often until then in a row of steps. */
    private double[] in = {};

    private double[] at = {};
    private int[] inRow = {};

    Strikes() {
        // grows with the bodies
    }

    void ensure(int n) {
        int before = in.length;
        if (before < n) {
            in = Arrays.copyOf(in, n);
            at = Arrays.copyOf(at, n);
            inRow = Arrays.copyOf(inRow, n);
            Arrays.fill(in, before, n, Double.NaN);
        }
    }

    /** Shares what another one notes. */
    void match(Strikes other) {
        in = other.in;
        at = other.at;
        inRow = other.inRow;
    }

    void note(int body, double step, double offset) {
        if (body >= in.length) {
            return; // it has never been driven
        }
        inRow[body] = step - in[body] <= 1 ? inRow[body] + 1 : 1;
        in[body] = step;
        at[body] = offset;
    }

    /** Whether a body has been struck in a step. */
    boolean has(int body, double step) {
        return body < in.length && in[body] == step;
    }

    /** Whether it has been struck often of late. */
    boolean areOften(int body, double step) {
        return body < in.length && inRow[body] >= OFTEN && step - in[body] <= 1;
    }

    /** The offset of the last one in a step, 0 if there was none. */
    double last(int body, double step) {
        return has(body, step) ? at[body] : 0;
    }

    /** Whether some body of a group was struck last in this step where the group has its anchors. */
    boolean areAtAnchors(IntList group, Trajectories trajectories) {
        boolean yes = false;
        for (int k = 0; k < group.size; k++) {
            int body = group.values[k];
            yes |= has(body, trajectories.step()) && at[body] == trajectories.offset(body);
        }
        return yes;
    }
}
