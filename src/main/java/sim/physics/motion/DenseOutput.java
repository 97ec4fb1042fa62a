// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import sim.physics.internal.IntList;

/**
 * Where bodies are within a step of an integrator that chooses it, as the method's own polynomials say: positions and
 * velocities, with θ from 0 at its start to 1 at its end,
 *
 * <pre>
 *   y(θ) = y0 + θ (f0 + (1 − θ) (f1 + θ (f2 + (1 − θ) (f3 + …))))
 * </pre>
 *
 * <p>f0 is the way of the step, f1 and f2 have the slopes at its ends, and what follows is the method's.
 */
final class DenseOutput implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Number of coefficients of a quintic. */
    static final int QUINTIC = 5;

    /** Number of coefficients of a coordinate, and of coordinates. */
    int terms;

    private int size;

    /** Length of the step, time. */
    double length;

    /** The start, by coordinate of the group without gaps. */
    double[] x0 = {};

    double[] v0 = {};

    /** The coefficients, {@link #terms} per coordinate. */
    double[] x = {};

    double[] v = {};

    DenseOutput() {
        // grows with the groups
    }

    /** Makes room for a step, and takes its start. */
    void begin(Stages s, double length, int terms) {
        this.length = length;
        this.terms = terms;
        size = s.size;
        if (x0.length < s.size) {
            x0 = new double[s.size];
            v0 = new double[s.size];
        }
        if (x.length < terms * s.size) {
            x = new double[terms * s.size];
            v = new double[terms * s.size];
        }
        System.arraycopy(s.x0, 0, x0, 0, s.size);
        System.arraycopy(s.v0, 0, v0, 0, s.size);
    }

    /** Sets the first three coefficients of a coordinate, which hold at both ends; the accelerations are those there. */
    void join(int m, double endX, double endV, double startA, double endA) {
        int o = terms * m;
        double way = endX - x0[m];
        x[o] = way;
        x[o + 1] = length * v0[m] - way;
        x[o + 2] = 2 * way - length * (v0[m] + endV);
        double gain = endV - v0[m];
        v[o] = gain;
        v[o + 1] = length * startA - gain;
        v[o + 2] = 2 * gain - length * (startA + endA);
    }

    /** Sets all coefficients of a coordinate to those of the quintic that has places, velocities and accelerations of both ends. */
    void quintic(int m, double endX, double endV, double startA, double endA) {
        join(m, endX, endV, startA, endA);
        int o = terms * m;
        double square = length * length;
        x[o + 3] = 0.5 * square * startA + x[o + 1] - x[o + 2];
        x[o + 4] = 0.5 * square * endA + x[o + 1] + 2 * x[o + 2] - x[o + 3];
        double mean = 0.5 * (v0[m] + endV) + length * (startA - endA) / 12;
        v[o + 3] = 30 * ((endX - x0[m]) / length - mean);
        v[o + 4] = 0;
        for (int k = 5; k < terms; k++) {
            x[o + k] = 0;
            v[o + k] = 0;
        }
    }

    /** Adds what is missing at the end, and nothing to the slopes at both ends: 3θ² − 2θ³ of it. */
    void bend(int o, double missX, double missV) {
        x[o] += missX;
        x[o + 1] -= missX;
        x[o + 2] += 2 * missX;
        v[o] += missV;
        v[o + 1] -= missV;
        v[o + 2] += 2 * missV;
    }

    /** Tells coordinates and their rates. */
    void at(double theta, double[] toX, double[] toV) {
        for (int m = 0; m < size; m++) {
            toX[m] = x0[m] + value(x, terms * m, theta);
            toV[m] = v0[m] + value(v, terms * m, theta);
        }
    }

    /** Tells the accelerations of the coordinates. */
    void slopes(double theta, double[] a) {
        for (int m = 0; m < size; m++) {
            a[m] = slope(v, terms * m, theta) / length;
        }
    }

    /** Writes where the bodies, whose own coordinates these are, are into the state vectors. */
    void put(State state, IntList bodies, double theta) {
        for (int k = 0, m = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int end = b + State.BLOCK; b < end; b++, m++) {
                state.x()[b] = x0[m] + value(x, terms * m, theta);
                state.v()[b] = v0[m] + value(v, terms * m, theta);
            }
        }
    }

    /** What a coordinate's polynomial, whose coefficients are at a place, adds to its start. */
    double value(double[] f, int at, double theta) {
        double sum = 0;
        for (int k = terms - 1; k >= 0; k--) {
            sum = f[at + k] + ((k & 1) == 0 ? 1 - theta : theta) * sum;
        }
        return theta * sum;
    }

    /** The accelerations of bodies whose own coordinates these are, by block. */
    void accelerations(IntList bodies, double theta, double[] a) {
        for (int k = 0, m = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int end = b + State.BLOCK; b < end; b++, m++) {
                a[b] = slope(v, terms * m, theta) / length;
            }
        }
    }

    private double slope(double[] f, int at, double theta) {
        double sum = 0;
        double rate = 0;
        for (int k = terms - 1; k >= 0; k--) {
            double factor = (k & 1) == 0 ? 1 - theta : theta;
            rate = ((k & 1) == 0 ? -sum : sum) + factor * rate;
            sum = f[at + k] + factor * sum;
        }
        return sum + theta * rate;
    }
}
