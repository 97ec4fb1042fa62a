// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;

/**
 * The symmetric matrix A = J W Jᵀ of an island in blocks of 2 × 2, and its factors L D Lᵀ, by block elimination in an
 * order that was found before. All indices of the work are kept, so that only numbers are computed.
 */
final class BlockFactor implements Serializable {
    private static final long serialVersionUID = 2L;

    private final int n;

    /** Blocks below the diagonal by columns: those of column p are start[p] … start[p + 1] − 1, with their rows. */
    final int[] start;

    final int[] row;

    /** Up to how many targets are kept: those of a node that all others meet are as many as the cube of their number. */
    private static final int MOST_KEPT = 1 << 24;

    /**
     * Where the products of the blocks of a column are subtracted: a block below the diagonal, or ~p on it. Of all columns, if these are
     * kept; else of the block that is eliminated.
     */
    private final int[] target;

    private final boolean areKept;

    /** The diagonal blocks, upper triangle: 3 each; their inverses when factored. */
    private final double[] diagonal;

    /** The diagonal values before the elimination, 2 each. */
    private final double[] size;

    private final double[] below;

    /** Rows that a node has: 2, 1, or 0 if it is at rest for now; and whether none beside or after it has two. */
    final byte[] rows;

    private final boolean[] isScalar;

    /** Whether all nodes have two rows. */
    private final boolean areAllPairs;

    /** Whether a row is one between angles, 2 each. */
    private final boolean[] isAngle;

    /** What was added to the diagonal of rows that are ways, and of those that are angles. */
    private double extraWay;

    private double extraTurn;

    /** The first of {@link #target} of each column. */
    private final int[] firstTarget;

    final Pivots pivots;

    /** Pivots not above this part of their diagonal are small. */
    private double floor;

    /**
     * Makes a matrix of zeros.
     *
     * @param start first block of each column, and the number of blocks
     * @param row the row of each block, ascending in a column
     * @param rows rows of each node, 1 or 2
     * @param isAngle whether a row is one between angles, 2 each
     */
    BlockFactor(int[] start, int[] row, byte[] rows, boolean[] isAngle) {
        this.start = start;
        this.row = row;
        this.rows = rows;
        this.isAngle = isAngle;
        n = start.length - 1;
        isScalar = new boolean[n];
        boolean all = true;
        for (int p = 0; p < n; p++) {
            all &= rows[p] == 2;
            isScalar[p] = rows[p] == 1;
            for (int e = start[p]; e < start[p + 1]; e++) {
                isScalar[p] &= rows[row[e]] == 1;
            }
        }
        areAllPairs = all;
        long count = count();
        areKept = count <= MOST_KEPT;
        firstTarget = new int[areKept ? n + 1 : 0];
        diagonal = new double[3 * n];
        pivots = new Pivots(2 * n);
        size = pivots.size;
        below = new double[4 * row.length];
        target = areKept ? targets((int) count) : new int[widest() + 1];
    }

    private long count() {
        long count = 0;
        for (int p = 0; p < n; p++) {
            long k = start[p + 1] - start[p];
            count += k * (k + 1) / 2;
        }
        return count;
    }

    private int widest() {
        int most = 0;
        for (int p = 0; p < n; p++) {
            most = Math.max(most, start[p + 1] - start[p]);
        }
        return most;
    }

    private int[] targets(int count) {
        int[] found = new int[count];
        int u = 0;
        for (int p = 0; p < n; p++) {
            firstTarget[p] = u;
            for (int e = start[p]; e < start[p + 1]; e++) {
                for (int f = e; f < start[p + 1]; f++) {
                    found[u++] = f == e ? ~row[e] : block(row[f], row[e]);
                }
            }
        }
        return found;
    }

