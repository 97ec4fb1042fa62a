// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.util.Arrays;
import sim.physics.motion.State;

/**
 * Solves by block elimination, in the order of the island's tree. The work is O(n) for trees. For loops, the order is that of the
 * least fill-in that minimum degree finds.
 *
 * <p>Where masses differ widely, λ is refined with residuals of twice the precision. That makes it right to rounding, whatever
 * the order of elimination was (formulation stiffness: Ascher, Pai and Cloutier 1997). Where constraints are redundant, the
 * matrix is made a little heavier on its diagonal, and the same refinement removes the effect of that. What is left is the λ of
 * least norm (proximal point iteration; Rockafellar 1976).
 */
public final class DirectSolver extends ConstraintSolver {
    private static final long serialVersionUID = 1L;

    /** Ratio of masses in an island from which λ is refined. */
    private static final double SPREAD = 100;

    /**
     * Pivots below this part of their diagonal: the pose is near a singular one, and a correction would make the rounding of
     * C large. It is damped: what it leaves is less than the error of the step.
     */
    private static final double SINGULAR = 1e-7;

    private static final double DAMPING = 1e-8;
    private static final double RELAXATION = 1e-9;
    private static final int PASSES = 2;
    private static final int PASSES_IF_REDUNDANT = 8;

    private double[] high = {};
    private double[] low = {};
    private double[] right = {};
    private double[] pull = {};

    /** Creates a solver. */
    public DirectSolver() {
        // grows with the islands
    }

    @Override
    boolean isDirect() {
        return true;
    }

    /** Whether masses are so unlike that pivots tell more of them than of the pose. */
    static boolean isSpread(Island island, double[] w) {
        return island.spread(w) > SPREAD;
    }

    @Override
    boolean isPlain(Island island, double[] w) {
        return !island.isRedundant && !isSpread(island, w);
    }

    @Override
    void prepare(Island island, double[] w) {
        island.factor(w, 0, least(island, w), false);
        Pivots pivots = island.factor.pivots;
        // beside a pose in which more rows are redundant, those that always are do not follow from the others any more
        boolean isShared = pivots.lasting() > 0 && pivots.isBeside();
        boolean redundant = isShared || island.redundant() > pivots.lasting();
        boolean damped = redundant && !isShared && isDamped(island, w);
        island.isRedundant = island.redundant() > 0 && !damped || isShared;
        if (!island.isProjected) {
            island.redundantRows = island.redundant();
        }
        if (redundant) {
            island.factor(w, damped ? DAMPING : RELAXATION, Pivots.NOISE, !damped);
        }
    }

    private boolean isDamped(Island island, double[] w) {
        return island.isProjected && !isSpread(island, w);
    }

    private double least(Island island, double[] w) {
        return isDamped(island, w) ? SINGULAR : Pivots.NOISE;
    }

    @Override
    void correct(Island island, double[] w, double[] u, double[] g) {
        if (right.length < 2 * island.nodes) {
            right = new double[2 * island.nodes];
        }
        double[] lambda = island.lambda;
        boolean isRough = island.near() > 0 && !island.isProjected;
        if (isPlain(island, w) && !isRough) {
            island.residual(u, g, lambda);
            island.solve(lambda);
            island.apply(w, lambda, u);
            return;
        }
        island.writeRows();
        Arrays.fill(lambda, 0);
        int passes = island.isRedundant ? PASSES_IF_REDUNDANT : PASSES;
        for (int pass = 0; pass <= passes; pass++) {
            move(island, w, u);
            residual(island, g);
            island.solve(right);
            if (!adds(island)) {
                break;
            }
        }
        move(island, w, u);
        for (int k = 0; k < island.bodies.size; k++) {
            System.arraycopy(high, 3 * k, u, 3 * island.bodies.values[k], 3);
        }
    }

    /** Adds a correction to λ; returns whether that changes more than its last bits, in forces or in torques. */
    private boolean adds(Island island) {
        double[] lambda = island.lambda;
        double force = 0;
        double torque = 0;
        double forceChange = 0;
        double torqueChange = 0;
        for (int k = 0; k < lambda.length; k++) {
            lambda[k] += right[k];
            if (island.isAngle[k]) {
                torque = Math.max(torque, Math.abs(lambda[k]));
                torqueChange = Math.max(torqueChange, Math.abs(right[k]));
            } else {
                force = Math.max(force, Math.abs(lambda[k]));
                forceChange = Math.max(forceChange, Math.abs(right[k]));
            }
        }
        return forceChange > 0x1p-53 * force || torqueChange > 0x1p-53 * torque;
    }

    @Override
    void takeAway(Island island, double[] w, double[] change) {
        island.residual(change, null, island.lambda);
        island.solve(island.lambda);
        island.apply(w, island.lambda, change);
    }

    @Override
    void prepareAndCorrect(Island island, double[] w, double[] u, double[] g) {
        if (!isPlain(island, w)) {
            super.prepareAndCorrect(island, w, u, g);
            return;
        }
        if (solveAtOnce(island, w, u, g) && (island.near() == 0 || island.isProjected)) {
            island.apply(w, island.lambda, u);
        } else {
            super.prepareAndCorrect(island, w, u, g);
        }
    }

