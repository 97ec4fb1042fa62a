// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

import java.util.Objects;

/**
 * A square matrix that has values on its diagonal only, stored as one array: the write-up's W (chapter <i>Matrix
 * Optimization</i>, section <i>Diagonal Matrix</i>).
 */
public final class DiagonalMatrix implements Matrix {
    private static final long serialVersionUID = 1L;

    private final double[] values;

    /**
     * Creates a zero matrix.
     *
     * @param n number of rows and columns
     * @throws IllegalArgumentException if n is negative
     */
    public DiagonalMatrix(int n) {
        Vectors.checkNotNegative("n", n);
        values = new double[n];
    }

    /**
     * Creates a matrix with given values.
     *
     * @param values values of the diagonal; kept, not copied
     */
    public DiagonalMatrix(double[] values) {
        this.values = Objects.requireNonNull(values, "values");
    }

    /**
     * Returns the diagonal itself, not a copy: writing to it changes the matrix.
     *
     * @return the array, whose value i is that in row i and column i
     */
    public double[] values() {
        return values;
    }

    /**
     * Returns a value of the diagonal.
     *
     * @param i number of the row and column
     * @return the value
     * @throws IllegalArgumentException if there is no such row
     */
    public double get(int i) {
        Vectors.checkIndex("i", i, values.length);
        return values[i];
    }

    /**
     * Sets a value of the diagonal.
     *
     * @param i number of the row and column
     * @param value the new value
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

    /** Multiplies the matrix by a vector, as it is its own transpose. */
    @Override
    public void transposeTimes(double[] x, double[] y) {
        times(x, y);
    }
}
