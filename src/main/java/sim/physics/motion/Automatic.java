// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.internal.IntList;

/**
 * Chooses the method as well as the step: {@link DormandPrince853}, and {@link RadauIIA} for as long as a group of bodies is
 * stiff. Use it when you do not know which method to take.
 */
public final class Automatic extends AdaptiveIntegrator {
    private static final long serialVersionUID = 1L;

    private final DormandPrince853 explicit;
    private final RadauIIA implicit;

    /**
     * Creates the method.
     *
     * @param tolerance error of a position that one step may make, length
     * @throws IllegalArgumentException if the tolerance is not a finite number greater than 0
     */
    public Automatic(double tolerance) {
        super(tolerance);
        explicit = new DormandPrince853(tolerance);
        implicit = new RadauIIA(tolerance);
    }

    @Override
    boolean takesTiedCoordinates(IntList bodies, Path path) {
        return path.stiffness == null || !path.stiffness.isStiff(bodies);
    }

    @Override
    double reach(IntList bodies, Path path) {
        return path.stiffness != null && path.stiffness.isStiff(bodies) && !path.stages.isTied()
                ? Double.POSITIVE_INFINITY
                : explicit.reach(bodies, path);
    }

    @Override
    double shareOfStop() {
        return explicit.shareOfStop();
    }

    @Override
    boolean makeDense(
            EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path, DenseOutput out) {
        return path.stages.maker.makeDense(equations, state, bodies, t, h, path, out);
    }

    @Override
    boolean attempt(EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path) {
        if (path.stiffness == null) {
            path.stiffness = new Stiffness(path);
        }
        Stiffness stiffness = path.stiffness;
        if (!stiffness.isStiff(bodies) && !path.stages.isRetry) {
            stiffness.look(bodies, path.stages);
        }
        boolean mayBeImplicit = !path.stages.isTied(); // from the next step on, if it has just been found stiff
        if (mayBeImplicit && stiffness.isStiff(bodies)) {
            boolean done = implicit.attempt(equations, state, bodies, t, h, path);
            if (done) {
                stiffness.look(bodies, path.stages.implicit(bodies).stiffness(h));
            }
            return done;
        }
        boolean done = explicit.attempt(equations, state, bodies, t, h, path);
        if (done) {
            stiffness.stepped(bodies, h);
        }
        return done;
    }

    @Override
    public int order() {
        return explicit.order();
    }

    @Override
    public String toString() {
        return "Automatic(" + getTolerance() + ")";
    }
}
