// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

/** Gauss's elimination with pivots from the column, of dense real and complex matrices by rows. */
public final class DenseFactor {
    private DenseFactor() {}

    /**
     * Factors in place.
     *
     * @param a the matrix by rows; its factors afterwards
     * @param n rows
     * @param pivots takes the row that each was exchanged with
     * @return false if the matrix is singular or not finite
     */
    public static boolean factor(double[] a, int n, int[] pivots) {
        for (int k = 0; k < n; k++) {
            int p = k;
            for (int row = k + 1; row < n; row++) {
                p = Math.abs(a[row * n + k]) > Math.abs(a[p * n + k]) ? row : p;
            }
            pivots[k] = p;
            double pivot = a[p * n + k];
            if (!(Math.abs(pivot) > 0 && Math.abs(pivot) < Double.POSITIVE_INFINITY)) {
                return false;
            }
            swap(a, n, k, p);
            eliminate(a, n, k);
        }
        return true;
    }

    /**
     * Factors in place without exchanging rows, where those are in a good order; what is singular has factors that are not finite.
     *
     * @param a the matrix by rows; its factors afterwards
     * @param n rows
     * @param pivots takes the row that each was exchanged with, itself
     */
    public static void factorInOrder(double[] a, int n, int[] pivots) {
        for (int k = 0; k < n; k++) {
            pivots[k] = k;
            eliminate(a, n, k);
        }
    }

    private static void eliminate(double[] a, int n, int k) {
        int from = k * n;
        double pivot = a[from + k];
        for (int row = k + 1; row < n; row++) {
            int to = row * n;
            double f = a[to + k] / pivot;
            a[to + k] = f;
            if (f != 0) {
                for (int m = k + 1; m < n; m++) {
                    a[to + m] -= f * a[from + m];
                }
            }
        }
    }

    private static void swap(double[] a, int n, int k, int p) {
        for (int m = 0; p != k && m < n; m++) {
            double other = a[k * n + m];
            a[k * n + m] = a[p * n + m];
            a[p * n + m] = other;
        }
    }

    /**
     * Solves in place.
     *
     * @param a factors
     * @param n rows
     * @param pivots of the factorization
     * @param x the right side before, the solution afterwards
     */
    public static void solve(double[] a, int n, int[] pivots, double[] x) {
        for (int k = 0; k < n; k++) {
            double other = x[k];
            x[k] = x[pivots[k]];
            x[pivots[k]] = other;
        }
        for (int row = 0; row < n; row++) {
            double sum = x[row];
            for (int m = 0; m < row; m++) {
                sum -= a[row * n + m] * x[m];
            }
            x[row] = sum;
        }
        for (int row = n - 1; row >= 0; row--) {
            double sum = x[row];
            for (int m = row + 1; m < n; m++) {
                sum -= a[row * n + m] * x[m];
            }
            x[row] = sum / a[row * n + row];
        }
    }

    /**
     * Factors a complex matrix in place.
     *
     * @param a its real part by rows
     * @param b its imaginary part
     * @param n rows
     * @param pivots takes the row that each was exchanged with
     * @return false if the matrix is singular or not finite
     */
    public static boolean factor(double[] a, double[] b, int n, int[] pivots) {
        for (int k = 0; k < n; k++) {
            int p = k;
            for (int row = k + 1; row < n; row++) {
                p = size(a, b, row * n + k) > size(a, b, p * n + k) ? row : p;
            }
            pivots[k] = p;
            double square = a[p * n + k] * a[p * n + k] + b[p * n + k] * b[p * n + k];
            if (!(square > 0 && square < Double.POSITIVE_INFINITY)) {
                return false;
            }
            swap(a, n, k, p);
            swap(b, n, k, p);
            double re = a[k * n + k] / square;
            double im = -b[k * n + k] / square;
            for (int row = k + 1; row < n; row++) {
                int o = row * n + k;
                double fr = a[o] * re - b[o] * im;
                double fi = a[o] * im + b[o] * re;
                a[o] = fr;
                b[o] = fi;
                for (int m = k + 1; m < n; m++) {
                    a[row * n + m] -= fr * a[k * n + m] - fi * b[k * n + m];
                    b[row * n + m] -= fr * b[k * n + m] + fi * a[k * n + m];
                }
            }
        }
        return true;
    }

    private static double size(double[] a, double[] b, int o) {
        return Math.abs(a[o]) + Math.abs(b[o]);
    }

    /**
     * Solves with a complex matrix in place.
     *
     * @param a real part of the factors
     * @param b imaginary part of the factors
     * @param n rows
     * @param pivots of the factorization
     * @param x real part of the right side before, of the solution afterwards
     * @param y the imaginary part
     */
    public static void solve(double[] a, double[] b, int n, int[] pivots, double[] x, double[] y) {
        for (int k = 0; k < n; k++) {
            double re = x[k];
            double im = y[k];
            x[k] = x[pivots[k]];
            y[k] = y[pivots[k]];
            x[pivots[k]] = re;
            y[pivots[k]] = im;
        }
        for (int row = 0; row < n; row++) {
            subtract(a, b, n, row, 0, row, x, y);
        }
        for (int row = n - 1; row >= 0; row--) {
            subtract(a, b, n, row, row + 1, n, x, y);
            double re = a[row * n + row];
            double im = b[row * n + row];
            double square = re * re + im * im;
            double xr = (x[row] * re + y[row] * im) / square;
            y[row] = (y[row] * re - x[row] * im) / square;
            x[row] = xr;
        }
    }

    private static void subtract(double[] a, double[] b, int n, int row, int from, int to, double[] x, double[] y) {
        double re = x[row];
        double im = y[row];
        for (int m = from; m < to; m++) {
            double ar = a[row * n + m];
            double ai = b[row * n + m];
            re -= ar * x[m] - ai * y[m];
            im -= ar * y[m] + ai * x[m];
        }
        x[row] = re;
        y[row] = im;
    }
}
