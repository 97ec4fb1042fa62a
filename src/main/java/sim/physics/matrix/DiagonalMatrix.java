// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

import java.util.Objects;

/**
 * A square matrix with values on its diagonal only, stored as one array: the write-up's W (chapter <i>Matrix
 * Optimization</i>, section <i>Diagonal Matrix</i>).
 */
public final class DiagonalMatrix implements Matrix {
    private static final long serialVersionUID = 1L;

    private final double[] values;

    /**
     * Makes a zero matrix.
     *
     * @param n rows and columns
     * @throws IllegalArgumentException if it is negative
     */
    public DiagonalMatrix(int n) {
        Vectors.checkNotNegative("n", n);
        values = new double[n];
    }

    /**
     * Makes a matrix of given values.
     *
     * @param values of the diagonal; kept, not copied
     */
    public DiagonalMatrix(double[] values) {
        this.values = Objects.requireNonNull(values, "values");
    }

    /**
     * The diagonal itself, not a copy: what is written there is the matrix's.
     *
     * @return value i is that in row i and column i
     */
    public double[] values() {
        return values;
    }

    /**
     * A value of the diagonal.
     *
     * @param i row and column
     * @return the value there
     * @throws IllegalArgumentException if there is no such row
     */
    public double get(int i) {
        Vectors.checkIndex("i", i, values.length);
        return values[i];
    }

    /**
     * Sets a value of the diagonal.
     *
     * @param i row and column
     * @param value the value there
     * @throws IllegalArgumentException if there is no such row
     */
    public void set(int i, double value) {
        Vectors.checkIndex("i", i, values.length);
        values[i] = value;
    }

    @Override
    public int rows() {
        return values.length;
    }

    @Override
    public int columns() {
        return values.length;
    }

    @Override
    public int storedValues() {
        return values.length;
    }

    @Override
    public void times(double[] x, double[] y) {
        Matrix.check(x, values.length, y, values.length);
        // yᵢ = wᵢ xᵢ
        for (int i = 0; i < values.length; i++) {
            y[i] = values[i] * x[i];
        }
    }

    /** The transpose of a diagonal matrix is the matrix itself. */
    @Override
    public void transposeTimes(double[] x, double[] y) {
        times(x, y);
    }
}
