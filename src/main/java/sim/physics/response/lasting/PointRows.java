// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.motion.SwitchedRow;

/**
 * The rows of J at the contact points of a cluster, one along the normal and one along the tangent of each: how velocities
 * of bodies move the points on one another, and how impulses at the points move the bodies. Bodies are numbers in the
 * cluster, −1 for what cannot move; velocities are three values for each, inverse masses and moments of inertia two.
 */
final class PointRows implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Values per point: the normal, as it is for either body, levers, arms. */
    private static final int STRIDE = 8;

    private static final int FIRST_X = 0;
    private static final int FIRST_Y = 1;
    private static final int NX = 2;
    private static final int NY = 3;
    private static final int LEVER_A = 4;
    private static final int LEVER_B = 5;
    private static final int ARM_A = 6;
    private static final int ARM_B = 7;

    private double[] data = new double[8 * STRIDE];
    private int[] bodies = new int[16];

    PointRows() {
        // grows with the clusters
    }

    /** Sets a point, which may be the next one. */
    void set(int p, int a, int b, ContactPoint c) {
        set(p, a, b, c.nx, c.ny, c.leverA, c.leverB, c.armA, c.armB);
    }

    /** Sets a row along a normal, and one along the tangent. */
    void set(int p, int a, int b, double nx, double ny, double leverA, double leverB, double armA, double armB) {
        if (bodies.length < 2 * p + 2) {
            bodies = Arrays.copyOf(bodies, 4 * p + 4);
            data = Arrays.copyOf(data, STRIDE * (2 * p + 2));
        }
        bodies[2 * p] = a;
        bodies[2 * p + 1] = b;
        int o = STRIDE * p;
        data[o + FIRST_X] = nx;
        data[o + FIRST_Y] = ny;
        data[o + NX] = nx;
        data[o + NY] = ny;
        data[o + LEVER_A] = leverA;
        data[o + LEVER_B] = leverB;
        data[o + ARM_A] = armA;
        data[o + ARM_B] = armB;
    }

    /** Sets the row of a motor or stop, along directions of whatever length; that along the tangent means nothing. */
    void set(int p, int a, int b, SwitchedRow row, double sign) {
        set(p, a, b, sign * row.nx, sign * row.ny, sign * row.firstLever, sign * row.secondLever, 0, 0);
        data[STRIDE * p + FIRST_X] = sign * row.firstX;
        data[STRIDE * p + FIRST_Y] = sign * row.firstY;
    }

    /** The first body of a point, or with side 1 its second one; −1 for what cannot move. */
    int body(int p, int side) {
        return bodies[2 * p + side];
    }

    double nx(int p) {
        return data[STRIDE * p + NX];
    }

    double ny(int p) {
        return data[STRIDE * p + NY];
    }

    /** What turns a body when an impulse acts along a point's normal. */
    double lever(int p, int side) {
        return data[STRIDE * p + LEVER_A + side];
    }

    /** The same along its tangent. */
    double arm(int p, int side) {
        return data[STRIDE * p + ARM_A + side];
    }

    /** 1 if the rows along the normals of two points are the same, −1 if they are opposite, else 0. */
    double alike(int p, int q) {
        boolean isSame = bodies[2 * p] == bodies[2 * q] && bodies[2 * p + 1] == bodies[2 * q + 1];
        boolean isOpposite = isSame;
        for (int k = FIRST_X; k <= LEVER_B; k++) {
            isSame &= data[STRIDE * p + k] == data[STRIDE * q + k];
            isOpposite &= data[STRIDE * p + k] == -data[STRIDE * q + k];
        }
        return isSame ? 1 : isOpposite ? -1 : 0;
    }

    /** Whether a row is one of turns alone, which is the same wherever its bodies are. */
    boolean isOfTurns(int p) {
        int o = STRIDE * p;
        return data[o + FIRST_X] == 0 && data[o + FIRST_Y] == 0 && data[o + NX] == 0 && data[o + NY] == 0;
    }

    /** Whether one of a point's bodies cannot move. */
    boolean isOnFixed(int p) {
        return bodies[2 * p] < 0 || bodies[2 * p + 1] < 0;
    }

    /** What a unit of impulse along a point's normal does to its velocity along that. */
    double normalMobility(int p, double[] w) {
        int o = STRIDE * p;
        return mobility(p, w, data[o + LEVER_A], data[o + LEVER_B]);
    }

    /** The same for directions of any length. */
    double wholeMobility(int p, double[] w) {
        int o = STRIDE * p;
        int a = bodies[2 * p];
        int b = bodies[2 * p + 1];
        double one = data[o + FIRST_X] * data[o + FIRST_X] + data[o + FIRST_Y] * data[o + FIRST_Y];
        double square = data[o + NX] * data[o + NX] + data[o + NY] * data[o + NY];
        double first = a < 0 ? 0 : one * w[2 * a] + data[o + LEVER_A] * data[o + LEVER_A] * w[2 * a + 1];
        return first + (b < 0 ? 0 : square * w[2 * b] + data[o + LEVER_B] * data[o + LEVER_B] * w[2 * b + 1]);
    }

    /** The same along its tangent. */
    double tangentMobility(int p, double[] w) {
        int o = STRIDE * p;
        return mobility(p, w, data[o + ARM_A], data[o + ARM_B]);
    }

    private double mobility(int p, double[] w, double armA, double armB) {
        int a = bodies[2 * p];
        int b = bodies[2 * p + 1];
        double first = a < 0 ? 0 : w[2 * a] + armA * armA * w[2 * a + 1];
        return first + (b < 0 ? 0 : w[2 * b] + armB * armB * w[2 * b + 1]);
    }

    /** What a unit along the tangent does to the velocity along the normal, and the other way round. */
    double crossMobility(int p, double[] w) {
        int o = STRIDE * p;
        int a = bodies[2 * p];
        int b = bodies[2 * p + 1];
        double first = a < 0 ? 0 : data[o + LEVER_A] * data[o + ARM_A] * w[2 * a + 1];
        return first + (b < 0 ? 0 : data[o + LEVER_B] * data[o + ARM_B] * w[2 * b + 1]);
    }

    /** Whether a point is one of a body's. */
    boolean isOf(int p, int body) {
        return bodies[2 * p] == body || bodies[2 * p + 1] == body;
    }

    /** Normal velocity of a point, positive when it parts. */
    double normal(int p, double[] v) {
        int o = STRIDE * p;
        int a = 3 * bodies[2 * p];
        int b = 3 * bodies[2 * p + 1];
        double sum = 0;
        if (b >= 0) {
            sum += v[b] * data[o + NX] + v[b + 1] * data[o + NY] + v[b + 2] * data[o + LEVER_B];
        }
        if (a >= 0) {
            sum -= v[a] * data[o + FIRST_X] + v[a + 1] * data[o + FIRST_Y] + v[a + 2] * data[o + LEVER_A];
        }
        return sum;
    }

    /** Tangential velocity of a point. */
    double tangent(int p, double[] v) {
        int o = STRIDE * p;
        int a = 3 * bodies[2 * p];
        int b = 3 * bodies[2 * p + 1];
        double nx = data[o + NX];
        double ny = data[o + NY];
        double sum = 0;
        if (b >= 0) {
            sum += v[b + 1] * nx - v[b] * ny + v[b + 2] * data[o + ARM_B];
        }
        if (a >= 0) {
            sum -= v[a + 1] * nx - v[a] * ny + v[a + 2] * data[o + ARM_A];
        }
        return sum;
    }

    /** Adds what a point's impulses do to the velocities of its first body. */
    void pushFirst(int p, double jn, double jt, double[] w, double[] v) {
        int a = bodies[2 * p];
        if (a >= 0) {
            int o = STRIDE * p;
            v[3 * a] -= w[2 * a] * (jn * data[o + FIRST_X] - jt * data[o + FIRST_Y]);
            v[3 * a + 1] -= w[2 * a] * (jn * data[o + FIRST_Y] + jt * data[o + FIRST_X]);
            v[3 * a + 2] -= w[2 * a + 1] * (jn * data[o + LEVER_A] + jt * data[o + ARM_A]);
        }
    }

    /** The same for its second body. */
    void pushSecond(int p, double jn, double jt, double[] w, double[] v) {
        int b = bodies[2 * p + 1];
        if (b >= 0) {
            int o = STRIDE * p;
            v[3 * b] += w[2 * b] * (jn * data[o + NX] - jt * data[o + NY]);
            v[3 * b + 1] += w[2 * b] * (jn * data[o + NY] + jt * data[o + NX]);
            v[3 * b + 2] += w[2 * b + 1] * (jn * data[o + LEVER_B] + jt * data[o + ARM_B]);
        }
    }
}
