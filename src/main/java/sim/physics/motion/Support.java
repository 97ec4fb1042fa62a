// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;

/**
 * What bears bodies at rest: contacts that give them accelerations, and static friction that holds them. Empty until one
 * rests.
 */
final class Support implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Accelerations that contacts at rest give to bodies, 3n. */
    private double[] accelerations = {};

    /** Bodies at rest that static friction holds. */
    private boolean[] held = {};

    /** Bodies that the integrator would drive, but for their contacts. */
    private boolean[] carried = {};

    /** Whether contacts have given accelerations to a driven body in this step. */
    boolean pushesDriven;

    Support() {
        // a scene in which nothing rests pays nothing
    }

    void set(int body, double ax, double ay, double alpha, boolean isDriven) {
        int b = State.BLOCK * body;
        if (b >= accelerations.length) {
            accelerations = Arrays.copyOf(accelerations, Math.max(2 * accelerations.length, b + State.BLOCK));
        }
        accelerations[b] = ax;
        accelerations[b + 1] = ay;
        accelerations[b + 2] = alpha;
        pushesDriven |= isDriven && (ax != 0 || ay != 0 || alpha != 0);
    }

    /** The acceleration that contacts give to a coordinate of a body. */
    double acceleration(int body, int coordinate) {
        int k = State.BLOCK * body + coordinate;
        return k < accelerations.length ? accelerations[k] : 0;
    }

    /** Whether contacts give an acceleration to a driven body. */
    boolean pushes(int body) {
        return pushesDriven
                && (acceleration(body, 0) != 0 || acceleration(body, 1) != 0 || acceleration(body, 2) != 0);
    }

    /** Adds the accelerations that contacts give to driven bodies. */
    void add(IntList bodies, double[] a) {
        if (pushesDriven) {
            bear(bodies, a);
        }
    }

    /** The same for bodies that all rest: they get in each step what they got in the one in which they came to rest. */
    void addTo(Repose repose, IntList bodies, double[] a) {
        if (repose.hasAll(bodies)) {
            bear(bodies, a);
        }
    }

    private void bear(IntList bodies, double[] a) {
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int c = b; c < Math.min(accelerations.length, b + State.BLOCK); c++) {
                a[c] += accelerations[c];
            }
        }
    }

    void hold(int body) {
        if (body >= held.length) {
            held = Arrays.copyOf(held, Math.max(2 * held.length, body + 1));
        }
        held[body] = true;
    }

    boolean holds(int body) {
        return body < held.length && held[body];
    }

    void carry(int body) {
        if (body >= carried.length) {
            carried = Arrays.copyOf(carried, Math.max(2 * carried.length, body + 1));
        }
        carried[body] = true;
    }

    boolean carries(int body) {
        return body < carried.length && carried[body];
    }

    /** Ends a body's rest; false if it did not rest. */
    boolean release(int body) {
        boolean rested = holds(body) || carries(body);
        if (holds(body)) {
            held[body] = false;
        }
        if (carries(body)) {
            carried[body] = false;
        }
        for (int c = State.BLOCK * body; c < Math.min(accelerations.length, State.BLOCK * (body + 1)); c++) {
            rested |= accelerations[c] != 0;
            accelerations[c] = 0;
        }
        return rested;
    }
}
