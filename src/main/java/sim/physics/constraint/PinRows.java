// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.constraint.tree.ServoStep;
import sim.physics.constraint.tree.TreeStep;
import sim.physics.internal.Trig;
import sim.physics.motion.Body;
import sim.physics.motion.State;

/** The rows of an island's pins, (42)–(46), all in one loop: {@link PinJoint#evaluate} without a call for each. */
final class PinRows implements Serializable {
    private static final long serialVersionUID = 1L;

    private final Island island;
    private final boolean[] isPin;

    /** Nodes of the pins. */
    private final int[] pins;

    /** By node: the arms in the coordinates of the bodies, or of the world where a body cannot move. */
    private final double[] arms;

    /** By node: the arms, turned; and inverse mass and moment of inertia of both bodies. */
    private final double[] r;

    private final double[] masses;

    /** C of a pin and what rounding leaves of it. */
    private final double[] sum = new double[2];

    private final double[] rest = new double[2];
    private boolean isWeighed;
    private final boolean areAll;

    /** Where two pins meet on a body: block of A, the arms of both; and whether they pull alike, 1, or not, −1. */
    private int[] meetings = {};

    private double[] sign = {};

    /** Each body's cosine and sine. */
    private final Turns turns;

    PinRows(Island island, Turns turns) {
        this.island = island;
        this.turns = turns;
        int n = island.constraints.length;
        isPin = new boolean[n];
        int count = 0;
        for (int k = 0; k < n; k++) {
            isPin[k] = island.constraints[k] instanceof PinJoint;
            count += pin(k) == null ? 0 : 1;
        }
        pins = new int[count];
        arms = new double[4 * island.nodes];
        r = new double[4 * island.nodes];
        masses = new double[4 * island.nodes];
        boolean all = true;
        for (int k = 0, at = 0; k < n; k++) {
            all &= isPin[k];
            if (pin(k) != null) {
                pins[at++] = island.firstNode[k];
                prepare(island.firstNode[k], pin(k));
            }
        }
        areAll = all;
    }

    /** The pin that a constraint is or has, or null. */
    private PinJoint pin(int constraint) {
        Constraint one = island.constraints[constraint];
        return one instanceof PinJoint p ? p : one instanceof WeldJoint w ? w.pin() : null;
    }

    /** Takes over where nodes share a body, as {@link Island} has it, if all constraints are pins. */
    void setShared(int[] shared) {
        meetings = new int[shared.length];
        sign = new double[shared.length / 3];
        for (int k = 0, m = 0; k < shared.length; k += 3, m++) {
            int q = shared[k + 1];
            int p = shared[k + 2];
            meetings[3 * m] = shared[k];
            meetings[3 * m + 1] = 4 * (q / Island.J) + 2 * (q % Island.J / 6);
            meetings[3 * m + 2] = 4 * (p / Island.J) + 2 * (p % Island.J / 6);
            sign[m] = q % Island.J == p % Island.J ? 1 : -1;
        }
    }

    /** The steps of the pins if they form a tree, or null. */
    TreeStep tree() {
        return TreeStep.of(new IslandTree(island), island.a, island.b, arms);
    }

    /** The same with torques at the pins, if these are all that there is beside motors and stops. */
    ServoStep servos() {
        int[] a = new int[pins.length];
        int[] b = new int[pins.length];
        double[] ends = new double[4 * pins.length];
        for (int k = 0; k < pins.length; k++) {
            a[k] = island.a[pins[k]];
            b[k] = island.b[pins[k]];
            System.arraycopy(arms, 4 * pins[k], ends, 4 * k, 4);
        }
        return ServoStep.of(new IslandTree(island), a, b, ends);
    }

    /** The steps of the pins if they form a chain, or null. */
    ChainStep chain() {
        PinChain chain = ChainLayout.find(island, arms);
        return chain == null ? null : new ChainStep(island, chain);
    }

    /** Whether all constraints are pins, so that node k is pin k. */
    boolean areAll() {
        return areAll;
    }

    boolean has(int constraint) {
        return isPin[constraint];
    }

    /** Whether a node is that of a pin. */
    boolean isAt(int node) {
        return Arrays.binarySearch(pins, node) >= 0;
    }

    private void prepare(int p, PinJoint pin) {
        anchor(4 * p, pin.getBodyA(), pin.getAnchorAX(), pin.getAnchorAY());
        anchor(4 * p + 2, pin.getBodyB(), pin.getAnchorBX(), pin.getAnchorBY());
        if (island.a[p] >= 0) {
            turns.need(island.a[p]);
            island.j[Island.J * p] = 1;
            island.j[Island.J * p + 4] = 1;
        }
        if (island.b[p] >= 0) {
            turns.need(island.b[p]);
            island.j[Island.J * p + 6] = -1;
            island.j[Island.J * p + 10] = -1;
        }
    }

