// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.broad;

import java.util.Arrays;
import sim.physics.internal.IntList;

/**
 * A broad phase for crowds: a grid of square cells, each body filed in the one cell that holds the centre of its box,
 * so that a box can only overlap boxes of its own cell and of the eight around it. Bodies whose box is larger than a
 * cell (walls) are kept in a list of their own that everybody looks at. The cost of a change does not grow with the
 * number of bodies.
 *
 * <p>The cells are found by hashing their coordinates, so the world needs no bounds. The cell size follows the boxes:
 * when too many of them do not fit, the grid is laid anew with larger cells.
 */
public final class CellGrid implements BroadPhase {
    private static final long serialVersionUID = 1L;

    private static final int NONE = -1;

    /** Cell of a body that is not in the grid, and of one in the list of large bodies. */
    private static final int OUTSIDE = -2;

    private static final int LARGE = -3;
    private static final int COLUMN_STEP = 0x9E3779B1;
    private static final int ROW_STEP = 0x85EBCA77;

    private double cell;
    private int mask = 255;
    private int[] head = filled(256);
    private int[] next = new int[8];
    private int[] previous = new int[8];
    private int[] bucket = filledOutside(8);
    private int[] column = new int[8];
    private int[] row = new int[8];

    /** The cell of each body, mixed into one number; two cells may share one, which costs a look and nothing else. */
    private int[] key = new int[8];

    /** Which bodies are pairs already of the body that is looked at: those marked with the present number. */
    private int[] mark = new int[8];

    private int marking;
    private final IntList large = new IntList();
    private int count;
    private int largeMovable;
    private int changesSinceLayout;

    /** Makes an empty grid; the first boxes decide the size of its cells. */
    public CellGrid() {
        // bodies come by add
    }

    @Override
    public void add(int body, Boxes boxes, Pairs pairs) {
        ensure(body + 1);
        count++;
        marking++;
        file(body, boxes);
        layAnewIfNeeded(boxes);
        collect(body, boxes, pairs);
    }

    /** Lays the grid anew when it is crowded or too many movable bodies do not fit; seldom enough to cost little. */
    private void layAnewIfNeeded(Boxes boxes) {
        changesSinceLayout++;
        boolean tooFine = largeMovable > 8 + count / 8;
        if (changesSinceLayout > count && (tooFine || count > 2 * (mask + 1))) {
            layAnew(boxes);
        }
    }

    @Override
    public void update(int body, Boxes boxes, Pairs pairs) {
        IntList of = pairs.of(body);
        marking++;
        if (of != null) {
            for (int k = of.size - 1; k >= 0; k--) {
                int p = of.values[k];
                int other = pairs.first(p) == body ? pairs.second(p) : pairs.first(p);
                mark[other] = marking;
                if (!boxes.overlap(body, other)) {
                    pairs.end(p);
                }
            }
        }
        if (bucket[body] == LARGE || !fits(body, boxes)) {
            unfile(body, boxes);
            file(body, boxes);
        }
        layAnewIfNeeded(boxes);
        collect(body, boxes, pairs);
    }

    /** Whether a body's box still belongs to the cell where the body is filed. */
    private boolean fits(int body, Boxes boxes) {
        double[] d = boxes.data();
        int o = Boxes.STRIDE * body;
        return Math.max(d[o + 2] - d[o], d[o + 3] - d[o + 1]) <= cell
                && coordinate(0.5 * (d[o] + d[o + 2])) == column[body]
                && coordinate(0.5 * (d[o + 1] + d[o + 3])) == row[body];
    }

    @Override
    public void remove(int body, Boxes boxes, Pairs pairs) {
        while (pairs.of(body) != null && pairs.of(body).size > 0) {
            pairs.end(pairs.of(body).values[0]);
        }
        unfile(body, boxes);
        count--;
    }

