// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import java.util.Arrays;
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.PlaceLog;
import sim.physics.motion.State;

/** The bodies that are there and the circles around them, and what of it has changed since the last question. */
final class Census {
    final State state;

    /** By block; null where there is none. */
    Body[] bodies = {};

    /** Of the circles around the bodies, with a margin for rounding; negative where there is no body. */
    double[] radii = {};

    /** Number of blocks. */
    int size;

    private PlaceLog log;
    private long read;
    private long sweeps;

    Census(State state) {
        this.state = state;
    }

    /**
     * Comes up to date.
     *
     * @param placed takes the blocks that were written since the last call
     * @return false if any block may have been
     */
    boolean follow(IntList placed) {
        boolean anew = log == null;
        if (anew) {
            log = state.placeLog();
        } else if (log.count() == read && log.sweeps() == sweeps) {
            return true;
        }
        size = state.size();
        if (anew || log.count() - read > PlaceLog.LENGTH) {
            ensure();
            for (int i = 0; i < size; i++) {
                learn(i);
            }
            anew = true;
        } else {
            for (long k = read; k < log.count(); k++) {
                ensure();
                learn(log.block(k));
                placed.add(log.block(k));
            }
        }
        anew |= log.sweeps() != sweeps;
        read = log.count();
        sweeps = log.sweeps();
        return !anew;
    }

    private void ensure() {
        if (bodies.length < size) {
            bodies = Arrays.copyOf(bodies, size + size / 2);
            radii = Arrays.copyOf(radii, size + size / 2);
        }
    }

    private void learn(int i) {
        bodies[i] = state.body(i);
        radii[i] = bodies[i] == null ? -1 : bodies[i].getShape().boundingRadius() * (1 + 1e-12);
    }
}
