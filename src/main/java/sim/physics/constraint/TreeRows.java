// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

/**
 * The algebra of {@link TieTrees}. A child c hangs on its parent p by up to three rows, Jc Δvc + Jp Δvp = r. With all that hangs on it, it is of mass
 * M and asks for M Δvc = g + Jcᵀ λ. So
 *
 * <pre>
 *   K = Jc M⁻¹ Jcᵀ,   λ = K⁻¹ (r − Jc M⁻¹ g − Jp Δvp),   Mp += Jpᵀ K⁻¹ Jp,   gp += Jpᵀ K⁻¹ (r − Jc M⁻¹ g)
 * </pre>
 *
 * <p>Rows that are not there are zero.
 */
final class TreeRows {
    /** Values of a bond: Jc, Jp, r, and λ of before, then what is added to it. */
    static final int CHILD = 0;

    static final int PARENT = 9;
    static final int ASKED = 18;
    static final int GIVEN = 21;

    /** How many of them are read of the joint. */
    static final int READ = 24;

    /** K and its inverse, M and its inverse, symmetric: 00, 01, 02, 11, 12, 22; g, then Δv. */
    private static final int YIELD = 24;

    private static final int MASS = 30;
    private static final int FORCE = 36;

    /** C that is to be left when the bodies have moved. */
    static final int LEFT = 39;

    static final int STRIDE = 42;

    /** What is left of a diagonal value when others are eliminated that counts as nothing, relative to it. */
    private static final double SINGULAR = 1e-12;

    private TreeRows() {}

    /** Begins with the body alone. */
    static void begin(double[] d, int o, double[] w, int body) {
        d[o + MASS] = 1 / w[body];
        d[o + MASS + 1] = 0;
        d[o + MASS + 2] = 0;
        d[o + MASS + 3] = d[o + MASS];
        d[o + MASS + 4] = 0;
        d[o + MASS + 5] = 1 / w[body + 2];
    }

    /**
     * Adds squares of what the rows are off, and of what their speeds are made of and their impulses make of these, as energies: so nothing depends on units.
     *
     * @param parent −1 for the world
     * @param to takes what is off, what impulses make, and all
     */
    static void measure(double[] d, int o, double[] v, double[] w, int child, int parent, double[] to) {
        double x = v[child] - (parent < 0 ? 0 : v[parent]);
        double y = v[child + 1] - (parent < 0 ? 0 : v[parent + 1]);
        for (int r = 0; r < 3; r++) {
            int j = o + 3 * r;
            double line = d[j] * d[j] + d[j + 1] * d[j + 1];
            double turn = d[j + 2] * v[child + 2];
            double yield = w[child] * line + w[child + 2] * d[j + 2] * d[j + 2];
            double all = line * (x * x + y * y) + turn * turn;
            j += PARENT;
            if (parent >= 0) {
                turn = d[j + 2] * v[parent + 2];
                yield += w[parent] * (d[j] * d[j] + d[j + 1] * d[j + 1]) + w[parent + 2] * d[j + 2] * d[j + 2];
                all += turn * turn;
            }
            if (yield > 0) {
                double got = yield * d[o + GIVEN + r];
                to[0] += d[o + ASKED + r] * d[o + ASKED + r] / yield;
                to[1] += got * got / yield;
                to[2] += (all + got * got) / yield;
            }
        }
    }

    /** Eliminates the child: its mass is inverted, and K. */
    static void eliminate(double[] d, int o) {
        invert(d, o + MASS);
        double m0 = d[o + MASS], m1 = d[o + MASS + 1], m2 = d[o + MASS + 2];
        double m3 = d[o + MASS + 3], m4 = d[o + MASS + 4], m5 = d[o + MASS + 5];
        double ax = d[o], ay = d[o + 1], at = d[o + 2];
        double bx = d[o + 3], by = d[o + 4], bt = d[o + 5];
        double cx = d[o + 6], cy = d[o + 7], ct = d[o + 8];
        double ux = m0 * ax + m1 * ay + m2 * at, uy = m1 * ax + m3 * ay + m4 * at, ut = m2 * ax + m4 * ay + m5 * at;
        d[o + YIELD] = ux * ax + uy * ay + ut * at;
        d[o + YIELD + 1] = ux * bx + uy * by + ut * bt;
        d[o + YIELD + 2] = ux * cx + uy * cy + ut * ct;
        ux = m0 * bx + m1 * by + m2 * bt;
        uy = m1 * bx + m3 * by + m4 * bt;
        ut = m2 * bx + m4 * by + m5 * bt;
        d[o + YIELD + 3] = ux * bx + uy * by + ut * bt;
        d[o + YIELD + 4] = ux * cx + uy * cy + ut * ct;
        d[o + YIELD + 5] = (m0 * cx + m1 * cy + m2 * ct) * cx + (m1 * cx + m3 * cy + m4 * ct) * cy + (m2 * cx + m4 * cy + m5 * ct) * ct;
        invert(d, o + YIELD);
    }

