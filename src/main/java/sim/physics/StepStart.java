// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics;

import java.io.Serializable;
import java.util.List;
import java.util.function.IntPredicate;
import sim.physics.constraint.Constraints;
import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.State;
import sim.physics.motion.Steering;

/**
 * Where bodies were when a step began in which joints act. In a pose in which these let nothing pass, or anything, a motion
 * that is followed with all its accelerations may go anywhere; then the step is made anew from here, by time stepping.
 */
final class StepStart implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Sizes of a body in a step, by which its velocity does not change within one. */
    private static final double FAR = 30;

    /**
     * How many times as fast as anything was, or is driven, a body is that has been thrown out. What is pressed past a wall gets out of the way at any speed
     * as that becomes narrow, and is what the last digits of places say.
     */
    private static final double THROWN = 4;

    /** Of the numbers of a step, nothing outlasts it. */
    private transient double[] x;

    private transient double[] v;

    /** The bodies: one that a listener adds within the step was nowhere. */
    private transient Body[] bodies;

    /** Notes the places and velocities of all bodies. */
    void keep(State state) {
        int n = State.BLOCK * state.size();
        if (x == null || x.length < state.x().length) {
            x = state.x().clone();
            v = state.v().clone();
            bodies = new Body[x.length / State.BLOCK];
        } else {
            System.arraycopy(state.x(), 0, x, 0, n);
            System.arraycopy(state.v(), 0, v, 0, n);
        }
        for (int k = 0; k < bodies.length; k++) {
            bodies[k] = k < state.size() ? state.body(k) : null;
        }
    }

    private boolean has(int body, State state) {
        return bodies != null && body < bodies.length && bodies[body] == state.body(body) && bodies[body] != null;
    }

    /** Puts a body back if it was there when the step began. */
    void restore(int body, State state) {
        int b = State.BLOCK * body;
        if (has(body, state)) {
            System.arraycopy(x, b, state.x(), b, State.BLOCK);
            System.arraycopy(v, b, state.v(), b, State.BLOCK);
        }
    }

    /** Whether a body's velocity is none that it can have got from where it was. */
    boolean hasLost(int body, State state, double h) {
        if (!has(body, state)) {
            return false;
        }
        int b = State.BLOCK * body;
        double change = Math.abs(state.v()[b] - v[b]) + Math.abs(state.v()[b + 1] - v[b + 1]);
        return !(change * h <= FAR * state.body(body).getShape().boundingRadius());
    }

    /**
     * Whether some free body is many times as fast as all were when the step began, or as forces and bodies that nothing moves make them, by a push of
     * these.
     *
     * @param part part of the step that is over
     */
    boolean isThrown(State state, Steering steering, IntPredicate areFree, double part, double h) {
        double pushed = steering.pushed(part);
        double fastest = 0;
        for (int k = 0; pushed > 0 && k < state.size(); k++) {
            fastest = isDynamic(state, k) ? Math.max(fastest, of(v, k)) : fastest;
        }
        fastest += steering.fastest() + h * steering.pull();
        boolean is = false;
        for (int k = 0; pushed > 0 && k < state.size() && !is; k++) {
            if (isDynamic(state, k) && of(state.v(), k) > THROWN * fastest && areFree.test(k)) {
                Body body = state.body(k);
                double got = of(state.v(), k) - of(v, k);
                is = of(state.v(), k) > THROWN * (fastest + h * Steering.applied(body)) && body.getMass() * got < THROWN * pushed;
            }
        }
        return is;
    }

    private boolean isDynamic(State state, int k) {
        return has(k, state) && bodies[k].isDynamic();
    }

    private static double of(double[] v, int k) {
        return Math.abs(v[State.BLOCK * k]) + Math.abs(v[State.BLOCK * k + 1]);
    }

    /**
     * Whether a step was too long from its beginning on: a tied body turns by more than half a turn in it, or falls by more than its size.
     * Joints that could not be kept closed then are the author's affair.
     */
    boolean isTooLong(State state, Constraints constraints, List<ForceGenerator> forces, double h) {
        double pull = Relief.pull(forces);
        boolean yes = false;
        for (int k = 0; k < state.size() && !yes; k++) {
            if (has(k, state) && constraints.isTied(k)) {
                double size = state.body(k).getShape().boundingRadius();
                yes = Math.abs(v[State.BLOCK * k + State.THETA]) * h > Math.PI || pull * h * h > size;
            }
        }
        return yes;
    }
}
