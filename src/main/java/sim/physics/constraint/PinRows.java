// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
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

    /** Each body's orientation at the last evaluation, and its cosine and sine. */
    private final double[] angle;

    private final double[] turn;

    PinRows(Island island) {
        this.island = island;
        int n = island.constraints.length;
        isPin = new boolean[n];
        int count = 0;
        for (int k = 0; k < n; k++) {
            isPin[k] = island.constraints[k] instanceof PinJoint;
            count += isPin[k] ? 1 : 0;
        }
        pins = new int[count];
        arms = new double[4 * island.nodes];
        turn = new double[2 * island.bodies.size];
        angle = new double[island.bodies.size];
        Arrays.fill(angle, Double.NaN);
        for (int k = 0, at = 0; k < n; k++) {
            if (isPin[k]) {
                pins[at++] = island.firstNode[k];
                prepare(island.firstNode[k], (PinJoint) island.constraints[k]);
            }
        }
    }

    /** Whether all constraints are pins, so that node k is pin k. */
    boolean areAll() {
        return pins.length == isPin.length;
    }

    boolean has(int constraint) {
        return isPin[constraint];
    }

    private void prepare(int p, PinJoint pin) {
        anchor(4 * p, pin.getBodyA(), pin.getAnchorAX(), pin.getAnchorAY());
        anchor(4 * p + 2, pin.getBodyB(), pin.getAnchorBX(), pin.getAnchorBY());
        if (island.a[p] >= 0) {
            island.j[Island.J * p] = 1;
            island.j[Island.J * p + 4] = 1;
        }
        if (island.b[p] >= 0) {
            island.j[Island.J * p + 6] = -1;
            island.j[Island.J * p + 10] = -1;
        }
    }

    /** Keeps an anchor in the coordinates of its body, or where it is in the world if it does not move. */
    private void anchor(int at, Body body, double x, double y) {
        arms[at] = x;
        arms[at + 1] = y;
        if (body != null && body.isFixed()) {
            double cos = Trig.cos(body.getAngle());
            double sin = Trig.sin(body.getAngle());
            arms[at] = body.getX() + (cos * x - sin * y);
            arms[at + 1] = body.getY() + (sin * x + cos * y);
        }
    }

    /** Evaluates C, J and J̇ ẋ of all pins at the positions and velocities of the state vectors. */
    void evaluate(State state) {
        if (pins.length == 0) {
            return;
        }
        double[] x = state.x();
        for (int k = 0; k < island.bodies.size; k++) {
            double theta = x[State.BLOCK * island.bodies.values[k] + State.THETA];
            if (theta != angle[k]) {
                angle[k] = theta;
                Trig.sinCos(theta, turn, 2 * k);
            }
        }
        for (int k = 0; k < pins.length; k++) {
            evaluate(pins[k], x, state.v());
        }
    }

    /** Takes note of a tiny move of the bodies: turns the cosines and sines by its angles instead of finding them anew. */
    void nudge(double[] x, double[] move) {
        if (pins.length == 0) {
            return;
        }
        for (int k = 0; k < island.bodies.size; k++) {
            int s = State.BLOCK * island.bodies.values[k] + State.THETA;
            double d = move[s];
            double cos = turn[2 * k];
            double sin = turn[2 * k + 1];
            angle[k] = x[s];
            turn[2 * k] = cos - d * (sin + 0.5 * d * cos);
            turn[2 * k + 1] = sin + d * (cos - 0.5 * d * sin);
        }
    }

    private void evaluate(int p, double[] x, double[] v) {
        double[] j = island.j;
        double ax = arms[4 * p];
        double ay = arms[4 * p + 1];
        double bx = arms[4 * p + 2];
        double by = arms[4 * p + 3];
        double rateX = 0;
        double rateY = 0;
        int o = Island.J * p;
        if (island.a[p] >= 0) {
            double cos = turn[2 * island.a[p]];
            double sin = turn[2 * island.a[p] + 1];
            double rx = cos * ax - sin * ay; // (45), (46)
            double ry = sin * ax + cos * ay;
            double omega = v[island.blockA[p] + State.THETA];
            rateX = -omega * omega * rx;
            rateY = -omega * omega * ry;
            j[o + 2] = -ry;
            j[o + 5] = rx;
            ax = x[island.blockA[p]] + rx; // (42)
            ay = x[island.blockA[p] + 1] + ry;
        }
        if (island.b[p] >= 0) {
            double cos = turn[2 * island.b[p]];
            double sin = turn[2 * island.b[p] + 1];
            double rx = cos * bx - sin * by;
            double ry = sin * bx + cos * by;
            double omega = v[island.blockB[p] + State.THETA];
            rateX += omega * omega * rx;
            rateY += omega * omega * ry;
            j[o + 8] = ry;
            j[o + 11] = -rx;
            bx = x[island.blockB[p]] + rx; // (43)
            by = x[island.blockB[p] + 1] + ry;
        }
        island.c[2 * p] = ax - bx; // (44)
        island.c[2 * p + 1] = ay - by;
        island.rate[2 * p] = rateX;
        island.rate[2 * p + 1] = rateY;
    }

    /** The diagonal blocks of A, as {@link Island#factor} has them, where all constraints are pins. */
    void diagonal(double[] w, double[] d) {
        double[] j = island.j;
        for (int p = 0; p < pins.length; p++) {
            int o = Island.J * p;
            double m = 0;
            double d00 = 0;
            double d01 = 0;
            double d11 = 0;
            int s = island.blockA[p];
            if (s >= 0) {
                double i = w[s + State.THETA];
                double ix = i * j[o + 2];
                m = w[s];
                d00 = ix * j[o + 2];
                d01 = ix * j[o + 5];
                d11 = i * j[o + 5] * j[o + 5];
            }
            s = island.blockB[p];
            if (s >= 0) {
                double i = w[s + State.THETA];
                double ix = i * j[o + 8];
                m += w[s];
                d00 += ix * j[o + 8];
                d01 += ix * j[o + 11];
                d11 += i * j[o + 11] * j[o + 11];
            }
            d[3 * p] = m + d00;
            d[3 * p + 1] = d01;
            d[3 * p + 2] = m + d11;
        }
    }

    /** The blocks of A below its diagonal. */
    void couple(double[] w, int[] shared, double[] below) {
        double[] j = island.j;
        for (int k = 0; k < shared.length; k += 4) {
            int e = shared[k];
            int q = shared[k + 1];
            int p = shared[k + 2];
            double m = w[shared[k + 3]] * (j[q] * j[p]);
            double i = w[shared[k + 3] + State.THETA];
            double ix = i * j[q + 2];
            double iy = i * j[q + 5];
            below[e] += m + ix * j[p + 2];
            below[e + 1] += ix * j[p + 5];
            below[e + 2] += iy * j[p + 2];
            below[e + 3] += m + iy * j[p + 5];
        }
    }

    /** −(J u + g) into {@code right}. */
    void residual(double[] u, double[] g, double[] right) {
        double[] j = island.j;
        for (int p = 0; p < pins.length; p++) {
            double r0 = g == null ? 0 : g[2 * p];
            double r1 = g == null ? 0 : g[2 * p + 1];
            int o = Island.J * p;
            int s = island.blockA[p];
            if (s >= 0) {
                r0 += u[s] + j[o + 2] * u[s + 2];
                r1 += u[s + 1] + j[o + 5] * u[s + 2];
            }
            s = island.blockB[p];
            if (s >= 0) {
                r0 += j[o + 8] * u[s + 2] - u[s];
                r1 += j[o + 11] * u[s + 2] - u[s + 1];
            }
            right[2 * p] = -r0;
            right[2 * p + 1] = -r1;
        }
    }

    /** u += W Jᵀ λ. */
    void apply(double[] w, double[] lambda, double[] u) {
        double[] j = island.j;
        for (int p = 0; p < pins.length; p++) {
            double l0 = lambda[2 * p];
            double l1 = lambda[2 * p + 1];
            int o = Island.J * p;
            int s = island.blockA[p];
            if (s >= 0) {
                u[s] += w[s] * l0;
                u[s + 1] += w[s] * l1;
                u[s + 2] += w[s + 2] * (j[o + 2] * l0 + j[o + 5] * l1);
            }
            s = island.blockB[p];
            if (s >= 0) {
                u[s] -= w[s] * l0;
                u[s + 1] -= w[s] * l1;
                u[s + 2] += w[s + 2] * (j[o + 8] * l0 + j[o + 11] * l1);
            }
        }
    }
}