    private boolean solveAtOnce(Island island, double[] w, double[] u, double[] g) {
        island.residual(u, g, island.lambda);
        island.factorAndSolve(w, island.lambda, least(island, w));
        if (island.redundant() > 0) {
            return false;
        }
        if (!island.isProjected) {
            island.redundantRows = 0;
        }
        return true;
    }

    @Override
    void accelerate(Island island, State state, double[] a) {
        Passage passage = island.passage;
        boolean isEven = !isSpread(island, state.w().values());
        boolean isMoved = isEven && passage.isBeside() && passage.close(state, this);
        solve(island, state, a);
        if (isEven) {
            passage.noteStage();
        }
        if (isMoved) {
            passage.open(state);
        }
        if (island.redundantRows > 0 && island.passage.stands(state, this, a)) {
            for (int k = 0; k < island.bodies.size; k++) {
                int s = State.BLOCK * island.bodies.values[k];
                Arrays.fill(a, s, s + State.BLOCK, 0);
            }
        }
    }

    private void solve(Island island, State state, double[] a) {
        double[] w = state.w().values();
        boolean isSpread = isSpread(island, w);
        boolean isSolved = !island.isRedundant && !isSpread && solveAtOnce(island, w, a, island.rate);
        if (!isSolved) {
            prepare(island, w);
        }
        if (island.redundantRows > 0 && island.passage.learns(state, this)) {
            prepare(island, w);
            isSolved = false; // λ is that of the way it went
        }
        if (island.factor.pivots.lasting() > 0) {
            accelerateBesides(island, state, a, isSpread);
            return;
        }
        if (!isSpread && island.passage.isNear()) {
            isSolved = false; // λ is that of the way it goes
            if (island.passage.accelerate(state, this, a)) {
                return;
            }
        }
        if (isSolved && island.near() == 0) {
            island.apply(w, island.lambda, a);
        } else {
            correct(island, w, a, island.rate);
        }
    }

    /**
     * The same where some rows are redundant always: the accelerations are found without them, as they are not quite
     * redundant at the positions of a stage, where constraints are a little open. Then λ is shared by all rows.
     */
    private void accelerateBesides(Island island, State state, double[] a, boolean isSpread) {
        double[] w = state.w().values();
        if (pull.length < a.length) {
            pull = new double[a.length];
        }
        System.arraycopy(a, 0, pull, 0, a.length);
        if (isSpread || !island.passage.isNear() || !island.passage.accelerate(state, this, a)) {
            correct(island, w, a, island.rate);
        }
        for (int k = 0; k < island.bodies.size; k++) {
            int s = State.BLOCK * island.bodies.values[k];
            for (int c = s; c < s + State.BLOCK; c++) {
                pull[c] -= a[c];
            }
        }
        boolean was = island.isRedundant;
        island.isRedundant = true;
        island.factor(w, RELAXATION, Pivots.NOISE, true);
        correct(island, w, pull, null);
        island.isRedundant = was;
    }

    /** high + low = u + W Jᵀ λ, by bodies of the island. */
    private void move(Island island, double[] w, double[] u) {
        int n = 3 * island.bodies.size;
        if (high.length < n) {
            high = new double[n];
            low = new double[n];
        }
        Arrays.fill(high, 0, n, 0);
        Arrays.fill(low, 0, n, 0);
        double[] j = island.j;
        for (int p = 0; p < island.nodes; p++) {
            for (int row = 0; row < 2; row++) {
                double l = island.lambda[2 * p + row];
                for (int k = 0; k < 3; k++) {
                    if (island.a[p] >= 0) {
                        TwoFold.add(high, low, 3 * island.a[p] + k, j[12 * p + 3 * row + k], l);
                    }
                    if (island.b[p] >= 0) {
                        TwoFold.add(high, low, 3 * island.b[p] + k, j[12 * p + 6 + 3 * row + k], l);
                    }
                }
            }
        }
        for (int k = 0; k < n; k++) {
            int s = 3 * island.bodies.values[k / 3] + k % 3;
            TwoFold.scale(high, low, k, w[s]);
            TwoFold.add(high, low, k, u[s]);
            double sum = high[k] + low[k];
            low[k] += high[k] - sum;
            high[k] = sum;
        }
    }

    /** right = −(J (high + low) + g), with twice the precision. */
    private void residual(Island island, double[] g) {
        double[] j = island.j;
        island.effort.refine();
        double[] sum = new double[1];
        double[] rest = new double[1];
        for (int p = 0; p < island.nodes; p++) {
            for (int row = 0; row < 2; row++) {
                sum[0] = g == null ? 0 : g[2 * p + row];
                rest[0] = 0;
                for (int side = 0; side < 2; side++) {
                    int body = side == 0 ? island.a[p] : island.b[p];
                    for (int k = 0; body >= 0 && k < 3; k++) {
                        double entry = j[12 * p + 6 * side + 3 * row + k];
                        TwoFold.add(sum, rest, 0, entry, high[3 * body + k]);
                        rest[0] += entry * low[3 * body + k];
                    }
                }
                right[2 * p + row] = -(sum[0] + rest[0]);
            }
        }
    }
}
