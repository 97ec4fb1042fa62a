// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.List;
import sim.physics.internal.DenseFactor;
import sim.physics.motion.Carry;
import sim.physics.motion.State;

/**
 * Moves an island onto C = 0 along the directions W Jᵀ of the start of a step, as the method SHAKE does (Ryckaert, Ciccotti
 * and Berendsen 1977): the move of a force that acts there, and so part of a symplectic map.
 *
 * <pre>
 *   x += W J₀ᵀ δ,   ẋ += W J₀ᵀ δ / h,   J₀ W J₀ᵀ δ = −C(x)
 * </pre>
 *
 * <p>The matrix is that of the start throughout, so the error falls by a factor of about the step's relative length each
 * time. It falls only while the step is short beside the way to a singular pose of the island. If it does not, because
 * the step passes one, the matrix is J(x) W J₀ᵀ, Newton's.
 */
final class Shake implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int CORRECTIONS = 60;

    /** Rounding of C, relative to the coordinates that it is computed from. */
    private static final double ROUNDING = 0x1p-53;

    /** Error, in these units, that is none where a step begins: one so short that it moves nothing. */
    private static final double CLOSED = 16;

    /** Error, in these units, below which there is none: C is evaluated with what rounding has left of the positions. */
    private static final double NONE = 0x1p-6;

    /** Error after which a correction that is no better is not due to rounding. */
    private static final double OPEN = 1e4;

    private static final int NEWTON_CORRECTIONS = 20;

    /** Rows up to which Newton's matrix is factored: it is not sparse. */
    private static final int MOST_ROWS = 800;

    private final Island island;
    private final DirectSolver solver = new DirectSolver();

    private double[] rows = {};
    private double[] push = {};
    private double[] startX = {};
    private double[] startV = {};
    private double[] dense = {};
    private int[] pivots = {};

    Shake(Island island) {
        this.island = island;
    }

    static void hold(List<Island> islands, State state) {
        for (int k = 0; k < islands.size(); k++) {
            islands.get(k).shake.hold(state);
        }
    }

    static void close(List<Island> islands, State state, double h) {
        for (int k = 0; k < islands.size(); k++) {
            islands.get(k).shake.close(state, h);
        }
    }

    /** Whether this is within a step of a method that carries what rounding leaves, after the rows have been kept. */
    boolean isCarried(State state) {
        return state.carry() != null && state.carry().isHeld(island.bodies.values[0]);
    }

    /** Two values per node, for who needs them while nothing is closed. */
    double[] scratch() {
        return push;
    }

    /** Keeps J and the factors of J W Jᵀ. */
    void hold(State state) {
        if (rows.length == 0) {
            rows = new double[island.j.length];
            push = new double[2 * island.nodes];
            startX = new double[State.BLOCK * island.bodies.size];
            startV = new double[startX.length];
        }
        boolean was = island.setPlacing(island.rolls());
        island.evaluate(state);
        island.setPlacing(was);
        island.invariants.swing();
        island.writeRows();
        System.arraycopy(island.j, 0, rows, 0, rows.length);
        double[] w = state.w().values();
        solver.prepare(island, w);
        if (island.passage.isNear()) {
            island.isProjected = true; // damped: C is known to fewer digits there than a push would ask for
            solver.prepare(island, w);
            island.isProjected = false;
        }
    }

    /** Closes the constraints, as far as rounding lets it. */
    void close(State state, double h) {
        boolean was = island.setPlacing(island.rolls());
        closePlaces(state, h);
        island.setPlacing(was);
    }

    private void closePlaces(State state, double h) {
        copy(state.x(), startX, true);
        copy(state.v(), startV, true);
        double before = Double.POSITIVE_INFINITY;
        double error = 0;
        for (int k = 0; k < CORRECTIONS; k++) {
            island.evaluate(state);
            error = Slack.error(island, state, ROUNDING);
            if (error <= (k == 0 ? CLOSED : NONE) || !(error < before) && error < OPEN) {
                return; // rounding
            }
            if (!(error < Double.POSITIVE_INFINITY)) {
                break;
            }
            before = error;
            for (int m = 0; m < push.length; m++) {
                push[m] = -island.c[m];
            }
            island.solve(push);
            move(state, h);
        }
        if (!(error < OPEN) && push.length <= MOST_ROWS) {
            again(state);
            if (!newton(state, h)) {
                again(state); // there is no closing them, which the projection after the step will find
            }
        }
    }

    private void again(State state) {
        copy(state.x(), startX, false);
        copy(state.v(), startV, false);
    }

    private void copy(double[] values, double[] kept, boolean keep) {
        for (int k = 0; k < kept.length; k++) {
            int s = State.BLOCK * island.bodies.values[k / State.BLOCK] + k % State.BLOCK;
            if (keep) {
                kept[k] = values[s];
            } else {
                values[s] = kept[k];
            }
        }
    }

    /** Closes the constraints with the rows of J as they change; false if that does not succeed. */
    private boolean newton(State state, double h) {
        int n = push.length;
        if (dense.length == 0) {
            dense = new double[n * n];
            pivots = new int[n];
        }
        double before = Double.POSITIVE_INFINITY;
        for (int k = 0; k < NEWTON_CORRECTIONS; k++) {
            island.evaluate(state);
            double error = Slack.error(island, state, ROUNDING);
            if (error <= NONE || !(error < before) && error < OPEN) {
                return true;
            }
            before = error;
            island.writeRows();
            assemble(state.w().values());
            for (int m = 0; m < n; m++) {
                push[m] = island.factor.pivots.isLasting(m) ? 0 : -island.c[m];
            }
            if (!(error < Double.POSITIVE_INFINITY) || !DenseFactor.factor(dense, n, pivots)) {
                return false;
            }
            DenseFactor.solve(dense, n, pivots, push);
            move(state, h);
        }
        return false;
    }

    /** J(x) W J₀ᵀ; rows that are zero, or implied by others always, get a 1 on the diagonal. */
    private void assemble(double[] w) {
        int n = push.length;
        for (int row = 0; row < n; row++) {
            double most = 0;
            boolean isLasting = island.factor.pivots.isLasting(row);
            for (int column = 0; column < n; column++) {
                double sum = 0;
                for (int sides = 0; !isLasting && sides < 4; sides++) {
                    sum += product(w, row, sides >> 1, column, sides & 1);
                }
                dense[row * n + column] = sum;
                most = Math.max(most, Math.abs(sum));
            }
            if (most == 0) {
                dense[row * n + row] = 1;
            }
        }
    }

    private double product(double[] w, int row, int side, int column, int other) {
        int s = side == 0 ? island.blockA[row >> 1] : island.blockB[row >> 1];
        int t = other == 0 ? island.blockA[column >> 1] : island.blockB[column >> 1];
        if (s < 0 || s != t) {
            return 0;
        }
        int o = Island.J * (row >> 1) + 6 * side + 3 * (row & 1);
        int q = Island.J * (column >> 1) + 6 * other + 3 * (column & 1);
        double sum = 0;
        for (int c = 0; c < State.BLOCK; c++) {
            sum += w[s + c] * island.j[o + c] * rows[q + c];
        }
        return sum;
    }

    private void move(State state, double h) {
        Carry carry = state.carry();
        double[] w = state.w().values();
        double[] x = state.x();
        double[] v = state.v();
        for (int p = 0; p < island.nodes; p++) {
            double l0 = push[2 * p];
            double l1 = push[2 * p + 1];
            int o = Island.J * p;
            for (int s = island.blockA[p], side = 0; side < 2; side++, s = island.blockB[p], o += 6) {
                for (int c = 0; s >= 0 && c < State.BLOCK; c++) {
                    double d = w[s + c] * (rows[o + c] * l0 + rows[o + 3 + c] * l1);
                    carry.addX(x, s + c, d);
                    carry.addV(v, s + c, d / h);
                }
            }
        }
    }
}
