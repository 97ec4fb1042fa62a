// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

/** A square matrix with values on its diagonal only: the write-up's W. */
public final class DiagonalMatrix implements Matrix {
    private static final long serialVersionUID = 1L;

    private final double[] values;

    /**
     * Makes a zero matrix.
     *
     * @param n rows and columns
     */
    public DiagonalMatrix(int n) {
        if (n < 0) {
            throw new IllegalArgumentException("n is " + n + ": it must not be negative");
        }
        values = new double[n];
    }

    /**
     * Makes a matrix of given values.
     *
     * @param values of the diagonal; kept, not copied
     */
    public DiagonalMatrix(double[] values) {
        this.values = values;
    }

    /**
     * The diagonal itself, not a copy.
     *
     * @return value n is that in row n and column n
     */
    public double[] values() {
        return values;
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
    public void times(double[] x, double[] y) {
        Matrix.check(x, values.length, y, values.length);
        for (int i = 0; i < values.length; i++) {
            y[i] = values[i] * x[i];
        }
    }

    /** The transpose of a diagonal matrix is the matrix itself. */
    @Override
    public void transposeTimes(double[] x, double[] y) {
        times(x, y);
    }

    @Override
    public int storedValues() {
        return values.length;
    }
}
