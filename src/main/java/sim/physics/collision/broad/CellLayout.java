// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.broad;

import java.util.Arrays;

/**
 * Sizes of cells for a crowd of boxes. Most movable ones share a level whose cells are a little larger than they. Larger ones, if
 * they are more than a few, have levels of their own; so have much smaller ones where they are crowded in a cell.
 */
final class CellLayout {
    /** Bodies too large for all levels that may be left to a list. */
    private static final int FEW = 16;

    /** Boxes that are smaller than the cells by this factor may have a level of their own, if they are more than so many. */
    private static final double SMALL = 0.125;

    private static final int FEW_SMALL = 64;
    private static final int MOST_FINER = CellLevel.MOST_LEVELS / 2;

    /** Small ones in one cell, in the mean of them, from which on they are a crowd. */
    private static final int CROWDED = 8;

    /** By how much the boxes in a level may differ at most, where it is not the usual one. */
    private static final double UNLIKE = 4;

    /** Size of a cell for a box. */
    static final double ROOM = 1.25;

    private static final double ROOM_FOR_ALL = 1.05;

    /** Bodies from which on a bucket has less room to spare, since memory then costs more than a look. */
    private static final int CROWD = 10_000;

    private final Boxes boxes;
    private final int[] bodies;

    /** Extents of the boxes in ascending order, as far as they are finite. */
    private final double[] extents;

    private final int usualBuckets;
    private final double[] cells = new double[CellLevel.MOST_LEVELS];
    private int count;
    private int usual;

    /**
     * Makes a layout.
     *
     * @param boxes all boxes
     * @param bodies indices
     * @param usualBuckets that the usual level has to have at least
     */
    CellLayout(Boxes boxes, int[] bodies, int usualBuckets) {
        this.boxes = boxes;
        this.bodies = bodies;
        this.usualBuckets = usualBuckets;
        extents = extents(true);
        double[] movable = extents(false);
        if (extents.length > 0) {
            choose(movable.length > 0 ? movable : extents);
        }
    }

    private double[] extents(boolean withFixed) {
        return Arrays.stream(bodies)
                .filter(body -> withFixed || !boxes.isFixed(body))
                .mapToDouble(boxes::extent)
                .filter(extent -> extent < Double.MAX_VALUE)
                .sorted()
                .toArray();
    }

    private void choose(double[] most) {
        double size = Math.max(size(most, 0, most.length), Double.MIN_NORMAL); // points may have a level, too
        finer(size, MOST_FINER);
        usual = count;
        add(size);
        coarser(size);
    }

    private void add(double size) {
        if (count < cells.length) {
            cells[count++] = size;
        }
    }

    /** Size of cells for the extents of a range. */
    private static double size(double[] sorted, int from, int to) {
        int last = to - 1;
        return Math.min(ROOM * sorted[from + (last - from) * 15 / 16], ROOM_FOR_ALL * sorted[last]);
    }

    /** Levels for what is crowded in cells of a size, the finest one first, and no more than some. */
    private void finer(double size, int most) {
        int small = above(SMALL * size);
        if (most > 0 && small > FEW_SMALL && size > Double.MIN_NORMAL && areCrowded(size)) {
            double finer = Math.max(size(extents, 0, small), Double.MIN_NORMAL);
            finer(finer, most - 1);
            add(finer);
        }
    }

    /** Levels for what does not fit cells of a size. */
    private void coarser(double size) {
        int from = above(size);
        while (extents.length - from > FEW && count < cells.length) {
            double next = Math.min(size(extents, from, extents.length), UNLIKE * extents[from]);
            add(next);
            from = Math.max(from + 1, above(next));
        }
    }

    /** Index of the first extent above a bound, with the margin of cells. */
    private int above(double bound) {
        int at = Arrays.binarySearch(extents, Math.nextUp(bound));
        return at < 0 ? -1 - at : at;
    }

    /** Whether many small ones share a cell of a size, in their mean. */
    private boolean areCrowded(double size) {
        CellLevel level = new CellLevel(0, size, bucketsFor(bodies.length, 0));
        int[] inCell = new int[level.mask + 1];
        long met = 0;
        long small = 0;
        for (int body : bodies) {
            if (boxes.extent(body) <= SMALL * size) {
                met += inCell[level.place(body, boxes)]++;
                small++;
            }
        }
        return 2 * met > CROWDED * small;
    }

    private static int bucketsFor(int bodies, int least) {
        int size = Math.max(CellLevel.SMALLEST, least);
        int wanted = bodies < CROWD ? 2 * bodies : bodies + bodies / 4;
        while (size < wanted && size < CellLevel.MOST_BUCKETS) {
            size *= 2;
        }
        return size;
    }

    /** The levels, without a body, from the finest one on. */
    CellLevel[] levels() {
        CellLevel[] levels = new CellLevel[count];
        for (int k = 0; k < count; k++) { // a ring has room for the shadows of finer levels, too
            int buckets = k == usual ? bucketsFor(bodies.length, usualBuckets) : bucketsFor(above(cells[k]), 0);
            levels[k] = new CellLevel(k, cells[k], buckets);
        }
        return levels;
    }

    /** Which level is that of most movable bodies. */
    int usual() {
        return usual;
    }
}
