// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

import java.io.Serializable;
import java.util.Objects;

/**
 * A matrix as an iterative solver sees it: all that it can do is multiply itself, or its transpose, by a vector. So the
 * write-up's solver works on each of the sparse forms without looking inside.
 */
public interface Matrix extends Serializable {
    /**
     * Returns the number of rows.
     *
     * @return length of M x
     */
    int rows();

    /**
     * Returns the number of columns.
     *
     * @return length of x
     */
    int columns();

    /**
     * Computes y = M x.
     *
     * @param x the vector, at least {@link #columns()} values
     * @param y array that takes {@link #rows()} values; must not be the same array as x
     * @throws IllegalArgumentException if an array is too short or both are the same
     */
    void times(double[] x, double[] y);

    /**
     * Computes y = Mᵀ x.
     *
     * @param x the vector, at least {@link #rows()} values
     * @param y array that takes {@link #columns()} values; must not be the same array as x
     * @throws IllegalArgumentException if an array is too short or both are the same
     */
    void transposeTimes(double[] x, double[] y);

    /**
     * Returns the number of values that are stored.
     *
     * @return the sum over all blocks
     */
    int storedValues();

    /**
     * Returns all values, for tests and inspection. They are read off the products with the unit vectors, so a value that is not
     * finite shows in its whole row.
     *
     * @return the values, row by row
     */
    default double[][] toDense() {
        double[][] dense = new double[rows()][columns()];
        double[] unit = new double[columns()];
        double[] column = new double[rows()];
        for (int j = 0; j < columns(); j++) {
            unit[j] = 1;
            times(unit, column);
            unit[j] = 0;
            for (int i = 0; i < rows(); i++) {
                dense[i][j] = column[i];
            }
        }
        return dense;
    }

    /**
     * Checks the arguments of a product.
     *
     * @param x the operand
     * @param needed number of values that it must have
     * @param y the result
     * @param made number of values that it must have room for
     * @throws IllegalArgumentException if an array is too short or both are the same
     */
    static void check(double[] x, int needed, double[] y, int made) {
        Objects.requireNonNull(x, "x");
        Objects.requireNonNull(y, "y");
        if (x.length < needed) {
            throw new IllegalArgumentException("x has " + x.length + " values: the product needs " + needed);
        }
        if (y.length < made) {
            throw new IllegalArgumentException("y has room for " + y.length + " values: the product has " + made);
        }
        if (x == y) {
            throw new IllegalArgumentException("x and y are the same array: the product would overwrite its operand");
        }
    }
}
