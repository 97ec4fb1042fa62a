// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;

/**
 * Friction with the plane as time stepping solves it: one impulse of force and torque for each body, which stops it or is that of the body's
 * patch ({@link SurfacePatch}). Against the motion that is sought stands the friction of the ellipsoid through the largest force and the largest
 * torque (Howe and Cutkosky, <i>Practical force-motion models for sliding manipulation</i>, 1996), which has a closed form; what the
 * patch's differs from it, by up to a third for slender bodies, is that of the motion of the substep before.
 */
public final class SurfaceRows implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int ROUNDS = 20;
    private static final double REACHED = 1e-12;

    /** How often the motion is looked for with which a body begins to slide that the ellipsoid would hold. */
    private static final int ONSET = 8;

    private static final int STRIDE = 9;

    /** Largest force, at rest and while sliding; torque over force. */
    private static final int STATIC = 3;

    private static final int KINETIC = 4;
    private static final int ARM = 5;

    /** What the ellipsoid's friction lacks of the patch's, for a largest force of one. */
    private static final int LACK = 6;

    /** Loads within this part of the ellipsoid are held by every patch, and those beyond it as many times by none. */
    private static final double SURELY = 0.5;

    private static final double NEVER = 1.5;

    /**
     * Substeps for which a body that others push slides against static friction: in the first ones after a push has grown, they give more and less than
     * the push by turns.
     */
    private static final int BREAKAWAY = 12;

    /** Substeps after which what slides is taken for a motion, and not for what a push that others have yet to bear has moved. */
    private static final int SETTLED = 6;

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
            rows[o + ARM] = body.surfacePatch().arm();
        }
    }

    /** Takes note of how bodies move before a substep: what their patches do then is not what the ellipsoid does. */
    public void note() {
        double[] v = state.v();
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            note(k, v[b], v[b + 1], v[b + 2]);
        }
    }

    private void note(int k, double vx, double vy, double spin) {
        int o = STRIDE * k;
        double arm = rows[o + ARM];
        double turn = arm * spin;
        double speed = Math.sqrt(vx * vx + vy * vy + turn * turn);
        Arrays.fill(rows, o + LACK, o + LACK + State.BLOCK, 0);
        if (turn != 0 && speed > 0) { // else there is no torque, and the force is against the way
            int body = bodies.values[k];
            state.body(body).surfacePatch().friction(vx, vy, spin, state.x()[State.BLOCK * body + 2], out);
            rows[o + LACK] = out[0] + vx / speed;
            rows[o + LACK + 1] = out[1] + vy / speed;
            rows[o + LACK + 2] = out[2] + arm * turn / speed;
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
     * @param isHalf whether the first half of the substep is meant, after which bodies move: what slides has got half of its friction then
     */
    public void solve(double h, boolean isHalf) {
        for (int k = 0; k < bodies.size; k++) {
            int body = bodies.values[k];
            solve(k, isHalf && slides[body] && slid[body] >= SETTLED ? 0.5 * h : h);
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
                solve(k, h);
            }
        }
    }

    private void solve(int k, double h) {
        double[] v = state.v();
        double[] w = state.w().values();
        int b = State.BLOCK * bodies.values[k];
        int o = STRIDE * k;
        double vx = v[b] - w[b] * rows[o]; // without friction
        double vy = v[b + 1] - w[b] * rows[o + 1];
        double spin = v[b + 2] - w[b + 2] * rows[o + 2];
        boolean rests = rests(k, vx / w[b], vy / w[b], spin / w[b + 2], h);
        slides[bodies.values[k]] = !rests;
        if (rests) {
            rows[o] = -vx / w[b];
            rows[o + 1] = -vy / w[b];
            rows[o + 2] = -spin / w[b + 2];
            v[b] = 0;
            v[b + 1] = 0;
            v[b + 2] = 0;
        } else {
            slide(k, vx, vy, spin, rows[o + (slid[bodies.values[k]] < BREAKAWAY ? STATIC : KINETIC)] * h);
        }
    }

    /** Whether static friction does not bear what forces and the speed of before ask for. */
    private boolean isBeyond(int k, double h) {
        double[] v = state.v();
        double[] w = state.w().values();
        int b = State.BLOCK * bodies.values[k];
        return !rests(k, v[b] / w[b], v[b + 1] / w[b], v[b + 2] / w[b + 2], h);
    }

    /** Whether static friction takes an impulse and a turn. */
    private boolean rests(int k, double px, double py, double turn, double h) {
        double most = rows[STRIDE * k + STATIC] * h;
        double push = turn / rows[STRIDE * k + ARM];
        double load = Math.sqrt(px * px + py * py + push * push);
        if (!(load > SURELY * most && load < NEVER * most)) {
            return load <= most;
        }
        int body = bodies.values[k];
        return state.body(body).surfacePatch().holds(px, py, turn, state.x()[State.BLOCK * body + 2], most);
    }

    /**
     * The impulse −P A u/σ against the velocity u that is left, P the largest one, A the squares of the ellipsoid's axes for P = 1 and σ² = u·A u: with
     * u = v / (1 + w P A/σ) an equation for the speed σ. What that lacks of the patch's friction is a force. Where the ellipsoid would hold what the patch does not,
     * that force is looked for with the motion that begins.
     */
    private void slide(int k, double vx, double vy, double spin, double most) {
        double[] v = state.v();
        double[] w = state.w().values();
        int b = State.BLOCK * bodies.values[k];
        int o = STRIDE * k;
        double arm = rows[o + ARM];
        double add = w[b] * most;
        double addTurn = w[b + 2] * most * arm * arm;
        double ux = vx;
        double uy = vy;
        double uSpin = spin;
        double sigma = 0;
        for (int round = 0; most > 0; round++) {
            ux = vx + add * rows[o + LACK];
            uy = vy + add * rows[o + LACK + 1];
            uSpin = spin + w[b + 2] * most * rows[o + LACK + 2];
            sigma = speed(ux * ux + uy * uy, arm * arm * uSpin * uSpin, add, addTurn);
            if (sigma > 0 || round == ONSET) {
                break;
            }
            boolean isFirst = round == 0;
            note(k, isFirst ? vx : ux / add, isFirst ? vy : uy / add, isFirst ? spin : uSpin / addTurn);
        }
        double keep = most > 0 ? sigma / (sigma + add) : 1;
        double keepTurn = most > 0 ? sigma / (sigma + addTurn) : 1;
        v[b] = ux * keep;
        v[b + 1] = uy * keep;
        v[b + 2] = uSpin * keepTurn;
        rows[o] = (v[b] - vx) / w[b];
        rows[o + 1] = (v[b + 1] - vy) / w[b];
        rows[o + 2] = (v[b + 2] - spin) / w[b + 2];
    }

    /** Solves line / (σ + add)² + turn / (σ + addTurn)² = 1, which is convex, by Newton's method from below; 0 if σ would be negative. */
    private static double speed(double line, double turn, double add, double addTurn) {
        if (!(line / (add * add) + turn / (addTurn * addTurn) > 1)) {
            return 0;
        }
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
        return sigma;
    }
}
