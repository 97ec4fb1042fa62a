// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.internal.IntList;

/**
 * Euler's symplectic method: velocities are advanced first, and then positions with the <i>new</i> velocities.
 *
 * <pre>
 *   v1 = v0 + h (a(x0, v0) + W J(x0)ᵀ λ)     with λ so that C(x1) = 0
 *   x1 = x0 + h v1
 * </pre>
 *
 * <p>Like {@link Euler}, it is of first order and takes one evaluation of the forces. But if forces depend on positions alone,
 * its energy swings by an error of that order and does not drift away. It is the method of game engines: for many bodies under
 * forces that must be cheap and need not be exact.
 *
 * <p>It is not cheap where bodies lie on one another or joints tie them. Its paths are so far from the motion that steps are
 * divided for contacts, and RK4 takes a half to a sixth of its time. Use time stepping ({@code PhysicsEngine.setTimeStepping})
 * for those.
 *
 * <p>Joints are closed along the directions of the start of the step, which keeps the map symplectic (Hairer, Lubich and Wanner,
 * <i>Geometric Numerical Integration</i>, VII.1). The projection after the step gives the velocities that the joints allow. A
 * step must be shorter than 2/ω for a spring of frequency ω.
 */
public final class SymplecticEuler implements Integrator {
    private static final long serialVersionUID = 1L;

    /** Creates the method. */
    public SymplecticEuler() {
        // no state
    }

    @Override
    public double advance(EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path) {
        path.ensure(State.BLOCK * state.size());
        path.start(state, bodies);
        Carry carry = state.ensureCarry();
        carry.begin(state, bodies);
        try {
            go(equations, state, bodies, t, h, path, carry);
        } finally {
            carry.end(state, bodies);
        }
        path.join(state, bodies, h);
        return h;
    }

    private static void go(
            EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path, Carry carry) {
        double[] x = state.x();
        double[] v = state.v();
        equations.acceleration(bodies, t, path.stage);
        equations.hold(bodies);
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int end = b + State.BLOCK; b < end; b++) {
                carry.addV(v, b, h * path.stage[b]);
                carry.addX(x, b, carry.way(v, b, h));
            }
        }
        equations.close(bodies, h);
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
        return "SymplecticEuler";
    }
}
