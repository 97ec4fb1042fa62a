// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

/**
 * Sums and products with twice the precision (Dekker 1971; Ogita, Rump and Oishi, <i>Accurate sum and dot product</i>,
 * 2005). A value is high[k] + low[k].
 */
final class TwoFold {
    private TwoFold() {}

    /** value[at] += x · y. */
    static void add(double[] high, double[] low, int at, double x, double y) {
        double product = x * y;
        double error = Math.fma(x, y, -product);
        double sum = high[at] + product;
        double part = sum - high[at];
        low[at] += (high[at] - (sum - part)) + (product - part) + error;
        high[at] = sum;
    }

    /** value[at] += x. */
    static void add(double[] high, double[] low, int at, double x) {
        double sum = high[at] + x;
        double part = sum - high[at];
        low[at] += (high[at] - (sum - part)) + (x - part);
        high[at] = sum;
    }

    /** value[at] = (value[at]) · x, rounded to twice the precision. */
    static void scale(double[] high, double[] low, int at, double x) {
        double product = high[at] * x;
        low[at] = Math.fma(high[at], x, -product) + low[at] * x;
        high[at] = product;
    }
}
