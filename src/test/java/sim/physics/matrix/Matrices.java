// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;

/** Matrices to test with, and the dense products that the sparse ones must agree with. */
final class Matrices {
    private Matrices() {}

    /** Values in [-1, 1). */
    static double[] vector(int n, SplittableRandom random) {
        double[] x = new double[n];
        for (int i = 0; i < n; i++) {
            x[i] = random.nextDouble(-1, 1);
        }
        return x;
    }

    static DenseMatrix dense(int rows, int columns, SplittableRandom random) {
        return new DenseMatrix(rows, columns, vector(rows * columns, random));
    }

    /** The pin joint's 2 × 3 block of J: ±(1 0 −ry; 0 1 rx), from (45) and (46). */
    static DenseMatrix pin(double sign, double rx, double ry) {
        return new DenseMatrix(2, 3, sign, 0, -sign * ry, 0, sign, sign * rx);
    }

    static double[] product(double[][] m, double[] x) {
        double[] y = new double[m.length];
        for (int i = 0; i < m.length; i++) {
            for (int j = 0; j < m[i].length; j++) {
                y[i] += m[i][j] * x[j];
            }
        }
        return y;
    }

    static double[][] transpose(double[][] m, int columns) {
        double[][] t = new double[columns][m.length];
        for (int i = 0; i < m.length; i++) {
            for (int j = 0; j < columns; j++) {
                t[j][i] = m[i][j];
            }
        }
        return t;
    }

    /** Both products agree with those of a dense matrix that was written down by hand. */
    static void assertActsAs(double[][] dense, Matrix m, SplittableRandom random) {
        assertThat(m.rows()).isEqualTo(dense.length);
        assertThat(m.toDense()).isDeepEqualTo(dense);
        double[] x = vector(m.columns(), random);
        double[] y = vector(m.rows(), random); // what was there before must not matter
        m.times(x, y);
        assertThat(y).containsExactly(product(dense, x), within(1e-14));
        double[] u = vector(m.rows(), random);
        double[] v = vector(m.columns(), random);
        m.transposeTimes(u, v);
        assertThat(v).containsExactly(product(transpose(dense, m.columns()), u), within(1e-14));
    }

    /** J W Jᵀ as a solver sees it, without its ever being made. */
    record Mobility(BlockSparseMatrix j, DiagonalMatrix w) implements Matrix {
        private static final long serialVersionUID = 1L;

        @Override
        public int rows() {
            return j.rows();
        }

        @Override
        public int columns() {
            return j.rows();
        }

        @Override
        public void times(double[] x, double[] y) {
            double[] impulse = new double[j.columns()];
            double[] change = new double[j.columns()];
            j.transposeTimes(x, impulse);
            w.times(impulse, change);
            j.times(change, y);
        }

        @Override
        public void transposeTimes(double[] x, double[] y) {
            times(x, y);
        }

        @Override
        public int storedValues() {
            return j.storedValues() + w.storedValues();
        }
    }
}
