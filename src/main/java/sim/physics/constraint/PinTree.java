// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.Trig;
import sim.physics.motion.State;

/**
 * Links that pins join to a tree, by their angles alone: where the root is, the angles say where all others are, so that
 * there is nothing to close. Each link hangs at its <i>near</i> pin; the root hangs in the world, or at its own centre of
 * mass if the tree is free.
 *
 * <p>The accelerations come from one pass from the tips to the root and one back (Featherstone 1983; the equations are
 * (37) to (41), eliminated in that order). The force that moves a link and all behind it is
 *
 * <pre>
 *   F = M A + p      A: acceleration of the near pin
 * </pre>
 *
 * <p>With ⊥ for a quarter turn, d from the near pin to the centre of mass and e to the pin of a child (M', p'), and with
 * S = m d⊥ + Σ M' e⊥, H = I + m d² + Σ e⊥·M' e⊥, q = Σ p' − ω² M' e, τ = −Σ e⊥·(p' − ω² M' e):
 *
 * <pre>
 *   θ″ = (τ − S·A) / H,   M = m + Σ M' − S Sᵀ / H,   p = q − m ω² d + S τ / H
 * </pre>
 *
 * <p>A uniform field is an acceleration of the root. All values of a link lie together; a child comes right behind its
 * parent if it can, and what it leaves behind stays in registers then.
 */
