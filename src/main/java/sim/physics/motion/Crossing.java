// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;

/**
 * Foresees when the first of several values becomes zero that were seen at some times: each by the polynomial that gives the time as a
 * function of the value (inverse interpolation), through what was seen of it last and at the start, and its slope there.
 */
final class Crossing implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Times of which the values are kept, beside the start. */
    private static final int MOST = 5;

    /** Part of what a value falls up to which the cubic does not say whether it is negative. */
    private static final double BARELY = 0.02;

    private final double[] times = new double[MOST];
    private final Watched[] seen = new Watched[MOST];
    private int count;

    /** What was seen at time 0, if somebody has looked there. */
    private final Watched first = new Watched();

    private boolean hasFirst;

    /** What the polynomial goes through: values, and divided differences of times. */
    private final double[] value = new double[MOST + 2];

    private final double[] part = new double[MOST + 2];

    Crossing() {
        for (int k = 0; k < MOST; k++) {
            seen[k] = new Watched();
        }
    }

    /** Begins anew. */
    void begin() {
        count = 0;
        hasFirst = false;
    }

    /** What takes note of the values at time 0, and of how fast they change there. */
    Watched start() {
        hasFirst = true;
        return first;
    }

    /** The same, with what was seen at time 0. */
    void beginAgain() {
        count = 0;
        hasFirst = true;
    }

    /** What takes note of the values at a time; the oldest but those of the start are forgotten. */
    Watched at(double time) {
        if (count == MOST) {
            Watched oldest = seen[0];
            System.arraycopy(seen, 1, seen, 0, MOST - 1);
            System.arraycopy(times, 1, times, 0, MOST - 1);
            seen[MOST - 1] = oldest;
            count--;
        }
        times[count] = time;
        return seen[count++];
    }

    /**
     * When a value seems to have been negative that is not so at the start, nor at the end where it was seen last: where the cubic through both
     * is least; infinite if there is none.
     */
    double dip(double length) {
        Watched last = seen[count - 1];
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < last.size; k++) {
            if (first.values[k] > 0 && last.values[k] > 0 && first.rates[k] < 0 && last.rates[k] > 0) {
                least = Math.min(least, dip(first.values[k], first.rates[k], last.values[k], last.rates[k], length));
            }
        }
        return least;
    }

    private static double dip(double from, double falls, double to, double rises, double length) {
        double mean = (to - from) / length;
        double square = 3 * (falls + rises - 2 * mean);
        double half = 3 * mean - 2 * falls - rises; // of what is linear in the rate, falls + 2 half u + square u²
        double u = -falls / (half + Math.sqrt(half * half - square * falls));
        double depth = from + length * u * (falls + u * (half + u * square / 3));
        return depth < BARELY * (from - depth) ? u * length : Double.POSITIVE_INFINITY;
    }

    /** The first time at which one of the values should be zero that have been seen to change their sign; infinite if none has. */
    double next() {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < seen[count - 1].size; k++) {
            least = Math.min(least, next(k));
        }
        return least;
    }

    private double next(int k) {
        double from = hasFirst && first.values[k] > 0 ? 0 : Double.NaN;
        double above = hasFirst ? first.values[k] : 0;
        double to = Double.POSITIVE_INFINITY;
        double below = 0;
        for (int m = 0; m < count; m++) {
            double f = seen[m].values[k];
            if (f > 0 && !(times[m] < from)) {
                from = times[m];
                above = f;
            } else if (f <= 0 && times[m] < to) {
                to = times[m];
                below = f;
            }
        }
        if (!(from < to) || to == Double.POSITIVE_INFINITY) {
            return Double.POSITIVE_INFINITY;
        }
        double time = interpolate(k);
        return time > from && time < to ? time : (from * below - to * above) / (below - above);
    }

    /** The time at which the polynomial says that a value is zero. */
    private double interpolate(int k) {
        int n = 0;
        for (int m = count - 1; m >= 0; m--, n++) {
            value[n] = seen[m].values[k];
            part[n] = times[m];
        }
        int twice = 0;
        if (hasFirst) {
            twice = first.rates[k] < 0 ? 1 : 0;
            for (int m = 0; m <= twice; m++, n++) {
                value[n] = first.values[k];
                part[n] = 0;
            }
        }
        for (int j = 1; j < n; j++) {
            for (int i = n - 1; i >= j; i--) {
                boolean isSlope = twice > 0 && j == 1 && i == n - 1;
                part[i] = isSlope ? 1 / first.rates[k] : (part[i] - part[i - 1]) / (value[i] - value[i - j]);
            }
        }
        double time = part[n - 1];
        for (int i = n - 2; i >= 0; i--) {
            time = part[i] - time * value[i];
        }
        return time;
    }
}
