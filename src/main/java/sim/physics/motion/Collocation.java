// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;

/**
 * The polynomial through the stages of an implicit method's last step, continued over the next one: from there its
 * iteration starts (Hairer and Wanner, <i>Solving Ordinary Differential Equations II</i>, 2nd edition, IV.8).
 */
final class Collocation implements Serializable {
    private static final long serialVersionUID = 1L;

    /** How much longer than the last step the next one may be for that to be of use. */
    private static final double FAR = 3;

    /** How far from its end a step may start, in tolerances. */
    private static final double NEAR = 1;

    private final double[] node;

    /** One over the products of the differences of the nodes. */
    private final double[] factor;

    private double length;
    private double end;
    private int[] bodies = {};

    /** Where it ended, and stages less the start, 3. */
    private double[] endX = {};

    private double[] endV = {};
    private final double[][] x = new double[3][0];
    private final double[][] v = new double[3][0];

    Collocation() {
        node = new double[] {0, RadauIIA.node(0), RadauIIA.node(1), 1};
        factor = new double[4];
        for (int i = 0; i < 4; i++) {
            factor[i] = 1;
            for (int k = 0; k < 4; k++) {
                factor[i] /= k == i ? 1 : node[i] - node[k];
            }
        }
    }

    /** Keeps a step that was made. */
    void keep(Stages s, IntList group, double t, double h, double[][] stageX, double[][] stageV) {
        if (endX.length < s.size) {
            endX = new double[s.size];
            endV = new double[s.size];
            for (int i = 0; i < 3; i++) {
                x[i] = new double[s.size];
                v[i] = new double[s.size];
            }
        }
        if (bodies.length != group.size) {
            bodies = new int[group.size];
        }
        System.arraycopy(group.values, 0, bodies, 0, group.size);
        length = h;
        end = t + h;
        for (int m = 0; m < s.size; m++) {
            endX[m] = s.x0[m] + stageX[2][m];
            endV[m] = s.v0[m] + stageV[2][m];
        }
        for (int i = 0; i < 3; i++) {
            System.arraycopy(stageX[i], 0, x[i], 0, s.size);
            System.arraycopy(stageV[i], 0, v[i], 0, s.size);
        }
    }

    /** Whether a step of the same bodies goes on from where the last one ended. */
    private boolean continues(Stages s, IntList group, double t, double h) {
        if (!(h / length > 0 && h / length <= FAR) || Math.abs(t - end) > 1e-6 * Math.abs(h)
                || !Arrays.equals(bodies, 0, bodies.length, group.values, 0, group.size)) {
            return false;
        }
        double most = 0;
        for (int m = 0; m < s.size; m++) {
            double off = Math.max(Math.abs(s.x0[m] - endX[m]), Math.abs(h * (s.v0[m] - endV[m])));
            most = Math.max(most, s.weight[m] * off);
        }
        return most <= NEAR;
    }

    /** Sets the stages of a step to where the polynomial comes if the step continues it, else to the start of the step. */
    void predict(Stages s, IntList group, double t, double h, double[][] stageX, double[][] stageV) {
        if (!continues(s, group, t, h)) {
            for (int i = 0; i < 3; i++) {
                Arrays.fill(stageX[i], 0, s.size, 0);
                Arrays.fill(stageV[i], 0, s.size, 0);
            }
            return;
        }
        for (int i = 0; i < 3; i++) {
            double at = 1 + node[i + 1] * h / length;
            double first = weight(1, at);
            double second = weight(2, at);
            double third = weight(3, at) - 1;
            for (int m = 0; m < s.size; m++) {
                stageX[i][m] = first * x[0][m] + second * x[1][m] + third * x[2][m];
                stageV[i][m] = first * v[0][m] + second * v[1][m] + third * v[2][m];
            }
        }
    }

    /** Lagrange's polynomial of a node. */
    private double weight(int i, double at) {
        double product = factor[i];
        for (int k = 0; k < 4; k++) {
            product *= k == i ? 1 : at - node[k];
        }
        return product;
    }
}
