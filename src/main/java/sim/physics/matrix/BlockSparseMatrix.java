// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A matrix that is zero but for some blocks, each stored with its row and column offset: the write-up's J and J̇.
 *
 * <p>A product multiplies each block by the section of the vector that begins at the block's <i>column</i> offset, and
 * adds the result to the section of the answer that begins at its <i>row</i> offset. (The write-up takes the
 * section at the row index, in its text and in its example, which is right only for a block on the diagonal.) The transposed product changes the roles of the two.
 */
public final class BlockSparseMatrix implements Matrix {
    private static final long serialVersionUID = 1L;

    private final int rows;
    private final int columns;
    private final List<DenseMatrix> blocks = new ArrayList<>();
    private int[] rowOffset = new int[4];
    private int[] columnOffset = new int[4];

    /**
     * Makes a zero matrix.
     *
     * @param rows not negative
     * @param columns not negative
     */
    public BlockSparseMatrix(int rows, int columns) {
        if (rows < 0 || columns < 0) {
            throw new IllegalArgumentException("matrix is " + rows + " x " + columns + ": sizes must not be negative");
        }
        this.rows = rows;
        this.columns = columns;
    }

    /**
     * Adds a block; blocks that overlap add up.
     *
     * @param row of its upper left value
     * @param column of its upper left value
     * @param block kept, not copied, so that its values may be set again
     * @throws IllegalArgumentException if it does not fit in
     */
    public void add(int row, int column, DenseMatrix block) {
        if (row < 0 || column < 0 || row + block.rows() > rows || column + block.columns() > columns) {
            throw new IllegalArgumentException("block of " + block.rows() + " x " + block.columns() + " at (" + row + ", "
                    + column + "): it must lie within " + rows + " x " + columns);
        }
        int k = blocks.size();
        if (k == rowOffset.length) {
            rowOffset = Arrays.copyOf(rowOffset, 2 * k);
            columnOffset = Arrays.copyOf(columnOffset, 2 * k);
        }
        rowOffset[k] = row;
        columnOffset[k] = column;
        blocks.add(block);
    }

    /** Removes all blocks. */
    public void clear() {
        blocks.clear();
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
        for (DenseMatrix block : blocks) {
            sum += block.storedValues();
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
        for (int k = 0; k < blocks.size(); k++) {
            blocks.get(k).addTimes(x, columnOffset[k], y, rowOffset[k]);
        }
    }

    void addTransposeTimes(double[] x, double[] y) {
        for (int k = 0; k < blocks.size(); k++) {
            blocks.get(k).addTransposeTimes(x, rowOffset[k], y, columnOffset[k]);
        }
    }
}
