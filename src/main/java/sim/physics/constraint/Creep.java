// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.List;
import sim.physics.motion.State;

/**
 * What an island does where no step is short enough for its motion: in a pose that it can leave to first order and not to
 * second, as a taut chain between two walls. The limit of a chain that is less and less slack swings faster and faster
 * over less and less, so its place is that of one that stands, and what it has of energy is lost to any step.
 *
 * <pre>
 *   v* = v₀ + h a,   x₁ = the nearest place to x₀ + h v* that satisfies C = 0,   v₁ = (x₁ − x₀) / h
 * </pre>
 *
 * <p>with the nearest in the metric of the masses, which is how an impact without restitution would choose. A motion that
 * the constraints allow goes on, to first order; one that they do not allow ends. Energy only falls: v₁ is made
 * shorter where it is more than v* and the work of the forces give.
 */
final class Creep implements Serializable {
    private static final long serialVersionUID = 1L;

    /** The way of a part, in rad or relative to the size of the bodies. */
    private static final double PART = 0.1;

    private static final int MOST_PARTS = 1024;

    /** The same, times the number of nodes: parts of large islands take long. */
    private static final int MOST_NODES = 1 << 16;

    /** Steps after which it is tried again to move as ever: 2 to the number of times that failed, and no more than this. */
    private static final int MOST_PATIENCE = 10;

    /**
     * How often steps may be halved when it is tried again. A bridge of planks in a line, with traffic on it, can be followed in
     * thousands of parts for a while, when contacts bend it by next to nothing; that is worth nothing, and takes seconds.
     */
    private static final int FEW_HALVINGS = 6;

    /**
     * Evaluations which a method that chooses its steps may make in a step of the engine for next to no way. Its strides are as short as
     * what swings there is fast, and none says that it is too long. And how many when it is tried again; and how many times as many where
     * motors or stops act, since it is not known there which rows depend on others always.
     */
    private static final int MOST_IN_VAIN = 2000;

    private static final int FEW_IN_VAIN = 250;
    private static final int SWITCHED = 32;

    private final Island island;
    private double[] x = {};
    private double[] v = {};
    private int failures;
    private int left;

    /** The step of the engine in which evaluations were made in vain last, and how many. */
    private double vainIn;

    private int vain;

    /** What pulled it when it stood still the last time, where it is in {@link #x}, and for how long; 0 if it has moved since. */
    private double[] stoodUnder = {};

    private double stoodFor;

    Creep(Island island) {
        this.island = island;
    }

    /** Whether the last steps found no way, so that the next one need not look for it. */
    boolean isOn() {
        return left > 0;
    }

    /** Whether the constraints of all islands are such that they may, and no motor or stop acts or pushes. */
    static boolean arePossible(List<Island> those) {
        boolean yes = true;
        for (int k = 0; k < those.size(); k++) {
            yes &= those.get(k).isOwn && those.get(k).switches.areIdle();
        }
        return yes;
    }

    /** Forgets what was found: bodies were written. */
    void forget() {
        failures = 0;
        left = 0;
        stoodFor = 0;
    }

    /**
     * How often a step of a group may be halved, which is so many times if none has gone on so before, and it does not stand where it can
     * go to first order only; −1 if some of its islands creep.
     *
     * @param standing where they stand, null if they do not
     */
    static int halvings(List<Island> those, State standing, ConstraintSolver solver, int most) {
        int least = most;
        for (int k = 0; k < those.size(); k++) {
            Creep one = those.get(k).passage.creep;
            boolean areFew = one.failures > 0 || standing != null && one.isWeak(standing, solver);
            least = one.isOn() ? -1 : areFew ? Math.min(least, FEW_HALVINGS) : least;
        }
        return least;
    }

    private boolean isWeak(State state, ConstraintSolver solver) {
        island.evaluate(state);
        solver.prepare(island, state.w().values());
        return island.passage.sight.isWeak(state.w().values());
    }

    /**
     * Takes note of evaluations that were made in a step of the engine for next to no way; returns how many may be yet, or the greatest
     * number if no singular pose is near.
     */
    static int tire(List<Island> those, State state, double step, int evaluations, boolean isTorn) {
        int spare = Integer.MAX_VALUE;
        for (int k = 0; k < those.size(); k++) {
            Passage passage = those.get(k).passage;
            boolean isWeak = (isTorn || those.get(k).factor.pivots.isWeakHere()) && passage.sight.isWeak(state.w().values());
            spare = isWeak ? Math.min(spare, passage.creep.tire(step, evaluations)) : spare;
        }
        return spare;
    }

    /** Whether such evaluations were noted in a step of the engine. */
    static boolean areTired(List<Island> those, double step) {
        boolean yes = false;
        for (int k = 0; k < those.size(); k++) {
            Creep one = those.get(k).passage.creep;
            yes |= one.vainIn == step && one.vain > 0;
        }
        return yes;
    }

