// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.broad;

import java.util.Arrays;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;

/**
 * A broad phase for crowds: a grid of square cells, each body filed in the one cell that holds the centre of its box,
 * so that a box can only overlap boxes of its own cell and of the eight around it. Bodies whose box is larger than a
 * cell (walls) are kept in a list of their own that everybody looks at. The cost of a change does not grow with the
 * number of bodies.
 *
 * <p>The cells lie one after the other along a row, and the rows are wound round one ring of buckets with an odd step
 * near the golden section, so the world needs no bounds and its shape does not matter. Cells far apart may share a
 * bucket, which costs a look and nothing else. The cell size follows the boxes: when the crowd has grown, or too many
 * boxes do not fit, the grid is laid anew.
 */
public final class CellGrid implements BroadPhase {
    private static final long serialVersionUID = 6L;

    private final Claim claim = new Claim();

    /** After the last body of a cell. */
    private static final int NONE = 0;

    /** Cell of a body that is not in the grid, and of one in the list of large bodies. */
    private static final int OUTSIDE = -2;

    private static final int LARGE = -3;

    private static final int SMALLEST = 256;

    /** Room for the four bodies that are taken out of a cell at once, and one more; the least room for bodies that are found. */
    private static final int USUAL = 5;

    private static final int LEAST = 64;

    /** Bodies from which on a bucket has less room to spare, since memory then costs more than a look. */
    private static final int CROWD = 10_000;

    /** A box counts as fitting only with a margin for the rounding of cell numbers. */
    private static final double MARGIN = 0.999;

    private double cell;
    private double perCell;
    private int mask = SMALLEST - 1;

    /** From a cell's bucket to that of the cell above. */
    private int rowStep = stepFor(SMALLEST);

    /** The first body of each cell's bucket, plus 1. */
    private int[] head = new int[SMALLEST];

    /** The body that follows another one in its cell, plus 1, at the place of the other one plus 1. */
    private int[] next = new int[9];

    private int[] bucket = filled(8, OUTSIDE);

    /** Which bodies are pairs already of the body that is looked at: those marked with the present number. */
    private int[] mark = new int[8];

    private int marking;

    /** Bodies or pairs found in a look, with room for one more. */
    private int[] found = new int[LEAST];

    private final IntList large = new IntList();
    private int count;
    private int largeMovable;
    private int changesSinceLayout;
    private int countAtLayout = 8;

    /** Boxes looked at so far, and bodies filed anew. */
    private long looks;

    /** Makes an empty grid; the first boxes decide the size of its cells. */
    public CellGrid() {
        // bodies come by add
    }

    @Override
    public void claim() {
        claim.take(this);
    }

    @Override
    public void add(int body, Boxes boxes, Pairs pairs) {
        ensure(boxes.data().length / Boxes.STRIDE); // after another broad phase it may have pairs with any body
        count++;
        endAndMark(body, boxes, pairs, null);
        file(body, place(body, boxes), boxes);
        layAnewIfNeeded(boxes);
        collect(body, boxes, pairs);
    }

    @Override
    public void update(int body, Boxes boxes, Pairs pairs) {
        update(body, boxes, pairs, null);
    }

    /**
     * The same for one of many bodies whose boxes have all been set again.
     *
     * @param body index
     * @param boxes all boxes
     * @param pairs the pairs
     * @param departures which these are, and their old boxes; null for one body
     */
    public void update(int body, Boxes boxes, Pairs pairs, Departures departures) {
        endAndMark(body, boxes, pairs, departures);
        int b = place(body, boxes);
        if (b != bucket[body]) {
            unfile(body, boxes);
            file(body, b, boxes);
        }
        layAnewIfNeeded(boxes);
        collect(body, boxes, pairs);
        if (departures != null) {
            departures.done(body);
        }
    }

    @Override
    public void remove(int body, Boxes boxes, Pairs pairs) {
        while (pairs.countOf(body) > 0) {
            pairs.end(pairs.of(body, 0));
        }
        unfile(body, boxes);
        count--;
    }

