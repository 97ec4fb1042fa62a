// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import java.util.Arrays;
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.State;

/**
 * An index of where bodies are: a grid of square cells over where most of them are, each body filed in all cells that its
 * box meets. The cells at the border reach on without end, so that bodies which have flown away are filed as well and
 * nobody needs to ask whether a point is in the grid. Bodies that would be filed in a large part of all cells are kept in
 * a list of their own. Where many share a cell, as in clusters far from one another, rows and columns are narrower where more
 * bodies are ({@link Lines}).
 *
 * <p>The grid is laid when it pays: a look at all bodies costs about a tenth of the laying, so the tenth question since the
 * bodies moved lays it, or the first one if there were so many before they moved. What is written afterwards between two
 * questions joins a list that each question looks at besides, until looking at it has cost as much as laying the grid anew.
 */
final class Cells {
    /** Up to so many bodies it is not worth while: a look at them all takes a quarter of a microsecond. */
    static final int FEW = 32;

    /** So many looks at all bodies cost as much as laying the grid: 10 among 100 or 1,000, 20 among more. */
    static final int LAYING = 10;

    /** Number of cells per body. */
    private static final double CELLS = 1;

    /** Bodies in a cell, in the mean of the bodies, from which on cells of one size will not do. */
    private static final int CROWDED = 12;

    /** Layings after which cells of one size are tried again, and bodies that are asked for each line where it is to be. */
    private static final int AGAIN = 32;

    private static final int ASKED = 4;

    /** So many bodies are asked where the crowd is. */
    private static final int SAMPLES = 64;

    /** By so much, relative to the coordinates, boxes are too large, which makes up for rounding in question and box. */
    private static final double MARGIN = 1e-9;

    /** Values per body in {@code spans}. */
    private static final int SPAN = 4;

    /** What to do with the cells of a body. */
    private static final int COUNT = 0;

    private static final int TALLY = 1;
    private static final int FILE = 2;

    final Census census;
    private final int few;
    private final int laying;

    final Lines xs = new Lines();
    final Lines ys = new Lines();
    int columns;
    int rows;
    private double side;

    /** How often cells of different size are to be laid before those of one size are tried again. */
    private int dense;

    /** The bodies of cell c are {@code filed[first[c]] … filed[first[c + 1] - 1]}, ascending. */
    int[] first = {};

    int[] filed = {};

    /** Those in no cell, and those that were written since. */
    final IntList others = new IntList();

    /** Bodies that the present question has looked at bear its number. */
    int[] mark = {};

    private int marking;

    /** What coordinates in and around the grid are as large as, at most. */
    private double reach;

    private boolean laid;
    private int huge;
    private boolean[] isOther = {};

    /** Questions since all bodies may have moved, and before that. */
    private long asked;

    private long askedBefore;

    /** Questions that will be put at once after the present one. */
    private int announced;

    /** Looks at bodies that were written since the grid was laid. */
    private long looks;

    private final IntList placed = new IntList();
    private double[] sample = new double[SAMPLES];
    private final Outline outline = new Outline();

    /** First and last column, first and last row of each body; first behind last: none. */
    private int[] spans = {};

    Cells(Census census, int few, int laying) {
        this.census = census;
        this.few = few;
        this.laying = laying;
    }

    /**
     * Takes note of what has happened since the last question, and decides how to answer the next one.
     *
     * @return true if by the cells, which hold all bodies then; false if by a look at all bodies
     */
    boolean serve() {
        placed.clear();
        boolean stay = census.follow(placed);
        if (!stay) {
            askedBefore = asked;
            asked = 0;
            laid = false;
        }
        asked++;
        int n = census.size;
        if (n <= few || census.state.isUnsettled()) {
            laid = false;
            return false;
        }
        if (laid) {
            for (int k = 0; k < placed.size; k++) {
                join(placed.values[k]);
            }
            looks += others.size - huge;
            laid = looks < (long) laying * n;
        }
        if (!laid && (asked + announced >= laying || askedBefore >= laying)) {
            lay();
        }
        return laid;
    }

    /** Says how many questions will be put one after the other, for which it may pay to lay the grid at the first one. */
    void announce(int questions) {
        announced = questions;
    }

    private void join(int body) {
        ensureMarks(body + 1);
        if (!isOther[body]) {
            isOther[body] = true;
            others.add(body);
        }
    }

