// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.util.Arrays;
import sim.physics.internal.IntList;
import sim.physics.internal.MinimumDegree;

/**
 * A matrix over the velocities of a heap's bodies: a block of 3 × 3 for each body, and two for each pair that touches; and its
 * factors L U by block elimination, body by body. The places of blocks are symmetric, their values need not be.
 */
final class BodyMatrix {
    /** Values of a block, row after row. */
    private static final int BLOCK = 9;

    private final MinimumDegree order = new MinimumDegree(false);
    private int n;

    /** Blocks beyond the diagonal by places in the order: those of place p are start[p] … start[p + 1] − 1, with the later places. */
    private int[] start = {};

    private int[] later = {};

    /** By blocks: where their products with the later ones of their place are subtracted, one after the other from the first. */
    private int[] firstTarget = {};

    private int[] target = {};

    /** Blocks of earlier places whose later place this is, place after place, and those places. */
    private int[] firstBefore = {};

    private int[] before = {};
    private int[] beforePlace = {};

    /** The blocks: of each place, and beyond it in its rows and in its columns. */
    private double[] diagonal = {};

    private double[] upper = {};
    private double[] lower = {};

    /** The same of the factors. */
    private double[] ownFactor = {};

    private double[] upperFactor = {};
    private double[] lowerFactor = {};

    /** Whether a place has to be factored. */
    private boolean[] isOld = {};

    /** By later places: the block, while those of one place are looked up. */
    private int[] at = {};

    private double[] work = {};

    BodyMatrix() {
        // grows with the heaps
    }

    /** Begins a heap whose bodies do not touch. */
    void begin(int bodies) {
        n = bodies;
        order.begin(bodies);
    }

    /** Takes note that two bodies touch. */
    void touch(int a, int b) {
        order.join(a, b);
    }

    /** Finds the order of elimination and the places of all blocks. */
    void lay() {
        order.find();
        ensureBodies();
        int count = 0;
        for (int p = 0; p < n; p++) {
            IntList met = order.later(order.order[p]);
            start[p] = count;
            later = later.length < count + met.size ? Arrays.copyOf(later, 2 * (count + met.size)) : later;
            for (int k = 0; k < met.size; k++) {
                later[count++] = order.place[met.values[k]];
            }
            IntList.sort(later, start[p], count);
        }
        start[n] = count;
        ensureBlocks(count);
        layBefore();
        int pairs = 0;
        for (int p = 0; p < n; p++) {
            int met = start[p + 1] - start[p];
            pairs += met * (met - 1) / 2;
        }
        target = target.length < pairs ? new int[2 * pairs] : target;
        int to = 0;
        for (int p = 0; p < n; p++) {
            to = aim(p, to);
        }
    }

    private void ensureBodies() {
        if (at.length < n) {
            start = new int[2 * n + 1];
            firstBefore = new int[2 * n + 1];
            at = new int[2 * n];
            isOld = new boolean[2 * n];
            diagonal = new double[BLOCK * 2 * n];
            ownFactor = new double[BLOCK * 2 * n];
            work = new double[6 * n];
        }
    }

    private void ensureBlocks(int count) {
        if (firstTarget.length < count) {
            firstTarget = new int[2 * count];
            before = new int[2 * count];
            beforePlace = new int[2 * count];
            upper = new double[2 * BLOCK * count];
            lower = new double[2 * BLOCK * count];
            upperFactor = new double[2 * BLOCK * count];
            lowerFactor = new double[2 * BLOCK * count];
        }
    }

    /** Finds the blocks of earlier places that each place is in. */
    private void layBefore() {
        Arrays.fill(firstBefore, 0, n + 1, 0);
        for (int i = 0; i < start[n]; i++) {
            firstBefore[later[i] + 1]++;
        }
        for (int p = 0; p < n; p++) {
            firstBefore[p + 1] += firstBefore[p];
            at[p] = firstBefore[p];
        }
        for (int p = 0; p < n; p++) {
            for (int i = start[p]; i < start[p + 1]; i++) {
                int r = at[later[i]]++;
                before[r] = i;
                beforePlace[r] = p;
            }
        }
    }