    /** Begins the pairs of a body with all whose boxes overlap its box, but for those that are marked. */
    private void collect(int body, Boxes boxes, Pairs pairs) {
        for (int k = 0; k < large.size; k++) {
            beginIfOverlapping(body, large.values[k], boxes, pairs);
        }
        if (bucket[body] == LARGE) {
            collectAll(body, boxes, pairs);
            return;
        }
        int centre = mix(column[body], row[body]);
        for (int dy = -1; dy <= 1; dy++) {
            for (int dx = -1; dx <= 1; dx++) {
                int wanted = centre + dx * COLUMN_STEP + dy * ROW_STEP;
                for (int other = head[hash(wanted)]; other != NONE; other = next[other]) {
                    if (key[other] == wanted) {
                        beginIfOverlapping(body, other, boxes, pairs);
                    }
                }
            }
        }
    }

    private void collectAll(int body, Boxes boxes, Pairs pairs) {
        for (int other = 0; other < bucket.length; other++) {
            if (bucket[other] >= 0) {
                beginIfOverlapping(body, other, boxes, pairs);
            }
        }
    }

    private void beginIfOverlapping(int body, int other, Boxes boxes, Pairs pairs) {
        if (other != body && mark[other] != marking && boxes.overlap(body, other)) {
            pairs.begin(body, other);
        }
    }

    private void file(int body, Boxes boxes) {
        double[] d = boxes.data();
        int o = Boxes.STRIDE * body;
        double extent = Math.max(d[o + 2] - d[o], d[o + 3] - d[o + 1]);
        if (cell == 0 && !boxes.isFixed(body)) {
            cell = 1.25 * extent;
        }
        if (!(extent <= cell)) {
            bucket[body] = LARGE;
            previous[body] = large.size;
            large.add(body);
            largeMovable += boxes.isFixed(body) ? 0 : 1;
            return;
        }
        column[body] = coordinate(0.5 * (d[o] + d[o + 2]));
        row[body] = coordinate(0.5 * (d[o + 1] + d[o + 3]));
        key[body] = mix(column[body], row[body]);
        int b = hash(key[body]);
        bucket[body] = b;
        previous[body] = NONE;
        next[body] = head[b];
        if (head[b] != NONE) {
            previous[head[b]] = body;
        }
        head[b] = body;
    }

    private void unfile(int body, Boxes boxes) {
        int b = bucket[body];
        bucket[body] = OUTSIDE;
        if (b == LARGE) {
            largeMovable -= boxes.isFixed(body) ? 0 : 1;
            int last = large.values[--large.size];
            large.values[previous[body]] = last;
            previous[last] = previous[body];
            return;
        }
        if (previous[body] == NONE) {
            head[b] = next[body];
        } else {
            next[previous[body]] = next[body];
        }
        if (next[body] != NONE) {
            previous[next[body]] = previous[body];
        }
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
            cell = 1.25 * extents[(n - 1) * 15 / 16];
        }
        while (count > mask + 1) {
            mask = 2 * mask + 1;
        }
        head = filled(mask + 1);
        large.clear();
        largeMovable = 0;
        changesSinceLayout = 0;
        for (int body = 0; body < bucket.length; body++) {
            if (bucket[body] != OUTSIDE) {
                file(body, boxes);
            }
        }
    }

    private int coordinate(double position) {
        double c = Math.floor(position / cell);
        return (int) Math.max(-1e9, Math.min(1e9, c));
    }

    private static int mix(int c, int r) {
        return c * COLUMN_STEP + r * ROW_STEP;
    }

    private int hash(int mixed) {
        return (mixed ^ mixed >>> 15) & mask;
    }

    private void ensure(int bodies) {
        int old = bucket.length;
        if (old < bodies) {
            int length = Math.max(2 * old, bodies);
            next = Arrays.copyOf(next, length);
            previous = Arrays.copyOf(previous, length);
            column = Arrays.copyOf(column, length);
            row = Arrays.copyOf(row, length);
            key = Arrays.copyOf(key, length);
            mark = Arrays.copyOf(mark, length);
            bucket = Arrays.copyOf(bucket, length);
            Arrays.fill(bucket, old, length, OUTSIDE);
        }
    }

    private static int[] filled(int length) {
        int[] a = new int[length];
        Arrays.fill(a, NONE);
        return a;
    }

    private static int[] filledOutside(int length) {
        int[] a = new int[length];
        Arrays.fill(a, OUTSIDE);
        return a;
    }
}