    /** The first target of a block of a column, when those before it were up to here; finds them if they are not kept. */
    private int first(int e, int end, int before) {
        if (areKept) {
            return before;
        }
        int column = row[e];
        int block = start[column];
        target[0] = ~column;
        int last = end - e - 1;
        while (last > 0 && row[block] < row[e + 1]) {
            block++;
        }
        if (last > 0 && row[block + last - 1] == row[end - 1]) { // the column meets all that this one does, and here nothing between
            for (int m = 1; m <= last; m++) {
                target[m] = block + m - 1;
            }
            return 0;
        }
        for (int m = 1; m <= last; m++) {
            while (row[block] < row[e + m]) {
                block++;
            }
            target[m] = block;
        }
        return 0;
    }

    /** The number of the block of a row and a column, row > column. */
    int block(int r, int column) {
        int e = Arrays.binarySearch(row, start[column], start[column + 1], r);
        if (e < 0) {
            throw new IllegalStateException("block (" + r + ", " + column + ") is not part of the matrix");
        }
        return e;
    }

    /** Sets whether a node of one row is at rest: its row is zero, and it is left out. */
    void rest(int p, boolean yes) {
        rows[p] = yes ? (byte) 0 : 1;
    }

    /** Rows of a node, 0 if it is at rest. */
    int rows(int p) {
        return rows[p];
    }

    double[] diagonal() {
        return diagonal;
    }

    double[] below() {
        return below;
    }

    void clear() {
        Arrays.fill(below, 0);
    }

    /**
     * Factors the matrix.
     *
     * @param relaxation added to the diagonal, relative to its largest value among rows of the same unit
     * @param least pivots below this part of their diagonal are redundant
     * @param whole whether rows that are always redundant get multipliers, too
     */
    void factor(double relaxation, double least, boolean whole) {
        start(least);
        relax(relaxation);
        if (!whole) {
            pivots.setAside();
        }
        for (int p = 0, u = 0; p < n && areAllPairs; p++) {
            invertPair(p);
            for (int e = start[p], end = start[p + 1]; e < end; e++) {
                u = eliminate(p, e, end, first(e, end, u));
            }
        }
        for (int p = 0; p < n && !areAllPairs; p++) {
            if (rows[p] > 0) {
                invert(p);
                eliminate(p);
            }
        }
    }

    /** Products of blocks that a factorization takes. */
    long work() {
        long sum = n;
        for (int p = 0; p < n; p++) {
            long met = start[p + 1] - start[p];
            sum += met * (met + 1) / 2;
        }
        return sum;
    }

    /** Ways and angles apart, as a sum of the two would depend on the unit of length; and without rows that are empty or at rest. */
    private void relax(double relaxation) {
        extraWay = 0;
        extraTurn = 0;
        if (relaxation == 0) {
            return;
        }
        for (int p = 0; p < n; p++) {
            for (int k = 2 * p; k < 2 * p + rows[p]; k++) {
                extraWay = isAngle[k] ? extraWay : Math.max(extraWay, relaxation * size[k]);
                extraTurn = isAngle[k] ? Math.max(extraTurn, relaxation * size[k]) : extraTurn;
            }
        }
    }

    private double extra(int k) {
        return isAngle[k] ? extraTurn : extraWay;
    }

    /**
     * Factors the matrix, and takes a right side along as far as its first half of the solution.
     *
     * @param x b before, L⁻¹ b afterwards
     * @param least pivots below this part of their diagonal are redundant
     */
    void factor(double[] x, double least) {
        start(least);
        relax(0);
        pivots.setAside();
        if (areAllPairs) {
            factorPairs(x);
            return;
        }
        for (int p = 0; p < n; p++) {
            if (rows[p] > 0) {
                invert(p);
                eliminate(p);
                forward(x, p);
            }
        }
    }

    private void factorPairs(double[] x) {
        double[] b = below;
        for (int p = 0, u = 0; p < n; p++) {
            invertPair(p);
            int end = start[p + 1];
            double x0 = x[2 * p];
            double x1 = x[2 * p + 1];
            for (int e = start[p]; e < end; e++) {
                u = eliminate(p, e, end, first(e, end, u));
                int q = 2 * row[e];
                x[q] -= b[4 * e] * x0 + b[4 * e + 1] * x1;
                x[q + 1] -= b[4 * e + 2] * x0 + b[4 * e + 3] * x1;
            }
        }
    }

