// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision.broad;

import java.util.Arrays;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;

/**
 * A broad phase for crowds: a grid of square cells. Each body is filed in the one cell that holds the centre of its box, so a box
 * can only overlap boxes of its own cell and of the eight around it. The cost of a change does not grow with the number of
 * bodies.
 *
 * <p>Where sizes are very unlike, there is a {@link CellLevel} of cells for each class of sizes, chosen by {@link CellLayout}. A
 * body looks at nine cells of each coarser level (hierarchical grids: Mirtich, <i>Efficient algorithms for two-phase collision
 * detection</i>, 1997), and at the bodies of the finer ones by their {@link CellShadow} in its own. The few largest bodies
 * (walls) are in a list of their own, which all others look at. The levels follow the boxes. The grid is laid again when the
 * crowd has grown, when too many boxes do not fit, or when a look finds too many.
 */
public final class CellGrid implements BroadPhase {
    private static final long serialVersionUID = 7L;

    private final Claim claim = new Claim();

    /** After the last body of a cell. */
    private static final int NONE = 0;

    /** Cell of a body that is not in the grid, and of one in the list of large bodies. */
    private static final int OUTSIDE = -2;

    private static final int LARGE = -3;

    /** Room for the four bodies that are taken out of a cell at once, and one more; the least room for bodies that are found. */
    private static final int USUAL = 5;

    private static final int LEAST = 64;

    /** Bodies that a look may find in the mean of many, and looks from which on that is a mean. */
    private static final int TOLERABLE = 64;

    private static final int MANY = 256;

    /** The levels, from the finest one on, and which of them is that of most movable bodies. */
    private CellLevel[] levels = {};

    private int usual;

    /** The body that follows another one in its cell, plus 1, at the place of the other one plus 1. */
    private int[] next = new int[9];

    /** Number of each body's cell, with that of its level. */
    private int[] bucket = filled(8, OUTSIDE);

    /** Which bodies are pairs already of the body that is looked at: those marked with the present number. */
    private int[] mark = new int[8];

    private int marking;

    /** Bodies or pairs found in a look, with room for one more. */
    private int[] found = new int[LEAST];

    private final IntList large = new IntList();
    private int count;

    /** Movable bodies that do not fit the usual level. */
    private int largeMovable;

    private int changesSinceLayout;
    private int countAtLayout = 8;

    /** Looks of late, bodies that they have found, and how many may be found in the mean. */
    private int looksOfLate;

    private long foundOfLate;
    private double tolerable = TOLERABLE;

    /** Boxes looked at so far, and bodies filed anew. */
    private long looks;

