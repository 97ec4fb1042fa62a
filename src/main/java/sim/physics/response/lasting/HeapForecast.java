// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;

/**
 * What the points of a heap will bear, by what they have borne: the value of the last solution, or the line through the last two,
 * or the parabola through three, whichever would have told the last one best. Machines that move smoothly change their forces
 * smoothly, and each digit that is known of these beforehand spares a part of an integration.
 */
final class HeapForecast implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Solutions that are kept. */
    private static final int KEPT = 3;

    /** How much longer the time to foretell may be than that between the last two solutions. */
    private static final double FAR = 1.5;

    /** A higher order is to be better by this factor, and the change between solutions more than that part of them. */
    private static final double BETTER = 0.25;

    private static final double NOISE = 1e-10;

    private final IntList points = new IntList();

    /** Forces, two by point, and the middle of the time in which they acted; the last ones first. */
    private final double[][] forces = new double[KEPT][0];

    private final double[] times = new double[KEPT];
    private final double[] weights = new double[KEPT];
    private int known;

    /** Points of the forecast that would have been best for the last solution. */
    private int best = 1;

    HeapForecast() {
        // grows with the heap
    }

    /** Begins with the points of a heap. */
    void begin(IntList those) {
        boolean isSame = those.size == points.size;
        for (int k = 0; isSame && k < those.size; k++) {
            isSame = those.values[k] == points.values[k];
        }
        if (isSame) {
            return;
        }
        known = 0;
        best = 1;
        points.clear();
        for (int k = 0; k < those.size; k++) {
            points.add(those.values[k]);
        }
        for (int k = 0; k < KEPT && forces[k].length < 2 * those.size; k++) {
            forces[k] = new double[4 * those.size];
        }
    }

    /** Starts the points of a system from the forces that are foretold for a time around an instant, if they can be. */
    void start(HeapSystem system, double middle, double time) {
        int n = Math.min(best, known);
        if (n < 2 || !weigh(n, middle)) {
            return;
        }
        for (int p = 0; p < points.size; p++) {
            system.start(p, time * value(n, 2 * p), time * value(n, 2 * p + 1));
        }
    }

    /** Keeps the forces that were found for a time around an instant. */
    void keep(HeapSystem system, double middle, double time) {
        best = known == 0 ? 1 : judge(system, middle, time);
        double[] oldest = forces[KEPT - 1];
        for (int k = KEPT - 1; k > 0; k--) {
            forces[k] = forces[k - 1];
            times[k] = times[k - 1];
        }
        forces[0] = oldest;
        times[0] = middle;
        for (int p = 0; p < points.size; p++) {
            oldest[2 * p] = system.normalImpulse(p) / time;
            oldest[2 * p + 1] = system.tangentImpulse(p) / time;
        }
        known = Math.min(known + 1, KEPT);
    }

    /** The number of solutions from which these forces would have been foretold best. */
    private int judge(HeapSystem system, double middle, double time) {
        double square = 0;
        for (int p = 0; p < points.size; p++) {
            square += energy(system, p, system.normalImpulse(p) / time, system.tangentImpulse(p) / time);
        }
        int found = 1;
        double least = 0;
        for (int n = 1; n <= known && weigh(n, middle); n++) {
            double error = 0;
            for (int p = 0; p < points.size; p++) {
                double normal = system.normalImpulse(p) / time - value(n, 2 * p);
                error += energy(system, p, normal, system.tangentImpulse(p) / time - value(n, 2 * p + 1));
            }
            if (n == 1 && error <= NOISE * NOISE * square) {
                return 1;
            }
            if (n == 1 || error < BETTER * BETTER * least) {
                found = n;
                least = error;
            }
        }
        return Math.min(found + (found == known ? 1 : 0), KEPT); // what was not tried yet is worth a try
    }

    /** What forces give in energy, nearly; where nothing moves there is none. */
    private static double energy(HeapSystem system, int p, double normal, double tangential) {
        double alongNormal = normal == 0 ? 0 : normal * normal * system.normalMobility(p);
        return alongNormal + (tangential == 0 ? 0 : tangential * tangential * system.tangentMobility(p));
    }

    /** Finds the weights of the polynomial through the last solutions at an instant; false if it is too far from these. */
    private boolean weigh(int n, double at) {
        boolean isNear = true;
        for (int k = 0; k < n; k++) {
            double later = k == 0 ? at : times[k - 1];
            isNear &= k == 0 || later - times[k] > 0;
            isNear &= k + 1 >= n || later - times[k] <= FAR * (times[k] - times[k + 1]);
        }
        Arrays.fill(weights, 1);
        for (int k = 0; k < n; k++) {
            for (int m = 0; m < n; m++) {
                weights[k] *= m == k ? 1 : (at - times[m]) / (times[k] - times[m]);
            }
        }
        return isNear;
    }

    private double value(int n, int at) {
        double sum = 0;
        for (int k = 0; k < n; k++) {
            sum += weights[k] * forces[k][at];
        }
        return sum;
    }
}
