// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import sim.physics.motion.Loads;
import sim.physics.motion.State;
import sim.physics.motion.TiedCoordinates;

/** The quick ways that islands have: trees and chains of pins, and skeletons that are such trees. */
final class QuickStep {
    /**
     * Ratio of masses up to which a tree moves in its angles. Its elimination loses digits of light links that carry heavy ones, and these only, by
     * as much as an angle's last digit does by itself: at this ratio seven of sixteen are left of what these have across.
     */
    private static final double MOST_SPREAD = 1e9;

    private QuickStep() {}

    /** Lets an island, which may be null, fly in a uniform field, if it is one rigid body; false if it is not. */
    static boolean fly(Island one, State state, ConstraintSolver solver, double gx, double gy, double h, double[] a) {
        return one != null && one.rigid != null && solver.isDirect() && one.rigid.advance(state, gx, gy, h, a);
    }

    /** A step of RK4 in a uniform field; false if an island, which may be null, has no quick way. */
    static boolean advance(Island one, State state, ConstraintSolver solver, double gx, double gy, double h) {
        if (one == null) {
            return false;
        }
        if (one.skeleton != null) {
            return one.skeleton.advance(solver, gx, gy, h);
        }
        if (one.switches.servos != null) {
            return one.switches.servos.advance(state, solver, gx, gy, h);
        }
        return one.tree != null
                ? isFit(one, state, solver) && one.tree.advance(state, gx, gy, h)
                : one.chain != null && one.chain.advance(state, solver, gx, gy, h);
    }

    /** The same under any loads; chains only under such as are even over the step. */
    static boolean advance(
            Island one, State state, ConstraintSolver solver, Loads loads, boolean areEven, double[] a, double t, double h) {
        if (one == null) {
            return false;
        }
        if (one.skeleton != null) {
            return one.skeleton.advance(solver, loads, a, t, h);
        }
        if (one.switches.servos != null) {
            return one.switches.servos.advance(state, solver, loads, a, t, h);
        }
        return one.tree != null
                ? advanceTree(one, state, solver, loads, a, t, h)
                : areEven && one.chain != null && one.chain.advance(state, solver, loads, a, t, h);
    }

    /** The same of an island that is a tree. */
    static boolean advanceTree(Island one, State state, ConstraintSolver solver, Loads loads, double[] a, double t, double h) {
        boolean isFit = solver.isDirect() && one.tree.isHub(state) || isFit(one, state, solver);
        return isFit && one.tree.advance(state, loads, a, t, h);
    }

    /** Whether an island that is a tree moves in its angles. */
    private static boolean isFit(Island one, State state, ConstraintSolver solver) {
        return solver.isDirect() && one.spread(state.w().values()) <= MOST_SPREAD;
    }

    /** Coordinates in which nothing ties the bodies, or null. */
    static TiedCoordinates coordinates(Island one, State state, ConstraintSolver solver) {
        boolean isTree = one != null && one.tree != null && one.skeleton == null;
        return isTree ? one.tree.coordinates(state, isFit(one, state, solver)) : null;
    }
}
