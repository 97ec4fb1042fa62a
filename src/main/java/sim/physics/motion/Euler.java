// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.internal.IntList;

/**
 * Euler's explicit method, (11) and (12), in the form of (14) and (15). Positions are advanced with the <i>old</i> velocities,
 * then velocities with the old forces. The method is of first order and gains energy, as the write-up's Figure 3 shows. It is not
 * the semi-implicit method that game engines call Euler's.
 */
public final class Euler implements Integrator {
    private static final long serialVersionUID = 1L;

    /** Creates the method. */
    public Euler() {
        // no state
    }

    @Override
    public double advance(EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path) {
        path.ensure(State.BLOCK * state.size());
        double[] x = state.x();
        double[] v = state.v();
        double[] a = path.stage;
        equations.acceleration(bodies, t, a);
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int end = b + State.BLOCK; b < end; b++) {
                x[b] += h * v[b]; // (12), (14)
                v[b] += h * a[b]; // (11), (15)
                path.straight(b);
                path.first[b] = 0;
            }
        }
        path.knowsFirst = true;
        return h;
    }

    @Override
    public boolean isConcurrent() {
        return true;
    }

    @Override
    public int order() {
        return 1;
    }

    @Override
    public String toString() {
        return "Euler";
    }
}