    private void ensureMarks(int bodies) {
        if (mark.length < bodies) {
            mark = Arrays.copyOf(mark, bodies + bodies / 2);
            isOther = Arrays.copyOf(isOther, mark.length);
        }
    }

    /** A number for a question, which no body bears. */
    int nextMark() {
        if (marking == Integer.MAX_VALUE) {
            Arrays.fill(mark, 0);
            marking = 0;
        }
        return ++marking;
    }

    /** Whether a point is near enough that the margin is larger than rounding. */
    boolean covers(double x, double y) {
        return Math.abs(x) <= 16 * reach && Math.abs(y) <= 16 * reach;
    }

    /** A length that is larger than rounding about here. */
    double margin() {
        return 16 * MARGIN * reach;
    }

    int column(double x) {
        return xs.at(x);
    }

    int row(double y) {
        return ys.at(y);
    }

    private void lay() {
        int n = census.size;
        ensureMarks(n);
        if (spans.length < SPAN * n) {
            spans = new int[SPAN * (n + n / 2)];
        }
        measure();
        divide();
        int cells = columns * rows;
        for (int c = 1; c <= cells; c++) {
            first[c] += first[c - 1];
        }
        if (filed.length < first[cells]) {
            filed = new int[first[cells] + first[cells] / 2];
        }
        for (int i = n - 1; i >= 0; i--) {
            visit(i, FILE);
        }
        looks = 0;
        laid = true;
    }

    /** Divides the region into cells, and counts the bodies in them. */
    private void divide() {
        dense = Math.max(0, dense - 1);
        if (dense > 0 && countDense()) {
            return;
        }
        countEven();
        dense = areCrowded() && countDense() ? AGAIN : 0;
        if (dense == 0 && !xs.isEven()) {
            countEven(); // lines that are dense were no good
        }
    }

    private void countEven() {
        setSide(side);
        while (isTooMuch(count())) {
            setSide(2 * side); // they lie upon one another
        }
    }

    private boolean isTooMuch(long entries) {
        return entries > 6L * census.size + 64;
    }

    /** Chooses region and size of the cells. */
    private void measure() {
        extent(State.X, xs);
        extent(State.Y, ys);
        reach = Math.abs(xs.low) + Math.abs(ys.low) + xs.length + ys.length;
        double cells = CELLS * census.size;
        setSide(Math.max(least(), Math.max(Math.sqrt(xs.length * ys.length / cells), (xs.length + ys.length) / cells)));
    }

    /** The least side that a cell may have. */
    private double least() {
        return Math.max(1e-6 * reach, Double.MIN_NORMAL);
    }

    private void setSide(double length) {
        side = length;
        xs.even(length);
        ys.even(length);
        columns = xs.count;
        rows = ys.count;
    }

    /** Whether a body shares its cell with many, in the mean of all; asked while {@code first} has their numbers. */
    private boolean areCrowded() {
        long sum = 0;
        long squares = 0;
        for (int c = 0; c < columns * rows; c++) {
            sum += first[c];
            squares += (long) first[c] * first[c];
        }
        return squares > CROWDED * sum;
    }

    /** Lays lines where bodies are dense, and counts; false if that would be too many entries. */
    private boolean countDense() {
        int each = (int) Math.sqrt(CELLS * census.size) + 1;
        int across = Math.min(each, room(ys));
        dense(xs, State.X, Math.min(room(xs), (int) (CELLS * census.size / across) + 1));
        dense(ys, State.Y, across);
        columns = xs.count;
        rows = ys.count;
        return !isTooMuch(count());
    }

    /** Columns or rows that there may be. */
    private int room(Lines lines) {
        return (int) Math.max(1, Math.min(census.size, lines.length / least()));
    }

    private void dense(Lines lines, int axis, int columns) {
        int asked = sample(axis, ASKED * columns);
        lines.dense(columns, sample, asked, least());
    }

    /** Where most centres are along one axis. */
    private void extent(int axis, Lines lines) {
        int count = sample(axis, SAMPLES);
        if (count == 0) {
            lines.low = 0;
            lines.length = 0;
            return;
        }
        Arrays.sort(sample, 0, count);
        int cut = count / 20;
        double low = sample[cut];
        double length = sample[count - 1 - cut] - low;
        double beyond = length * (cut + 1) / (count - 2 * cut); // as dense as between
        lines.low = low - beyond;
        lines.length = length + 2 * beyond;
    }

