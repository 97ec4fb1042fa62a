// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

import java.util.Arrays;
import java.util.Objects;

/** A small matrix with all its values, row by row: the block of the sparse forms. */
public final class DenseMatrix implements Matrix {
    private static final long serialVersionUID = 1L;

    private final int rows;
    private final int columns;
    private final double[] values;

    /**
     * Creates a matrix.
     *
     * @param rows number of rows, at least 1
     * @param columns number of columns, at least 1
     * @param values values row by row, copied; none for a zero matrix
     * @throws IllegalArgumentException if the sizes are not positive or do not fit the values
     */
    public DenseMatrix(int rows, int columns, double... values) {
        if (rows < 1 || columns < 1) {
            throw new IllegalArgumentException(
                    "matrix is " + rows + " x " + columns + ": it must have rows and columns");
        }
        long size = (long) rows * columns;
        if (size > Integer.MAX_VALUE) {
            throw new IllegalArgumentException("matrix is " + rows + " x " + columns + ": it is too large to be dense");
        }
        Objects.requireNonNull(values, "values");
        if (values.length != 0 && values.length != size) {
            throw new IllegalArgumentException(
                    values.length + " values were given: a " + rows + " x " + columns + " matrix has " + size);
        }
        this.rows = rows;
        this.columns = columns;
        this.values = values.length == 0 ? new double[(int) size] : values.clone();
    }

    /**
     * Returns a value.
     *
     * @param row number of the row, from 0
     * @param column number of the column, from 0
     * @return the value
     * @throws IllegalArgumentException if there is no such row or column
     */
    public double get(int row, int column) {
        return values[index(row, column)];
    }

    /**
     * Sets a value.
     *
     * @param row number of the row, from 0
     * @param column number of the column, from 0
     * @param value the new value
     * @throws IllegalArgumentException if there is no such row or column
     */
    public void set(int row, int column, double value) {
        values[index(row, column)] = value;
    }

    private int index(int row, int column) {
        Vectors.checkIndex("row", row, rows);
        Vectors.checkIndex("column", column, columns);
        return row * columns + column;
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
        Arrays.fill(y, 0, rows, 0);
        addTimes(x, 0, y, 0);
    }

    @Override
    public void transposeTimes(double[] x, double[] y) {
        Matrix.check(x, rows, y, columns);
        Arrays.fill(y, 0, columns, 0);
        addTransposeTimes(x, 0, y, 0);
    }

    /** Adds M times a section of x to a section of y. */
    void addTimes(double[] x, int fromX, double[] y, int fromY) {
        // yᵢ += Σⱼ mᵢⱼ xⱼ
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
        // yⱼ += Σᵢ mᵢⱼ xᵢ, row by row as the values lie
        for (int i = 0, k = 0; i < rows; i++) {
            double factor = x[fromX + i];
            for (int j = 0; j < columns; j++) {
                y[fromY + j] += values[k++] * factor;
            }
        }
    }
}
