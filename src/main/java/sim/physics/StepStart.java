// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import java.io.Serializable;
import java.util.Arrays;
import java.util.List;
import sim.physics.constraint.Constraints;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.State;

/**
 * Where bodies were when a step began in which joints act. In a pose in which these let nothing pass, or anything, a motion
 * that is followed with all its accelerations may go anywhere; then the step is made anew from here, by time stepping.
 */
final class StepStart implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Sizes of a body in a step, by which its velocity does not change within one. */
    private static final double FAR = 30;

    /** Of the numbers of a step, nothing outlasts it. */
    private transient double[] x;

    private transient double[] v;

    /** Notes the places and velocities of all bodies. */
    void keep(State state) {
        if (x == null || x.length < state.x().length) {
            x = Arrays.copyOf(state.x(), state.x().length);
            v = Arrays.copyOf(state.v(), state.v().length);
            return;
        }
        int n = State.BLOCK * state.size();
        System.arraycopy(state.x(), 0, x, 0, n);
        System.arraycopy(state.v(), 0, v, 0, n);
    }

    /** Puts a body back that was there when the step began. */
    void restore(int body, State state) {
        int b = State.BLOCK * body;
        System.arraycopy(x, b, state.x(), b, State.BLOCK);
        System.arraycopy(v, b, state.v(), b, State.BLOCK);
    }

    /** Whether a body's velocity is none that it can have got from where it was. */
    boolean hasLost(int body, State state, double h) {
        int b = State.BLOCK * body;
        double change = Math.abs(state.v()[b] - v[b]) + Math.abs(state.v()[b + 1] - v[b + 1]);
        return !(change * h <= FAR * state.body(body).getShape().boundingRadius());
    }

    /**
     * Whether a step was too long from its beginning on: a tied body turns by more than half a turn in it, or falls by more than its size.
     * Joints that could not be kept closed then are the author's affair.
     */
    boolean isTooLong(State state, Constraints constraints, List<ForceGenerator> forces, double h) {
        double pull = Relief.pull(forces);
        boolean yes = false;
        for (int k = 0; k < state.size() && !yes; k++) {
            if (state.body(k) != null && constraints.isTied(k)) {
                double size = state.body(k).getShape().boundingRadius();
                yes = Math.abs(v[State.BLOCK * k + State.THETA]) * h > Math.PI || pull * h * h > size;
            }
        }
        return yes;
    }
}
