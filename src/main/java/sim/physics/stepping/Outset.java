// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;
import sim.physics.motion.State;

/** How a step begins: with which forces, and where the bodies are, which go back there if it ends nowhere. */
final class Outset implements Serializable {
    private static final long serialVersionUID = 1L;

    private final State state;

    /** Those that are awake, and what touches. */
    private final IntList bodies;

    private final ContactRows rows;

    /** Accelerations by forces, in this step and in the one before. */
    double[] a = {};

    double[] before = {};

    /** Whether the step has been solved that was begun last. */
    private boolean isOver = true;

    /** Places and velocities of those that are awake; nothing outlasts the step. */
    private transient double[] x;

    private transient double[] v;

    Outset(State state, IntList bodies, ContactRows rows) {
        this.state = state;
        this.bodies = bodies;
        this.rows = rows;
    }

    /** A body is new: nothing pulls at it yet, nor ever if it is fixed; what was in its place was pulled at. */
    void add(int body) {
        int b = State.BLOCK * body;
        if (b < a.length) {
            Arrays.fill(a, b, b + State.BLOCK, 0);
            Arrays.fill(before, b, b + State.BLOCK, 0);
        }
    }

    /** Begins a step, whose forces are to be found; one that was not solved begins anew. */
    void begin() {
        int n = state.x().length;
        if (a.length < n) {
            a = Arrays.copyOf(a, n);
            before = Arrays.copyOf(before, n);
        }
        if (isOver) {
            System.arraycopy(a, 0, before, 0, a.length);
            isOver = false;
        }
    }

    /** Notes where the bodies are. */
    void note() {
        if (x == null || x.length < a.length) {
            x = new double[a.length];
            v = new double[a.length];
        }
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            copy(state.x(), x, b);
            copy(state.v(), v, b);
        }
    }

    private static void copy(double[] from, double[] to, int b) {
        to[b] = from[b];
        to[b + 1] = from[b + 1];
        to[b + 2] = from[b + 2];
    }

    /** {@return a body whose place or velocity is no number, −1 if there is none} */
    int lost() {
        double[] x = state.x();
        double[] v = state.v();
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            if (!areNumbers(x, b) || !areNumbers(v, b)) {
                return bodies.values[k];
            }
        }
        for (int k = 0; k < rows.count; k++) { // fixed ones get nothing of an impulse, unless that is infinite
            if (!areNumbers(v, State.BLOCK * rows.first(k)) || !areNumbers(v, State.BLOCK * rows.second(k))) {
                return areNumbers(v, State.BLOCK * rows.first(k)) ? rows.first(k) : rows.second(k);
            }
        }
        return -1;
    }

    private static boolean areNumbers(double[] values, int b) {
        return 0 * values[b] + 0 * values[b + 1] + 0 * values[b + 2] == 0; // else NaN
    }

    /** Puts all back to where they were, from where they begin anew. */
    void putBack() {
        for (int k = 0; k < rows.count; k++) {
            rest(rows.first(k));
            rest(rows.second(k));
        }
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            copy(x, state.x(), b);
            copy(v, state.v(), b);
            state.touch(bodies.values[k]);
        }
    }

    private void rest(int body) {
        if (state.body(body).isImmobile()) {
            Arrays.fill(state.v(), State.BLOCK * body, State.BLOCK * body + State.BLOCK, 0);
        }
    }

    /** The step is over. */
    void end() {
        isOver = true;
    }
}
