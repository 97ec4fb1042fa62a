// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import java.util.Arrays;

/**
 * The lines of a grid along one axis, which part its columns or rows; the first and the last one of these reach on without end.
 * Where bodies are all over the place the lines are evenly spaced. Where they are in clusters far from one another half of the lines
 * lie as densely as the bodies do, so that a cluster is not all in one cell.
 */
final class Lines {
    /** Part of the lines that are evenly spaced in any case. */
    private static final double EVEN = 0.5;

    /** Entries of the table for a column. */
    private static final int FINE = 4;

    /** Where the first one would begin, and how far all of them reach. */
    double low;

    double length;

    /** Number of columns or rows. */
    int count;

    private double side;
    private double perSide;
    private boolean isEven;

    /** The lines, if they are not even: line k is where column k begins. */
    private double[] lines = {};

    /** For each of even parts of the length the column in which it begins. */
    private int[] table = {};

    private double perEntry;

    boolean isEven() {
        return isEven;
    }

    /** Lines that are evenly spaced. */
    void even(double width) {
        isEven = true;
        side = width;
        perSide = 1 / width;
        count = 1 + (int) (length * perSide);
    }

    /**
     * Lines as dense as some places are.
     *
     * @param columns how many columns there are to be
     * @param places where bodies are, in any order; sorted then
     * @param number of them
     * @param least width of a column
     */
    void dense(int columns, double[] places, int number, double least) {
        Arrays.sort(places, 0, number);
        if (lines.length < columns + 1) {
            lines = new double[columns + columns / 2 + 1];
        }
        lines[0] = low;
        count = 1;
        double before = low;
        double part = 0;
        for (int k = 0; k <= number; k++) {
            double next = k < number ? Math.max(low, Math.min(low + length, places[k])) : low + length;
            double then = k < number ? EVEN * (next - low) / length + (1 - EVEN) * (k + 0.5) / number : 1;
            while (count < columns && (double) count / columns <= then) {
                double line = before + (next - before) * ((double) count / columns - part) / (then - part);
                lines[count] = Math.max(line, lines[count - 1] + least);
                count++;
            }
            before = next;
            part = then;
        }
        isEven = false;
        fillTable();
    }

    private void fillTable() {
        int entries = FINE * count;
        if (table.length < entries + 1) {
            table = new int[entries + entries / 2 + 1];
        }
        perEntry = entries / length;
        int column = 0;
        for (int k = 0; k < entries; k++) {
            while (column < count - 1 && lines[column + 1] <= low + k / perEntry) {
                column++;
            }
            table[k] = column;
        }
        table[entries] = count - 1;
    }

    /** The column or row of a place. */
    int at(double x) {
        if (isEven) {
            return Math.max(0, Math.min(count - 1, (int) ((x - low) * perSide)));
        }
        int entry = Math.max(0, Math.min(FINE * count - 1, (int) ((x - low) * perEntry)));
        int from = Math.max(0, table[entry] - 1); // rounding may have made it the neighbour's entry
        int to = Math.min(count - 1, table[entry + 1] + 1);
        while (from < to) {
            int middle = from + to + 1 >>> 1;
            if (lines[middle] <= x) {
                from = middle;
            } else {
                to = middle - 1;
            }
        }
        return from;
    }

    /** Where a column or row begins; that behind the last one too. */
    double line(int k) {
        if (isEven) {
            return low + k * side;
        }
        return k < count ? lines[k] : low + length;
    }
}
