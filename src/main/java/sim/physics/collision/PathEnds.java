// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;

/** When the paths of bodies end before the step does; empty while none does and no integrator drives a body. */
final class PathEnds implements Serializable {
    private static final long serialVersionUID = 1L;

    /** When a body's path ends in the present step, or NaN. */
    private double[] ends = {};

    /** Until when a driven body's path holds. */
    private double[] holdsUntil = {};

    PathEnds() {
        // a scene of free bodies pays nothing
    }

    /** When a body's path is to end in the present step, NaN if it is not. */
    double end(int body) {
        return body < ends.length ? ends[body] : Double.NaN;
    }

    void plan(int body, double tau) {
        if (body >= ends.length) {
            int old = ends.length;
            ends = Arrays.copyOf(ends, Math.max(2 * old, body + 1));
            Arrays.fill(ends, old, ends.length, Double.NaN);
        }
        ends[body] = tau;
    }

    void forget(int body) {
        if (body < ends.length) {
            ends[body] = Double.NaN;
        }
    }

    /** Until when a driven body's path holds; for ever if nobody has said. */
    double holdsUntil(int body) {
        return body < holdsUntil.length ? holdsUntil[body] : Double.POSITIVE_INFINITY;
    }

    void setHoldsUntil(int body, double tau) {
        if (body >= holdsUntil.length) {
            int old = holdsUntil.length;
            holdsUntil = Arrays.copyOf(holdsUntil, Math.max(2 * old, body + 1));
            Arrays.fill(holdsUntil, old, holdsUntil.length, Double.POSITIVE_INFINITY);
        }
        holdsUntil[body] = tau;
    }

    /** The same for bodies in ascending order. */
    void setHoldsUntil(IntList bodies, double tau) {
        if (bodies.isRow()) {
            setHoldsUntil(bodies.values[bodies.size - 1], tau); // makes room for all
            Arrays.fill(holdsUntil, bodies.values[0], bodies.values[bodies.size - 1], tau);
            return;
        }
        for (int k = 0; k < bodies.size; k++) {
            setHoldsUntil(bodies.values[k], tau);
        }
    }

    /** Forgets all of a body. */
    void clear(int body) {
        forget(body);
        if (body < holdsUntil.length) {
            holdsUntil[body] = Double.POSITIVE_INFINITY;
        }
    }
}