    private void eliminate(int p) {
        int u = areKept ? firstTarget[p] : 0;
        int end = start[p + 1];
        if (isScalar[p]) {
            for (int e = start[p]; e < end; e++) {
                u = eliminateScalar(p, e, end, first(e, end, u));
            }
        } else if (rows[p] == 1) {
            for (int e = start[p]; e < end; e++) {
                u = eliminateRow(p, e, end, first(e, end, u));
            }
        } else {
            for (int e = start[p]; e < end; e++) {
                u = rows[row[e]] == 0 ? u + end - e : eliminate(p, e, end, first(e, end, u));
            }
        }
    }

    /** Takes a node's part of the right side from the later ones. */
    private void forward(double[] x, int p) {
        double[] b = below;
        double x0 = x[2 * p];
        int end = start[p + 1];
        if (rows[p] == 1) {
            for (int e = start[p]; e < end; e++) {
                int q = 2 * row[e];
                x[q] -= b[4 * e] * x0;
                x[q + 1] -= b[4 * e + 2] * x0;
            }
            return;
        }
        double x1 = x[2 * p + 1];
        for (int e = start[p]; e < end; e++) {
            int q = 2 * row[e];
            x[q] -= b[4 * e] * x0 + b[4 * e + 1] * x1;
            x[q + 1] -= b[4 * e + 2] * x0 + b[4 * e + 3] * x1;
        }
    }

    /** Keeps the diagonal values, by which small pivots are known. */
    private void start(double least) {
        floor = pivots.start(least);
        double[] d = diagonal;
        for (int p = 0; p < n; p++) {
            size[2 * p] = d[3 * p];
            size[2 * p + 1] = d[3 * p + 2];
        }
    }

    /** Inverts a diagonal block; a row that is redundant gets no multiplier. */
    private void invert(int p) {
        if (rows[p] == 2) {
            invertPair(p);
            return;
        }
        double d00 = diagonal[3 * p] + extra(2 * p);
        diagonal[3 * p] = d00 > floor * size[2 * p] ? 1 / d00 : pivots.invert(d00, 2 * p);
    }

    private void invertPair(int p) {
        double[] d = diagonal;
        double d00 = d[3 * p] + extra(2 * p);
        double d01 = d[3 * p + 1];
        double d11 = d[3 * p + 2] + extra(2 * p + 1);
        double i0 = d00 > floor * size[2 * p] ? 1 / d00 : pivots.invert(d00, 2 * p);
        double q = d01 * i0;
        double s = d11 - d01 * q;
        double i1 = s > floor * size[2 * p + 1] ? 1 / s : pivots.invert(s, 2 * p + 1);
        d[3 * p] = i0 + q * q * i1;
        d[3 * p + 1] = -q * i1;
        d[3 * p + 2] = i1;
    }

    /** The same as {@link #eliminate(int, int, int, int)} where all nodes have one row. */
    private int eliminateScalar(int p, int e, int end, int from) {
        int u = from;
        double[] b = below;
        double c = b[4 * e];
        double l = c * diagonal[3 * p];
        diagonal[3 * ~target[u++]] -= l * c;
        for (int f = e + 1; f < end; f++) {
            b[4 * target[u++]] -= b[4 * f] * l;
        }
        b[4 * e] = l;
        return u;
    }

