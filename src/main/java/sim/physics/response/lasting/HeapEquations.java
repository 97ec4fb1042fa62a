// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;

/** Equations for impulses that need not be unique: elimination of a matrix a little heavier on its diagonal, and refinement. */
final class HeapEquations implements Serializable {
    private static final long serialVersionUID = 1L;
    private static final int REFINEMENTS = 3;
    private static final double WEIGHT = 1e-9;

    private double[] matrix = {};
    private double[] factors = {};
    private int[] pivots = {};
    private double[] right = {};

    /** What a unit at a row does there, of which a part makes the matrix heavier. */
    private double[] own = {};

    private double[] solution = {};
    private double[] rest = {};

    HeapEquations() {
        // grows with the heaps
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

    /** Solves them; false if the matrix is singular even so. */
    boolean solve(int n) {
        if (!factor(n)) {
            return false;
        }
        Arrays.fill(solution, 0, n, 0);
        for (int pass = 0; pass <= REFINEMENTS; pass++) {
            for (int row = 0; row < n; row++) {
                double sum = right[row];
                for (int m = 0; m < n; m++) {
                    sum -= matrix[row * n + m] * solution[m];
                }
                rest[row] = sum;
            }
            substitute(n);
            for (int k = 0; k < n; k++) {
                solution[k] += rest[k];
            }
        }
        return true;
    }

    private boolean factor(int n) {
        double[] a = factors;
        System.arraycopy(matrix, 0, a, 0, n * n);
        for (int k = 0; k < n; k++) {
            a[k * n + k] += WEIGHT * own[k];
        }
        for (int k = 0; k < n; k++) {
            swap(a, n, k);
            double diagonal = a[k * n + k];
            if (!(Math.abs(diagonal) > 0) || Double.isInfinite(diagonal)) {
                return false;
            }
            int from = k * n;
            for (int row = k + 1; row < n; row++) {
                int to = row * n;
                double f = a[to + k] / diagonal;
                a[to + k] = f;
                if (f != 0) {
                    for (int m = k + 1; m < n; m++) {
                        a[to + m] -= f * a[from + m];
                    }
                }
            }
        }
        return true;
    }

    /** Brings the row with the largest element of a column up. */
    private void swap(double[] a, int n, int k) {
        int pivot = k;
        for (int row = k + 1; row < n; row++) {
            pivot = Math.abs(a[row * n + k]) > Math.abs(a[pivot * n + k]) ? row : pivot;
        }
        pivots[k] = pivot;
        for (int m = 0; pivot != k && m < n; m++) {
            double swap = a[k * n + m];
            a[k * n + m] = a[pivot * n + m];
            a[pivot * n + m] = swap;
        }
    }

    private void substitute(int n) {
        for (int k = 0; k < n; k++) {
            double swap = rest[k];
            rest[k] = rest[pivots[k]];
            rest[pivots[k]] = swap;
        }
        for (int row = 0; row < n; row++) {
            double sum = rest[row];
            for (int m = 0; m < row; m++) {
                sum -= factors[row * n + m] * rest[m];
            }
            rest[row] = sum;
        }
        for (int row = n - 1; row >= 0; row--) {
            double sum = rest[row];
            for (int m = row + 1; m < n; m++) {
                sum -= factors[row * n + m] * rest[m];
            }
            rest[row] = sum / factors[row * n + row];
        }
    }
}
