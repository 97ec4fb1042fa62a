// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;

/** The numbers of the rows of a {@link HeapMatrix}: a normal one for each point that moves, and a tangential one if it rubs. */
final class HeapNumbers implements Serializable {
    private static final long serialVersionUID = 1L;

    /** How nearly a motor acts along the coordinate of a stop: the square of a cosine. */
    private static final double ALONG = 1 - 1e-9;

    /** By point: its normal and its tangential row, or −1. */
    int[] normal = {};

    int[] tangent = {};
    private int rows;

    HeapNumbers() {
        // grows with the heaps
    }

    /** Numbers the rows of a system; returns how many there are. */
    int number(HeapSystem s) {
        if (normal.length < s.size()) {
            normal = new int[2 * s.size()];
            tangent = new int[2 * s.size()];
        }
        rows = 0;
        for (int p = 0; p < s.size(); p++) {
            boolean moves = s.normalMobility(p) < Double.POSITIVE_INFINITY;
            normal[p] = moves ? rows++ : -1;
            boolean rubs = moves && s.friction(p) > 0 && s.tangentMobility(p) < Double.POSITIVE_INFINITY;
            tangent[p] = rubs ? rows++ : -1;
        }
        return rows;
    }

    /** Finds the motors that act along the coordinates of stops. */
    void pair(HeapSystem s, double[] replies, int[] against) {
        Arrays.fill(against, 0, rows, -1);
        for (int p = s.contacts(); p < s.size(); p++) {
            for (int q = s.contacts(); q < s.size() && normal[p] >= 0 && !s.isMotor(p); q++) {
                int i = normal[p];
                int k = s.isMotor(q) ? normal[q] : -1;
                double both = k < 0 ? 0 : replies[i * rows + k];
                against[i] = k >= 0 && both * both > ALONG * replies[i * rows + i] * replies[k * rows + k] ? k : against[i];
            }
        }
    }
}
