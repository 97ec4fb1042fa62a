// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import sim.physics.collision.broad.Pairs;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;

/** In how many of the pairs that touch at one instant a body has part. */
final class Meetings implements Serializable {
    private static final long serialVersionUID = 1L;

    /** By body, from {@link #count} on as far as bodies meet. */
    private transient int[] counts;

    void count(IntList touching, Pairs pairs, int bodies) {
        if (counts == null || counts.length < bodies) {
            counts = new int[counts == null ? bodies : Growth.length(counts.length, bodies)];
        }
        for (int k = 0; k < touching.size; k++) {
            counts[pairs.first(touching.values[k])] = 0;
            counts[pairs.second(touching.values[k])] = 0;
        }
        for (int k = 0; k < touching.size; k++) {
            counts[pairs.first(touching.values[k])]++;
            counts[pairs.second(touching.values[k])]++;
        }
    }

    /** Whether a body has part in no more than one of the pairs that were counted. */
    boolean isOnly(int body) {
        return counts[body] < 2;
    }
}
