// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
import java.util.List;
import sim.physics.motion.State;

/**
 * What an island keeps as long as no force but that of its own constraints acts on it: kinetic energy, and momentum and
 * angular momentum if nothing holds it in the world. They are known, so a step need not lose them.
 *
 * <p>A symplectic method is left alone: its energy swings, and it is neither symplectic nor reversible if that is put back. Its
 * momenta are kept by each of its steps. No method is symplectic where wheels roll, which are no constraints of places: energy is put back there.
 *
 * <p>Under other forces the work of these, and what motors give at most, is all that kinetic energy can grow by, since constraints do none: a step that
 * says otherwise was too long for the pose, as those of a chain that is all but taut. Where forces change within a step that is asked within sight of
 * singular poses only: elsewhere the error of a step is the method's own. Where they do not, it is asked everywhere, but of symplectic methods, whose
 * error is to go up and down, and of those of first order: a bridge that sags by a hundredth of its length swings much faster than a step can
 * follow, without any pose that is singular, and would be thrown about.
 *
 * <p>In the metric of the masses the velocities are a sum of a motion of the whole and an internal one, which are
 * orthogonal and both satisfy the constraints. The first gets the momenta back, the second the energy that is left.
 */
final class Invariants implements Serializable {
    private static final long serialVersionUID = 1L;

    private final Island island;
    private final boolean isFloating;
    private final double[] before = new double[4];
    private final double[] after = new double[4];
    private double[] whole = {};
    private double[] slip = {};
    private boolean isFree;
    private final boolean mayBeSymplectic;
    private boolean isSymplectic;

    /** Growth of the energy beyond what is known, relative to it, that a step may have; and what is left to it. */
    private static final double WRONG = 3;

    private static final double WRONG_IF_STEADY = 0.1;
    static final double LEFT = 1e-3;

    /** Rounding of the work, relative to that of the forces along the coordinates. */
    static final double ROUNDING = 1e-13;

    /** Whether other forces act whose work is watched; the state at the start, accelerations there and the largest ones. */
    private boolean isWatched;

    private boolean isSteady;
    private boolean isNoted;

    /** Whether the method has asked for accelerations more than once: one of first order gains or loses what it does, however short its steps are. */
    private boolean isSubtle;

    private double[] x0 = {};
    private double[] v0 = {};
    private double[] pull = {};
    private double[] most = {};

    /** Work of the forces, as far as they are those of the start, and what it may have been at most. */
    private double work;

    private double mostWork;
    private double roundingOfWork;

    Invariants(Island island) {
        this.island = island;
        boolean floating = true;
        boolean rolls = false;
        for (int p = 0; p < island.nodes; p++) {
            floating &= island.blockA[p] >= 0 && island.blockB[p] >= 0;
        }
        for (Constraint constraint : island.constraints) {
            floating &= Joint.isInternal(constraint);
            rolls |= Roll.isOf(constraint);
        }
        isFloating = floating;
        mayBeSymplectic = !rolls;
    }

    /** Begins a step of some islands. */
    static void begin(List<Island> islands, State state, boolean isFree) {
        for (int k = 0; k < islands.size(); k++) {
            islands.get(k).invariants.begin(state, isFree);
        }
    }

    /** Notes the values at the start of a step. */
    void begin(State state, boolean free) {
        island.passage.begin();
        isFree = free && island.switches.isEmpty() && !island.isMoved;
        isSymplectic = false;
        isWatched = !free && island.isOwn && !island.isMoved && island.switches.work.begin(state.x());
        isNoted = false;
        isSubtle = false;
        if (isFree) {
            measure(state, before);
        }
        if (isWatched) {
            keepStart(state.x(), state.v());
        }
    }

    private void keepStart(double[] x, double[] v) {
        ensure();
        for (int k = 0, m = 0; k < island.bodies.size; k++, m += State.BLOCK) {
            int s = State.BLOCK * island.bodies.values[k];
            x0[m] = x[s];
            x0[m + 1] = x[s + 1];
            x0[m + 2] = x[s + 2];
            v0[m] = v[s];
            v0[m + 1] = v[s + 1];
            v0[m + 2] = v[s + 2];
        }
    }

    private void ensure() {
        if (x0.length == 0) {
            x0 = new double[State.BLOCK * island.bodies.size];
            v0 = new double[x0.length];
            pull = new double[x0.length];
            most = new double[x0.length];
        }
    }