    /** Work done so far: boxes compared, and bodies sorted or filed anew. */
    long looks() {
        return looks;
    }

    /** Lays the grid anew when it is crowded or too many movable bodies do not fit; seldom enough to cost little. */
    private void layAnewIfNeeded(Boxes boxes) {
        changesSinceLayout++;
        boolean tooFine = largeMovable > 8 + count / 8 && changesSinceLayout > count;
        if (tooFine || count > 2 * countAtLayout) {
            layAnew(boxes);
        }
    }

    /** Ends the pairs of a body whose boxes are apart now, and marks the partners in the others. */
    private void endAndMark(int body, Boxes boxes, Pairs pairs, Departures departures) {
        marking++;
        double[] d = boxes.data();
        int o = Boxes.STRIDE * body;
        double minX = d[o];
        double minY = d[o + 1];
        double maxX = d[o + 2];
        double maxY = d[o + 3];
        int apart = 0;
        if (pairs.countOf(body) >= found.length) {
            found = new int[2 * pairs.countOf(body)];
        }
        for (int k = pairs.countOf(body) - 1; k >= 0; k--) {
            int p = pairs.of(body, k);
            int other = pairs.other(p, body);
            found[apart] = p;
            int ends = 1 - boxes.met(other, minX, minY, maxX, maxY);
            if (departures != null && departures.parts(body, other, boxes)) {
                ends = 1; // and may begin anew
            } else {
                mark[other] = marking;
            }
            apart += ends;
        }
        for (int k = 0; k < apart; k++) {
            pairs.end(found[k]);
        }
        looks += pairs.countOf(body) + apart;
    }

    /** Begins the pairs of a body with all whose boxes overlap its box, but for those that are marked. */
    private void collect(int body, Boxes boxes, Pairs pairs) {
        mark[body] = marking;
        int near = around(body);
        looks += near;
        int count = fresh(body, near, boxes);
        for (int k = 0; k < count; k++) {
            int other = found[k];
            if (!(boxes.isFixed(body) && boxes.isFixed(other))) {
                pairs.beginNew(body, other);
            }
        }
    }

    /** Finds the large bodies, and those in the nine cells around a body's, or all if it is large; how many there are. */
    private int around(int body) {
        int centre = bucket[body];
        if (centre == LARGE) {
            return all();
        }
        int[] list = found.length < large.size + LEAST ? new int[2 * large.size + LEAST] : found;
        int[] after = next;
        int count = large.size;
        for (int k = 0; k < count; k++) {
            list[k] = large.values[k];
        }
        for (int row = -1; row <= 1; row++) {
            int first = centre + row * rowStep - 1;
            for (int c = first; c <= first + 2; c++) {
                if (count + USUAL >= list.length) {
                    list = Arrays.copyOf(list, 2 * list.length);
                }
                // no branch by how many of the usual few are in a cell, since nobody could foretell it
                int a = head[c & mask];
                list[count] = a - 1;
                count += -a >>> 31;
                int b = after[a];
                list[count] = b - 1;
                count += -b >>> 31;
                int d = after[b];
                list[count] = d - 1;
                count += -d >>> 31;
                int e = after[d];
                list[count] = e - 1;
                count += -e >>> 31;
                for (int other = after[e]; other != NONE; other = after[other]) {
                    if (count + USUAL >= list.length) {
                        list = Arrays.copyOf(list, 2 * list.length);
                    }
                    list[count++] = other - 1;
                }
            }
        }
        found = list;
        return count;
    }

    /** Keeps of the bodies found those whose boxes overlap that of a body and that are not marked; how many they are. */
    private int fresh(int body, int count, Boxes boxes) {
        double[] d = boxes.data();
        int o = Boxes.STRIDE * body;
        double minX = d[o];
        double minY = d[o + 1];
        double maxX = d[o + 2];
        double maxY = d[o + 3];
        int[] list = found;
        int kept = 0;
        for (int k = 0; k < count; k++) { // without a branch, too
            int other = list[k];
            int change = mark[other] ^ marking;
            list[kept] = other;
            kept += boxes.met(other, minX, minY, maxX, maxY) & (change | -change) >>> 31;
        }
        return kept;
    }

