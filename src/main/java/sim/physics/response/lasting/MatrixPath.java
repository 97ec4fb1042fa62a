// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;

/**
 * Finds which rows of {@link HeapRows} are at which bound by the method of complementary pivots (Lemke 1965; Cottle, Pang and Stone,
 * <i>The Linear Complementarity Problem</i>, 1992). All rows are made to part by a speed τ that is large enough for no contact to press;
 * as τ falls, contacts close, stick and slide one after the other, and at τ = 0 the bounds are those of the problem. In the
 * plane Coulomb's law is made of straight lines, so that the way is, and τ may have to rise again for a while; it ends where sets of bounds
 * that are exchanged one by one run in circles, since a path that comes from infinity cannot close on itself (friction of bodies in a
 * plane has no other end for it: Stewart and Trinkle 1996).
 *
 * <p>Each exchange of a row's impulse for its velocity is one sweep over the tableau of all rows. Rounding adds up on the way,
 * and the matrix is a little heavier on its diagonal, so impulses are about right only; the sides are.
 */
final class MatrixPath implements Serializable {
    private static final long serialVersionUID = 1L;
    private static final double WEIGHT = 1e-8;

    /** Exchanges at most for each row, and beside them. */
    private static final int EACH = 8;

    private static final int BESIDE = 40;

    /** Pivots, and rates along the way relative to the largest, that are zero but for rounding. */
    private static final double NOTHING = 1e-13;

    /** Lower bounds that are that many times farther than velocities are out of sight. */
    private static final double FAR = 1e3;

    /** Multiplications in the time in which a row is asked for its next bound. */
    private static final int BOUNDED = 8;

    private transient HeapRows at;
    private int n;

    /** Whether the tableau is that of the end of a path for these rows. */
    private boolean isAtEnd;

    /** What the present basic variables, impulses of free rows and velocities of others, do under the other variables of all rows. */
    private double[] tableau = {};

    /** The basic variables' values at τ = 0, and how they grow with τ; and the rows' units. */
    private double[] value = {};

    private double[] rate = {};
    private double[] unit = {};

    /** Rates that are none on the present way. */
    private double none;

    /** −1 and +1 at the lower and the upper bound, 0 where the row is free. */
    private int[] side = {};

    /** The next bound on the way: its row, and on which side it lies. */
    private int row;

    private int way;

    /**
     * Follows the path.
     *
     * @param rows the problem, which gets about the impulses of its end
     * @param sides takes the side of each row if it comes to its end
     * @return whether it does
     */
    boolean follow(HeapRows rows, double[] sides) {
        at = rows;
        isAtEnd = begin() && go(start(FAR)) || begin() && go(start(Double.POSITIVE_INFINITY));
        return give(sides);
    }

    /** Takes note that the rows have changed. */
    void forget() {
        isAtEnd = false;
    }

    /**
     * Goes on from the end of the last path, whose rows have other velocities now, as these change evenly.
     *
     * @param rows the same rows
     * @param sides as before
     * @return whether there is such an end, and the way from it came to one
     */
    boolean resume(HeapRows rows, double[] sides) {
        if (!isAtEnd) {
            return false;
        }
        at = rows;
        give(sides);
        at.evaluate();
        return change(sides, true);
    }

    /**
     * Goes on from the end of a path to a solution that is nearer to that of the matrix without its additional weight (the proximal point
     * algorithm: Rockafellar 1976).
     *
     * @param sides as before
     * @return whether the path to it came to its end; else the impulses are as before
     */
    boolean refine(double[] sides) {
        return change(sides, false);
    }

    /** Follows the way on which velocities that the impulses leave wrong are made right. */
    private boolean change(double[] sides, boolean fromBefore) {
        double[] a = tableau;
        at.count((long) n * n);
        none = 0;
        for (int i = 0; i < n; i++) {
            double before = value[i];
            double now = side[i] == 0 ? at.impulse[i] / unit[i] : unit[i] * (at.velocity[i] - at.bound[i]);
            double change = 0;
            for (int j = 0; j < n; j++) {
                change -= side[j] == 0 ? a[i * n + j] * unit[j] * (at.velocity[j] - at.bound[j]) : 0;
            }
            value[i] = now + change;
            rate[i] = (fromBefore ? before : now) - value[i];
            none = Math.max(none, NOTHING * Math.max(Math.abs(value[i]), Math.abs(rate[i])));
        }
        isAtEnd = go(1);
        return give(sides);
    }

