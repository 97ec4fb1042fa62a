// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.internal.Trig;

/**
 * Dense output for a method of any order whose steps have none of their own: from the quintic through both ends the
 * accelerations at some nodes between, from their polynomial, integrated twice, better places of the nodes, and so on until
 * these stay (the bootstrapping of Hairer, Nørsett and Wanner, <i>Solving Ordinary Differential Equations I</i>, 2nd edition,
 * II.6). What then is missing at the step's end, where the method itself has brought the bodies, says what the error is.
 */
final class Bootstrap {
    private static final int MOST_SWEEPS = 5;

    private static final int LEAST_NODES = 2;

    /** By number of nodes between the ends, less the least one. */
    private static final Bootstrap[] TABLES = new Bootstrap[6];

    static {
        for (int k = 0; k < TABLES.length; k++) {
            TABLES[k] = new Bootstrap(LEAST_NODES + k);
        }
    }

    private final int nodes;
    private final int terms;

    /** With the ends. */
    private final double[] node;

    /** Coefficients of positions and velocities, by term and node. */
    private final double[][] byX;

    private final double[][] byV;

    private Bootstrap(int inner) {
        nodes = inner + 2;
        terms = inner + 3;
        node = new double[nodes];
        for (int i = 0; i < nodes; i++) {
            node[i] = 0.5 - 0.5 * Trig.cos(Math.PI * i / (nodes - 1));
        }
        node[nodes - 1] = 1;
        byX = new double[terms][nodes];
        byV = new double[terms][nodes];
        for (int i = 0; i < nodes; i++) {
            double[] once = integral(lagrange(i));
            nested(once, byV, i);
            nested(integral(once), byX, i);
        }
    }

    /** The polynomial that is 1 at a node and 0 at the others, by powers. */
    private double[] lagrange(int i) {
        double[] p = new double[terms + 1];
        p[0] = 1;
        for (int k = 0, degree = 0; k < nodes; k++) {
            if (k == i) {
                continue;
            }
            double factor = 1 / (node[i] - node[k]);
            degree++;
            for (int c = degree; c >= 0; c--) {
                p[c] = factor * ((c > 0 ? p[c - 1] : 0) - node[k] * p[c]);
            }
        }
        return p;
    }

    private static double[] integral(double[] p) {
        double[] sum = new double[p.length];
        for (int c = 1; c < p.length; c++) {
            sum[c] = p[c - 1] / c;
        }
        return sum;
    }

    /** The coefficients of {@link DenseOutput} of a polynomial that is 0 at 0. */
    private void nested(double[] powers, double[][] to, int column) {
        double[] q = new double[terms];
        System.arraycopy(powers, 1, q, 0, terms);
        for (int k = 0; k < terms; k++) {
            boolean isAtEnd = (k & 1) == 0;
            double value = q[0];
            for (int c = 1; isAtEnd && c < terms; c++) {
                value += q[c];
            }
            to[k][column] = value;
            q[0] -= value;
            double carry = 0;
            for (int c = 0; isAtEnd && c < terms; c++) { // over 1 − θ
                carry += q[c];
                q[c] = carry;
            }
            for (int c = 0; !isAtEnd && c < terms; c++) { // over θ
                q[c] = c + 1 < terms ? q[c + 1] : 0;
            }
        }
    }

    /**
     * Makes the output of a step whose end the state vectors hold.
     *
     * @param t time of its start
     * @param h its length
     * @param s its workspace
     * @param out takes the output
     * @param inner nodes between its ends, 2 … 7
     * @param most the error that it may have, in units of what is allowed
     * @return false if it has more
     */
    static boolean make(double t, double h, Stages s, DenseOutput out, int inner, double most) {
        return TABLES[inner - LEAST_NODES].fill(t, h, s, out, most);
    }

    private boolean fill(double t, double h, Stages s, DenseOutput out, double most) {
        s.ensureMore(nodes);
        out.begin(s, h, terms);
        s.coordinates.accelerate(s.endX, s.endV, t + h, s.a);
        take(s, nodes - 1);
        for (int m = 0; m < s.size; m++) {
            s.more[nodes * m] = s.a0[m];
            out.quintic(m, s.endX[m], s.endV[m], s.a0[m], s.more[nodes * m + nodes - 1]);
        }
        double error = Double.POSITIVE_INFINITY;
        double last = Double.POSITIVE_INFINITY;
        for (int sweep = 0; error > most && sweep < MOST_SWEEPS; sweep++) {
            for (int i = 1; i < nodes - 1; i++) {
                out.at(node[i], s.x, s.v);
                s.coordinates.accelerate(s.x, s.v, t + node[i] * h, s.a);
                take(s, i);
            }
            error = sweep(s, h, out);
            if (!(error < 0.9 * last)) {
                break;
            }
            last = error;
        }
        s.putEnd();
        return error <= most;
    }

    /** Makes the coefficients of the accelerations; returns by how much they change places, or miss the end, at most. */
    private double sweep(Stages s, double h, DenseOutput out) {
        for (int m = 0; m < s.size; m++) {
            int o = terms * m;
            double middleX = out.value(out.x, o, 0.5);
            double middleV = out.value(out.v, o, 0.5);
            for (int k = 0; k < terms; k++) {
                double sumX = 0;
                double sumV = 0;
                for (int i = 0; i < nodes; i++) {
                    sumX += byX[k][i] * s.more[nodes * m + i];
                    sumV += byV[k][i] * s.more[nodes * m + i];
                }
                out.x[o + k] = h * h * sumX;
                out.v[o + k] = h * sumV;
            }
            out.x[o] += h * s.v0[m];
            double missX = s.endX[m] - s.x0[m] - out.x[o];
            double missV = s.endV[m] - s.v0[m] - out.v[o];
            out.bend(o, missX, missV);
            s.offX[m] = missX;
            s.offV[m] = missV;
            s.x[m] = out.value(out.x, o, 0.5) - middleX;
            s.v[m] = out.value(out.v, o, 0.5) - middleV;
        }
        double time = Math.min(s.time, h);
        return Math.max(s.norm(s.offX, s.offV, time), s.norm(s.x, s.v, time));
    }

    private void take(Stages s, int at) {
        for (int m = 0; m < s.size; m++) {
            s.more[nodes * m + at] = s.a[m];
        }
    }
}
