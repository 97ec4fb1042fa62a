// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

import java.util.Arrays;

/**
 * The identity with a border of some rows below and as many columns on the right. Only blocks of the border are stored. This is
 * the write-up's matrix of a collision (chapter <i>Matrix Optimization</i>, section <i>Bordered Diagonal Identity Matrix</i>).
 *
 * <pre>
 *         n       m
 *     +-------+-------+
 *  n  |   1   | right |     momentum before and after, (18), (19), (24)
 *     +-------+-------+
 *  m  | below | corner|     restitution (23) and direction of the impulse (20)
 *     +-------+-------+
 * </pre>
 */
public final class BorderedIdentityMatrix implements Matrix {
    private static final long serialVersionUID = 1L;

    private final int identity;
    private final int border;
    private final BlockSparseMatrix blocks;

    /**
     * Creates an identity with an empty border.
     *
     * @param identity number of rows of the identity, n
     * @param border number of rows and columns of the border, m
     * @throws IllegalArgumentException if a size is negative or the sum does not fit into an int
     */
    public BorderedIdentityMatrix(int identity, int border) {
        Vectors.checkNotNegative("identity", identity);
        Vectors.checkNotNegative("border", border);
        if (border > Integer.MAX_VALUE - identity) {
            throw new IllegalArgumentException("border is " + border + ": with " + identity + " rows it is too large");
        }
        this.identity = identity;
        this.border = border;
        this.blocks = new BlockSparseMatrix(identity + border, identity + border);
    }

    /**
     * Adds a block to the border. Blocks that overlap add up.
     *
     * @param row row of its upper left value
     * @param column column of its upper left value
     * @param block the block; kept, not copied, so that its values may be set again
     * @throws IllegalArgumentException if the block reaches into the identity or out of the matrix
     */
    public void add(int row, int column, DenseMatrix block) {
        if (row < identity && column < identity) {
            throw new IllegalArgumentException(
                    "block at (" + row + ", " + column + "): it must lie in the border, from " + identity + " on");
        }
        blocks.add(row, column, block);
    }

    /**
     * Creates a zero block and adds it to the border.
     *
     * @param row row of its upper left value
     * @param column column of its upper left value
     * @param blockRows number of rows of the block, at least 1
     * @param blockColumns number of columns of the block, at least 1
     * @return the block, whose values may be set again and again
     * @throws IllegalArgumentException if the block reaches into the identity or out of the matrix
     */
    public DenseMatrix add(int row, int column, int blockRows, int blockColumns) {
        DenseMatrix block = new DenseMatrix(blockRows, blockColumns);
        add(row, column, block);
        return block;
    }

    /** Empties the border. */
    public void clear() {
        blocks.clear();
    }

    @Override
    public int rows() {
        return identity + border;
    }

    @Override
    public int columns() {
        return identity + border;
    }

    /** {@return the number of values of the blocks; the identity needs none} */
    @Override
    public int storedValues() {
        return blocks.storedValues();
    }

    @Override
    public void times(double[] x, double[] y) {
        Matrix.check(x, columns(), y, rows());
        copyIdentity(x, y);
        blocks.addTimes(x, y);
    }

    @Override
    public void transposeTimes(double[] x, double[] y) {
        Matrix.check(x, rows(), y, columns());
        copyIdentity(x, y);
        blocks.addTransposeTimes(x, y);
    }

    /** y = (x₀ … xₙ₋₁, 0 … 0). */
    private void copyIdentity(double[] x, double[] y) {
        System.arraycopy(x, 0, y, 0, identity);
        Arrays.fill(y, identity, identity + border, 0);
    }
}