    /** The same where the column's node has one row. */
    private int eliminateRow(int p, int e, int end, int from) {
        if (rows[row[e]] == 0) {
            return from + end - e;
        }
        int u = from;
        double[] b = below;
        int o = 4 * e;
        double b0 = b[o];
        double b1 = b[o + 2];
        double l0 = b0 * diagonal[3 * p];
        double l1 = b1 * diagonal[3 * p];
        int q = 3 * ~target[u++];
        diagonal[q] -= l0 * b0;
        diagonal[q + 1] -= l0 * b1;
        diagonal[q + 2] -= l1 * b1;
        for (int f = e + 1; f < end; f++) {
            int t = 4 * target[u++];
            double c0 = b[4 * f];
            double c1 = b[4 * f + 2];
            b[t] -= c0 * l0; // rows of f, columns of e
            b[t + 1] -= c0 * l1;
            b[t + 2] -= c1 * l0;
            b[t + 3] -= c1 * l1;
        }
        b[o] = l0;
        b[o + 2] = l1;
        return u;
    }

    /** Forms L of one block, and subtracts its products with the later blocks of the column. */
    private int eliminate(int p, int e, int end, int from) {
        int u = from;
        double[] b = below;
        double i00 = diagonal[3 * p];
        double i01 = diagonal[3 * p + 1];
        double i11 = diagonal[3 * p + 2];
        int o = 4 * e;
        double b00 = b[o];
        double b01 = b[o + 1];
        double b10 = b[o + 2];
        double b11 = b[o + 3];
        double l00 = b00 * i00 + b01 * i01;
        double l01 = b00 * i01 + b01 * i11;
        double l10 = b10 * i00 + b11 * i01;
        double l11 = b10 * i01 + b11 * i11;
        int q = 3 * ~target[u++];
        diagonal[q] -= l00 * b00 + l01 * b01;
        diagonal[q + 1] -= l00 * b10 + l01 * b11;
        diagonal[q + 2] -= l10 * b10 + l11 * b11;
        for (int f = e + 1; f < end; f++) {
            int t = 4 * target[u++];
            double c00 = b[4 * f];
            double c01 = b[4 * f + 1];
            double c10 = b[4 * f + 2];
            double c11 = b[4 * f + 3];
            b[t] -= c00 * l00 + c01 * l01; // rows of f, columns of e
            b[t + 1] -= c00 * l10 + c01 * l11;
            b[t + 2] -= c10 * l00 + c11 * l01;
            b[t + 3] -= c10 * l10 + c11 * l11;
        }
        b[o] = l00;
        b[o + 1] = l01;
        b[o + 2] = l10;
        b[o + 3] = l11;
        return u;
    }

    /**
     * Solves A x = b.
     *
     * @param x b before, x afterwards, 2 per block
     */
    void solve(double[] x) {
        for (int p = 0; p < n; p++) {
            if (rows[p] > 0) {
                forward(x, p);
            }
        }
        back(x);
    }

    /**
     * The second half of the solution.
     *
     * @param x L⁻¹ b before, x afterwards
     */
    void back(double[] x) {
        double[] b = below;
        for (int p = n - 1; p >= 0; p--) {
            if (rows[p] < 2) {
                backRow(x, p);
                continue;
            }
            double x0 = diagonal[3 * p] * x[2 * p] + diagonal[3 * p + 1] * x[2 * p + 1];
            double x1 = diagonal[3 * p + 1] * x[2 * p] + diagonal[3 * p + 2] * x[2 * p + 1];
            for (int e = start[p]; e < start[p + 1]; e++) {
                double q0 = x[2 * row[e]];
                double q1 = x[2 * row[e] + 1];
                x0 -= b[4 * e] * q0 + b[4 * e + 2] * q1;
                x1 -= b[4 * e + 1] * q0 + b[4 * e + 3] * q1;
            }
            x[2 * p] = x0;
            x[2 * p + 1] = x1;
        }
    }

    private void backRow(double[] x, int p) {
        double sum = 0;
        if (rows[p] == 1) {
            sum = diagonal[3 * p] * x[2 * p];
            for (int e = start[p]; e < start[p + 1]; e++) {
                sum -= below[4 * e] * x[2 * row[e]] + below[4 * e + 2] * x[2 * row[e] + 1];
            }
        }
        x[2 * p] = sum;
        x[2 * p + 1] = 0;
    }
}
