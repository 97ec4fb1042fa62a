// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.List;

/**
 * What is evaluated, factored and solved for an island, in units of {@link sim.physics.internal.Work}: by the numbers of its nodes and of the
 * blocks of its factors, so that it is the same on every machine. The weights are times as they were measured, in nanoseconds.
 */
final class Effort implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Time of a unit of work. */
    static final int UNIT = 200;

    private static final int EVALUATED = 80;
    private static final int FACTORED = 80;
    private static final int UPDATED = 10;
    private static final int SOLVED = 30;
    private static final int BLOCK_SOLVED = 10;

    /** Per link that is passed, of a tree or a chain that moves in its angles. */
    private static final int PASSED = 50;

    /** Per node, of a residual with twice the precision. */
    private static final int REFINED = 250;

    private final long evaluation;
    private final long factorization;
    private final long solution;
    private final long refinement;
    private long spent;

    /** Whether nothing counts. */
    private boolean isFree;

    /**
     * That of an island.
     *
     * @param nodes of its matrix
     * @param start where the blocks below the diagonal begin, by node
     */
    Effort(int nodes, int[] start) {
        long updates = 0;
        for (int p = 0; p < nodes; p++) {
            long below = start[p + 1] - start[p];
            updates += below * (below + 3) / 2;
        }
        evaluation = (long) EVALUATED * nodes;
        factorization = (long) FACTORED * nodes + UPDATED * updates;
        solution = (long) SOLVED * nodes + (long) BLOCK_SOLVED * start[nodes];
        refinement = (long) REFINED * nodes;
    }

    void evaluate() {
        spend(evaluation);
    }

    void factor() {
        spend(factorization);
    }

    void solve() {
        spend(solution);
    }

    void refine() {
        spend(refinement);
    }

    void pass(long links) {
        spend(PASSED * links);
    }

    private void spend(long time) {
        spent += isFree ? 0 : time;
    }

    /** Sets whether it counts what is done: not what somebody asks between steps. */
    void setFree(boolean yes) {
        isFree = yes;
    }

    boolean isFree() {
        return isFree;
    }

    /** Whole units that were spent for some islands since the last call. */
    static long take(List<Island> islands) {
        long units = 0;
        for (int k = 0; k < islands.size(); k++) {
            Island one = islands.get(k);
            one.effort.pass(one.tree == null ? 0 : one.tree.takePassed());
            one.effort.pass(one.switches.servos == null ? 0 : one.switches.servos.takePassed());
            units += one.effort.take();
        }
        return units;
    }

    private long take() {
        long units = spent / UNIT;
        spent -= units * UNIT;
        return units;
    }
}