    private int aim(int p, int first) {
        int to = first;
        for (int i = start[p]; i < start[p + 1]; i++) {
            firstTarget[i] = to;
            for (int k = start[later[i]]; k < start[later[i] + 1]; k++) {
                at[later[k]] = k;
            }
            for (int j = i + 1; j < start[p + 1]; j++) {
                target[to++] = at[later[j]];
            }
        }
        return to;
    }

    /** The number of the block of two bodies that touch, as one of the rows of the first or, as ~ that, of its columns. */
    int block(int a, int b) {
        int p = order.place[a];
        int q = order.place[b];
        int first = Math.min(p, q);
        int k = Arrays.binarySearch(later, start[first], start[first + 1], Math.max(p, q));
        return p < q ? k : ~k;
    }

    /** Sets all to the inverses of masses and moments of inertia, 2 per body. */
    void clear(double[] w) {
        Arrays.fill(diagonal, 0, BLOCK * n, 0);
        Arrays.fill(upper, 0, BLOCK * start[n], 0);
        Arrays.fill(lower, 0, BLOCK * start[n], 0);
        for (int k = 0; k < n; k++) {
            int o = BLOCK * order.place[k];
            diagonal[o] = 1 / w[2 * k];
            diagonal[o + 4] = 1 / w[2 * k];
            diagonal[o + 8] = 1 / w[2 * k + 1];
        }
    }

    /** Adds a column times a row to a body's own block. */
    void add(int body, double cx, double cy, double ct, double rx, double ry, double rt) {
        add(diagonal, BLOCK * order.place[body], cx, cy, ct, rx, ry, rt);
    }

    /** Adds the same to the block of two bodies: the column is the first one's, the row the second one's. */
    void addBeyond(int block, double cx, double cy, double ct, double rx, double ry, double rt) {
        if (block >= 0) {
            add(upper, BLOCK * block, cx, cy, ct, rx, ry, rt);
        } else {
            add(lower, BLOCK * ~block, cx, cy, ct, rx, ry, rt);
        }
    }

    private static void add(double[] m, int o, double cx, double cy, double ct, double rx, double ry, double rt) {
        m[o] += cx * rx;
        m[o + 1] += cx * ry;
        m[o + 2] += cx * rt;
        m[o + 3] += cy * rx;
        m[o + 4] += cy * ry;
        m[o + 5] += cy * rt;
        m[o + 6] += ct * rx;
        m[o + 7] += ct * ry;
        m[o + 8] += ct * rt;
    }

    /** Factors the matrix; false if a pivot is none. */
    boolean factor() {
        Arrays.fill(isOld, 0, n, true);
        return refactor();
    }

    /** Takes note that the blocks of a body have changed since the matrix was factored. */
    void touchUp(int body) {
        isOld[order.place[body]] = true;
    }

    /** Factors again what has changed, and what depends on that: the way from each changed place to the last one. */
    boolean refactor() {
        for (int p = 0; p < n; p++) {
            if (isOld[p]) {
                isOld[p] = false;
                if (!refactor(p)) {
                    return false;
                }
                if (start[p] < start[p + 1]) {
                    isOld[later[start[p]]] = true;
                }
            }
        }
        return true;
    }

    /** Factors the blocks of a place, given those before it. */
    private boolean refactor(int p) {
        System.arraycopy(diagonal, BLOCK * p, ownFactor, BLOCK * p, BLOCK);
        System.arraycopy(upper, BLOCK * start[p], upperFactor, BLOCK * start[p], BLOCK * (start[p + 1] - start[p]));
        System.arraycopy(lower, BLOCK * start[p], lowerFactor, BLOCK * start[p], BLOCK * (start[p + 1] - start[p]));
        for (int r = firstBefore[p]; r < firstBefore[p + 1]; r++) {
            int i = before[r];
            subtract(ownFactor, BLOCK * p, lowerFactor, BLOCK * i, upperFactor, BLOCK * i);
            int to = firstTarget[i];
            for (int j = i + 1; j < start[beforePlace[r] + 1]; j++) {
                int o = BLOCK * target[to++];
                subtract(upperFactor, o, lowerFactor, BLOCK * i, upperFactor, BLOCK * j);
                subtract(lowerFactor, o, lowerFactor, BLOCK * j, upperFactor, BLOCK * i);
            }
        }
        if (!factor(ownFactor, BLOCK * p)) {
            return false;
        }
        for (int i = start[p]; i < start[p + 1]; i++) {
            divide(lowerFactor, BLOCK * i, ownFactor, BLOCK * p);
        }
        return true;
    }

