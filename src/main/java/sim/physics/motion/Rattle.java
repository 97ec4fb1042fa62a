// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.internal.IntList;

/**
 * The symplectic and time-reversible method RATTLE (Andersen 1983), and its symmetric compositions of orders 4 and 6. Use it for
 * very long runs under forces that depend on positions alone, such as gravity and springs without damping. The energy swings by
 * an error of the method's order, but does not drift away, however long the run is, because sums carry their rounding errors
 * along ({@link Carry}). It goes back the way it came while its steps are whole. Under forces that depend on velocities it is of
 * first order, whichever order was asked for.
 *
 * <pre>
 *   v½ = v0 + h/2 (a(x0) + W J(x0)ᵀ λ)     with λ so that C(x1) = 0
 *   x1 = x0 + h v½
 *   v1 = v½ + h/2 (a(x1) + W J(x1)ᵀ μ)     with μ so that J(x1) v1 = 0
 * </pre>
 *
 * <p>Compositions make such steps with lengths γₖ h: the five of order 4 by Suzuki (1990), and the nine of order 6 by Kahan and
 * Li (1997). For both, see Hairer, Lubich and Wanner, <i>Geometric Numerical Integration</i>, V.3.
 */
public final class Rattle implements Integrator {
    private static final long serialVersionUID = 1L;

    private static final double[] ORDER_2 = {1};

    private static final double[] ORDER_4 = {
        0.41449077179437573714, 0.41449077179437573714, -0.65796308717750294857,
        0.41449077179437573714, 0.41449077179437573714
    };

    private static final double[] ORDER_6 = {
        0.39216144400731413928, 0.33259913678935943860, -0.70624617255763935981,
        0.08221359629355080023, 0.79854399093482996340, 0.08221359629355080023,
        -0.70624617255763935981, 0.33259913678935943860, 0.39216144400731413928
    };

    private final int order;

    /**
     * Creates the method.
     *
     * @param order order of the method: 2, 4 or 6
     * @throws IllegalArgumentException if the order is another number
     */
    public Rattle(int order) {
        if (order != 2 && order != 4 && order != 6) {
            throw new IllegalArgumentException("order is " + order + ": it must be 2, 4 or 6");
        }
        this.order = order;
    }

    private double[] parts() {
        return order == 2 ? ORDER_2 : order == 4 ? ORDER_4 : ORDER_6;
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

    private void go(EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path, Carry carry) {
        equations.acceleration(bodies, t, path.stage);
        double time = t;
        for (double part : parts()) {
            double length = part * h;
            equations.hold(bodies);
            kick(state, bodies, path, 0.5 * length, carry);
            drift(state, bodies, length, carry);
            equations.close(bodies, length);
            time += length;
            equations.acceleration(bodies, time, path.stage);
            kick(state, bodies, path, 0.5 * length, carry);
            equations.settle(bodies);
        }
    }

    private static void kick(State state, IntList bodies, Path path, double time, Carry carry) {
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int end = b + State.BLOCK; b < end; b++) {
                carry.addV(state.v(), b, time * path.stage[b]);
            }
        }
    }

    private static void drift(State state, IntList bodies, double time, Carry carry) {
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int end = b + State.BLOCK; b < end; b++) {
                carry.addX(state.x(), b, carry.way(state.v(), b, time));
            }
        }
    }

    @Override
    public boolean isConcurrent() {
        return true;
    }

    @Override
    public int order() {
        return order;
    }

    @Override
    public String toString() {
        return "Rattle(" + order + ")";
    }
}