    /** Adds the bond's mass to that of its parent. */
    static void hang(double[] d, int o, int up) {
        double k0 = d[o + YIELD], k1 = d[o + YIELD + 1], k2 = d[o + YIELD + 2];
        double k3 = d[o + YIELD + 3], k4 = d[o + YIELD + 4], k5 = d[o + YIELD + 5];
        double ax = d[o + 9], bx = d[o + 12], cx = d[o + 15];
        double ay = d[o + 10], by = d[o + 13], cy = d[o + 16];
        double at = d[o + 11], bt = d[o + 14], ct = d[o + 17];
        double y0 = k0 * ay + k1 * by + k2 * cy, y1 = k1 * ay + k3 * by + k4 * cy, y2 = k2 * ay + k4 * by + k5 * cy;
        double t0 = k0 * at + k1 * bt + k2 * ct, t1 = k1 * at + k3 * bt + k4 * ct, t2 = k2 * at + k4 * bt + k5 * ct;
        d[up + MASS] += ax * (k0 * ax + k1 * bx + k2 * cx) + bx * (k1 * ax + k3 * bx + k4 * cx) + cx * (k2 * ax + k4 * bx + k5 * cx);
        d[up + MASS + 1] += ax * y0 + bx * y1 + cx * y2;
        d[up + MASS + 2] += ax * t0 + bx * t1 + cx * t2;
        d[up + MASS + 3] += ay * y0 + by * y1 + cy * y2;
        d[up + MASS + 4] += ay * t0 + by * t1 + cy * t2;
        d[up + MASS + 5] += at * t0 + bt * t1 + ct * t2;
    }

    /** Begins with no force. */
    static void ask(double[] d, int o) {
        d[o + FORCE] = 0;
        d[o + FORCE + 1] = 0;
        d[o + FORCE + 2] = 0;
    }

    /** Takes off what the child gets anyway, and tells the parent what it is to bear; −1 for none. */
    static void lean(double[] d, int o, int up) {
        double gx = d[o + FORCE], gy = d[o + FORCE + 1], gt = d[o + FORCE + 2];
        double x = d[o + MASS] * gx + d[o + MASS + 1] * gy + d[o + MASS + 2] * gt;
        double y = d[o + MASS + 1] * gx + d[o + MASS + 3] * gy + d[o + MASS + 4] * gt;
        double t = d[o + MASS + 2] * gx + d[o + MASS + 4] * gy + d[o + MASS + 5] * gt;
        double r0 = d[o + ASKED] - d[o] * x - d[o + 1] * y - d[o + 2] * t;
        double r1 = d[o + ASKED + 1] - d[o + 3] * x - d[o + 4] * y - d[o + 5] * t;
        double r2 = d[o + ASKED + 2] - d[o + 6] * x - d[o + 7] * y - d[o + 8] * t;
        d[o + ASKED] = r0;
        d[o + ASKED + 1] = r1;
        d[o + ASKED + 2] = r2;
        if (up < 0) {
            return;
        }
        double l0 = d[o + YIELD] * r0 + d[o + YIELD + 1] * r1 + d[o + YIELD + 2] * r2;
        double l1 = d[o + YIELD + 1] * r0 + d[o + YIELD + 3] * r1 + d[o + YIELD + 4] * r2;
        double l2 = d[o + YIELD + 2] * r0 + d[o + YIELD + 4] * r1 + d[o + YIELD + 5] * r2;
        d[up + FORCE] += d[o + 9] * l0 + d[o + 12] * l1 + d[o + 15] * l2;
        d[up + FORCE + 1] += d[o + 10] * l0 + d[o + 13] * l1 + d[o + 16] * l2;
        d[up + FORCE + 2] += d[o + 11] * l0 + d[o + 14] * l1 + d[o + 17] * l2;
    }