    /** Factors a block: below the diagonal L, whose diagonal is 1, and U with the inverses of its diagonal. */
    private static boolean factor(double[] a, int o) {
        double p = 1 / a[o];
        double l = a[o + 3] * p;
        double m = a[o + 6] * p;
        double q = 1 / (a[o + 4] - l * a[o + 1]);
        double s = a[o + 5] - l * a[o + 2];
        double k = (a[o + 7] - m * a[o + 1]) * q;
        double r = 1 / (a[o + 8] - m * a[o + 2] - k * s);
        a[o] = p;
        a[o + 3] = l;
        a[o + 6] = m;
        a[o + 4] = q;
        a[o + 5] = s;
        a[o + 7] = k;
        a[o + 8] = r;
        return Math.abs(p) < Double.POSITIVE_INFINITY && Math.abs(q) < Double.POSITIVE_INFINITY
                && Math.abs(r) < Double.POSITIVE_INFINITY;
    }

    /** Divides a block by a factored one, from the right. */
    private static void divide(double[] a, int o, double[] f, int d) {
        for (int i = o; i < o + BLOCK; i += 3) {
            double x = a[i] * f[d];
            double y = (a[i + 1] - x * f[d + 1]) * f[d + 4];
            double z = (a[i + 2] - x * f[d + 2] - y * f[d + 5]) * f[d + 8];
            y -= z * f[d + 7];
            a[i + 2] = z;
            a[i + 1] = y;
            a[i] = x - y * f[d + 3] - z * f[d + 6];
        }
    }

    /** Subtracts the product of two blocks. */
    private static void subtract(double[] c, int o, double[] a, int i, double[] b, int j) {
        for (int row = 0; row < 3; row++) {
            double x = a[i + 3 * row];
            double y = a[i + 3 * row + 1];
            double z = a[i + 3 * row + 2];
            int at = o + 3 * row;
            c[at] -= x * b[j] + y * b[j + 3] + z * b[j + 6];
            c[at + 1] -= x * b[j + 1] + y * b[j + 4] + z * b[j + 7];
            c[at + 2] -= x * b[j + 2] + y * b[j + 5] + z * b[j + 8];
        }
    }

    /** Solves for velocities, 3 per body, in the place of the right side. */
    void solve(double[] r) {
        for (int p = 0; p < n; p++) {
            System.arraycopy(r, 3 * order.order[p], work, 3 * p, 3);
        }
        for (int p = 0; p < n; p++) {
            for (int i = start[p]; i < start[p + 1]; i++) {
                subtract(work, 3 * later[i], lowerFactor, BLOCK * i, 3 * p);
            }
        }
        for (int p = n - 1; p >= 0; p--) {
            for (int i = start[p]; i < start[p + 1]; i++) {
                subtract(work, 3 * p, upperFactor, BLOCK * i, 3 * later[i]);
            }
            int d = BLOCK * p;
            double x = work[3 * p];
            double y = work[3 * p + 1] - ownFactor[d + 3] * x;
            double z = (work[3 * p + 2] - ownFactor[d + 6] * x - ownFactor[d + 7] * y) * ownFactor[d + 8];
            y = (y - ownFactor[d + 5] * z) * ownFactor[d + 4];
            work[3 * p] = (x - ownFactor[d + 1] * y - ownFactor[d + 2] * z) * ownFactor[d];
            work[3 * p + 1] = y;
            work[3 * p + 2] = z;
        }
        for (int p = 0; p < n; p++) {
            System.arraycopy(work, 3 * p, r, 3 * order.order[p], 3);
        }
    }

    private static void subtract(double[] v, int to, double[] m, int o, int from) {
        double x = v[from];
        double y = v[from + 1];
        double z = v[from + 2];
        v[to] -= m[o] * x + m[o + 1] * y + m[o + 2] * z;
        v[to + 1] -= m[o + 3] * x + m[o + 4] * y + m[o + 5] * z;
        v[to + 2] -= m[o + 6] * x + m[o + 7] * y + m[o + 8] * z;
    }
}
