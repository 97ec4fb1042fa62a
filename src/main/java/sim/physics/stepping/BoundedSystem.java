// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;

/**
 * Finds the unknowns between bounds for which ½ xᵀ A x + bᵀ x is least, where A is symmetric and positive definite. First by Newton's steps in those that
 * are not held at a bound, of which what goes beyond a bound ends there (Bertsekas, <i>Projected Newton methods for optimization problems with simple
 * constraints</i>, 1982): mostly one or two. If one of them does not make it less, by steps that end at the first bound (active sets; Nocedal and Wright,
 * <i>Numerical Optimization</i>, 2006). Each makes it less, so that the last one is of use even if it is not the solution. Factors are made within the
 * envelope of the matrix: unknowns that depend on one another are to be near one another.
 */
final class BoundedSystem implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Steps at most, and of the first kind. */
    private static final int STEPS = 100;

    private static final int BOLD = 8;

    /** Part of the largest unknowns by which they may miss the solution. */
    private static final double CLOSE = 1e-12;

    int size;

    /** Length of a row of the matrix. */
    transient int room;

    /** The lower triangle, row by row; and the first column of each row that is not 0. */
    transient double[] matrix;

    transient int[] begins;

    /** The constant b, and bounds. */
    transient double[] constant;

    transient double[] low;
    transient double[] high;

    /** The unknowns: where to begin, and the solution. */
    transient double[] x;

    /** How large unknowns are that matter. */
    double scale;

    /** A x + b; and whether an unknown is held at its bound. */
    private transient double[] slope;

    private transient boolean[] areHeld;

    /** The unknowns that are free; the factor of their part of the matrix, with the inverses of its diagonal, and where its rows begin. */
    private transient int[] free;

    private transient double[] factor;
    private transient double[] inverse;
    private transient int[] firsts;

    /** Newton's step of the free ones; where all go to, what they move by, and the matrix times that. */
    private transient double[] step;

    private transient double[] next;
    private transient double[] moved;
    private transient double[] turned;

    /** Makes room. */
    void reserve(int unknowns) {
        size = unknowns;
        if (unknowns > room) {
            room = Math.max(unknowns, 2 * room);
            matrix = new double[room * room];
            factor = new double[room * room];
            begins = new int[room];
            firsts = new int[room];
            free = new int[room];
            areHeld = new boolean[room];
            constant = new double[room];
            low = new double[room];
            high = new double[room];
            x = new double[room];
            slope = new double[room];
            inverse = new double[room];
            step = new double[room];
            next = new double[room];
            moved = new double[room];
            turned = new double[room];
        }
    }

    /** Solves it, from where the unknowns are, as far as that goes. */
    void solve() {
        begin();
        boolean isBold = true;
        boolean hasGained = true;
        boolean goesOn = holdAll();
        for (int turn = 0; goesOn && turn < STEPS; turn++) {
            int count = listFree();
            if (!factor(count)) {
                restart();
                return;
            }
            head(count);
            boolean wasBold = isBold;
            isBold &= turn < BOLD && leap(count);
            if (wasBold && !isBold && restart()) {
                goesOn = holdAll();
                continue;
            }
            double part = isBold ? 1 : walk(count);
            hasGained |= part > 0;
            if (part >= 1) {
                goesOn = hasGained ? holdAll() : freeOne();
                hasGained = isBold;
            }
        }
    }

    /** Begins anew in the middle of the bounds, or where there is but one, if that is less; whether it is. */
    private boolean restart() {
        double here = 0;
        for (int k = 0; k < size; k++) {
            here += 0.5 * x[k] * (slope[k] + constant[k]);
            moved[k] = high[k] < Double.POSITIVE_INFINITY ? 0.5 * (low[k] + high[k]) : low[k];
        }
        multiply(moved, turned);
        double there = 0;
        for (int k = 0; k < size; k++) {
            there += moved[k] * (0.5 * turned[k] + constant[k]);
        }
        if (there < here) {
            System.arraycopy(moved, 0, x, 0, size);
            begin();
        }
        return there < here;
    }

    private void begin() {
        for (int k = 0; k < size; k++) {
            x[k] = Math.max(low[k], Math.min(high[k], x[k]));
        }
        multiply(x, slope);
        for (int k = 0; k < size; k++) {
            slope[k] += constant[k];
            scale = Math.max(scale, Math.abs(slope[k]) / matrix[k * room + k]);
        }
    }

    /** How far an unknown alone would go, 0 if it is held where it is. */
    private double push(int k) {
        double push = -slope[k] / matrix[k * room + k];
        boolean isHeld = x[k] <= low[k] && push <= 0 || x[k] >= high[k] && push >= 0 || low[k] >= high[k];
        return isHeld ? 0 : push;
    }

    /** Holds those at bounds that are not pushed off them, and frees all others; whether something has to go anywhere. */
    private boolean holdAll() {
        boolean goes = false;
        for (int k = 0; k < size; k++) {
            boolean isPushed = Math.abs(push(k)) > CLOSE * scale;
            areHeld[k] = (x[k] <= low[k] || x[k] >= high[k]) && !isPushed;
            goes |= isPushed;
        }
        return goes;
    }

    /** Frees the one that is pushed off its bound most; whether there is one. */
    private boolean freeOne() {
        double most = CLOSE * scale;
        int first = -1;
        for (int k = 0; k < size; k++) {
            if (areHeld[k] && Math.abs(push(k)) > most) {
                most = Math.abs(push(k));
                first = k;
            }
        }
        if (first >= 0) {
            areHeld[first] = false;
        }
        return first >= 0;
    }

    private int listFree() {
        int count = 0;
        for (int k = 0; k < size; k++) {
            if (!areHeld[k]) {
                free[count++] = k;
            }
        }
        return count;
    }

    /** Finds Newton's step. */
    private void head(int count) {
        for (int i = 0; i < count; i++) {
            double sum = -slope[free[i]];
            for (int j = firsts[i]; j < i; j++) {
                sum -= factor[i * room + j] * step[j];
            }
            step[i] = sum * inverse[i];
        }
        for (int i = count - 1; i >= 0; i--) {
            step[i] *= inverse[i];
            for (int j = firsts[i]; j < i; j++) {
                step[j] -= factor[i * room + j] * step[i];
            }
        }
    }

    /** Takes the step, of each unknown as far as its bounds, if that makes it less; whether it does. */
    private boolean leap(int count) {
        System.arraycopy(x, 0, next, 0, size);
        for (int i = 0; i < count; i++) {
            int k = free[i];
            next[k] = Math.max(low[k], Math.min(high[k], x[k] + step[i]));
        }
        compare();
        double change = 0;
        for (int k = 0; k < size; k++) {
            change += moved[k] * (slope[k] + 0.5 * turned[k]);
        }
        if (change < 0) {
            move();
        }
        return change < 0;
    }

    /** Goes along the step to the first bounds that are in the way, which hold from then on; the part of the step that this is. */
    private double walk(int count) {
        double part = 1;
        for (int i = 0; i < count; i++) {
            double way = Math.abs((step[i] < 0 ? low[free[i]] : high[free[i]]) - x[free[i]]);
            part = Math.abs(step[i]) * part > way ? way / Math.abs(step[i]) : part;
        }
        System.arraycopy(x, 0, next, 0, size);
        for (int i = 0; i < count; i++) {
            int k = free[i];
            double bound = step[i] < 0 ? low[k] : high[k];
            boolean isThere = part < 1 && Math.abs(bound - x[k] - part * step[i]) <= CLOSE * scale;
            next[k] = isThere ? bound : x[k] + part * step[i];
            areHeld[k] = isThere;
        }
        compare();
        move();
        return part;
    }

    private void compare() {
        for (int k = 0; k < size; k++) {
            moved[k] = next[k] - x[k];
        }
        multiply(moved, turned);
    }

    private void move() {
        for (int k = 0; k < size; k++) {
            x[k] = next[k];
            slope[k] += turned[k];
        }
    }

    /** The matrix times a vector. */
    private void multiply(double[] vector, double[] product) {
        for (int i = 0; i < size; i++) {
            int row = i * room;
            double sum = matrix[row + i] * vector[i];
            for (int j = begins[i]; j < i; j++) {
                sum += matrix[row + j] * vector[j];
                product[j] += matrix[row + j] * vector[i];
            }
            product[i] = sum;
        }
    }

    /** Cholesky's factor of the part of the matrix that is of the free ones; whether there is one. */
    private boolean factor(int count) {
        int first = 0;
        for (int i = 0; i < count; i++) {
            int row = free[i] * room;
            int own = i * room;
            first = first(i, first);
            firsts[i] = first;
            double rest = matrix[row + free[i]];
            for (int j = first; j < i; j++) {
                double sum = matrix[row + free[j]];
                int other = j * room;
                for (int k = Math.max(first, firsts[j]); k < j; k++) {
                    sum -= factor[own + k] * factor[other + k];
                }
                factor[own + j] = sum * inverse[j];
                rest -= factor[own + j] * factor[own + j];
            }
            if (!(rest > 0)) {
                return false;
            }
            inverse[i] = 1 / Math.sqrt(rest);
        }
        return true;
    }

    /** The first free one on which a free one depends, looked for from another one on. */
    private int first(int i, int near) {
        int first = near;
        while (first < i && free[first] < begins[free[i]]) {
            first++;
        }
        while (first > 0 && free[first - 1] >= begins[free[i]]) {
            first--;
        }
        return first;
    }
}
