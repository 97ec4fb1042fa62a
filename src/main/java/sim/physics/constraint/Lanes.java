// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

/**
 * Loops over arrays that write one of them, element by element: compilers make vector instructions of these and seldom of
 * longer ones. The length is that of what is written.
 */
final class Lanes {
    private Lanes() {}

    /** out = a + s b. */
    static void add(double[] a, double s, double[] b, double[] out) {
        for (int k = 0; k < out.length; k++) {
            out[k] = a[k] + s * b[k];
        }
    }

    /** out = a + b. */
    static void add(double[] a, double[] b, double[] out) {
        for (int k = 0; k < out.length; k++) {
            out[k] = a[k] + b[k];
        }
    }

    /** out = a b − c d. */
    static void cross(double[] a, double[] b, double[] c, double[] d, double[] out) {
        for (int k = 0; k < out.length; k++) {
            out[k] = a[k] * b[k] - c[k] * d[k];
        }
    }

    /** out = a b + c d. */
    static void dot(double[] a, double[] b, double[] c, double[] d, double[] out) {
        for (int k = 0; k < out.length; k++) {
            out[k] = a[k] * b[k] + c[k] * d[k];
        }
    }

    /** out = a + b c. */
    static void addProduct(double[] a, double[] b, double[] c, double[] out) {
        for (int k = 0; k < out.length; k++) {
            out[k] = a[k] + b[k] * c[k];
        }
    }

    /** out = a − b c. */
    static void subtractProduct(double[] a, double[] b, double[] c, double[] out) {
        for (int k = 0; k < out.length; k++) {
            out[k] = a[k] - b[k] * c[k];
        }
    }

    /** out = a − b² c. */
    static void subtractSquare(double[] a, double[] b, double[] c, double[] out) {
        for (int k = 0; k < out.length; k++) {
            out[k] = a[k] - b[k] * b[k] * c[k];
        }
    }

    /** out = m + i a b. */
    static void entry(double[] m, double[] i, double[] a, double[] b, double[] out) {
        for (int k = 0; k < out.length; k++) {
            out[k] = m[k] + i[k] * a[k] * b[k];
        }
    }

    /** out = −(m + i a b). */
    static void minusEntry(double[] m, double[] i, double[] a, double[] b, double[] out) {
        for (int k = 0; k < out.length; k++) {
            out[k] = -(m[k] + i[k] * a[k] * b[k]);
        }
    }

    /** out = i a b. */
    static void product(double[] i, double[] a, double[] b, double[] out) {
        for (int k = 0; k < out.length; k++) {
            out[k] = i[k] * a[k] * b[k];
        }
    }

    /** out = a + those of b one place on. */
    static void addNext(double[] a, double[] b, double[] out) {
        for (int k = 0; k < out.length; k++) {
            out[k] = a[k] + b[k + 1];
        }
    }

    /** out = −a − those of b one place on. */
    static void minusSumNext(double[] a, double[] b, double[] out) {
        for (int k = 0; k < out.length; k++) {
            out[k] = -(a[k] + b[k + 1]);
        }
    }

    /** out = those of b one place on − a. */
    static void nextLess(double[] b, double[] a, double[] out) {
        for (int k = 0; k < out.length; k++) {
            out[k] = b[k + 1] - a[k];
        }
    }

    /** out = f + m (those of p one place on − p). */
    static void push(double[] f, double[] m, double[] p, double[] out) {
        for (int k = 0; k < out.length; k++) {
            out[k] = f[k] + m[k] * (p[k + 1] - p[k]);
        }
    }

    /** out = i (rx py − ry px), with p one place on. */
    static void turnNext(double[] i, double[] rx, double[] ry, double[] px, double[] py, double[] out) {
        for (int k = 0; k < out.length; k++) {
            out[k] = i[k] * (rx[k] * py[k + 1] - ry[k] * px[k + 1]);
        }
    }

    /** out = out − i (rx py − ry px). */
    static void turnLast(double[] i, double[] rx, double[] ry, double[] px, double[] py, double[] out) {
        for (int k = 0; k < out.length; k++) {
            out[k] -= i[k] * (rx[k] * py[k] - ry[k] * px[k]);
        }
    }

    /** out = sin (a − b), for differences up to 1/8. */
    static void sine(double[] a, double[] b, double[] out) {
        for (int k = 0; k < out.length; k++) {
            double d = a[k] - b[k];
            double z = d * d;
            out[k] = d - d * (z * (1.0 / 6 - z * (1.0 / 120 - z * (1.0 / 5040 - z * (1.0 / 362880)))));
        }
    }

    /** out = 1 − cos (a − b), for differences up to 1/8. */
    static void versine(double[] a, double[] b, double[] out) {
        for (int k = 0; k < out.length; k++) {
            double d = a[k] - b[k];
            double z = d * d;
            out[k] = z * (0.5 - z * (1.0 / 24 - z * (1.0 / 720 - z * (1.0 / 40320 - z * (1.0 / 3628800)))));
        }
    }

    /** out = a − (a p + b q). */
    static void rotate(double[] a, double[] p, double[] b, double[] q, double[] out) {
        for (int k = 0; k < out.length; k++) {
            out[k] = a[k] - (a[k] * p[k] + b[k] * q[k]);
        }
    }

    /** out = a − (a p − b q). */
    static void rotateBack(double[] a, double[] p, double[] b, double[] q, double[] out) {
        for (int k = 0; k < out.length; k++) {
            out[k] = a[k] - (a[k] * p[k] - b[k] * q[k]);
        }
    }

    /** out = (a + b) + (c + d). */
    static void weigh(double[] x0, double[] v0, double[] a, double[] b, double[] c, double h, double[] out) {
        double sixth = h * h / 6;
        for (int k = 0; k < out.length; k++) {
            out[k] = x0[k] + (h * v0[k] + sixth * (a[k] + b[k] + c[k]));
        }
    }

    /** out = v0 + h (a + 2 b + 2 c + d) / 6. */
    static void weigh(double[] v0, double[] a, double[] b, double[] c, double[] d, double[] out, double h) {
        double sixth = h / 6;
        for (int k = 0; k < out.length; k++) {
            out[k] = v0[k] + sixth * (a[k] + 2 * (b[k] + c[k]) + d[k]);
        }
    }

    /** Whether some |a − b| is more than a bound, or not a number. */
    static boolean areApart(double[] a, double[] b, double bound) {
        boolean apart = false;
        for (int k = 0; k < a.length; k++) {
            apart |= !(Math.abs(a[k] - b[k]) <= bound);
        }
        return apart;
    }

    /** The largest |a| + |b|, or NaN. */
    static double most(double[] a, double[] b) {
        double most = 0;
        for (int k = 0; k < a.length; k++) {
            double size = Math.abs(a[k]) + Math.abs(b[k]);
            if (!(size <= most)) { // seldom; a maximum would make each wait for the last
                if (Double.isNaN(size)) {
                    return size;
                }
                most = size;
            }
        }
        return most;
    }

    /** The largest s (|a| + |b|) + t |c|, or NaN. */
    static double most(double s, double[] a, double[] b, double t, double[] c) {
        double most = 0;
        for (int k = 0; k < a.length; k++) {
            double size = s * (Math.abs(a[k]) + Math.abs(b[k])) + t * Math.abs(c[k]);
            if (!(size <= most)) {
                if (Double.isNaN(size)) {
                    return size;
                }
                most = size;
            }
        }
        return most;
    }
}
