// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;

/**
 * Friction with the plane as time stepping solves it: one impulse of force and torque for each body, which stops it or is on the
 * limit surface, there in the direction that takes most energy. The limit surface is taken for the ellipsoid through the
 * largest force and the largest torque (Howe and Cutkosky, <i>Practical force-motion models for sliding manipulation</i>, 1996).
 */
public final class SurfaceRows implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int ROUNDS = 20;
    private static final double REACHED = 1e-12;

    private static final int STRIDE = 6;

    /** Largest force, at rest and while sliding; torque over force. */
    private static final int STATIC = 3;

    private static final int KINETIC = 4;
    private static final int ARM = 5;

    /**
     * Substeps for which a body that others push slides against static friction: in the first ones after a push has grown, they give more and less than
     * the push by turns.
     */
    private static final int BREAKAWAY = 12;

    private final State state;
    private final Generators generators;
    private final IntList bodies = new IntList();

    /** Per body of the list: force, torque, and the largest ones, as impulses of a substep. */
    private double[] rows = {};

    /** By body: whether it slides by the last solution, and for how many substeps on end it has. */
    private boolean[] slides = {};

    private int[] slid = {};

    private final double[] out = new double[State.BLOCK];

    SurfaceRows(State state, Generators generators) {
        this.state = state;
        this.generators = generators;
    }

    /** {@return whether nothing rubs on the plane} */
    public boolean isEmpty() {
        return generators.surface == null;
    }

    /**
     * Begins a step.
     *
     * @param movable the bodies
     */
    public void begin(IntList movable) {
        bodies.clear();
        if (isEmpty()) {
            return;
        }
        if (STRIDE * movable.size > rows.length) {
            rows = new double[STRIDE * Growth.length(movable.size, movable.size)];
        }
        if (slid.length < state.size()) {
            slid = Arrays.copyOf(slid, Growth.length(slid.length, state.size()));
            slides = Arrays.copyOf(slides, slid.length);
        }
        for (int k = 0; k < movable.size; k++) {
            Body body = state.body(movable.values[k]);
            if (!generators.surface.actsOn(body)) {
                continue;
            }
            int o = STRIDE * bodies.size;
            bodies.add(movable.values[k]);
            double weight = body.getMass() * generators.surface.getGravity();
            rows[o + STATIC] = body.getSurfaceStaticFriction() * weight;
            rows[o + KINETIC] = body.getSurfaceFriction() * weight;
            body.surfacePatch().friction(0, 0, 1, 0, out);
            rows[o + ARM] = -out[State.THETA];
        }
    }

    /**
     * Begins a substep, in which nothing but forces has acted: nothing is known of its impulses, as each body's are found at once.
     *
     * @param h substep
     */
    public void start(double h) {
        for (int k = 0; k < bodies.size; k++) {
            int body = bodies.values[k];
            Arrays.fill(rows, STRIDE * k, STRIDE * k + State.BLOCK, 0);
            slid[body] = isBeyond(k, h) ? BREAKAWAY : slides[body] ? Math.min(BREAKAWAY, slid[body] + 1) : 0;
        }
    }

    /**
     * Solves all bodies once.
     *
     * @param h substep
     */
    public void solve(double h) {
        double[] v = state.v();
        double[] w = state.w().values();
        for (int k = 0; k < bodies.size; k++) {
            solve(k, v, w, h);
        }
    }

    /**
     * Takes the impulses of some bodies away, without a change of their velocities.
     *
     * @param marks by body
     */
    public void clear(boolean[] marks) {
        for (int k = 0; k < bodies.size; k++) {
            if (marks[bodies.values[k]]) {
                Arrays.fill(rows, STRIDE * k, STRIDE * k + State.BLOCK, 0);
            }
        }
    }

    /**
     * Solves some bodies once.
     *
     * @param marks by body
     * @param h substep
     */
    public void solve(boolean[] marks, double h) {
        for (int k = 0; k < bodies.size; k++) {
            if (marks[bodies.values[k]]) {
                solve(k, state.v(), state.w().values(), h);
            }
        }
    }

    private void solve(int k, double[] v, double[] w, double h) {
        int b = State.BLOCK * bodies.values[k];
        int o = STRIDE * k;
        double vx = v[b] - w[b] * rows[o]; // without friction
        double vy = v[b + 1] - w[b] * rows[o + 1];
        double spin = v[b + 2] - w[b + 2] * rows[o + 2];
        double arm = rows[o + ARM];
        boolean rests = held(vx, vy, spin, w[b], w[b + 2], arm) <= rows[o + STATIC] * h;
        slides[bodies.values[k]] = !rests;
        if (rests) {
            rows[o] = -vx / w[b];
            rows[o + 1] = -vy / w[b];
            rows[o + 2] = -spin / w[b + 2];
            v[b] = 0;
            v[b + 1] = 0;
            v[b + 2] = 0;
        } else {
            slide(o, b, vx, vy, spin, rows[o + (slid[bodies.values[k]] < BREAKAWAY ? STATIC : KINETIC)] * h);
        }
    }

    /** Whether static friction does not bear what forces and the speed of before ask for. */
    private boolean isBeyond(int k, double h) {
        double[] v = state.v();
        double[] w = state.w().values();
        int b = State.BLOCK * bodies.values[k];
        return held(v[b], v[b + 1], v[b + 2], w[b], w[b + 2], rows[STRIDE * k + ARM]) > rows[STRIDE * k + STATIC] * h;
    }

    /** The force to stop a body, in the measure of the ellipsoid. */
    private static double held(double vx, double vy, double spin, double w, double wSpin, double arm) {
        double force = (vx * vx + vy * vy) / (w * w);
        double turn = spin / (wSpin * arm);
        return Math.sqrt(force + turn * turn);
    }

    /**
     * The impulse −D u/σ against the velocity u that is left, D the squares of the ellipsoid's axes and σ² = u·D u: with
     * u = v / (1 + w D/σ) an equation for σ, which is convex, by Newton's method from below.
     */
    private void slide(int o, int b, double vx, double vy, double spin, double most) {
        double[] v = state.v();
        double[] w = state.w().values();
        double arm = rows[o + ARM];
        if (most == 0) {
            v[b] = vx;
            v[b + 1] = vy;
            v[b + 2] = spin;
            Arrays.fill(rows, o, o + State.BLOCK, 0);
            return;
        }
        double d = most * most;
        double dTurn = d * arm * arm;
        double line = d * (vx * vx + vy * vy);
        double turn = dTurn * spin * spin;
        double add = w[b] * d;
        double addTurn = w[b + 2] * dTurn;
        // each of the two terms alone has its zero below that of their sum, and not far off
        double sigma = Math.max(0, Math.max(Math.sqrt(line) - add, Math.sqrt(turn) - addTurn));
        for (int round = 0; round < ROUNDS; round++) {
            double p = 1 / (sigma + add);
            double q = 1 / (sigma + addTurn);
            double excess = line * p * p + turn * q * q - 1;
            double step = excess / (2 * (line * p * p * p + turn * q * q * q));
            sigma += step;
            if (!(Math.abs(step) > REACHED * sigma)) {
                break;
            }
        }
        double keep = sigma / (sigma + add);
        double keepTurn = sigma / (sigma + addTurn);
        v[b] = vx * keep;
        v[b + 1] = vy * keep;
        v[b + 2] = spin * keepTurn;
        rows[o] = (v[b] - vx) / w[b];
        rows[o + 1] = (v[b + 1] - vy) / w[b];
        rows[o + 2] = (v[b + 2] - spin) / w[b + 2];
    }
}
