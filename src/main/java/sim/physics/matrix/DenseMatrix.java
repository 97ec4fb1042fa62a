// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

/** A small matrix with all its values, row by row: the block of the sparse forms. */
public final class DenseMatrix implements Matrix {
    private static final long serialVersionUID = 1L;

    private final int rows;
    private final int columns;
    private final double[] values;

    /**
     * Makes a matrix.
     *
     * @param rows at least 1
     * @param columns at least 1
     * @param values row by row; none for a zero matrix
     * @throws IllegalArgumentException if the sizes are not positive or do not fit the values
     */
    public DenseMatrix(int rows, int columns, double... values) {
        if (rows < 1 || columns < 1) {
            throw new IllegalArgumentException("matrix is " + rows + " x " + columns + ": it must have rows and columns");
        }
        if (values.length != 0 && values.length != rows * columns) {
            throw new IllegalArgumentException(
                    values.length + " values were given: a " + rows + " x " + columns + " matrix has " + rows * columns);
        }
        this.rows = rows;
        this.columns = columns;
        this.values = values.length == 0 ? new double[rows * columns] : values.clone();
    }

    /**
     * A value.
     *
     * @param row 0 …
     * @param column 0 …
     * @return the value there
     */
    public double get(int row, int column) {
        return values[row * columns + column];
    }

    /**
     * Sets a value.
     *
     * @param row 0 …
     * @param column 0 …
     * @param value the value there
     */
    public void set(int row, int column, double value) {
        values[row * columns + column] = value;
    }

    @Override
    public int rows() {
        return rows;
    }

    @Override
    public int columns() {
        return columns;
    }

    @Override
    public int storedValues() {
        return values.length;
    }

    @Override
    public void times(double[] x, double[] y) {
        Matrix.check(x, columns, y, rows);
        java.util.Arrays.fill(y, 0, rows, 0);
        addTimes(x, 0, y, 0);
    }

    @Override
    public void transposeTimes(double[] x, double[] y) {
        Matrix.check(x, rows, y, columns);
        java.util.Arrays.fill(y, 0, columns, 0);
        addTransposeTimes(x, 0, y, 0);
    }

    /** Adds M times a section of x to a section of y. */
    void addTimes(double[] x, int fromX, double[] y, int fromY) {
        for (int i = 0, k = 0; i < rows; i++) {
            double sum = 0;
            for (int j = 0; j < columns; j++) {
                sum += values[k++] * x[fromX + j];
            }
            y[fromY + i] += sum;
        }
    }

    /** Adds Mᵀ times a section of x to a section of y. */
    void addTransposeTimes(double[] x, int fromX, double[] y, int fromY) {
        for (int i = 0, k = 0; i < rows; i++) {
            double factor = x[fromX + i];
            for (int j = 0; j < columns; j++) {
                y[fromY + j] += values[k++] * factor;
            }
        }
    }
}