    private int tire(double step, int evaluations) {
        vain = vainIn == step ? vain + evaluations : evaluations;
        vainIn = step;
        int most = (failures > 0 ? FEW_IN_VAIN : MOST_IN_VAIN) * (island.switches.isEmpty() ? 1 : SWITCHED);
        if (vain < most) {
            return most - vain;
        }
        fail();
        return 0;
    }

    private void fail() {
        failures = Math.min(failures + 1, MOST_PATIENCE);
        left = 1 << failures;
    }

    /**
     * Goes on for a time, with all islands of a group.
     *
     * @param state where the accelerations that were noted last are those without constraints
     * @param h time, of either sign
     * @throws ConstraintException if it has just begun, and no pose is within sight of a singular one
     */
    static void advance(List<Island> those, State state, ConstraintSolver solver, Projection projection, double h) {
        boolean isWeak = halvings(those, null, solver, 0) < 0;
        for (int k = 0; k < those.size() && !isWeak; k++) {
            isWeak = those.get(k).passage.sight.isWeak(state.w().values());
        }
        if (!isWeak) {
            throw projection.tooLong(those);
        }
        for (int k = 0; k < those.size(); k++) {
            those.get(k).passage.creep.advance(state, solver, projection, h);
        }
    }

    private void advance(State state, ConstraintSolver solver, Projection projection, double h) {
        if (left == 0) {
            fail();
        }
        left--;
        int n = State.BLOCK * island.bodies.size;
        if (x.length == 0) {
            x = new double[n];
            v = new double[n];
            stoodUnder = new double[n];
        }
        double[] pull = island.invariants.pull();
        island.invariants.end();
        if (standsAsBefore(state, pull, h)) {
            left = Math.max(left, 1);
            return;
        }
        int parts = parts(state, pull, h);
        boolean stands = true;
        for (int k = 0; k < parts; k++) {
            if (!go(state, solver, projection, pull, h / parts)) {
                stand(state);
            } else {
                stands = false;
            }
        }
        stoodFor = stands && parts == 1 ? h : 0;
        System.arraycopy(pull, 0, stoodUnder, 0, x.length);
        island.redundantRows = island.redundant();
    }

    /** Whether the island stands where it stood, under what it stood under: then it does so again, and need not try. */
    private boolean standsAsBefore(State state, double[] pull, double h) {
        boolean yes = stoodFor == h;
        for (int k = 0; yes && k < x.length; k++) {
            yes = state.x()[slot(k)] == x[k] && state.v()[slot(k)] == 0 && pull[k] == stoodUnder[k];
        }
        return yes;
    }

    private int parts(State state, double[] pull, double h) {
        double way = 0;
        for (int k = 0; k < x.length; k++) {
            double one = Math.abs(h * (Math.abs(state.v()[slot(k)]) + Math.abs(h * pull[k])));
            way = Math.max(way, k % State.BLOCK == State.THETA ? one : one / island.leastSize);
        }
        int most = Math.max(1, Math.min(MOST_PARTS, MOST_NODES / Math.max(1, island.c.length / 2)));
        return Math.max(1, (int) Math.min(most, Math.ceil(way / PART)));
    }

    /** Goes on for a part; false if there is no place near, or only one that is higher than the energy is. */
    private boolean go(State state, ConstraintSolver solver, Projection projection, double[] pull, double h) {
        double before = 0;
        double most = 0;
        double[] w = state.w().values();
        for (int k = 0; k < x.length; k++) {
            int s = slot(k);
            x[k] = state.x()[s];
            before += 0.5 * state.v()[s] * state.v()[s] / w[s];
            v[k] = state.v()[s] + h * pull[k];
            most += 0.5 * v[k] * v[k] / w[s];
            state.x()[s] = x[k] + h * v[k];
            state.v()[s] = 0;
        }
        if (most == 0) {
            return true;
        }
        if (!projection.projectPatiently(island, state, solver)) {
            return false;
        }
        double work = 0;
        for (int k = 0; k < x.length; k++) {
            int s = slot(k);
            double way = state.x()[s] - x[k];
            work += pull[k] * way / w[s];
            state.v()[s] = way / h;
        }
        island.evaluate(state);
        solver.prepare(island, w);
        projection.settle(island, state, solver);
        return shorten(state, w, Math.min(most, before + work));
    }

    /** Lets the island have no more than an energy. */
    private boolean shorten(State state, double[] w, double most) {
        double now = 0;
        for (int k = 0; k < x.length; k++) {
            int s = slot(k);
            now += 0.5 * state.v()[s] * state.v()[s] / w[s];
        }
        if (!(now < Double.POSITIVE_INFINITY) || !(most >= 0)) {
            return false;
        }
        double scale = now > most ? Math.sqrt(most / now) : 1;
        for (int k = 0; k < x.length; k++) {
            state.v()[slot(k)] *= scale;
        }
        return true;
    }

    private void stand(State state) {
        for (int k = 0; k < x.length; k++) {
            state.x()[slot(k)] = x[k];
            state.v()[slot(k)] = 0;
        }
        state.placedAll();
    }

    private int slot(int k) {
        return State.BLOCK * island.bodies.values[k / State.BLOCK] + k % State.BLOCK;
    }
}