    /** Goes the way from a τ to zero. */
    private boolean go(double from) {
        double tau = from;
        double sense = -1;
        for (int k = EACH * n + BESIDE; k > 0 && tau < Double.POSITIVE_INFINITY && sense != 0; k--) {
            double step = next(tau, sense);
            if (sense < 0 && step >= tau) {
                return true;
            }
            if (row < 0) {
                return false;
            }
            tau += sense * step;
            sense = exchange(tau);
        }
        return false;
    }

    /** Takes the problem over, in units in which a unit at a row does 1 there; false if a row cannot be moved. */
    private boolean begin() {
        n = at.rows;
        at.count(2L * n * n);
        if (side.length < n) {
            int room = at.bearer.length;
            tableau = new double[room * room];
            value = new double[room];
            rate = new double[room];
            unit = new double[room];
            side = new int[room];
        }
        for (int i = 0; i < n; i++) {
            if (!(at.own(i) > 0 && at.own(i) < Double.POSITIVE_INFINITY)) {
                return false;
            }
            unit[i] = 1 / Math.sqrt(at.own(i));
        }
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                tableau[i * n + j] = at.replies[j * n + i] * unit[i] * unit[j];
            }
            tableau[i * n + i] += WEIGHT;
        }
        return true;
    }

    /**
     * Puts all rows at their lower bounds, where there is one in sight; the others are free.
     *
     * @param far how many times the speeds a row's lower bound gives it that is out of sight
     * @return the τ at which all are right, or NaN if free rows are beyond their bounds
     */
    private double start(double far) {
        double scale = 0;
        none = NOTHING;
        for (int i = 0; i < n; i++) {
            value[i] = unit[i] * (at.without[i] - at.bound[i]);
            rate[i] = at.bearer[i] < 0 ? 1 + 0.5 * (i * 0.6180339887498949 % 1) : 0; // uneven, so that seldom two are met at once
            side[i] = -1;
            scale = Math.max(scale, Math.abs(value[i]));
        }
        for (int t = 0; t < n; t++) {
            if (at.bearer[t] >= 0) {
                lean(t, -1, 0);
            }
        }
        for (int j = 0; j < n; j++) {
            double low = bound(j, -1);
            if (low < -far * scale || low == Double.NEGATIVE_INFINITY) {
                side[j] = 0;
            }
            for (int i = 0; low != 0 && side[j] != 0 && i < n; i++) {
                value[i] += low * tableau[i * n + j];
            }
        }
        for (int j = 0; j < n; j++) {
            if (side[j] == 0 && !pivot(j, 0, 0)) {
                return Double.NaN;
            }
        }
        double tau = 0;
        for (int i = 0; i < n; i++) {
            tau = at.bearer[i] < 0 && side[i] != 0 ? Math.max(tau, -value[i] / rate[i]) : tau;
        }
        for (int i = 0; i < n; i++) {
            double x = (value[i] + tau * rate[i]) * unit[i];
            if (side[i] == 0 && !(x >= at.least[i] && x <= at.most[i])) {
                return Double.NaN;
            }
        }
        return tau;
    }

    /** How far the way goes on until the next row is at a bound, which is noted. */
    private double next(double tau, double sense) {
        double step = Double.POSITIVE_INFINITY;
        row = -1;
        at.count(BOUNDED * (long) n);
        for (int i = 0; i < n; i++) {
            double x = value[i] + tau * rate[i];
            double dx = sense * rate[i];
            int by = at.bearer[i];
            if (side[i] != 0) {
                boolean counts = by < 0 || side[by] == 0;
                step = counts ? nearer(i, side[i], -side[i] * x, -side[i] * dx, step) : step;
            } else if (by < 0) {
                step = nearer(i, -1, x - bound(i, -1), dx, step);
                step = nearer(i, 1, bound(i, 1) - x, -dx, step);
            } else {
                double width = rub(i) * (value[by] + tau * rate[by]);
                double widening = sense * rub(i) * rate[by];
                step = nearer(i, -1, width + x, widening + dx, step);
                step = nearer(i, 1, width - x, widening - dx, step);
            }
        }
        return step;
    }

    /** Notes a bound that is nearer than others. */
    private double nearer(int i, int where, double room, double growth, double step) {
        if (!(growth < -none) || !(Math.max(0, room) < -growth * step)) {
            return step;
        }
        row = i;
        way = where;
        return Math.max(0, room) / -growth;
    }

    /** Friction in the rows' units. */
    private double rub(int t) {
        return at.friction[t] * unit[at.bearer[t]] / unit[t];
    }

    /** Lets the row off its bound or to it; returns whether τ falls or rises from there on, 0 if that is not to be said. */
    private double exchange(double tau) {
        if (side[row] == 0 && bears(row) && side[row + 1] == 0) {
            row++; // where nothing is borne nothing rubs: both are met at once
            way = value[row] + tau * rate[row] < 0 ? -1 : 1;
        }
        return side[row] != 0 ? free(row, tau) : bind(row);
    }

    /** Lets a row off its bound; returns what {@link #exchange} does. */
    private double free(int k, double tau) {
        if (bears(k)) {
            int t = k + 1;
            int slides = value[t] + tau * rate[t] > 0 ? -1 : 1; // against its velocity
            lean(t, slides, side[t]);
            side[t] = slides;
        }
        int from = side[k];
        if (!pivot(k, 0, bound(k, from))) {
            return 0;
        }
        side[k] = 0;
        double sense = -from * Math.signum(rate[k]); // inwards
        if (at.bearer[k] >= 0) {
            add(k, at.bearer[k], from * rub(k));
        }
        return sense;
    }

    /** Puts a row to the bound that it has come to; returns what {@link #exchange} does. */
    private double bind(int k) {
        if (at.bearer[k] >= 0) {
            add(k, at.bearer[k], -way * rub(k));
        }
        if (!pivot(k, bound(k, way), 0)) {
            return 0;
        }
        side[k] = way;
        return -way * Math.signum(rate[k]);
    }

    /** Where the impulse of a row is at a bound; that of friction is counted from there. */
    private double bound(int k, int where) {
        return at.bearer[k] >= 0 ? 0 : (where < 0 ? at.least[k] : at.most[k]) / unit[k];
    }

    private boolean bears(int k) {
        return k + 1 < n && at.bearer[k + 1] == k;
    }

    /** Adds a row's multiple to another one. */
    private void add(int to, int from, double times) {
        double[] a = tableau;
        for (int j = 0, o = to * n, p = from * n; j < n; j++) {
            a[o + j] += times * a[p + j];
        }
        value[to] += times * value[from];
        rate[to] += times * rate[from];
    }

    /** Lets friction that slides lean on what bears it to a side, where it did to another. */
    private void lean(int t, int now, int before) {
        double times = (now - before) * rub(t);
        for (int i = 0; times != 0 && i < n; i++) {
            tableau[i * n + at.bearer[t]] += times * tableau[i * n + t];
        }
    }

    /**
     * Exchanges the variables of a row.
     *
     * @param to where the one that was free stays
     * @param from where the other one was
     */
    private boolean pivot(int k, double to, double from) {
        double[] a = tableau;
        at.count((long) n * n);
        int o = k * n;
        double pivot = a[o + k];
        if (!(Math.abs(pivot) > NOTHING)) {
            return false;
        }
        double inverse = 1 / pivot;
        double v = (to - value[k]) * inverse;
        double r = -rate[k] * inverse;
        for (int i = 0; i < n; i++) {
            double f = a[i * n + k];
            if (i == k || f == 0) {
                continue;
            }
            value[i] += f * v;
            rate[i] += f * r;
            double g = f * inverse;
            for (int j = 0, q = i * n; j < n; j++) {
                a[q + j] -= g * a[o + j];
            }
            a[i * n + k] = g;
        }
        for (int j = 0; j < n; j++) {
            a[o + j] *= -inverse;
        }
        a[o + k] = inverse;
        value[k] = from + v;
        rate[k] = r;
        return true;
    }

    /** Tells what is found, if that is the end of a path; returns whether it is. */
    private boolean give(double[] sides) {
        for (int i = 0; isAtEnd && i < n; i++) {
            sides[i] = side[i];
            if (side[i] == 0) {
                at.impulse[i] = value[i] * unit[i];
            } else if (at.bearer[i] < 0) {
                at.impulse[i] = side[i] < 0 ? at.least[i] : at.most[i];
            } else {
                at.impulse[i] = side[i] * at.friction[i] * at.impulse[at.bearer[i]]; // which comes first
            }
        }
        return isAtEnd;
    }
}