    /** Where the island's k-th coordinate is in the state vectors. */
    private int slot(int k) {
        return State.BLOCK * island.bodies.values[k / State.BLOCK] + k % State.BLOCK;
    }

    /** The accelerations without those of the constraints that were noted last at the start of a step, by coordinate. */
    double[] pull() {
        ensure();
        if (!isNoted) {
            Arrays.fill(pull, 0);
        }
        return pull;
    }

    /** The step is one of a symplectic method. */
    void swing() {
        isSymplectic = mayBeSymplectic;
    }

    /** There is no step whose values are to be kept. */
    void end() {
        isFree = false;
        isWatched = false;
    }

    /** Takes note of the accelerations at a stage, without those of the constraints. */
    void note(double[] a) {
        for (int k = 0; isFree && k < island.bodies.size; k++) {
            int s = State.BLOCK * island.bodies.values[k];
            isFree = a[s] == 0 && a[s + 1] == 0 && a[s + 2] == 0;
        }
        if (!isWatched) {
            return;
        }
        isSteady |= !isNoted;
        isSubtle = isNoted;
        for (int k = 0, m = 0; k < island.bodies.size; k++) {
            int s = State.BLOCK * island.bodies.values[k];
            for (int end = s + State.BLOCK; s < end; s++, m++) {
                if (!isNoted) {
                    pull[m] = a[s];
                    most[m] = Math.abs(a[s]);
                } else if (a[s] != pull[m]) {
                    isSteady = false;
                    most[m] = Math.max(most[m], Math.abs(a[s]));
                }
            }
        }
        isNoted = true;
    }

    /** [energy, momentum x, y, angular momentum about the origin]. */
    private void measure(State state, double[] sum) {
        double[] w = state.w().values();
        double[] x = state.x();
        double[] v = state.v();
        sum[0] = 0;
        sum[1] = 0;
        sum[2] = 0;
        sum[3] = 0;
        for (int k = 0; k < island.bodies.size; k++) {
            int s = State.BLOCK * island.bodies.values[k];
            double px = v[s] / w[s];
            double py = v[s + 1] / w[s];
            double turn = v[s + 2] / w[s + 2];
            sum[0] += 0.5 * (px * v[s] + py * v[s + 1] + turn * v[s + 2]);
            sum[1] += px;
            sum[2] += py;
            sum[3] += x[s] * py - x[s + 1] * px + turn;
        }
    }

    /**
     * Gives the velocities at the end of a step the values back that they had at its start.
     *
     * @param isEnd whether this is the end of the step, and not a place on the way
     * @return false if the energy has grown so much that the step was wrong
     */
    boolean restore(State state, boolean isEnd) {
        if (isEnd && isWatched && isNoted) {
            boolean isWeak = island.factor.pivots.isWeak();
            if (isWeak || isSteady && isSubtle && !isSymplectic) {
                return isWithinWork(state, isWeak);
            }
        }
        if (isFree && before[0] != 0) {
            if (isSymplectic) {
                measure(state, after);
            } else {
                restoreAll(state);
            }
            return after[0] <= (1 + WRONG) * before[0];
        }
        return true;
    }

    private double energyAtStart(double[] w) {
        double sum = 0;
        for (int k = 0, m = 0; k < island.bodies.size; k++, m += State.BLOCK) {
            int s = State.BLOCK * island.bodies.values[k];
            double px = v0[m] / w[s];
            double py = v0[m + 1] / w[s];
            double turn = v0[m + 2] / w[s + 2];
            sum += 0.5 * (px * v0[m] + py * v0[m + 1] + turn * v0[m + 2]);
        }
        return sum;
    }