    /** Asks some bodies, evenly chosen, for the coordinates of their centres; returns how many these are. */
    private int sample(int axis, int most) {
        if (sample.length < most) {
            sample = new double[most + most / 2];
        }
        double[] x = census.state.x();
        int n = census.size;
        int count = 0;
        for (int k = 0; k < most; k++) {
            int i = (int) ((long) k * n / most);
            if (census.bodies[i] != null) {
                sample[count++] = x[State.BLOCK * i + axis];
            }
        }
        return count;
    }

    /** Finds the cells of all bodies; leaves the numbers of bodies in {@code first}, and returns their sum. */
    private long count() {
        int cells = columns * rows;
        if (first.length <= cells) {
            first = new int[cells + cells / 2 + 1];
        }
        Arrays.fill(first, 0, cells + 1, 0);
        for (int k = 0; k < others.size; k++) {
            isOther[others.values[k]] = false;
        }
        others.clear();
        int most = 16 + cells / 16;
        long sum = 0;
        for (int i = 0; i < census.size; i++) {
            int o = SPAN * i;
            if (census.bodies[i] == null) {
                spans[o + 1] = -1;
                spans[o] = 0;
                continue;
            }
            span(i);
            int in = isFine(o) && area(o) <= 4 * most ? visit(i, COUNT) : area(o);
            if (in > most) {
                spans[o + 1] = -1;
                spans[o] = 0;
                join(i);
            } else {
                sum += visit(i, TALLY);
            }
        }
        huge = others.size;
        return sum;
    }

    private int area(int o) {
        return (spans[o + 1] - spans[o] + 1) * (spans[o + 3] - spans[o + 2] + 1);
    }

    /** Whether it is worth while to look which cells a body meets, as for a slender one that lies askew. */
    private boolean isFine(int o) {
        return spans[o + 1] - spans[o] > 1 && spans[o + 3] - spans[o + 2] > 1;
    }

    /** Finds columns and rows of the box around a body: that around its circle, or a smaller one if that is large. */
    private void span(int i) {
        double[] at = census.state.x();
        double x = at[State.BLOCK * i];
        double y = at[State.BLOCK * i + 1];
        double radius = census.radii[i];
        double margin = marginOf(i);
        double r = radius + margin;
        int o = SPAN * i;
        spans[o] = column(x - r);
        spans[o + 1] = column(x + r);
        spans[o + 2] = row(y - r);
        spans[o + 3] = row(y + r);
        Body body = census.bodies[i];
        if (area(o) > 4 && body.getShape().vertexCount() > 1) {
            outline.of(body);
            outline.bound();
            spans[o] = Math.max(spans[o], column(outline.leastX - margin));
            spans[o + 1] = Math.min(spans[o + 1], column(outline.mostX + margin));
            spans[o + 2] = Math.max(spans[o + 2], row(outline.leastY - margin));
            spans[o + 3] = Math.min(spans[o + 3], row(outline.mostY + margin));
        }
    }

    private double marginOf(int i) {
        double[] at = census.state.x();
        return MARGIN * (Math.abs(at[State.BLOCK * i]) + Math.abs(at[State.BLOCK * i + 1]) + census.radii[i] + reach);
    }

    /** Goes over the cells that a body meets; returns their number. */
    private int visit(int i, int what) {
        int o = SPAN * i;
        boolean fine = isFine(o);
        double margin = 0;
        if (fine) {
            outline.of(census.bodies[i]);
            margin = marginOf(i);
        }
        int number = 0;
        for (int row = spans[o + 2]; row <= spans[o + 3]; row++) {
            for (int column = spans[o]; column <= spans[o + 1]; column++) {
                if (fine && !meets(column, row, margin)) {
                    continue;
                }
                number++;
                int cell = row * columns + column;
                if (what == TALLY) {
                    first[cell]++;
                } else if (what == FILE) {
                    filed[--first[cell]] = i;
                }
            }
        }
        return number;
    }

    private boolean meets(int column, int row, double margin) {
        double left = column == 0 ? Double.NEGATIVE_INFINITY : xs.line(column) - margin;
        double right = column == columns - 1 ? Double.POSITIVE_INFINITY : xs.line(column + 1) + margin;
        double lower = row == 0 ? Double.NEGATIVE_INFINITY : ys.line(row) - margin;
        double upper = row == rows - 1 ? Double.POSITIVE_INFINITY : ys.line(row + 1) + margin;
        return outline.meets(left, lower, right, upper);
    }
}
