// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.util.Arrays;
import sim.physics.internal.IntList;

/** Anchors and paths of all bodies of a group; where their blocks lie side by side, the loops need not look them up. */
final class GroupPaths {
    private GroupPaths() {}

    /** Anchors bodies at the start of a step, as {@link Trajectories#anchor} does. */
    static void anchor(Trajectories paths, IntList bodies, double[] x, double[] v) {
        double[] m = paths.data();
        double[] k = bodies.size > 0 ? paths.unfold() : m;
        double step = paths.step();
        if (bodies.isRow()) {
            int end = Trajectories.STRIDE * (bodies.values[0] + bodies.size);
            int b = State.BLOCK * bodies.values[0];
            for (int o = Trajectories.STRIDE * bodies.values[0]; o < end; o += Trajectories.STRIDE) {
                anchor(m, k, o, x, v, b, step);
                b += State.BLOCK;
            }
            return;
        }
        for (int body = 0; body < bodies.size; body++) {
            anchor(m, k, Trajectories.STRIDE * bodies.values[body], x, v, State.BLOCK * bodies.values[body], step);
        }
    }

    private static void anchor(double[] m, double[] k, int o, double[] x, double[] v, int b, double step) {
        m[o] = x[b];
        m[o + 1] = x[b + 1];
        m[o + 2] = x[b + 2];
        m[o + Trajectories.VX] = v[b];
        m[o + Trajectories.VY] = v[b + 1];
        m[o + Trajectories.OMEGA] = v[b + 2];
        k[o + Trajectories.AX] = 0;
        k[o + Trajectories.AY] = 0;
        k[o + Trajectories.ATHETA] = 0;
        k[o + Trajectories.JX] = 0;
        k[o + Trajectories.JY] = 0;
        k[o + Trajectories.JTHETA] = 0;
        m[o + Trajectories.STEP] = step;
        m[o + Trajectories.OFFSET] = 0;
    }

    /**
     * Lets bodies' paths be the cubics from their anchors to where the state vectors have them, as {@link Path} does.
     *
     * @param paths where they are written
     * @param group indices
     * @param per one over the time from the anchor to then
     * @param state the vectors
     * @return the largest angular velocity at an anchor
     */
    static double lead(Trajectories paths, IntList group, double per, State state) {
        double[] x = state.x();
        double[] v = state.v();
        double[] m = paths.data();
        double[] k = paths.unfold();
        double fastest = 0;
        if (group.isRow()) {
            int end = Trajectories.STRIDE * (group.values[0] + group.size);
            int b = State.BLOCK * group.values[0];
            for (int o = Trajectories.STRIDE * group.values[0]; o < end; o += Trajectories.STRIDE) {
                lead(m, k, o, x, v, b, per);
                fastest = larger(m[o + Trajectories.OMEGA], fastest);
                b += State.BLOCK;
            }
            return fastest;
        }
        for (int body = 0; body < group.size; body++) {
            int o = Trajectories.STRIDE * group.values[body];
            lead(m, k, o, x, v, State.BLOCK * group.values[body], per);
            fastest = larger(m[o + Trajectories.OMEGA], fastest);
        }
        return fastest;
    }

    private static void lead(double[] m, double[] k, int o, double[] x, double[] v, int b, double per) {
        for (int c = 0; c < State.BLOCK; c++) {
            double start = m[o + Trajectories.VX + c];
            double end = v[b + c];
            double bend = start + end - 2 * per * (x[b + c] - m[o + c]);
            bend = Math.abs(bend) <= Path.ROUNDING * (Math.abs(start) + Math.abs(end)) ? 0 : bend;
            k[o + Trajectories.AX + c] = per * (0.5 * (end - start) - 1.5 * bend);
            k[o + Trajectories.JX + c] = per * per * bend;
        }
    }

    /** The new one is seldom larger, or no number; a maximum would make each wait for the last. */
    private static double larger(double omega, double most) {
        return Math.abs(omega) <= most ? most : Math.abs(omega);
    }

    /** The largest angular velocity of bodies at their anchors. */
    static double fastestTurn(Trajectories paths, IntList group) {
        double[] m = paths.data();
        double fastest = 0;
        for (int body = 0; body < group.size; body++) {
            fastest = larger(m[Trajectories.STRIDE * group.values[body] + Trajectories.OMEGA], fastest);
        }
        return fastest;
    }

    /** Puts the anchors of bodies back into the state vectors. */
    static void restore(Trajectories trajectories, State state, IntList group) {
        double[] m = trajectories.data();
        for (int k = 0; k < group.size; k++) {
            int o = Trajectories.STRIDE * group.values[k];
            int b = State.BLOCK * group.values[k];
            copy(m, o, state.x(), b);
            copy(m, o + Trajectories.VX, state.v(), b);
        }
    }

    /** Copies a block; a call of the system's takes longer. */
    static void copy(double[] from, int at, double[] to, int where) {
        to[where] = from[at];
        to[where + 1] = from[at + 1];
        to[where + 2] = from[at + 2];
    }

    /** Copies the blocks of a group. */
    static void copy(IntList group, double[] from, double[] to) {
        if (group.isRow()) {
            int b = State.BLOCK * group.values[0];
            System.arraycopy(from, b, to, b, State.BLOCK * group.size);
            return;
        }
        for (int k = 0; k < group.size; k++) {
            int b = State.BLOCK * group.values[k];
            copy(from, b, to, b);
        }
    }

    /** Gives all bodies of a group a value. */
    static void set(double[] values, IntList group, double value) {
        if (group.isRow()) {
            Arrays.fill(values, group.values[0], group.values[0] + group.size, value);
            return;
        }
        for (int k = 0; k < group.size; k++) {
            values[group.values[k]] = value;
        }
    }
}
