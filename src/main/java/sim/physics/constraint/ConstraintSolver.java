// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
import java.util.List;
import sim.physics.motion.State;

/** Solves J W Jᵀ λ = −J W F − J̇ ẋ, (41), for the constraint forces: {@link DirectSolver} or {@link GlobalSolver}. */
public abstract sealed class ConstraintSolver implements Serializable permits DirectSolver, GlobalSolver {
    private static final long serialVersionUID = 1L;

    ConstraintSolver() {
        // two are there
    }

    /**
     * Prepares for solves at the present J of an island.
     *
     * @param island evaluated
     * @param w the diagonal of W
     */
    abstract void prepare(Island island, double[] w);

    /**
     * Finds λ so that J (u + W Jᵀ λ) + g = 0, and adds W Jᵀ λ to u.
     *
     * @param island prepared
     * @param w the diagonal of W
     * @param u by blocks of the state
     * @param g 2 per node; null: zero
     */
    abstract void correct(Island island, double[] w, double[] u, double[] g);

    /**
     * Takes from changes of places or velocities of some islands, which are evaluated, what their rows do not allow; false if
     * some of these depend on others, so that what they do is not to be relied on.
     */
    final boolean pass(List<Island> islands, double[] w, double[] change) {
        boolean well = true;
        for (int k = 0; k < islands.size(); k++) {
            well &= islands.get(k).redundantRows == 0;
        }
        for (int k = 0; k < islands.size() && well; k++) {
            takeAway(islands.get(k), w, change);
        }
        return well;
    }

    /** The same for one island, to a few digits. */
    void takeAway(Island island, double[] w, double[] change) {
        correct(island, w, change, null);
    }

    /**
     * Whether an island's equations are well enough conditioned to be solved without refinement, in what order ever.
     *
     * @param island any
     * @param w the diagonal of W
     * @return false if only this solver's own way will do
     */
    boolean isPlain(Island island, double[] w) {
        return false;
    }

    /** Whether islands in which there is nothing to solve may go their own way, whatever their masses are. */
    boolean isDirect() {
        return false;
    }

    /**
     * Both at once.
     *
     * @param island evaluated
     * @param w the diagonal of W
     * @param u by blocks of the state
     * @param g 2 per node; null: zero
     */
    void prepareAndCorrect(Island island, double[] w, double[] u, double[] g) {
        prepare(island, w);
        correct(island, w, u, g);
    }

    /**
     * Finds the multipliers of the accelerations, (41), and adds W Jᵀ λ to them.
     *
     * @param island evaluated
     * @param state where the island is; changed for the time of the call only
     * @param a accelerations without those of the constraints
     */
    void accelerate(Island island, State state, double[] a) {
        prepareAndCorrect(island, state.w().values(), a, island.rate);
    }

    /** What an impulse on one body does to the velocities of its island, which is prepared, (47)–(54). */
    void reply(Island island, double[] w, int body, double px, double py, double turn, double[] velocities) {
        for (int k = 0; k < island.bodies.size; k++) {
            int s = State.BLOCK * island.bodies.values[k];
            Arrays.fill(velocities, s, s + State.BLOCK, 0);
        }
        int s = State.BLOCK * body;
        velocities[s] = w[s] * px;
        velocities[s + 1] = w[s + 1] * py;
        velocities[s + 2] = w[s + 2] * turn;
        correct(island, w, velocities, null);
    }
}