    /**
     * Whether the energy has grown by no more than the work of the forces. What is a little more is taken away; what is a little less is put back, but
     * for poses that let nothing pass, in which swings are lost.
     */
    private boolean isWithinWork(State state, boolean isWeak) {
        measure(state, after);
        double[] w = state.w().values();
        before[0] = energyAtStart(w);
        work = 0;
        mostWork = 0;
        roundingOfWork = 0;
        double torque = 0;
        for (int k = 0; k < x0.length; k++) {
            int s = slot(k);
            double way = state.x()[s] - x0[k];
            work += pull[k] * way / w[s];
            mostWork += most[k] * Math.abs(way) / w[s];
            double size = k % State.BLOCK == State.THETA ? 1 : island.mostSize;
            roundingOfWork += most[k] * Math.max(Math.abs(x0[k]), size) / w[s];
            torque += most[k] * size / w[s];
        }
        double given = island.switches.work.most(state.x());
        mostWork += Math.max(0, given);
        work += given;
        double known = before[0] + mostWork;
        double room = ROUNDING * roundingOfWork + island.switches.work.leeway(torque);
        if (!isSteady) {
            return after[0] <= (1 + WRONG) * known + room;
        }
        double excess = after[0] - before[0] - work - room;
        double lack = isWeak || island.switches.work.acts() ? 0 : -excess - 2 * room;
        double wrong = Math.max(excess, lack);
        if (wrong > LEFT * known && wrong < WRONG_IF_STEADY * known && !island.switches.work.keepsSpeed()) {
            double scale = Math.sqrt(Math.max(0, 1 - (excess > 0 ? excess : -lack) / after[0]));
            for (int k = 0; k < x0.length; k++) {
                state.v()[slot(k)] *= scale;
            }
        }
        return wrong < WRONG_IF_STEADY * known || wrong <= 0;
    }

    private void restoreAll(State state) {
        measure(state, after);
        double keep = 0;
        double internal = after[0];
        if (isFloating && wholeMotion(state)) {
            keep = dot(state, whole, whole);
            internal = 0;
            for (int k = 0; k < island.bodies.size; k++) {
                int s = State.BLOCK * island.bodies.values[k];
                for (int c = 0; c < State.BLOCK; c++) {
                    state.v()[s + c] -= slip[s + c];
                }
            }
            internal = dot(state, state.v(), state.v());
        }
        double scale = Math.sqrt((before[0] - keep) / internal);
        boolean sound = scale > 0.5 && scale < 2 && internal > 1e-12 * before[0];
        for (int k = 0; k < island.bodies.size; k++) {
            int s = State.BLOCK * island.bodies.values[k];
            for (int c = 0; c < State.BLOCK; c++) {
                double moved = sound ? scale * state.v()[s + c] : state.v()[s + c];
                state.v()[s + c] = moved + (keep > 0 ? whole[s + c] : 0);
            }
        }
    }

    private double dot(State state, double[] u, double[] v) {
        double[] w = state.w().values();
        double sum = 0;
        for (int k = 0; k < island.bodies.size; k++) {
            int s = State.BLOCK * island.bodies.values[k];
            sum += 0.5 * ((u[s] * v[s] + u[s + 1] * v[s + 1]) / w[s] + u[s + 2] * v[s + 2] / w[s + 2]);
        }
        return sum;
    }

    /**
     * The motion of the whole that has the momenta of the start, in {@code whole}, and the one that has those of now, in
     * {@code slip}; false if the constraints do not let the whole turn.
     */
    private boolean wholeMotion(State state) {
        if (whole.length < state.x().length) {
            whole = new double[state.x().length];
            slip = new double[state.x().length];
        }
        double[] w = state.w().values();
        double[] x = state.x();
        double mass = 0;
        double cx = 0;
        double cy = 0;
        for (int k = 0; k < island.bodies.size; k++) {
            int s = State.BLOCK * island.bodies.values[k];
            mass += 1 / w[s];
            cx += x[s] / w[s];
            cy += x[s + 1] / w[s];
        }
        cx /= mass;
        cy /= mass;
        double inertia = 0;
        for (int k = 0; k < island.bodies.size; k++) {
            int s = State.BLOCK * island.bodies.values[k];
            double dx = x[s] - cx;
            double dy = x[s + 1] - cy;
            inertia += (dx * dx + dy * dy) / w[s] + 1 / w[s + 2];
        }
        turn(x, cx, cy, before[1] / mass, before[2] / mass, (before[3] - cx * before[2] + cy * before[1]) / inertia, whole);
        turn(x, cx, cy, after[1] / mass, after[2] / mass, (after[3] - cx * after[2] + cy * after[1]) / inertia, slip);
        island.residual(whole, null, island.lambda);
        return Slack.slip(island, whole, island.lambda) < 1e-12;
    }

    private void turn(double[] x, double cx, double cy, double vx, double vy, double omega, double[] v) {
        for (int k = 0; k < island.bodies.size; k++) {
            int s = State.BLOCK * island.bodies.values[k];
            v[s] = vx - omega * (x[s + 1] - cy);
            v[s + 1] = vy + omega * (x[s] - cx);
            v[s + 2] = omega;
        }
    }
}