    /** Keeps an anchor in the coordinates of its body, or where it is in the world if it does not move. */
    private void anchor(int at, Body body, double x, double y) {
        arms[at] = x;
        arms[at + 1] = y;
        if (body != null && body.isImmobile()) {
            double cos = Trig.cos(body.getAngle());
            double sin = Trig.sin(body.getAngle());
            arms[at] = body.getX() + (cos * x - sin * y);
            arms[at + 1] = body.getY() + (sin * x + cos * y);
        }
    }

    /** Evaluates C, J and J̇ ẋ of all pins at the positions and velocities of the state vectors. */
    void evaluate(State state, boolean moved) {
        double[] x = state.x();
        double[] v = state.v();
        for (int k = 0; k < pins.length; k++) {
            if (moved) {
                evaluate(pins[k], x);
            }
            if (turns.isCarried()) {
                refine(pins[k], x, state.carry().lowX());
            }
            evaluateRate(pins[k], v);
        }
    }

    private void evaluate(int p, double[] x) {
        double[] turn = turns.turn;
        double ax = arms[4 * p];
        double ay = arms[4 * p + 1];
        double bx = arms[4 * p + 2];
        double by = arms[4 * p + 3];
        int a = island.a[p];
        if (a >= 0) {
            double cos = turn[2 * a];
            double sin = turn[2 * a + 1];
            double rx = cos * ax - sin * ay; // (45), (46)
            double ry = sin * ax + cos * ay;
            int s = island.blockA[p];
            r[4 * p] = rx;
            r[4 * p + 1] = ry;
            ax = x[s] + rx; // (42)
            ay = x[s + 1] + ry;
        }
        int b = island.b[p];
        if (b >= 0) {
            double cos = turn[2 * b];
            double sin = turn[2 * b + 1];
            double rx = cos * bx - sin * by;
            double ry = sin * bx + cos * by;
            int s = island.blockB[p];
            r[4 * p + 2] = rx;
            r[4 * p + 3] = ry;
            bx = x[s] + rx; // (43)
            by = x[s + 1] + ry;
        }
        island.c[2 * p] = ax - bx; // (44)
        island.c[2 * p + 1] = ay - by;
    }

    /**
     * Evaluates C with what rounding has left of the positions, of cosines and sines and of their sums, and the arms with what
     * they have digits for. Where C was closed at a position and J was that of its rounded value, forces would do a little
     * work, of the order of a thousandth of a digit's unit, but to the same side in each step.
     */
    private void refine(int p, double[] x, double[] low) {
        sum[0] = 0;
        sum[1] = 0;
        rest[0] = 0;
        rest[1] = 0;
        refine(p, 0, island.a[p], island.blockA[p], 1, x, low);
        refine(p, 2, island.b[p], island.blockB[p], -1, x, low);
        island.c[2 * p] = sum[0] + rest[0];
        island.c[2 * p + 1] = sum[1] + rest[1];
    }

    private void refine(int p, int side, int body, int s, double sign, double[] x, double[] low) {
        double armX = arms[4 * p + side];
        double armY = arms[4 * p + side + 1];
        if (body < 0) {
            TwoFold.add(sum, rest, 0, sign * armX);
            TwoFold.add(sum, rest, 1, sign * armY);
            return;
        }
        double cos = turns.turn[2 * body];
        double sin = turns.turn[2 * body + 1];
        double most = Math.max(cos * cos, sin * sin);
        double least = Math.min(cos * cos, sin * sin);
        double off = 0.5 * (1 - most - least - Math.fma(cos, cos, -cos * cos) - Math.fma(sin, sin, -sin * sin));
        double lowCos = off * cos - low[s + State.THETA] * sin;
        double lowSin = off * sin + low[s + State.THETA] * cos;
        double lowX = lowCos * armX - lowSin * armY + error(cos, armX, -sin, armY);
        double lowY = lowSin * armX + lowCos * armY + error(sin, armX, cos, armY);
        TwoFold.add(sum, rest, 0, sign * x[s]);
        TwoFold.add(sum, rest, 1, sign * x[s + 1]);
        TwoFold.add(sum, rest, 0, sign * r[4 * p + side]);
        TwoFold.add(sum, rest, 1, sign * r[4 * p + side + 1]);
        rest[0] += sign * (low[s] + lowX);
        rest[1] += sign * (low[s + 1] + lowY);
        r[4 * p + side] += lowX;
        r[4 * p + side + 1] += lowY;
    }

    /** What rounding leaves of a x + b y. */
    private static double error(double a, double x, double b, double y) {
        double p = a * x;
        double q = b * y;
        double sum = p + q;
        double part = sum - p;
        return (p - (sum - part)) + (q - part) + Math.fma(a, x, -p) + Math.fma(b, y, -q);
    }

