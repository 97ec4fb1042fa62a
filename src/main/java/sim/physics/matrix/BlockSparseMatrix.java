// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

import java.util.Arrays;

/**
 * A matrix that is zero except for some blocks, each stored with its row and column offset: the write-up's J and J̇ (chapter
 * <i>Matrix Optimization</i>, section <i>Block Sparse Matrix</i>).
 *
 * <pre>
 *             column offset
 *                  |
 *            +-----+-------+-+
 *            |     .       | |
 * row offset +.....+-------+ |     y[row offset ...] += block x[column offset ...]
 *            |     | block | |
 *            |     +-------+ |
 *            +---------------+
 * </pre>
 *
 * <p>A product multiplies each block by the section of the vector that begins at the block's <i>column</i> offset. It adds the
 * result to the section of the answer that begins at the block's <i>row</i> offset. In the transposed product, the two change
 * roles. (The write-up takes the section of the vector at the <i>row</i> index, in its text and in its example. That is a slip:
 * it is right only for a block whose two offsets are equal.)
 *
 * <p>A block stays live: its values may be set again at each step, without a new block being made.
 */
public final class BlockSparseMatrix implements Matrix {
    private static final long serialVersionUID = 1L;

    private final int rows;
    private final int columns;
    private int count;
    private DenseMatrix[] blocks = new DenseMatrix[4];
    private int[] rowOffset = new int[4];
    private int[] columnOffset = new int[4];

    /**
     * Creates a zero matrix.
     *
     * @param rows number of rows, not negative
     * @param columns number of columns, not negative
     * @throws IllegalArgumentException if a size is negative
     */
    public BlockSparseMatrix(int rows, int columns) {
        Vectors.checkNotNegative("rows", rows);
        Vectors.checkNotNegative("columns", columns);
        this.rows = rows;
        this.columns = columns;
    }

    /**
     * Adds a block. Blocks that overlap add up.
     *
     * @param row row of its upper left value
     * @param column column of its upper left value
     * @param block the block; kept, not copied, so that its values may be set again
     * @throws IllegalArgumentException if the block does not fit into the matrix
     */
    public void add(int row, int column, DenseMatrix block) {
        if (row < 0 || column < 0 || block.rows() > rows - row || block.columns() > columns - column) {
            throw new IllegalArgumentException("block of " + block.rows() + " x " + block.columns() + " at (" + row
                    + ", " + column + "): it must lie within " + rows + " x " + columns);
        }
        if (count == blocks.length) {
            blocks = Arrays.copyOf(blocks, 2 * count);
            rowOffset = Arrays.copyOf(rowOffset, 2 * count);
            columnOffset = Arrays.copyOf(columnOffset, 2 * count);
        }
        blocks[count] = block;
        rowOffset[count] = row;
        columnOffset[count] = column;
        count++;
    }

    /**
     * Creates a zero block and adds it.
     *
     * @param row row of its upper left value
     * @param column column of its upper left value
     * @param blockRows number of rows of the block, at least 1
     * @param blockColumns number of columns of the block, at least 1
     * @return the block, whose values may be set again and again
     * @throws IllegalArgumentException if the block does not fit into the matrix
     */
    public DenseMatrix add(int row, int column, int blockRows, int blockColumns) {
        DenseMatrix block = new DenseMatrix(blockRows, blockColumns);
        add(row, column, block);
        return block;
    }

    /** Removes all blocks. The room for them stays. */
    public void clear() {
        Arrays.fill(blocks, 0, count, null);
        count = 0;
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
        int sum = 0;
        for (int k = 0; k < count; k++) {
            sum += blocks[k].storedValues();
        }
        return sum;
    }

    @Override
    public void times(double[] x, double[] y) {
        Matrix.check(x, columns, y, rows);
        Arrays.fill(y, 0, rows, 0);
        addTimes(x, y);
    }

    @Override
    public void transposeTimes(double[] x, double[] y) {
        Matrix.check(x, rows, y, columns);
        Arrays.fill(y, 0, columns, 0);
        addTransposeTimes(x, y);
    }

    void addTimes(double[] x, double[] y) {
        // y[row …] += B x[column …]
        for (int k = 0; k < count; k++) {
            blocks[k].addTimes(x, columnOffset[k], y, rowOffset[k]);
        }
    }

    void addTransposeTimes(double[] x, double[] y) {
        // y[column …] += Bᵀ x[row …]
        for (int k = 0; k < count; k++) {
            blocks[k].addTransposeTimes(x, rowOffset[k], y, columnOffset[k]);
        }
    }
}