    /** Creates an empty grid. The first boxes decide the size of its cells. */
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
        shade(body, boxes);
        layAnewIfNeeded(boxes);
        collect(body, boxes, pairs);
    }

    @Override
    public void update(int body, Boxes boxes, Pairs pairs) {
        update(body, boxes, pairs, null);
    }

    /**
     * Updates one of many bodies whose boxes have all been set again.
     *
     * @param body index of the body
     * @param boxes all boxes
     * @param pairs the pairs
     * @param departures the bodies concerned and their old boxes; null for one body
     */
    public void update(int body, Boxes boxes, Pairs pairs, Departures departures) {
        endAndMark(body, boxes, pairs, departures);
        int b = place(body, boxes);
        if (b != bucket[body]) {
            unfile(body, boxes);
            file(body, b, boxes);
        }
        if (levels.length > 1) {
            shade(body, boxes);
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
        shade(body, boxes);
        count--;
    }

    /** Work done so far: boxes compared, and bodies sorted or filed anew. */
    long looks() {
        return looks;
    }

    /** Number of sizes of cells. */
    int levels() {
        return levels.length;
    }

    /** Lays the grid anew when it is crowded, too many movable bodies do not fit, or looks find too many; seldom enough to cost little. */
    private void layAnewIfNeeded(Boxes boxes) {
        changesSinceLayout++;
        boolean tooFine = largeMovable > 8 + count / 8 && changesSinceLayout > count;
        if (tooFine || count > 2 * countAtLayout || looksOfLate > MANY && findsTooMany()) {
            layAnew(boxes);
        }
    }

    /**
     * Whether looks found more than they may, in the mean of as many as there are bodies, or before that more than those may in
     * all. What a new layout does not mend it is not asked to mend again.
     */
    private boolean findsTooMany() {
        boolean isTooMany = foundOfLate > tolerable * Math.max(count, MANY);
        if (isTooMany || looksOfLate > count) {
            double mean = foundOfLate / (double) looksOfLate;
            tolerable = isTooMany ? 2 * mean : Math.max(TOLERABLE, Math.min(tolerable, 4 * mean));
            looksOfLate = 0;
            foundOfLate = 0;
        }
        return isTooMany;
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
        int near = around(body, boxes);
        looks += near;
        looksOfLate++;
        foundOfLate += near;
        int count = fresh(body, near, boxes);
        for (int k = 0; k < count; k++) {
            int other = found[k];
            if (mark[other] != marking && !(boxes.isFixed(body) && boxes.isFixed(other))) {
                mark[other] = marking; // it may have been found twice, in cells that share a bucket
                pairs.beginNew(body, other);
            }
        }
    }

    /** Finds the large bodies, and those in the cells that a body's box may reach, or all if that is less; how many there are. */
    private int around(int body, Boxes boxes) {
        if (found.length < large.size + LEAST) {
            found = new int[2 * large.size + LEAST];
        }
        System.arraycopy(large.values, 0, found, 0, large.size);
        int own = bucket[body];
        if (own == LARGE) {
            return aroundLarge(body, boxes, large.size);
        }
        CellLevel level = levels[CellLevel.of(own)];
        int size = around(level, level.head, next, own, large.size);
        return levels.length == 1 ? size : inOtherLevels(body, boxes, CellLevel.of(own), size);
    }

    private int aroundLarge(int body, Boxes boxes, int size) {
        double cells = 0;
        for (CellLevel level : levels) {
            cells += level.reached(body, boxes);
        }
        if (cells > count) {
            return all();
        }
        int count = size;
        for (CellLevel level : levels) {
            count = within(level, body, boxes, count);
        }
        return count;
    }

    private int inOtherLevels(int body, Boxes boxes, int own, int size) {
        int count = size;
        int finer = 0;
        for (int k = 0; k < own; k++) {
            finer += levels[k].count;
        }
        if (finer > 0) {
            CellLevel level = levels[own];
            CellShadow shadow = shadow(level, own, boxes);
            count = around(level, shadow.head, shadow.next, bucket[body], count);
        }
        for (int k = own + 1; k < levels.length; k++) {
            if (levels[k].count > 0) {
                count = around(levels[k], levels[k].head, next, levels[k].place(body, boxes), count);
            }
        }
        return count;
    }

    /** The shadow of the finer levels in one; it is cast when a body of that level looks at it first. */
    private CellShadow shadow(CellLevel level, int number, Boxes boxes) {
        if (level.shadow == null) {
            level.shadow = new CellShadow(level, bucket.length);
            looks += count;
            for (int body = 0; body < bucket.length; body++) {
                if (bucket[body] >= 0 && CellLevel.of(bucket[body]) < number) {
                    level.shadow.put(body, boxes);
                }
            }
        }
        return level.shadow;
    }

    /** Casts the shadow of a body anew, after it has been filed or taken out. */
    private void shade(int body, Boxes boxes) {
        int own = bucket[body] >= 0 ? CellLevel.of(bucket[body]) : levels.length;
        for (int k = 0; k < levels.length; k++) {
            CellShadow shadow = levels[k].shadow;
            if (shadow != null && own < k) {
                shadow.put(body, boxes);
            } else if (shadow != null) {
                shadow.drop(body);
            }
        }
    }

    /** Those in the nine cells around one, in the chains of a level or its shadow. */
    private int around(CellLevel level, int[] head, int[] after, int centre, int size) {
        int mask = level.mask;
        int[] list = found;
        int count = size;
        for (int row = -1; row <= 1; row++) {
            int first = centre + row * level.rowStep - 1;
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

    /** Those in the cells of a level that the box of a large body may reach. */
    private int within(CellLevel level, int body, Boxes boxes, int size) {
        double[] d = boxes.data();
        int o = Boxes.STRIDE * body;
        int low = level.first(d[o]);
        int columns = level.last(d[o + 2]) - low;
        int lowest = level.first(d[o + 1]);
        int rows = level.last(d[o + 3]) - lowest;
        int[] list = found;
        int count = size;
        for (int row = 0; row <= rows; row++) {
            int first = low + (lowest + row) * level.rowStep;
            for (int c = 0; c <= columns; c++) { // the numbers of cells may be the last ones there are
                for (int other = level.head[first + c & level.mask]; other != NONE; other = next[other]) {
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

    /** The cell where a body belongs by its box, in the finest level that it fits, or {@link #LARGE}. */
    private int place(int body, Boxes boxes) {
        double extent = boxes.extent(body);
        if (levels.length == 0 && !boxes.isFixed(body)) {
            levels = new CellLevel[] {new CellLevel(0, CellLayout.ROOM * extent, CellLevel.SMALLEST)};
        }
        for (CellLevel level : levels) {
            if (extent <= level.largest) {
                return level.place(body, boxes);
            }
        }
        return LARGE;
    }

    /** Whether a body in a cell, or in the list of large ones, is too large for the usual level, and movable. */
    private int unusual(int body, int b, Boxes boxes) {
        return (b == LARGE || CellLevel.of(b) > usual) && !boxes.isFixed(body) ? 1 : 0;
    }

    private void file(int body, int b, Boxes boxes) {
        bucket[body] = b;
        largeMovable += unusual(body, b, boxes);
        if (b == LARGE) {
            large.add(body);
        } else {
            CellLevel level = levels[CellLevel.of(b)];
            int at = b & level.mask;
            next[body + 1] = level.head[at];
            level.head[at] = body + 1;
            level.count++;
        }
    }

    private void unfile(int body, Boxes boxes) {
        int b = bucket[body];
        bucket[body] = OUTSIDE;
        largeMovable -= unusual(body, b, boxes);
        if (b == LARGE) {
            int place = 0;
            while (large.values[place] != body) {
                place++;
            }
            large.values[place] = large.values[--large.size];
            return;
        }
        CellLevel level = levels[CellLevel.of(b)];
        level.count--;
        int at = b & level.mask;
        int before = level.head[at];
        if (before == body + 1) {
            level.head[at] = next[body + 1];
            return;
        }
        while (next[before] != body + 1) { // few are in a cell
            before = next[before];
        }
        next[before] = next[body + 1];
    }

    /** Chooses the levels by the boxes of all bodies, and files everybody again. */
    private void layAnew(Boxes boxes) {
        CellLayout layout = new CellLayout(boxes, bodies(), levels.length == 0 ? 0 : levels[usual].mask + 1);
        levels = layout.levels();
        usual = layout.usual();
        large.clear();
        largeMovable = 0;
        changesSinceLayout = 0;
        countAtLayout = count;
        looksOfLate = 0;
        foundOfLate = 0;
        looks += count;
        for (int body = 0; body < bucket.length; body++) {
            if (bucket[body] != OUTSIDE) {
                file(body, place(body, boxes), boxes);
            }
        }
    }

    private int[] bodies() {
        int[] bodies = new int[count];
        for (int body = 0, n = 0; n < count; body++) {
            if (bucket[body] != OUTSIDE) {
                bodies[n++] = body;
            }
        }
        return bodies;
    }

    private void ensure(int bodies) {
        int old = bucket.length;
        if (old < bodies) {
            int length = Growth.length(old, bodies);
            next = Arrays.copyOf(next, length + 1);
            mark = Arrays.copyOf(mark, length);
            bucket = Arrays.copyOf(bucket, length);
            for (CellLevel level : levels) {
                level.shadow = null; // it is cast anew when it is wanted
            }
            Arrays.fill(bucket, old, length, OUTSIDE);
        }
    }

    private static int[] filled(int length, int value) {
        int[] a = new int[length];
        Arrays.fill(a, value);
        return a;
    }
}