    private int all() {
        if (found.length <= count) {
            found = new int[2 * count];
        }
        int n = large.size;
        System.arraycopy(large.values, 0, found, 0, n);
        for (int other = 0; other < bucket.length; other++) {
            if (bucket[other] >= 0) {
                found[n++] = other;
            }
        }
        return n;
    }

    /** The bucket where a body belongs by its box, or {@link #LARGE}. */
    private int place(int body, Boxes boxes) {
        double[] d = boxes.data();
        int o = Boxes.STRIDE * body;
        double extent = Math.max(d[o + 2] - d[o], d[o + 3] - d[o + 1]);
        if (cell == 0 && !boxes.isFixed(body)) {
            setCell(1.25 * extent);
        }
        if (!(extent <= MARGIN * cell)) {
            return LARGE;
        }
        return coordinate(d[o] + d[o + 2]) + coordinate(d[o + 1] + d[o + 3]) * rowStep & mask;
    }

    private void setCell(double size) {
        cell = size;
        perCell = 0.5 / size;
    }

    /** Number of a row or column from the sum of a box's bounds; beyond ±2³¹ all are one. */
    private int coordinate(double sum) {
        return (int) Math.floor(sum * perCell);
    }

    private void file(int body, int b, Boxes boxes) {
        bucket[body] = b;
        if (b == LARGE) {
            large.add(body);
            largeMovable += boxes.isFixed(body) ? 0 : 1;
            return;
        }
        next[body + 1] = head[b];
        head[b] = body + 1;
    }

    private void unfile(int body, Boxes boxes) {
        int b = bucket[body];
        bucket[body] = OUTSIDE;
        if (b == LARGE) {
            largeMovable -= boxes.isFixed(body) ? 0 : 1;
            int place = 0;
            while (large.values[place] != body) {
                place++;
            }
            large.values[place] = large.values[--large.size];
            return;
        }
        if (head[b] == body + 1) {
            head[b] = next[body + 1];
            return;
        }
        int before = head[b]; // few are in a cell
        while (next[before] != body + 1) {
            before = next[before];
        }
        next[before] = next[body + 1];
    }

    /** Chooses the cell size by the boxes of the movable bodies, and files everybody again. */
    private void layAnew(Boxes boxes) {
        double[] extents = new double[count];
        int n = 0;
        for (int body = 0; body < bucket.length; body++) {
            if (bucket[body] != OUTSIDE && !boxes.isFixed(body)) {
                double[] d = boxes.data();
                int o = Boxes.STRIDE * body;
                extents[n++] = Math.max(d[o + 2] - d[o], d[o + 3] - d[o + 1]);
            }
        }
        if (n > 0) {
            Arrays.sort(extents, 0, n);
            setCell(Math.min(1.25 * extents[(n - 1) * 15 / 16], 1.05 * extents[n - 1]));
        }
        int size = mask + 1;
        int least = count < CROWD ? 2 * count : count + count / 4;
        while (size < least) {
            size *= 2;
        }
        mask = size - 1;
        rowStep = stepFor(size);
        head = new int[size];
        large.clear();
        largeMovable = 0;
        changesSinceLayout = 0;
        countAtLayout = count;
        looks += count;
        for (int body = 0; body < bucket.length; body++) {
            if (bucket[body] != OUTSIDE) {
                file(body, place(body, boxes), boxes);
            }
        }
    }

    private static int stepFor(int buckets) {
        return (int) (0.6180339887498949 * buckets) | 1;
    }

    private void ensure(int bodies) {
        int old = bucket.length;
        if (old < bodies) {
            int length = Growth.length(old, bodies);
            next = Arrays.copyOf(next, length + 1);
            mark = Arrays.copyOf(mark, length);
            bucket = Arrays.copyOf(bucket, length);
            Arrays.fill(bucket, old, length, OUTSIDE);
        }
    }

    private static int[] filled(int length, int value) {
        int[] a = new int[length];
        Arrays.fill(a, value);
        return a;
    }
}
