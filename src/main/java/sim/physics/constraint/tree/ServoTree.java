// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint.tree;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.SineTable;
import sim.physics.motion.State;

/**
 * The accelerations of a {@link PinTree} at whose pins torques act. A pin is <i>held</i> whose motor keeps its speed, or whose stop is
 * pressed: its link turns as the one before it, but for a constant rate. At any other pin a torque is given.
 *
 * <p>They come from one pass from the tips to the root and one back (Featherstone 1983, for joints of both kinds). The force and
 * torque at the near pin of a link, which move it and all behind it, are
 *
 * <pre>
 *   F = M A + S θ″ + q,   T = S·A + H θ″ − τ      A: acceleration of the near pin
 * </pre>
 *
 * <p>Where T is given, θ″ follows from it, and leaves F = M' A + q'. Where the link is held, θ″ is that of the link before it, and T
 * follows.
 */
final class ServoTree implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Values of a link: e from the near pin of the link before it to its own, in the coordinates of that, and turned; M, S, H, q, τ; A. */
    private static final int STRIDE = 16;

    private static final int ARMX = 0;
    private static final int ARMY = 1;
    private static final int EX = 2;
    private static final int EY = 3;
    private static final int M00 = 4;
    private static final int M01 = 5;
    private static final int M11 = 6;
    private static final int SX = 7;
    private static final int SY = 8;
    private static final int H = 9;
    private static final int QX = 10;
    private static final int QY = 11;
    private static final int TAU = 12;
    private static final int AX = 13;
    private static final int AY = 14;

    private final PinTree tree;
    private final double[] node;

    /** Angular accelerations, by stage. */
    private final double[][] alpha;

    /** By link: the torque that is given at its near pin; whether it is held there, and the least and the greatest torque of that. */
    private final double[] torque;

    private final boolean[] isHeld;
    private final double[] least;
    private final double[] most;

    /** By link that is held: the torque at its near pin that was found last. */
    private final double[] needed;

    /** Whether all that is held in the step was held by no more than that. */
    private boolean isWithin;

    /** By link that is held: by how much its angle is to change beside that of the link before it, where velocities jump; and 0 then, else 1. */
    private final double[] jump;

    private double moving = 1;

    /** What the first stage of the last step was found with, and what held then; whether its accelerations are there still. */
    private final double[] firstTorque;

    private final boolean[] wereHeld;
    private final double[] firstNeeded;
    private double firstX;
    private double firstY;
    private boolean isFirstKnown;

    ServoTree(PinTree tree) {
        this.tree = tree;
        int n = tree.links;
        node = new double[STRIDE * n];
        alpha = new double[TreeLoads.STAGES][n];
        torque = new double[n];
        isHeld = new boolean[n];
        least = new double[n];
        most = new double[n];
        needed = new double[n];
        jump = new double[n];
        firstTorque = new double[n];
        wereHeld = new boolean[n];
        firstNeeded = new double[n];
        for (int k = 1; k < n; k++) {
            int j = tree.parent[k];
            boolean isRightBehind = j == k - 1;
            node[STRIDE * k + ARMX] = isRightBehind ? tree.link[PinTree.STRIDE * j + PinTree.EX] : tree.side[PinTree.SIDE * k];
            node[STRIDE * k + ARMY] = isRightBehind ? tree.link[PinTree.STRIDE * j + PinTree.EY] : tree.side[PinTree.SIDE * k + 1];
        }
    }

    /** Lets nothing act at any pin. */
    void clear() {
        Arrays.fill(torque, 0);
        Arrays.fill(isHeld, false);
    }

    void push(int link, double given) {
        torque[link] += given;
    }

    /** Holds a link, with a torque between two beside what was given; false if it is held already. */
    boolean hold(int link, double from, double to) {
        boolean isNew = !isHeld[link];
        isHeld[link] = true;
        least[link] = torque[link] + from;
        most[link] = torque[link] + to;
        return isNew;
    }

    /** Lets the velocity of a link that is held jump by a rate, beside that of the link before it. */
    void jump(int link, double rate) {
        jump[link] = rate;
    }

    /** The torque at the near pin of a link that is held there, as it was found last, without what was given. */
    double holds(int link) {
        return needed[link] - torque[link];
    }

    /** Begins a step. */
    void begin() {
        isWithin = true;
    }

    /** Whether nothing was held by more than it can be since the step began. */
    boolean isWithin() {
        return isWithin;
    }

    /**
     * The pass from the tips to the root.
     *
     * @param alone accelerations x″, y″, θ″ of each link as if it were alone, by block; null for a uniform field
     * @param gx the field: an acceleration of the root, if that hangs in the world; a free tree falls as a whole
     * @param gy the field
     */
    void eliminate(double[] alone, double gx, double gy) {
        tree.passed += tree.links;
        for (int k = 0; k < tree.links; k++) {
            weigh(k, alone);
        }
        for (int k = tree.links - 1; k > 0; k--) {
            fold(k);
        }
        hang(gx, gy);
    }

    /** What a link is by itself. */
    private void weigh(int k, double[] alone) {
        double[] l = tree.link;
        int p = PinTree.STRIDE * k;
        int o = STRIDE * k;
        double cos = l[p + PinTree.COS];
        double sin = l[p + PinTree.SIN];
        double m = l[p + PinTree.MASS];
        double dx = m * (cos * l[p + PinTree.DX] - sin * l[p + PinTree.DY]);
        double dy = m * (sin * l[p + PinTree.DX] + cos * l[p + PinTree.DY]);
        double square = moving * (l[p + PinTree.TURNING] * l[p + PinTree.TURNING]);
        node[o + M00] = m;
        node[o + M01] = 0;
        node[o + M11] = m;
        node[o + SX] = -dy;
        node[o + SY] = dx;
        node[o + H] = l[p + PinTree.INERTIA] + (dx * dx + dy * dy) / m;
        node[o + QX] = -square * dx;
        node[o + QY] = -square * dy;
        node[o + TAU] = 0;
        if (alone != null) {
            double x = alone[tree.block[k]];
            double y = alone[tree.block[k] + 1];
            node[o + QX] -= m * x;
            node[o + QY] -= m * y;
            node[o + TAU] = dx * y - dy * x + l[p + PinTree.INERTIA] * alone[tree.block[k] + State.THETA];
        }
        if (k > 0) {
            int j = PinTree.STRIDE * tree.parent[k];
            node[o + EX] = l[j + PinTree.COS] * node[o + ARMX] - l[j + PinTree.SIN] * node[o + ARMY];
            node[o + EY] = l[j + PinTree.SIN] * node[o + ARMX] + l[j + PinTree.COS] * node[o + ARMY];
        }
    }

    /** Lets the link before one feel it, with all behind it. */
    private void fold(int k) {
        double[] a = node;
        int o = STRIDE * k;
        int j = STRIDE * tree.parent[k];
        double omega = tree.link[PinTree.STRIDE * tree.parent[k] + PinTree.TURNING];
        double square = moving * (omega * omega);
        double ex = a[o + EX];
        double ey = a[o + EY];
        settle(k);
        double m00 = a[o + M00];
        double m01 = a[o + M01];
        double m11 = a[o + M11];
        double g0 = m01 * ex - m00 * ey;
        double g1 = m11 * ex - m01 * ey;
        double c0 = a[o + QX] - square * (m00 * ex + m01 * ey);
        double c1 = a[o + QY] - square * (m01 * ex + m11 * ey);
        a[j + M00] += m00;
        a[j + M01] += m01;
        a[j + M11] += m11;
        a[j + SX] += g0;
        a[j + SY] += g1;
        a[j + H] += ex * g1 - ey * g0;
        a[j + QX] += c0;
        a[j + QY] += c1;
        a[j + TAU] -= ex * c1 - ey * c0;
        if (isHeld[k]) {
            a[j + SX] += a[o + SX];
            a[j + SY] += a[o + SY];
            a[j + H] += 2 * (ex * a[o + SY] - ey * a[o + SX]) + a[o + H];
            a[j + TAU] += a[o + TAU] + square * (ex * a[o + SX] + ey * a[o + SY]);
        } else {
            a[j + TAU] -= torque[k];
        }
    }

    /** What is held, and may jump, turns with the link before it; and what is not, by itself. */
    private void settle(int k) {
        int o = STRIDE * k;
        if (!isHeld[k]) {
            release(k);
        } else if (moving == 0) {
            node[o + QX] += node[o + SX] * jump[k];
            node[o + QY] += node[o + SY] * jump[k];
            node[o + TAU] -= node[o + H] * jump[k];
        }
    }

    /** The angle of a link follows from its torque: M' and q', and S/H and (T + τ)/H in the place of S and τ. */
    private void release(int k) {
        double[] a = node;
        int o = STRIDE * k;
        double per = 1 / a[o + H];
        double sx = a[o + SX];
        double sy = a[o + SY];
        double free = (torque[k] + a[o + TAU]) * per;
        a[o + M00] -= sx * sx * per;
        a[o + M01] -= sx * sy * per;
        a[o + M11] -= sy * sy * per;
        a[o + QX] += sx * free;
        a[o + QY] += sy * free;
        a[o + SX] = sx * per;
        a[o + SY] = sy * per;
        a[o + TAU] = free;
    }

    /** The acceleration of the root. */
    private void hang(double gx, double gy) {
        node[AX] = -gx;
        node[AY] = -gy;
        settle(0);
        if (tree.isFree) {
            double m00 = node[M00];
            double m01 = node[M01];
            double m11 = node[M11];
            double per = 1 / (m00 * m11 - m01 * m01);
            node[AX] = per * (m01 * node[QY] - m11 * node[QX]);
            node[AY] = per * (m01 * node[QX] - m00 * node[QY]);
        }
    }

    /** The pass from the root to the tips at a stage. */
    private void spread(double[] turned) {
        double[] a = node;
        for (int k = 0; k < tree.links; k++) {
            int o = STRIDE * k;
            double before = 0;
            if (k > 0) {
                int j = tree.parent[k];
                double omega = tree.link[PinTree.STRIDE * j + PinTree.TURNING];
                double square = moving * (omega * omega);
                before = turned[j];
                a[o + AX] = a[STRIDE * j + AX] - square * a[o + EX] - before * a[o + EY];
                a[o + AY] = a[STRIDE * j + AY] - square * a[o + EY] + before * a[o + EX];
            }
            double along = a[o + SX] * a[o + AX] + a[o + SY] * a[o + AY];
            if (isHeld[k]) {
                needed[k] = along + a[o + H] * before - a[o + TAU];
                isWithin &= needed[k] >= least[k] && needed[k] <= most[k];
            }
            turned[k] = isHeld[k] ? before + (moving == 0 ? jump[k] : 0) : a[o + TAU] - along;
        }
    }

    /**
     * The accelerations where the links are.
     *
     * @param a has those of each link as if it were alone, x″, y″, θ″ by block; gets those that it has
     */
    void accelerations(double[] a) {
        double[] l = tree.link;
        double[] turned = alpha[0];
        forgetFirst();
        eliminate(a, 0, 0);
        spread(turned);
        for (int k = 0, p = 0; k < tree.links; k++, p += PinTree.STRIDE) {
            int b = tree.block[k];
            double dx = l[p + PinTree.COS] * l[p + PinTree.DX] - l[p + PinTree.SIN] * l[p + PinTree.DY];
            double dy = l[p + PinTree.SIN] * l[p + PinTree.DX] + l[p + PinTree.COS] * l[p + PinTree.DY];
            double square = l[p + PinTree.TURNING] * l[p + PinTree.TURNING];
            a[b] = node[STRIDE * k + AX] - square * dx - turned[k] * dy;
            a[b + 1] = node[STRIDE * k + AY] - square * dy + turned[k] * dx;
            a[b + State.THETA] = turned[k];
        }
    }

    /** Lets velocities jump as little as what is held and jumps asks for; places are as before. */
    void jump() {
        double[] l = tree.link;
        double[] change = alpha[0];
        forgetFirst();
        moving = 0;
        eliminate(null, 0, 0);
        spread(change);
        moving = 1;
        for (int k = 0, p = 0; k < tree.links; k++, p += PinTree.STRIDE) {
            l[p + PinTree.OMEGA] += change[k];
            l[p + PinTree.TURNING] = l[p + PinTree.OMEGA];
        }
    }

    /** The links are elsewhere, or weigh more or less. */
    void forgetFirst() {
        isFirstKnown = false;
    }

    /** The first stage of a step in a uniform field; that of the last one, if it has begun where this does, and with what acts now. */
    void first(double gx, double gy, double c) {
        boolean isSame = isFirstKnown && gx == firstX && gy == firstY && Arrays.equals(torque, firstTorque) && Arrays.equals(isHeld, wereHeld);
        if (!isSame) {
            eliminate(null, gx, gy);
            spread(alpha[0]);
            firstX = gx;
            firstY = gy;
            System.arraycopy(torque, 0, firstTorque, 0, torque.length);
            System.arraycopy(isHeld, 0, wereHeld, 0, isHeld.length);
            System.arraycopy(needed, 0, firstNeeded, 0, needed.length);
            isFirstKnown = true;
        }
        for (int k = 0; k < tree.links; k++) {
            isWithin &= !isHeld[k] || firstNeeded[k] >= least[k] && firstNeeded[k] <= most[k];
        }
        turn(alpha[0], c);
    }

    /**
     * That pass, and the links at the next stage: by c times the rates of this one from the start.
     *
     * @param stage number of this stage
     * @param c time
     */
    void accelerate(int stage, double c) {
        spread(alpha[stage]);
        turn(alpha[stage], c);
    }

    private void turn(double[] now, double c) {
        double[] l = tree.link;
        for (int k = 0, p = 0; k < tree.links; k++, p += PinTree.STRIDE) {
            double angle = l[p + PinTree.ANGLE] + c * l[p + PinTree.TURNING];
            l[p + PinTree.TURNING] = l[p + PinTree.OMEGA] + c * now[k];
            l[p + PinTree.TURNED] = angle;
            SineTable.turn(angle, l[p + PinTree.EX], l[p + PinTree.EY], l, p + PinTree.COS);
        }
    }

    /**
     * That pass at the last stage, and the links at the end of the step, (13).
     *
     * @param h step
     */
    void finish(double h) {
        double[] last = alpha[TreeLoads.STAGES - 1];
        spread(last);
        double[] l = tree.link;
        double sixth = h / 6;
        double rough = 0;
        for (int k = 0, p = 0; k < tree.links; k++, p += PinTree.STRIDE) {
            double before = l[p + PinTree.OMEGA];
            double middle = alpha[1][k] + alpha[2][k];
            double sum = alpha[0][k] + middle;
            rough = Math.max(rough, Math.abs(alpha[0][k] - middle + last[k]) + Math.abs(alpha[1][k] - alpha[2][k]));
            rough = PinTree.follows(h * before) ? rough : Double.POSITIVE_INFINITY;
            double angle = l[p + PinTree.ANGLE] + h * (before + sixth * sum);
            l[p + PinTree.OMEGA] = before + sixth * (sum + middle + last[k]);
            l[p + PinTree.ANGLE] = angle;
            l[p + PinTree.TURNING] = l[p + PinTree.OMEGA];
            SineTable.turn(angle, l[p + PinTree.EX], l[p + PinTree.EY], l, p + PinTree.COS);
        }
        tree.setRoughness(rough);
    }
}
