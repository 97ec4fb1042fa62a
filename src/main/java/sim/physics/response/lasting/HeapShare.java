// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.DenseFactor;

/**
 * Shares a load among more points than bodies need, as a plate on many rollers. Which of them bear it is not determined then, and
 * next to nothing decides; but one that bears nothing has no friction to roll or hold with. So all are taken for a little soft in
 * the same way, by far less than a gap that matters, which leaves one solution: each point is open or closed, and each closed one
 * sticks or slides, until none contradicts what it is.
 */
final class HeapShare implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Points of heaps in which loads are shared. */
    static final int MOST = 20;

    /** Points that may change between open and closed, stuck and sliding, before the search is given up. */
    private static final int TRIES = 60;

    /** How much faster soft points give way under the load than errors of velocities are that do not matter. */
    private static final double SOFT = 1000;

    /** The same at most, relative to what rows give way by themselves. */
    private static final double SOFTEST = 1e-3;

    /** What is no violation, relative to the load. */
    private static final double NONE = 1e-9;

    /** Times that the equations are solved: what points give way for is taken back where it decides nothing. */
    private static final int TURNS = 3;

    private static final int OPEN = 0;
    private static final int CLOSED = 1;
    private static final int SLIDES = 2;

    /** By rows: points' normals, and behind them their tangents. What each does to all, row after row. */
    private double[] replies = {};

    /** Velocities without impulses, less what they are to be; square roots of mobilities; impulses in their units. */
    private double[] lack = {};
    private double[] scale = {};
    private double[] impulse = {};

    /** What a row is; and of a sliding one the sign of its friction. */
    private int[] is = {};
    private double[] sign = {};

    /** The equations: unknown rows, matrix and right side; rows of the matrix that change places. */
    private int[] unknown = {};
    private int[] exchanged = {};
    private double[] matrix = {};
    private double[] right = {};
    private double softness;
    private double load;

    HeapShare() {
        // grows with the heaps
    }

    /** Whether there are as many rows as freedoms, so that loads are to be shared. */
    private static boolean isFor(HeapSystem s) {
        return !s.isTied() && s.size() == s.contacts() && s.contacts() <= MOST && 2 * s.contacts() >= 3 * s.bodyCount();
    }

    /** Solves a system, whose velocities are those without impulses; false if there is nothing to share or nothing found, and nothing changed. */
    boolean solve(HeapSystem s) {
        if (!isFor(s)) {
            return false;
        }
        assemble(s);
        if (!(load > 0)) {
            return false;
        }
        softness = Math.min(SOFTEST, SOFT * s.tolerance().enough() / load);
        for (int k = 0; k < TRIES; k++) {
            if (!eliminate(s)) {
                return false;
            }
            if (!changesOne(s)) {
                give(s);
                return true;
            }
        }
        return false;
    }

    private void assemble(HeapSystem s) {
        int n = 2 * s.contacts();
        if (lack.length < n) {
            replies = new double[4 * n * n];
            matrix = new double[4 * n * n];
            right = new double[2 * n];
            exchanged = new int[2 * n];
            lack = new double[2 * n];
            scale = new double[2 * n];
            impulse = new double[2 * n];
            sign = new double[2 * n];
            is = new int[2 * n];
            unknown = new int[2 * n];
        }
        load = 0;
        for (int i = 0; i < n; i++) {
            int p = i / 2;
            boolean along = i % 2 == 1;
            scale[i] = Math.sqrt(along ? s.tangentMobility(p) : s.normalMobility(p));
            lack[i] = (along ? s.tangent(p) : s.normal(p) - s.bound(p)) / scale[i];
            load = along ? load : Math.max(load, -lack[i] * scale[i]);
            is[i] = s.normalImpulse(p) > 0 || s.bound(p) >= 0 ? CLOSED : OPEN;
            is[i] = along && s.friction(p) == 0 ? OPEN : is[i];
        }
        double[] v = s.scratch();
        for (int i = 0; i < n; i++) {
            boolean along = i % 2 == 1;
            Arrays.fill(v, 0, 3 * s.bodyCount(), 0);
            s.push(i / 2, along ? 0 : 1, along ? 1 : 0, v);
            for (int j = 0; j < n; j++) {
                double reply = j % 2 == 1 ? s.tangent(j / 2, v) : s.normal(j / 2, v);
                replies[i * n + j] = reply / (scale[i] * scale[j]);
            }
        }
    }

    /** Finds the impulses of rows that are closed, by elimination; false if some of their equations contradict one another. */
    private boolean eliminate(HeapSystem s) {
        int n = 2 * s.contacts();
        int count = 0;
        for (int i = 0; i < n; i++) {
            impulse[i] = 0;
            if (is[i] == CLOSED) {
                unknown[count++] = i;
            }
        }
        for (int a = 0; a < count; a++) {
            for (int b = 0; b < count; b++) {
                matrix[a * count + b] = reply(s, unknown[b], unknown[a], n);
            }
            matrix[a * count + a] += softness;
        }
        if (!DenseFactor.factor(matrix, count, exchanged)) {
            return false;
        }
        for (int turn = 0; turn < TURNS; turn++) {
            for (int a = 0; a < count; a++) {
                double sum = -lack[unknown[a]];
                for (int b = 0; b < count; b++) {
                    sum -= impulse[unknown[b]] * reply(s, unknown[b], unknown[a], n);
                }
                right[a] = sum;
            }
            DenseFactor.solve(matrix, count, exchanged, right);
            for (int a = 0; a < count; a++) {
                impulse[unknown[a]] += right[a];
            }
        }
        for (int i = 1; i < n; i += 2) {
            impulse[i] = is[i] == SLIDES ? impulse[i - 1] * slide(s, i) : impulse[i];
        }
        return true;
    }

    /** What a unit at a row, with the friction of its point if that slides, does at another one. */
    private double reply(HeapSystem s, int of, int at, int n) {
        double sum = replies[of * n + at];
        return of % 2 == 0 && is[of + 1] == SLIDES ? sum + slide(s, of + 1) * replies[(of + 1) * n + at] : sum;
    }

    /** A sliding tangent's impulse for a unit along its normal. */
    private double slide(HeapSystem s, int tangent) {
        return sign[tangent] * s.friction(tangent / 2) * scale[tangent] / scale[tangent - 1];
    }

    /** Changes the row that contradicts most what it is; false if none does. */
    private boolean changesOne(HeapSystem s) {
        int n = 2 * s.contacts();
        int worst = -1;
        double most = NONE * load;
        for (int i = 0; i < n; i++) {
            double wrong = wrong(s, i, n);
            worst = wrong > most ? i : worst;
            most = Math.max(most, wrong);
        }
        if (worst < 0) {
            return false;
        }
        boolean along = worst % 2 == 1;
        if (along) {
            sign[worst] = Math.signum(impulse[worst]);
            is[worst] = is[worst] == CLOSED ? SLIDES : CLOSED;
        } else {
            is[worst] = is[worst] == CLOSED ? OPEN : CLOSED;
            is[worst + 1] = is[worst] == CLOSED && s.friction(worst / 2) > 0 ? CLOSED : OPEN;
        }
        return true;
    }

    /** By what speed a row contradicts what it is. */
    private double wrong(HeapSystem s, int i, int n) {
        boolean along = i % 2 == 1;
        if (is[i] == CLOSED) {
            double pressed = along ? s.friction(i / 2) * impulse[i - 1] * scale[i] / scale[i - 1] - Math.abs(impulse[i]) : impulse[i];
            return -pressed * scale[i];
        }
        if (along && is[i] == OPEN) {
            return 0;
        }
        double velocity = lack[i];
        for (int j = 0; j < n; j++) {
            velocity += impulse[j] * replies[j * n + i];
        }
        return along ? sign[i] * velocity * scale[i] : -velocity * scale[i];
    }

    private void give(HeapSystem s) {
        for (int p = 0; p < s.contacts(); p++) {
            double jn = impulse[2 * p] / scale[2 * p];
            double jt = impulse[2 * p + 1] / scale[2 * p + 1];
            s.start(p, jn, jt);
            s.apply(p, jn, jt);
        }
    }
}
