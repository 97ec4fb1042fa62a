// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint.tree;

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
 * <p>A link is as good as two points at its near pin and at the next link's, and what is left: with f e = m d the mass f of the
 * far one counts to M' of the next link, m − f to the own M, I + m d² − f e² is left of the inertia, and m d is in none of
 * these equations. Where d is not along e, a moment m d − f e is left over too.
 *
 * <p>A uniform field is an acceleration of the root. All values of a link lie together; a child comes right behind its
 * parent if it can, and what it leaves behind stays in registers then.
 */
final class PinTree implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Values of a link. */
    static final int STRIDE = 32;

    /** The largest turn of a link that is followed at once. */
    private static final double HALF_TURN = Math.PI;

    /** At a stage: cosine and sine of the angle, e, angular velocity. */
    static final int COS = 0;
    static final int SIN = 1;
    static final int RX = 2;
    static final int RY = 3;
    static final int TURNING = 4;

    /** I + m d² − f e²; mass at the pin of the next link: the own f and what that link has at its near pin. */
    static final int HUB = 5;

    static final int KNOT = 6;

    /** At a stage: S/H and τ/H. */
    private static final int SX = 7;

    private static final int SY = 8;
    private static final int T = 9;

    /** The state at the start, and at the end of a step. */
    static final int X = 10;
    static final int Y = 11;
    static final int ANGLE = 12;
    static final int U = 13;
    static final int V = 14;
    static final int OMEGA = 15;

    /** From the near pin to the next link's, and to the centre of mass, in the coordinates of the link. */
    static final int EX = 16;

    static final int EY = 17;
    static final int DX = 18;
    static final int DY = 19;

    /** Angle at a stage. */
    static final int TURNED = 20;

    /** Angular accelerations of the stages. */
    private static final int ALPHA = 21;

    /** Mass, and its part of the mass of all links; moment of inertia; f. */
    static final int MASS = 24;
    static final int SHARE = 25;
    static final int INERTIA = 26;
    static final int FAR = 27;

    /** m d − f e in the coordinates of the link. */
    static final int RESTX = 28;

    static final int RESTY = 29;

    /** Values of the first link of a run: own e; e, M and p at a stage; A; place and velocity. */
    static final int SIDE = 16;
    private static final int SIDE_E = 2;
    private static final int SIDE_M = 4;
    private static final int SIDE_P = 7;
    static final int SIDE_A = 9;
    static final int SIDE_X = 11;

    final int links;

    /** How many links were passed to find their accelerations, in all stages. */
    long passed;

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

    /** By link: whether more than what is right behind it takes part in its elimination. */
    final boolean[] isOdd;

    /** Whether some links are much heavier than others: forces between links, as {@link HungChain} finds them, lose digits then. */
    boolean isSpread;

    private final double[] sum = new double[9];

    /** By block: accelerations x″, y″, θ″ as if each link were alone; null but while they are used. */
    private double[] alone;

    private double roughness;

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
        isOdd = new boolean[links];
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
            if (k == links - 1 || parent[k + 1] != k) {
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
        forget(); // a state of zeros is no end of a step
    }

    /** Takes the masses over. */
    void weigh(double[] w) {
        TreeMasses.weigh(this, w);
        places.weigh();
    }

    /** Begins with the first stage of a state that is not where the last step ended. */
    void begin() {
        for (int o = 0; o < link.length; o += STRIDE) {
            link[o + TURNING] = link[o + OMEGA];
            SineTable.turn(link[o + ANGLE], link[o + EX], link[o + EY], link, o + COS);
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
        passed += links;
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
     * A run, from the tip to its first link. What does not need 1/H of the child is found without waiting for it, and H only by
     * its last term: the way from one division to the next is what takes the time.
     */
    private void eliminate(int from, int to) {
        double[] l = link;
        double m00 = 0;
        double m01 = 0;
        double m11 = 0;
        double q0 = 0;
        double q1 = 0;
        double tau = 0;
        double s0 = 0;
        double s1 = 0;
        double u0 = 0; // S/H
        double u1 = 0;
        double per = 0;
        for (int k = to, o = STRIDE * to; k >= from; k--, o -= STRIDE) {
            double ex = l[o + RX];
            double ey = l[o + RY];
            double square = l[o + TURNING] * l[o + TURNING];
            m00 += l[o + KNOT];
            m11 += l[o + KNOT];
            double g0 = m01 * ex - m00 * ey; // as if nothing had turned the child
            double g1 = m11 * ex - m01 * ey;
            double se = s1 * ex - s0 * ey;
            double hub = l[o + HUB] + (ex * g1 - ey * g0) - se * se * per;
            g0 -= se * u0;
            g1 -= se * u1;
            m00 -= u0 * s0;
            m01 -= u0 * s1;
            m11 -= u1 * s1;
            s0 = g0;
            s1 = g1;
            double trace = m00 + m11; // M' e is the rest of trace e
            q0 = q0 + u0 * tau - square * (trace * ex - s1);
            q1 = q1 + u1 * tau - square * (trace * ey + s0);
            tau = ey * q0 - ex * q1;
            if (alone != null || isOdd[k]) {
                addOthers(k, square);
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
            per = 1 / hub;
            u0 = s0 * per;
            u1 = s1 * per;
            l[o + SX] = u0;
            l[o + SY] = u1;
            l[o + T] = tau * per;
        }
        double near = link[STRIDE * from + MASS] - link[STRIDE * from + FAR];
        leave(SIDE * from, m00 + near - u0 * s0, m01 - u0 * s1, m11 + near - u1 * s1, q0 + u0 * tau, q1 + u1 * tau);
    }

    /** Keeps what a run leaves behind. */
    private void leave(int at, double m00, double m01, double m11, double p0, double p1) {
        side[at + SIDE_M] = m00;
        side[at + SIDE_M + 1] = m01;
        side[at + SIDE_M + 2] = m11;
        side[at + SIDE_P] = p0;
        side[at + SIDE_P + 1] = p1;
    }

    /**
     * What else takes part in the elimination of a link. Sums over the children that are not right behind it: e⊥·M' e⊥, M' e⊥,
     * p' − ω² M' e, τ, M'; what the points leave over, and what acts on the link itself.
     */
    private void addOthers(int k, double square) {
        double[] b = side;
        int o = STRIDE * k;
        double cos = link[o + COS];
        double sin = link[o + SIN];
        Arrays.fill(sum, 0);
        double restX = cos * link[o + RESTX] - sin * link[o + RESTY];
        double restY = sin * link[o + RESTX] + cos * link[o + RESTY];
        sum[1] = -restY;
        sum[2] = restX;
        sum[3] = -square * restX;
        sum[4] = -square * restY;
        if (alone != null) {
            double x = link[o + MASS] * alone[block[k]];
            double y = link[o + MASS] * alone[block[k] + 1];
            double dx = cos * link[o + DX] - sin * link[o + DY];
            double dy = sin * link[o + DX] + cos * link[o + DY];
            sum[3] -= x;
            sum[4] -= y;
            sum[5] = dx * y - dy * x + link[o + INERTIA] * alone[block[k] + State.THETA];
        }
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
            x = x - square * rx - alpha * ry;
            y = y - square * ry + alpha * rx;
            l[o + ALPHA + stage] = alpha;
            double turned = l[o + ANGLE] + c * omega;
            l[o + TURNING] = l[o + OMEGA] + c * alpha;
            l[o + TURNED] = turned;
            SineTable.turn(turned, l[o + EX], l[o + EY], l, o + COS); // (45), (46)
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
        roughness = 0;
        for (int r = 0; r < runCount; r++) {
            finish(h, runs[r], runs[r + 1]);
        }
    }

    private void finish(double h, int from, int to) {
        double[] l = link;
        double x = side[SIDE * from + SIDE_A];
        double y = side[SIDE * from + SIDE_A + 1];
        double sixth = h / 6;
        double most = roughness;
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
            double second = l[o + ALPHA + 1];
            double third = l[o + ALPHA + 2];
            double middle = second + third;
            double rough = Math.abs(first - middle + alpha) + Math.abs(second - third);
            if (!(rough <= most && Math.abs(h * before) <= HALF_TURN)) { // seldom; a maximum would make each wait for the last
                most = rough >= 0 && Math.abs(h * before) <= HALF_TURN ? rough : Double.POSITIVE_INFINITY; // NaN stays
            }
            double angle = l[o + ANGLE] + h * (before + sixth * (first + middle));
            double omega = before + sixth * (first + 2 * middle + alpha);
            l[o + ANGLE] = angle;
            l[o + OMEGA] = omega;
            l[o + TURNING] = omega;
            SineTable.turn(angle, l[o + EX], l[o + EY], l, o + COS);
        }
        roughness = most;
    }

    /**
     * By how much the angular accelerations of the stages of the last step are not those of a uniform change: the largest
     * |α₁ − α₂ − α₃ + α₄| + |α₂ − α₃| of a link. Both are of second order in the step. Infinite if a link turns too far.
     */
    double roughness() {
        return roughness;
    }

    /** Sets it, after a step that was made elsewhere. */
    void setRoughness(double roughness) {
        this.roughness = roughness;
    }

    /** Whether a link may turn by an angle at once; not by NaN. */
    static boolean follows(double turn) {
        return Math.abs(turn) <= HALF_TURN;
    }
}