    private void evaluateRate(int p, double[] v) {
        int a = island.blockA[p];
        int b = island.blockB[p];
        double omegaA = a < 0 ? 0 : v[a + State.THETA];
        double omegaB = b < 0 ? 0 : v[b + State.THETA];
        double squareA = omegaA * omegaA;
        double squareB = omegaB * omegaB;
        island.rate[2 * p] = squareB * r[4 * p + 2] - squareA * r[4 * p];
        island.rate[2 * p + 1] = squareB * r[4 * p + 3] - squareA * r[4 * p + 1];
    }

    /** Writes the rows of J that the arms make; needed where not all constraints are pins, and by the general solvers. */
    void writeRows() {
        double[] j = island.j;
        for (int p : pins) {
            int o = Island.J * p;
            if (island.a[p] >= 0) {
                j[o + 2] = -r[4 * p + 1];
                j[o + 5] = r[4 * p];
            }
            if (island.b[p] >= 0) {
                j[o + 8] = r[4 * p + 3];
                j[o + 11] = -r[4 * p + 2];
            }
        }
    }

    /** The masses of the pins' bodies. */
    private void weigh(double[] w) {
        for (int p = 0; p < pins.length; p++) {
            int s = island.blockA[p];
            masses[4 * p] = s < 0 ? 0 : w[s];
            masses[4 * p + 1] = s < 0 ? 0 : w[s + State.THETA];
            s = island.blockB[p];
            masses[4 * p + 2] = s < 0 ? 0 : w[s];
            masses[4 * p + 3] = s < 0 ? 0 : w[s + State.THETA];
        }
        isWeighed = true;
    }

    /** Masses may have changed. */
    void forgetMasses() {
        isWeighed = false;
    }

    /** The diagonal blocks of A, as {@link Island#factor} has them, where all constraints are pins. */
    void diagonal(double[] w, double[] d) {
        if (!isWeighed) {
            weigh(w);
        }
        for (int p = 0; p < pins.length; p++) {
            int o = 4 * p;
            double ax = r[o];
            double ay = r[o + 1];
            double bx = r[o + 2];
            double by = r[o + 3];
            double iA = masses[o + 1];
            double iB = masses[o + 3];
            double m = masses[o] + masses[o + 2];
            double ia = iA * ay;
            double ib = iB * by;
            d[3 * p] = m + (ia * ay + ib * by);
            d[3 * p + 1] = -(ia * ax + ib * bx);
            d[3 * p + 2] = m + (iA * ax * ax + iB * bx * bx);
        }
    }

    /** The blocks of A below its diagonal. */
    void couple(double[] below) {
        for (int k = 0, e = 0; k < meetings.length; k += 3, e++) {
            int q = meetings[k + 1];
            int p = meetings[k + 2];
            int at = meetings[k];
            double m = sign[e] * masses[p];
            double i = sign[e] * masses[p + 1];
            double ix = i * r[q];
            double iy = i * r[q + 1];
            below[at] += m + iy * r[p + 1];
            below[at + 1] -= iy * r[p];
            below[at + 2] -= ix * r[p + 1];
            below[at + 3] += m + ix * r[p];
        }
    }

    /** −(J u + g) into {@code right}. */
    void residual(double[] u, double[] g, double[] right) {
        for (int p = 0; p < pins.length; p++) {
            double r0 = g == null ? 0 : g[2 * p];
            double r1 = g == null ? 0 : g[2 * p + 1];
            int s = island.blockA[p];
            if (s >= 0) {
                double turning = u[s + 2];
                r0 += u[s] - r[4 * p + 1] * turning;
                r1 += u[s + 1] + r[4 * p] * turning;
            }
            s = island.blockB[p];
            if (s >= 0) {
                double turning = u[s + 2];
                r0 -= u[s] - r[4 * p + 3] * turning;
                r1 -= u[s + 1] + r[4 * p + 2] * turning;
            }
            right[2 * p] = -r0;
            right[2 * p + 1] = -r1;
        }
    }

    /** u += W Jᵀ λ. */
    void apply(double[] w, double[] lambda, double[] u) {
        if (!isWeighed) { // a solver that factors has done so
            weigh(w);
        }
        for (int p = 0; p < pins.length; p++) {
            double l0 = lambda[2 * p];
            double l1 = lambda[2 * p + 1];
            int o = 4 * p;
            int s = island.blockA[p];
            if (s >= 0) {
                double m = masses[o];
                u[s] += m * l0;
                u[s + 1] += m * l1;
                u[s + 2] += masses[o + 1] * (r[o] * l1 - r[o + 1] * l0);
            }
            s = island.blockB[p];
            if (s >= 0) {
                double m = masses[o + 2];
                u[s] -= m * l0;
                u[s + 1] -= m * l1;
                u[s + 2] -= masses[o + 3] * (r[o + 2] * l1 - r[o + 3] * l0);
            }
        }
    }
}