final class PinTree implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Values of a link. */
    static final int STRIDE = 32;

    /** Mass; I + m d²; m d, d and e to the next link in the coordinates of the link. */
    static final int MASS = 0;

    static final int HUB = 1;
    static final int MDX = 2;
    static final int MDY = 3;
    static final int DX = 4;
    static final int DY = 5;
    static final int EX = 6;
    static final int EY = 7;

    /** An angle near the present one, its cosine and sine. */
    static final int KNOWN = 8;

    static final int KNOWN_COS = 9;
    static final int KNOWN_SIN = 10;

    /** The state at the start, and at the end of a step. */
    static final int X = 11;

    static final int Y = 12;
    static final int ANGLE = 13;
    static final int U = 14;
    static final int V = 15;
    static final int OMEGA = 16;

    /** At a stage: angular velocity, cosine and sine of the angle, e; S/H and τ/H. */
    private static final int TURNING = 17;

    private static final int COS = 18;
    private static final int SIN = 19;
    private static final int RX = 20;
    private static final int RY = 21;
    private static final int SX = 22;
    private static final int SY = 23;
    private static final int T = 24;

    /** Angular accelerations of the stages. */
    private static final int ALPHA = 25;

    /** Sum of the second derivatives of e at the stages. */
    private static final int BENDX = 28;

    private static final int BENDY = 29;

    /** e at the first stage. */
    private static final int FIRSTX = 30;

    private static final int FIRSTY = 31;

    /** Angles from the one whose cosine and sine are known, up to which series are right to rounding. */
    private static final double NEAR = 0.125;

    /** Known angles are multiples of 1/16 rad, so that the cosines do not depend on what was before. */
    private static final double GRAIN = 16;

    /** Values of a link that is not right behind its parent: own e; e, M and p at a stage; A; place and velocity. */
    private static final int SIDE = 16;

    private static final int SIDE_E = 2;
    private static final int SIDE_M = 4;
    private static final int SIDE_P = 7;
    private static final int SIDE_A = 9;
    private static final int SIDE_X = 11;

    final int links;

    /** Blocks of the links in the state vectors. */
    final int[] block;

    /** By link. */
    final double[] link;

    final boolean isFree;

    /** By link: −1 for the root, else smaller than the link. */
    private final int[] parent;

    /** By link: the first of its children that is not right behind it, −1 if there is none; and the next sister. */
    private final int[] child;

    private final int[] sister;

    private final double[] side;
    private final double[] sum = new double[9];

    /** Where the root hangs. */
    private final double rootX;

    private final double rootY;

    private double total;
    private double gap;

    /** Acceleration of the root, without that of the field. */
    private double a0;

    private double a1;

    /** Centre of mass, and its velocity, at the start. */
    private double centreX;

    private double centreY;
    private double centreU;
    private double centreV;

    /**
     * Makes a tree.
     *
     * @param block by link
     * @param parent by link, −1 for the root, else smaller than the link
     * @param arms by link, from its centre of mass in its own coordinates: the near pin; and in those of its parent: the same
     *     pin, or where it is in the world
     * @param isFree whether the root hangs nowhere
     */
    PinTree(int[] block, int[] parent, double[] arms, boolean isFree) {
        this.block = block;
        this.parent = parent;
        this.isFree = isFree;
        links = block.length;
        link = new double[STRIDE * links];
        child = new int[links];
        sister = new int[links];
        boolean isBranched = false;
        for (int k = 0; k < links; k++) {
            child[k] = -1;
            sister[k] = -1;
            isBranched |= parent[k] != k - 1;
        }
        side = new double[isBranched ? SIDE * links : 0];
        rootX = isFree ? 0 : arms[2];
        rootY = isFree ? 0 : arms[3];
        for (int k = links - 1; k >= 0; k--) {
            int o = STRIDE * k;
            int j = parent[k];
            link[o + KNOWN] = Double.NaN;
            link[o + DX] = k == 0 && isFree ? 0 : -arms[4 * k];
            link[o + DY] = k == 0 && isFree ? 0 : -arms[4 * k + 1];
            if (k == links - 1 || parent[k + 1] != k) { // for gap() alone
                link[o + EX] = link[o + DX];
                link[o + EY] = link[o + DY];
            }
            if (j < 0) {
                continue;
            }
            boolean isAtCentre = j == 0 && isFree;
            double ex = arms[4 * k + 2] - (isAtCentre ? 0 : arms[4 * j]);
            double ey = arms[4 * k + 3] - (isAtCentre ? 0 : arms[4 * j + 1]);
            if (j == k - 1) {
                link[STRIDE * j + EX] = ex;
                link[STRIDE * j + EY] = ey;
            } else {
                sister[k] = child[j];
                child[j] = k;
                side[SIDE * k] = ex;
                side[SIDE * k + 1] = ey;
            }
        }
    }

    /** Takes the masses over. */
    void weigh(double[] w) {
        total = 0;
        for (int k = 0, o = 0; k < links; k++, o += STRIDE) {
            double m = 1 / w[block[k]];
            double dx = link[o + DX];
            double dy = link[o + DY];
            link[o + MASS] = m;
            link[o + HUB] = 1 / w[block[k] + State.THETA] + m * (dx * dx + dy * dy);
            link[o + MDX] = m * dx;
            link[o + MDY] = m * dy;
            total += m;
        }
    }

    /** Takes note of where the centre of mass is, if the tree is free. */
    void centre() {
        centreX = 0;
        centreY = 0;
        centreU = 0;
        centreV = 0;
        for (int k = 0, o = 0; k < links; k++, o += STRIDE) {
            double m = link[o + MASS] / total;
            centreX += m * link[o + X];
            centreY += m * link[o + Y];
            centreU += m * link[o + U];
            centreV += m * link[o + V];
        }
    }

    /** Begins with the first stage. */
    void begin() {
        for (int o = 0; o < link.length; o += STRIDE) {
            double angle = link[o + ANGLE];
            double nearest = Math.rint(GRAIN * angle) / GRAIN;
            if (nearest != link[o + KNOWN]) {
                link[o + KNOWN] = nearest;
                Trig.sinCos(nearest, link, o + KNOWN_COS);
            }
            link[o + TURNING] = link[o + OMEGA];
            turn(link, o, angle);
        }
    }

    /** Cosine and sine of an angle, (45), (46). */
    private static void turn(double[] l, int o, double angle) {
        double d = angle - l[o + KNOWN];
        if (!(Math.abs(d) <= NEAR)) {
            Trig.sinCos(angle, l, o + COS);
            return;
        }
        double z = d * d;
        double c = l[o + KNOWN_COS];
        double s = l[o + KNOWN_SIN];
        double sine = d - d * (z * (1.0 / 6 - z * (1.0 / 120 - z * (1.0 / 5040 - z * (1.0 / 362880)))));
        double versine = z * (0.5 - z * (1.0 / 24 - z * (1.0 / 720 - z * (1.0 / 40320 - z * (1.0 / 3628800)))));
        l[o + COS] = c - (c * versine + s * sine);
        l[o + SIN] = s - (s * versine - c * sine);
    }

    /** The pass from the tips to the root. */
    void eliminate(double gx, double gy) {
        double[] l = link;
        double m00 = 0;
        double m01 = 0;
        double m11 = 0;
        double p0 = 0;
        double p1 = 0;
        double f0 = 0;
        double f1 = 0;
        double fe = 0;
        int o = STRIDE * (links - 1);
        double ex = l[o + COS] * l[o + EX] - l[o + SIN] * l[o + EY];
        double ey = l[o + SIN] * l[o + EX] + l[o + COS] * l[o + EY];
        for (int k = links - 1; k >= 0; k--, o -= STRIDE) {
            double cos = l[o + COS];
            double sin = l[o + SIN];
            double mdx = cos * l[o + MDX] - sin * l[o + MDY];
            double mdy = sin * l[o + MDX] + cos * l[o + MDY];
            double square = l[o + TURNING] * l[o + TURNING];
            double cx = square * ex;
            double cy = square * ey;
            double q0 = p0 - (m00 * cx + m01 * cy);
            double q1 = p1 - (m01 * cx + m11 * cy);
            double tau = ey * q0 - ex * q1;
            double hub = l[o + HUB] + fe;
            double s0 = f0 - mdy;
            double s1 = f1 + mdx;
            if (child[k] >= 0) {
                addChildren(k, cos, sin, square);
                hub += sum[0];
                s0 += sum[1];
                s1 += sum[2];
                q0 += sum[3];
                q1 += sum[4];
                tau += sum[5];
                m00 += sum[6];
                m01 += sum[7];
                m11 += sum[8];
            }
            double per = 1 / hub;
            l[o + RX] = ex;
            l[o + RY] = ey;
            m00 += l[o + MASS];
            m11 += l[o + MASS];
            if (k > 0) {
                int n = o - STRIDE;
                ex = l[n + COS] * l[n + EX] - l[n + SIN] * l[n + EY];
                ey = l[n + SIN] * l[n + EX] + l[n + COS] * l[n + EY];
            }
            double g0 = m01 * ex - m00 * ey;
            double g1 = m11 * ex - m01 * ey;
            double ge = ex * g1 - ey * g0;
            double se = s1 * ex - s0 * ey;
            double ue = se * per;
            f0 = g0 - s0 * ue;
            f1 = g1 - s1 * ue;
            fe = ge - se * ue;
            double u0 = s0 * per;
            double u1 = s1 * per;
            l[o + SX] = u0;
            l[o + SY] = u1;
            l[o + T] = tau * per;
            m00 -= u0 * s0;
            m01 -= u0 * s1;
            m11 -= u1 * s1;
            p0 = q0 - square * mdx + u0 * tau;
            p1 = q1 - square * mdy + u1 * tau;
            if (parent[k] != k - 1) {
                leave(SIDE * k, m00, m01, m11, p0, p1);
                m00 = 0;
                m01 = 0;
                m11 = 0;
                p0 = 0;
                p1 = 0;
                f0 = 0;
                f1 = 0;
                fe = 0;
            }
        }
        hang(gx, gy, m00, m01, m11, p0, p1);
    }

    /** What hangs at the root takes part in the fall of a tree that is free; else the field is an acceleration against it. */
    private void hang(double gx, double gy, double m00, double m01, double m11, double p0, double p1) {
        a0 = -gx;
        a1 = -gy;
        if (isFree) {
            double per = 1 / (m00 * m11 - m01 * m01);
            a0 = per * (m01 * p1 - m11 * p0);
            a1 = per * (m01 * p0 - m00 * p1);
        }
    }

    /** Keeps what a link that is not right behind its parent leaves behind. */
    private void leave(int at, double m00, double m01, double m11, double p0, double p1) {
        side[at + SIDE_M] = m00;
        side[at + SIDE_M + 1] = m01;
        side[at + SIDE_M + 2] = m11;
        side[at + SIDE_P] = p0;
        side[at + SIDE_P + 1] = p1;
    }

    /** Sums over the children that are not right behind a link: Σ e⊥·M' e⊥, Σ M' e⊥, Σ (p' − ω² M' e), τ, Σ M'. */
    private void addChildren(int k, double cos, double sin, double square) {
        double[] b = side;
        Arrays.fill(sum, 0);
        for (int c = child[k]; c >= 0; c = sister[c]) {
            int at = SIDE * c;
            double ex = cos * b[at] - sin * b[at + 1];
            double ey = sin * b[at] + cos * b[at + 1];
            double m00 = b[at + SIDE_M];
            double m01 = b[at + SIDE_M + 1];
            double m11 = b[at + SIDE_M + 2];
            double f0 = m01 * ex - m00 * ey;
            double f1 = m11 * ex - m01 * ey;
            double q0 = b[at + SIDE_P] - square * (m00 * ex + m01 * ey);
            double q1 = b[at + SIDE_P + 1] - square * (m01 * ex + m11 * ey);
            b[at + SIDE_E] = ex;
            b[at + SIDE_E + 1] = ey;
            sum[0] += ex * f1 - ey * f0;
            sum[1] += f0;
            sum[2] += f1;
            sum[3] += q0;
            sum[4] += q1;
            sum[5] += ey * q0 - ex * q1;
            sum[6] += m00;
            sum[7] += m01;
            sum[8] += m11;
        }
    }

    /**
     * The pass from the root to the tips, and the links at the next stage: by c times the rates of this one from the start.
     *
     * @param stage number of this stage
     * @param c time
     */
    void accelerate(int stage, double c) {
        double[] l = link;
        double x = a0;
        double y = a1;
        for (int k = 0, o = 0; k < links; k++, o += STRIDE) {
            if (parent[k] != k - 1) {
                x = side[SIDE * k + SIDE_A];
                y = side[SIDE * k + SIDE_A + 1];
            }
            double alpha = l[o + T] - (l[o + SX] * x + l[o + SY] * y);
            double omega = l[o + TURNING];
            double square = omega * omega;
            if (child[k] >= 0) {
                carry(k, x, y, alpha, square);
            }
            double rx = l[o + RX];
            double ry = l[o + RY];
            double bendX = square * rx + alpha * ry;
            double bendY = square * ry - alpha * rx;
            x -= bendX;
            y -= bendY;
            if (stage == 0) {
                l[o + FIRSTX] = rx;
                l[o + FIRSTY] = ry;
            }
            l[o + BENDX] = stage == 0 ? bendX : l[o + BENDX] + bendX;
            l[o + BENDY] = stage == 0 ? bendY : l[o + BENDY] + bendY;
            l[o + ALPHA + stage] = alpha;
            l[o + TURNING] = l[o + OMEGA] + c * alpha;
            turn(l, o, l[o + ANGLE] + c * omega);
        }
    }

    /** The accelerations of the pins of children that are not right behind a link. */
    private void carry(int k, double x, double y, double alpha, double square) {
        for (int c = child[k]; c >= 0; c = sister[c]) {
            int at = SIDE * c;
            double ex = side[at + SIDE_E];
            double ey = side[at + SIDE_E + 1];
            side[at + SIDE_A] = x - square * ex - alpha * ey;
            side[at + SIDE_A + 1] = y - square * ey + alpha * ex;
        }
    }

    /**
     * The pass from the root to the tips at the last stage, and the links at the end of the step, (13).
     *
     * @param h step
     */
    void finish(double h) {
        double[] l = link;
        double x = a0;
        double y = a1;
        double sixth = h / 6;
        gap = 0;
        for (int k = 0, o = 0; k < links; k++, o += STRIDE) {
            if (parent[k] != k - 1) {
                x = side[SIDE * k + SIDE_A];
                y = side[SIDE * k + SIDE_A + 1];
            }
            double alpha = l[o + T] - (l[o + SX] * x + l[o + SY] * y);
            double omega = l[o + TURNING];
            double square = omega * omega;
            if (child[k] >= 0) {
                carry(k, x, y, alpha, square);
            }
            x = x - square * l[o + RX] - alpha * l[o + RY];
            y = y - square * l[o + RY] + alpha * l[o + RX];
            double before = l[o + OMEGA];
            double first = l[o + ALPHA];
            double middle = l[o + ALPHA + 1] + l[o + ALPHA + 2];
            double angle = l[o + ANGLE] + h * (before + sixth * (first + middle));
            l[o + OMEGA] = before + sixth * (first + 2 * middle + alpha);
            l[o + ANGLE] = angle;
            turn(l, o, angle);
            double gapX = l[o + FIRSTX] - h * (before * l[o + FIRSTY] + sixth * l[o + BENDX]);
            double gapY = l[o + FIRSTY] + h * (before * l[o + FIRSTX] - sixth * l[o + BENDY]);
            gapX -= l[o + COS] * l[o + EX] - l[o + SIN] * l[o + EY];
            gapY -= l[o + SIN] * l[o + EX] + l[o + COS] * l[o + EY];
            gap = Math.max(gap, Math.abs(gapX) + Math.abs(gapY));
        }
    }

    /**
     * How far RK4 of the places would have parted what the angles hold together: about the error of a link in the last step.
     */
    double gap() {
        return gap;
    }

    /** Where the angles of the end say that the links are, and how fast they move; (42), (43). */
    void place() {
        double[] l = link;
        double x = rootX;
        double y = rootY;
        double u = 0;
        double v = 0;
        for (int k = 0, o = 0; k < links; k++, o += STRIDE) {
            if (parent[k] != k - 1) {
                x = side[SIDE * k + SIDE_X];
                y = side[SIDE * k + SIDE_X + 1];
                u = side[SIDE * k + SIDE_X + 2];
                v = side[SIDE * k + SIDE_X + 3];
            }
            double cos = l[o + COS];
            double sin = l[o + SIN];
            double omega = l[o + OMEGA];
            if (child[k] >= 0) {
                placeChildren(k, x, y, u, v);
            }
            double dx = cos * l[o + DX] - sin * l[o + DY];
            double dy = sin * l[o + DX] + cos * l[o + DY];
            double ex = cos * l[o + EX] - sin * l[o + EY];
            double ey = sin * l[o + EX] + cos * l[o + EY];
            l[o + X] = x + dx;
            l[o + Y] = y + dy;
            l[o + U] = u - omega * dy;
            l[o + V] = v + omega * dx;
            x += ex;
            y += ey;
            u -= omega * ey;
            v += omega * ex;
        }
    }

    private void placeChildren(int k, double x, double y, double u, double v) {
        int o = STRIDE * k;
        double cos = link[o + COS];
        double sin = link[o + SIN];
        double omega = link[o + OMEGA];
        for (int c = child[k]; c >= 0; c = sister[c]) {
            int at = SIDE * c;
            double ex = cos * side[at] - sin * side[at + 1];
            double ey = sin * side[at] + cos * side[at + 1];
            side[at + SIDE_X] = x + ex;
            side[at + SIDE_X + 1] = y + ey;
            side[at + SIDE_X + 2] = u - omega * ey;
            side[at + SIDE_X + 3] = v + omega * ex;
        }
    }

    /** Puts the centre of mass of a free tree where it moves to in a step. */
    void shift(double gx, double gy, double h) {
        double x = centreX + h * (centreU + 0.5 * h * gx);
        double y = centreY + h * (centreV + 0.5 * h * gy);
        double u = centreU + h * gx;
        double v = centreV + h * gy;
        centre();
        x -= centreX;
        y -= centreY;
        u -= centreU;
        v -= centreV;
        for (int o = 0; o < link.length; o += STRIDE) {
            link[o + X] += x;
            link[o + Y] += y;
            link[o + U] += u;
            link[o + V] += v;
        }
    }

    /**
     * How far the pins are open at the start, and how fast they open.
     *
     * @param out gets the largest gap, and the largest rate of one
     */
    void gaps(double[] out) {
        double gap = 0;
        double slip = 0;
        for (int k = isFree ? 1 : 0; k < links; k++) {
            int o = STRIDE * k;
            int j = parent[k];
            double[] l = link;
            double dx = l[o + COS] * l[o + DX] - l[o + SIN] * l[o + DY];
            double dy = l[o + SIN] * l[o + DX] + l[o + COS] * l[o + DY];
            double x = l[o + X] - dx - rootX;
            double y = l[o + Y] - dy - rootY;
            double u = l[o + U] + l[o + OMEGA] * dy;
            double v = l[o + V] - l[o + OMEGA] * dx;
            if (j >= 0) {
                int p = STRIDE * j;
                double ex = (j == k - 1 ? l[p + EX] : side[SIDE * k]) - l[p + DX];
                double ey = (j == k - 1 ? l[p + EY] : side[SIDE * k + 1]) - l[p + DY];
                double rx = l[p + COS] * ex - l[p + SIN] * ey;
                double ry = l[p + SIN] * ex + l[p + COS] * ey;
                x = l[o + X] - dx - l[p + X] - rx;
                y = l[o + Y] - dy - l[p + Y] - ry;
                u -= l[p + U] - l[p + OMEGA] * ry;
                v -= l[p + V] + l[p + OMEGA] * rx;
            }
            gap = Math.max(gap, Math.abs(x) + Math.abs(y)); // NaN stays
            slip = Math.max(slip, Math.abs(u) + Math.abs(v));
        }
        out[0] = gap;
        out[1] = slip;
    }
}
