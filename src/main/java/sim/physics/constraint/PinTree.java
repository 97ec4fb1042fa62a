// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.SineTable;
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

    /** The state at the start, and at the end of a step. */
    static final int X = 8;

    static final int Y = 9;
    static final int ANGLE = 10;
    static final int U = 11;
    static final int V = 12;
    static final int OMEGA = 13;

    /** At a stage: angular velocity, cosine and sine of the angle, e; S/H and τ/H. */
    static final int TURNING = 14;

    static final int COS = 15;
    static final int SIN = 16;
    static final int RX = 17;
    static final int RY = 18;
    private static final int SX = 19;
    private static final int SY = 20;
    private static final int T = 21;

    /** Angular accelerations of the stages. */
    private static final int ALPHA = 22;

    /** Sum of the second derivatives of e at the stages. */
    private static final int BENDX = 25;

    private static final int BENDY = 26;

    /** e at the first stage. */
    private static final int FIRSTX = 27;

    private static final int FIRSTY = 28;

    /** Angle at a stage, and the moment of inertia. */
    static final int TURNED = 29;

    private static final int INERTIA = 30;

    /** Part of the mass of all links. */
    static final int SHARE = 31;

    /** Values of the first link of a run: own e; e, M and p at a stage; A; place and velocity. */
    static final int SIDE = 16;

    private static final int SIDE_E = 2;
    private static final int SIDE_M = 4;
    private static final int SIDE_P = 7;
    static final int SIDE_A = 9;
    static final int SIDE_X = 11;

    final int links;

    /** Blocks of the links in the state vectors. */
    final int[] block;

    /** By link. */
    final double[] link;

    final boolean isFree;

    final TreePlaces places;

    /** By link: −1 for the root, else smaller than the link. */
    final int[] parent;

    /** First links of the runs of links that are right behind their parents, and the number of links. */
    final int[] runs;

    final int runCount;

    /** By link: the first of its children that is not right behind it, −1 if there is none; and the next sister. */
    final int[] child;

    final int[] sister;

    /** By first links of runs. */
    final double[] side;

    private final double[] sum = new double[9];

    /** By block: accelerations x″, y″, θ″ as if each link were alone; null but while they are used. */
    private double[] alone;

    private double gap;

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
        runs = new int[links + 1];
        int count = 0;
        for (int k = 0; k < links; k++) {
            child[k] = -1;
            sister[k] = -1;
            if (k == 0 || parent[k] != k - 1) {
                runs[count++] = k;
            }
        }
        runs[count] = links;
        runCount = count;
        side = new double[count == 1 ? SIDE : SIDE * links];
        places = new TreePlaces(this, arms[2], arms[3]);
        for (int k = links - 1; k >= 0; k--) {
            int o = STRIDE * k;
            int j = parent[k];
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
        for (int k = 0, o = 0; k < links; k++, o += STRIDE) {
            double m = 1 / w[block[k]];
            double dx = link[o + DX];
            double dy = link[o + DY];
            link[o + MASS] = m;
            link[o + INERTIA] = 1 / w[block[k] + State.THETA];
            link[o + HUB] = link[o + INERTIA] + m * (dx * dx + dy * dy);
            link[o + MDX] = m * dx;
            link[o + MDY] = m * dy;
        }
        places.weigh();
    }

    /** Begins with the first stage of a state that is not where the last step ended. */
    void begin() {
        for (int o = 0; o < link.length; o += STRIDE) {
            link[o + TURNING] = link[o + OMEGA];
            SineTable.sinCos(link[o + ANGLE], link, o + COS);
        }
    }

    /** Lets the next state be one that is not where the last step ended. */
    void forget() {
        link[X] = Double.NaN;
    }

    /** The pass from the tips to the root, run by run, under a uniform field. */
    void eliminate(double gx, double gy) {
        eliminate();
        hang(gx, gy);
    }

    /**
     * The same under any forces.
     *
     * @param loads accelerations x″, y″, θ″ of each link as if it were alone, by block
     */
    void eliminate(double[] loads) {
        alone = loads;
        eliminate();
        alone = null;
        hang(0, 0);
    }

    private void eliminate() {
        for (int r = runCount - 1; r >= 0; r--) {
            eliminate(runs[r], runs[r + 1] - 1);
        }
    }

    /** The acceleration of the root. */
    private void hang(double gx, double gy) {
        double x = -gx;
        double y = -gy;
        if (isFree) { // what hangs at the root takes part in the fall
            double m00 = side[SIDE_M];
            double m01 = side[SIDE_M + 1];
            double m11 = side[SIDE_M + 2];
            double per = 1 / (m00 * m11 - m01 * m01);
            x = per * (m01 * side[SIDE_P + 1] - m11 * side[SIDE_P]);
            y = per * (m01 * side[SIDE_P] - m00 * side[SIDE_P + 1]);
        }
        side[SIDE_A] = x;
        side[SIDE_A + 1] = y;
    }

    /**
     * A run, from the tip to its first link. M' e⊥ and e⊥·M' e⊥ of a link are found together with M' of its child and do not
     * wait for it: the way from one division to the next is what takes the time.
     */
    private void eliminate(int from, int to) {
        double[] l = link;
        double m00 = 0;
        double m01 = 0;
        double m11 = 0;
        double p0 = 0;
        double p1 = 0;
        double f0 = 0;
        double f1 = 0;
        double fe = 0;
        double ex = turnedX(STRIDE * to);
        double ey = turnedY(STRIDE * to);
        for (int k = to, o = STRIDE * to; k >= from; k--, o -= STRIDE) {
            double mdx = l[o + COS] * l[o + MDX] - l[o + SIN] * l[o + MDY];
            double mdy = l[o + SIN] * l[o + MDX] + l[o + COS] * l[o + MDY];
            double square = l[o + TURNING] * l[o + TURNING];
            p0 -= square * (m00 * ex + m01 * ey); // q
            p1 -= square * (m01 * ex + m11 * ey);
            double tau = ey * p0 - ex * p1;
            double hub = l[o + HUB] + fe;
            double s0 = f0 - mdy;
            double s1 = f1 + mdx;
            if (alone != null) {
                p0 -= pull(k, State.X);
                p1 -= pull(k, State.Y);
                tau += mdx * alone[block[k] + 1] - mdy * alone[block[k]] + l[o + INERTIA] * alone[block[k] + State.THETA];
            }
            if (child[k] >= 0) {
                addOthers(k, square);
                hub += sum[0];
                s0 += sum[1];
                s1 += sum[2];
                p0 += sum[3];
                p1 += sum[4];
                tau += sum[5];
                m00 += sum[6];
                m01 += sum[7];
                m11 += sum[8];
            }
            double per = 1 / hub;
            keep(o, ex, ey, s0 * per, s1 * per, tau * per);
            m00 += l[o + MASS];
            m11 += l[o + MASS];
            ex = turnedX(Math.max(0, o - STRIDE)); // of the parent, if the run goes on
            ey = turnedY(Math.max(0, o - STRIDE));
            double g0 = m01 * ex - m00 * ey;
            double g1 = m11 * ex - m01 * ey;
            double se = s1 * ex - s0 * ey;
            double u0 = s0 * per;
            double u1 = s1 * per;
            f0 = g0 - se * u0;
            f1 = g1 - se * u1;
            fe = ex * g1 - ey * g0 - se * se * per;
            m00 -= u0 * s0;
            m01 -= u0 * s1;
            m11 -= u1 * s1;
            p0 = p0 - square * mdx + u0 * tau;
            p1 = p1 - square * mdy + u1 * tau;
        }
        leave(SIDE * from, m00, m01, m11, p0, p1);
    }

    private double pull(int k, int coordinate) {
        return link[STRIDE * k + MASS] * alone[block[k] + coordinate];
    }

    private void keep(int o, double rx, double ry, double sx, double sy, double t) {
        link[o + RX] = rx;
        link[o + RY] = ry;
        link[o + SX] = sx;
        link[o + SY] = sy;
        link[o + T] = t;
    }

    private double turnedX(int o) {
        return link[o + COS] * link[o + EX] - link[o + SIN] * link[o + EY];
    }

    private double turnedY(int o) {
        return link[o + SIN] * link[o + EX] + link[o + COS] * link[o + EY];
    }

    /** Keeps what a run leaves behind. */
    private void leave(int at, double m00, double m01, double m11, double p0, double p1) {
        side[at + SIDE_M] = m00;
        side[at + SIDE_M + 1] = m01;
        side[at + SIDE_M + 2] = m11;
        side[at + SIDE_P] = p0;
        side[at + SIDE_P + 1] = p1;
    }

    /** Sums over the children that are not right behind a link: e⊥·M' e⊥, M' e⊥, p' − ω² M' e, τ, M'. */
    private void addOthers(int k, double square) {
        double[] b = side;
        double cos = link[STRIDE * k + COS];
        double sin = link[STRIDE * k + SIN];
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
        for (int r = 0; r < runCount; r++) {
            accelerate(stage, c, runs[r], runs[r + 1]);
        }
    }

    private void accelerate(int stage, double c, int from, int to) {
        double[] l = link;
        double x = side[SIDE * from + SIDE_A];
        double y = side[SIDE * from + SIDE_A + 1];
        for (int k = from, o = STRIDE * from; k < to; k++, o += STRIDE) {
            double alpha = angular(o, x, y);
            double omega = l[o + TURNING];
            double square = omega * omega;
            if (child[k] >= 0) {
                carry(k, x, y, alpha, square);
            }
            double rx = l[o + RX];
            double ry = l[o + RY];
            double pullX = square * rx;
            double pullY = square * ry;
            double turnX = alpha * ry;
            double turnY = alpha * rx;
            x = x - pullX - turnX;
            y = y - pullY + turnY;
            double bendX = pullX + turnX;
            double bendY = pullY - turnY;
            if (stage == 0) {
                l[o + FIRSTX] = rx;
                l[o + FIRSTY] = ry;
            }
            l[o + BENDX] = stage == 0 ? bendX : l[o + BENDX] + bendX;
            l[o + BENDY] = stage == 0 ? bendY : l[o + BENDY] + bendY;
            l[o + ALPHA + stage] = alpha;
            l[o + TURNING] = l[o + OMEGA] + c * alpha;
            l[o + TURNED] = l[o + ANGLE] + c * omega;
            SineTable.sinCos(l[o + TURNED], l, o + COS); // (45), (46)
        }
    }

    /** The angular acceleration of a link whose near pin has an acceleration. */
    double angular(int o, double x, double y) {
        return link[o + T] - (link[o + SX] * x + link[o + SY] * y);
    }

    /** The accelerations of the pins of children that are not right behind a link. */
    void carry(int k, double x, double y, double alpha, double square) {
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
        gap = 0;
        for (int r = 0; r < runCount; r++) {
            finish(h, runs[r], runs[r + 1]);
        }
    }

    private void finish(double h, int from, int to) {
        double[] l = link;
        double x = side[SIDE * from + SIDE_A];
        double y = side[SIDE * from + SIDE_A + 1];
        double sixth = h / 6;
        double most = gap;
        for (int k = from, o = STRIDE * from; k < to; k++, o += STRIDE) {
            double alpha = angular(o, x, y);
            double square = l[o + TURNING] * l[o + TURNING];
            if (child[k] >= 0) {
                carry(k, x, y, alpha, square);
            }
            x = x - square * l[o + RX] - alpha * l[o + RY];
            y = y - square * l[o + RY] + alpha * l[o + RX];
            double before = l[o + OMEGA];
            double first = l[o + ALPHA];
            double middle = l[o + ALPHA + 1] + l[o + ALPHA + 2];
            double angle = l[o + ANGLE] + h * (before + sixth * (first + middle));
            double omega = before + sixth * (first + 2 * middle + alpha);
            l[o + ANGLE] = angle;
            l[o + OMEGA] = omega;
            l[o + TURNING] = omega;
            SineTable.sinCos(angle, l, o + COS);
            double gapX = l[o + FIRSTX] - h * (before * l[o + FIRSTY] + sixth * l[o + BENDX]);
            double gapY = l[o + FIRSTY] + h * (before * l[o + FIRSTX] - sixth * l[o + BENDY]);
            gapX -= l[o + COS] * l[o + EX] - l[o + SIN] * l[o + EY];
            gapY -= l[o + SIN] * l[o + EX] + l[o + COS] * l[o + EY];
            double open = Math.abs(gapX) + Math.abs(gapY);
            if (!(open <= most)) { // seldom; a maximum would make each wait for the last
                most = open >= 0 ? open : Double.POSITIVE_INFINITY; // NaN stays
            }
        }
        gap = most;
    }

    /**
     * How far RK4 of the places would have parted what the angles hold together: about the error of a link in the last step.
     */
    double gap() {
        return gap;
    }
}
