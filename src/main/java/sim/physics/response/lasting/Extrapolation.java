// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import sim.physics.internal.IntList;

/**
 * Where an iteration that maps velocities to velocities goes, by its last results: Anderson's mixing (1965, <i>Iterative
 * procedures for nonlinear integral equations</i>), of the results whose combination has changed least, by its kinetic energy.
 * The map changes little from one step to the next, so differences of the last step help in this one from the start.
 */
final class Extrapolation implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Differences of results that are made use of. */
    private static final int MOST = 4;

    /** Part of a difference, of its energy, that must be left without those after it. */
    private static final double LEFT = 1e-4;

    /** Energy of a difference that is rounding, relative to that of the velocities. */
    private static final double NOISE = 1e-22;

    /** How much longer or shorter the time may be for which the map was another one. */
    private static final double LIKE = 1.5;

    /** What was put into the map last, what came out of it and by how much that is different. */
    private double[] put = {};

    private double[] result = {};
    private double[] change = {};
    private int count;

    /** Whether it is known what was put into the map first. */
    private boolean isKnown;

    /** Differences of results and of their changes; how many there are, and the place of the newest. */
    private final double[][] results = new double[MOST][];

    private final double[][] changes = new double[MOST][];
    private int size;
    private int newest;

    /** The same, each orthogonal to those that are newer; energies of the changes. */
    private final double[][] ownResults = new double[MOST][];

    private final double[][] ownChanges = new double[MOST][];
    private final double[] energy = new double[MOST];

    /** Of which bodies these are, and for what time. */
    private final IntList bodies = new IntList();

    private double time;

    Extrapolation() {
        // grows with the heap
    }

    /** Begins with a map of the velocities of some bodies to those after a time. */
    void begin(IntList heap, double length) {
        boolean isSame = heap.size == bodies.size && length < LIKE * time && time < LIKE * length;
        for (int k = 0; isSame && k < heap.size; k++) {
            isSame = heap.values[k] == bodies.values[k];
        }
        time = length;
        count = 0;
        isKnown = false;
        if (isSame) {
            return;
        }
        size = 0;
        bodies.clear();
        for (int k = 0; k < heap.size; k++) {
            bodies.add(heap.values[k]);
        }
        int n = 3 * heap.size;
        if (put.length != n) {
            put = new double[n];
            result = new double[n];
            change = new double[n];
            for (int k = 0; k < MOST; k++) {
                results[k] = new double[n];
                changes[k] = new double[n];
                ownResults[k] = new double[n];
                ownChanges[k] = new double[n];
            }
        }
    }

    /**
     * Replaces a result by what to put into the map next.
     *
     * @param w inverse masses and moments of inertia, 2 per body
     * @param v the result of the map, of what the last call made of the one before
     */
    void next(double[] w, double[] v) {
        int n = put.length;
        if (count > 1 || isKnown) {
            note(w, v);
        }
        for (int k = 0; k < n; k++) {
            result[k] = v[k];
            change[k] = v[k] - put[k];
        }
        if (count > 0) {
            mix(w, v);
        }
        System.arraycopy(v, 0, put, 0, n);
        count++;
    }

    /** Whether differences of before are known. */
    boolean isLearned() {
        return size > 0;
    }

    /**
     * Tells what was put into the map for its first result, and replaces what is to be put next.
     *
     * @param w inverse masses and moments of inertia, 2 per body
     * @param v what was put; what to put next afterwards
     */
    void learn(double[] w, double[] v) {
        for (int k = 0; k < put.length; k++) {
            change[k] = result[k] - v[k];
            v[k] = result[k];
        }
        mix(w, v);
        System.arraycopy(v, 0, put, 0, put.length);
        isKnown = true;
    }

    /** Goes back to the first result itself. */
    void unlearn(double[] v) {
        System.arraycopy(result, 0, v, 0, put.length);
        System.arraycopy(result, 0, put, 0, put.length);
    }

    /** Keeps the difference to the last result in place of the oldest, unless it is one by rounding. */
    private void note(double[] w, double[] v) {
        int at = size == 0 ? 0 : (newest + 1) % MOST;
        for (int k = 0; k < put.length; k++) {
            results[at][k] = v[k] - result[k];
            changes[at][k] = v[k] - put[k] - change[k];
        }
        boolean isNoise = product(w, changes[at], changes[at]) <= NOISE * product(w, v, v);
        size = isNoise ? Math.min(size, MOST - 1) : Math.min(size + 1, MOST);
        newest = isNoise ? newest : at;
    }

    /** Goes to where the change would be least if the map were linear. */
    private void mix(double[] w, double[] v) {
        int n = put.length;
        for (int m = 0; m < size; m++) {
            int at = (newest - m + MOST) % MOST;
            double[] r = ownResults[m];
            double[] c = ownChanges[m];
            System.arraycopy(results[at], 0, r, 0, n);
            System.arraycopy(changes[at], 0, c, 0, n);
            double before = product(w, c, c);
            for (int i = 0; i < m; i++) {
                add(c, r, energy[i] > 0 ? -product(w, c, ownChanges[i]) / energy[i] : 0, i);
            }
            double left = product(w, c, c);
            energy[m] = left > LEFT * before ? left : 0;
            double share = energy[m] > 0 ? product(w, change, c) / energy[m] : 0;
            for (int k = 0; k < n; k++) {
                v[k] -= share * r[k];
            }
        }
    }

    private void add(double[] c, double[] r, double share, int i) {
        for (int k = 0; share != 0 && k < c.length; k++) {
            c[k] += share * ownChanges[i][k];
            r[k] += share * ownResults[i][k];
        }
    }

    /** Twice the kinetic energy that two velocities have with one another. */
    private static double product(double[] w, double[] a, double[] b) {
        double sum = 0;
        for (int k = 0, m = 0; k < a.length; k += 3, m += 2) {
            sum += (a[k] * b[k] + a[k + 1] * b[k + 1]) / w[m] + a[k + 2] * b[k + 2] / w[m + 1];
        }
        return sum;
    }
}
