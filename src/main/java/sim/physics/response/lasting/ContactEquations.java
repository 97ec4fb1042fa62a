// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.DenseFactor;

/**
 * Equations for impulses or forces at contacts that need not be unique: elimination of a matrix a little heavier on its diagonal,
 * and refinement until that has no effect. Of all that do the same about the smallest are found.
 */
final class ContactEquations implements Serializable {
    private static final long serialVersionUID = 1L;
    private static final double WEIGHT = 1e-9;

    /** Multiplications in the time that a row takes beside its own, in each pass. */
    private static final int PER_ROW = 8;

    private double[] matrix = {};
    private double[] factors = {};
    private int[] pivots = {};
    private double[] right = {};

    /** What a unit at a row does there, of which a part makes the matrix heavier. */
    private double[] own = {};

    private double[] solution = {};
    private double[] rest = {};

    private final boolean exchanges;
    private final int refinements;

    /**
     * Makes equations that grow with the heaps.
     *
     * @param exchanges whether rows are exchanged, where their order may be a bad one
     * @param refinements how often they are refined
     */
    ContactEquations(boolean exchanges, int refinements) {
        this.exchanges = exchanges;
        this.refinements = refinements;
    }

    void ensure(int n) {
        matrix = new double[n * n];
        factors = new double[n * n];
        pivots = new int[n];
        right = new double[n];
        own = new double[n];
        solution = new double[n];
        rest = new double[n];
    }

    void set(int at, double value) {
        matrix[at] = value;
    }

    void add(int at, double value) {
        matrix[at] += value;
    }

    void setRight(int row, double value, double unit) {
        right[row] = value;
        own[row] = unit;
    }

    double solution(int row) {
        return solution[row];
    }

    /** What solving them costs, in multiplications. */
    long cost(int n) {
        long square = (long) n * n;
        return n * square / 3 + 2 * (1 + refinements) * square + (long) PER_ROW * (1 + refinements) * n;
    }

    /** Solves them; false if the matrix is singular even so. */
    boolean solve(int n) {
        if (!factor(n)) {
            return false;
        }
        Arrays.fill(solution, 0, n, 0);
        for (int pass = 0; pass <= refinements; pass++) {
            for (int row = 0; row < n; row++) {
                double sum = right[row];
                for (int m = 0; m < n; m++) {
                    sum -= matrix[row * n + m] * solution[m];
                }
                rest[row] = sum;
            }
            DenseFactor.solve(factors, n, pivots, rest);
            for (int k = 0; k < n; k++) {
                solution[k] += rest[k];
            }
        }
        return true;
    }

    private boolean factor(int n) {
        System.arraycopy(matrix, 0, factors, 0, n * n);
        for (int k = 0; k < n; k++) {
            factors[k * n + k] += WEIGHT * own[k];
        }
        if (exchanges) {
            return DenseFactor.factor(factors, n, pivots);
        }
        DenseFactor.factorInOrder(factors, n, pivots);
        return true;
    }
}
