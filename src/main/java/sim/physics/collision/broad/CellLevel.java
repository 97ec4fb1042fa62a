// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.broad;

import java.io.Serializable;

/**
 * Square cells for boxes that are no larger than one of them. They lie one after the other along a row, and the rows are wound round
 * one ring of buckets with an odd step near the golden section, so the world needs no bounds and its shape does not matter. Cells far
 * apart may share a bucket, which costs a look and nothing else.
 */
final class CellLevel implements Serializable {
    private static final long serialVersionUID = 1L;

    static final int SMALLEST = 256;

    /** Where in the number of a cell that of its level begins. */
    private static final int SHIFT = 26;

    static final int MOST_LEVELS = 1 << 31 - SHIFT;
    static final int MOST_BUCKETS = 1 << SHIFT;

    /** A box counts as fitting only with a margin for the rounding of cell numbers. */
    private static final double MARGIN = 0.999;

    private final int number;
    private final double perLength;

    /** Of the sum of a box's bounds. */
    private final double perCell;

    /** Extent of the largest box that fits. */
    final double largest;

    final int mask;

    /** From a cell's bucket to that of the cell above. */
    final int rowStep;

    /** The first body of each cell's bucket, plus 1. */
    final int[] head;

    /** Bodies in it. */
    int count;

    /** Where the bodies of finer levels are in its cells; null while nobody has asked. */
    CellShadow shadow;

    CellLevel(int number, double cell, int buckets) {
        this.number = number;
        perLength = 1 / cell;
        perCell = 0.5 / cell;
        largest = MARGIN * cell;
        mask = buckets - 1;
        rowStep = (int) (0.6180339887498949 * buckets) | 1;
        head = new int[buckets];
    }

    /** The level of a cell. */
    static int of(int cell) {
        return cell >>> SHIFT;
    }

    /** The cell that holds the centre of a body's box. */
    int place(int body, Boxes boxes) {
        double[] d = boxes.data();
        int o = Boxes.STRIDE * body;
        int bucket = coordinate(d[o] + d[o + 2]) + coordinate(d[o + 1] + d[o + 3]) * rowStep & mask;
        return number << SHIFT | bucket;
    }

    /** Number of a row or column from the sum of a box's bounds; beyond ±2³¹ all are one. */
    private int coordinate(double sum) {
        return (int) Math.floor(sum * perCell);
    }

    /** The first row or column whose boxes may reach up to a place. */
    int first(double low) {
        return (int) Math.floor(low * perLength - 0.5);
    }

    /** The last one whose boxes may reach down to a place. */
    int last(double high) {
        return (int) Math.floor(high * perLength + 0.5);
    }

    /** Number of cells whose boxes may overlap that of a body. */
    double reached(int body, Boxes boxes) {
        double[] d = boxes.data();
        int o = Boxes.STRIDE * body;
        return (1.0 + last(d[o + 2]) - first(d[o])) * (1.0 + last(d[o + 3]) - first(d[o + 1]));
    }
}
