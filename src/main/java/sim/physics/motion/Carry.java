// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;

/**
 * What rounding has left of the state vectors: sums x + d are kept with the part of d that x has no digits for, and which is
 * added the next time (Kahan 1965, Møller 1965). Without it a symplectic method's energy does drift in the end, by a
 * thousandth of a digit's unit in each step, but always to the same side.
 */
public final class Carry implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Change of a value, relative, by which a projection may have rounded it otherwise. */
    private static final double SAME = 0x1p-50;

    private double[] x = {};
    private double[] v = {};

    /** The values that belong to them. */
    private double[] leftX = {};

    private double[] leftV = {};

    /** Whether what is kept belongs to the values that a body has now: within a step of a method that carries it. */
    private boolean[] isHeld = {};

    Carry() {
        // grows with the state
    }

    void ensure(int n) {
        if (x.length < n) {
            x = Arrays.copyOf(x, n);
            v = Arrays.copyOf(v, n);
            leftX = Arrays.copyOf(leftX, n);
            leftV = Arrays.copyOf(leftV, n);
            isHeld = Arrays.copyOf(isHeld, n / State.BLOCK);
        }
    }

    /** Forgets the parts of values that have been written since {@link #end}. */
    void begin(State state, IntList bodies) {
        ensure(state.x().length);
        double[] stateX = state.x();
        double[] stateV = state.v();
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            isHeld[bodies.values[k]] = true;
            for (int end = b + State.BLOCK; b < end; b++) {
                if (!isSame(stateX[b], leftX[b])) {
                    x[b] = 0;
                }
                if (!isSame(stateV[b], leftV[b])) {
                    v[b] = 0;
                }
            }
        }
    }

    private static boolean isSame(double now, double then) {
        return Math.abs(now - then) <= SAME * Math.abs(then);
    }

    void end(State state, IntList bodies) {
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            isHeld[bodies.values[k]] = false;
            for (int end = b + State.BLOCK; b < end; b++) {
                leftX[b] = state.x()[b];
                leftV[b] = state.v()[b];
            }
        }
    }

    /**
     * Whether a body is within a step of a method that carries what rounding leaves.
     *
     * @param body its index
     * @return false outside such steps, where the state vectors are all there is
     */
    public boolean isHeld(int body) {
        return body < isHeld.length && isHeld[body];
    }

    /**
     * What rounding has left of positions.
     *
     * @return by place in the position vector; it holds for bodies that are held
     */
    public double[] lowX() {
        return x;
    }

    /**
     * What rounding has left of velocities.
     *
     * @return by place in the velocity vector; it holds for bodies that are held
     */
    public double[] lowV() {
        return v;
    }

    /**
     * Adds to a position.
     *
     * @param to the position vector
     * @param at which value
     * @param d what to add
     */
    public void addX(double[] to, int at, double d) {
        add(to, x, at, d);
    }

    /**
     * Adds to a velocity.
     *
     * @param to the velocity vector
     * @param at which value
     * @param d what to add
     */
    public void addV(double[] to, int at, double d) {
        add(to, v, at, d);
    }

    /** The way of a time at a velocity. */
    double way(double[] velocities, int at, double time) {
        return time * velocities[at] + time * v[at];
    }

    private static void add(double[] to, double[] low, int at, double d) {
        double old = to[at];
        double all = d + low[at];
        double sum = old + all;
        double part = sum - old;
        low[at] = (old - (sum - part)) + (all - part);
        to[at] = sum;
    }
}