    /** Gives the child what its bond makes of it, now that it is known what its parent gets. */
    static void solve(double[] d, int o, int up, double[] v, int child) {
        double r0 = d[o + ASKED], r1 = d[o + ASKED + 1], r2 = d[o + ASKED + 2];
        if (up >= 0) {
            double x = d[up + FORCE], y = d[up + FORCE + 1], t = d[up + FORCE + 2];
            r0 -= d[o + 9] * x + d[o + 10] * y + d[o + 11] * t;
            r1 -= d[o + 12] * x + d[o + 13] * y + d[o + 14] * t;
            r2 -= d[o + 15] * x + d[o + 16] * y + d[o + 17] * t;
        }
        double l0 = d[o + YIELD] * r0 + d[o + YIELD + 1] * r1 + d[o + YIELD + 2] * r2;
        double l1 = d[o + YIELD + 1] * r0 + d[o + YIELD + 3] * r1 + d[o + YIELD + 4] * r2;
        double l2 = d[o + YIELD + 2] * r0 + d[o + YIELD + 4] * r1 + d[o + YIELD + 5] * r2;
        d[o + GIVEN] = l0;
        d[o + GIVEN + 1] = l1;
        d[o + GIVEN + 2] = l2;
        double gx = d[o + FORCE] + d[o] * l0 + d[o + 3] * l1 + d[o + 6] * l2;
        double gy = d[o + FORCE + 1] + d[o + 1] * l0 + d[o + 4] * l1 + d[o + 7] * l2;
        double gt = d[o + FORCE + 2] + d[o + 2] * l0 + d[o + 5] * l1 + d[o + 8] * l2;
        double x = d[o + MASS] * gx + d[o + MASS + 1] * gy + d[o + MASS + 2] * gt;
        double y = d[o + MASS + 1] * gx + d[o + MASS + 3] * gy + d[o + MASS + 4] * gt;
        double t = d[o + MASS + 2] * gx + d[o + MASS + 4] * gy + d[o + MASS + 5] * gt;
        d[o + FORCE] = x;
        d[o + FORCE + 1] = y;
        d[o + FORCE + 2] = t;
        v[child] += x;
        v[child + 1] += y;
        v[child + 2] += t;
    }

    /** By how much the velocity of the child has changed. */
    static double change(double[] d, int o, int component) {
        return d[o + FORCE + component];
    }

    /** Gives the other body what the bond makes of it. */
    static void push(double[] d, int o, double[] v, double[] w, int body) {
        for (int r = 0; r < 3; r++) {
            for (int m = 0; m < 3; m++) {
                v[body + m] += w[body + m] * d[o + PARENT + 3 * r + m] * d[o + GIVEN + r];
            }
        }
    }

    /** Inverts a symmetric matrix with no negative eigenvalue by L D Lᵀ; rows that are zero or depend on those before stay out. */
    private static void invert(double[] d, int o) {
        double a = d[o], b = d[o + 1], c = d[o + 2];
        double e = d[o + 3], f = d[o + 4], g = d[o + 5];
        double i0 = a > 0 ? 1 / a : 0;
        double l10 = b * i0;
        double l20 = c * i0;
        double d1 = e - l10 * b;
        double i1 = d1 > SINGULAR * e ? 1 / d1 : 0;
        double t = f - l20 * b;
        double l21 = t * i1;
        double d2 = g - l20 * c - l21 * t;
        double i2 = d2 > SINGULAR * g ? 1 / d2 : 0;
        double m20 = l10 * l21 - l20; // of L⁻¹
        d[o] = i0 + l10 * l10 * i1 + m20 * m20 * i2;
        d[o + 1] = -l10 * i1 - m20 * l21 * i2;
        d[o + 2] = m20 * i2;
        d[o + 3] = i1 + l21 * l21 * i2;
        d[o + 4] = -l21 * i2;
        d[o + 5] = i2;
    }
}
