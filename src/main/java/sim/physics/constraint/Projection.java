// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import sim.physics.motion.Carry;
import sim.physics.motion.Reach;
import sim.physics.motion.State;

/**
 * Brings positions and velocities back onto C = 0 and J ẋ = 0 by the move of least mass-weighted length,
 *
 * <pre>
 *   x += W Jᵀ δ,   J W Jᵀ δ = −C        (Newton's method)
 *   ẋ += W Jᵀ μ,   J W Jᵀ μ = −J ẋ
 * </pre>
 *
 * <p>What it takes away is the error of the step, so it does not cost the order of the integrator, and it needs no
 * springs that would make the joints soft.
 */
final class Projection implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int CORRECTIONS = 40;
    static final int VELOCITY_CORRECTIONS = 4;

    /** Rounding of C, relative to the coordinates that it is computed from. */
    static final double ROUNDING = 4 * 0x1p-52;

    /** Correction of a step, relative to the size of the bodies or in rad, from which the step was too long. */
    static final double ROUGH = 5e-3;

    /** Error of C, in units of its rounding, up to which joints count as closed: 100 ε of the size. */
    private static final double CLOSED = 25;

    /** The same, from which what damping left is taken away without it. */
    private static final double OPEN = 100;

    /** The same, from which a row that was set aside is none that the others imply. */
    private static final double SET_ASIDE = 1e6;

    /** Size of a correction whose square is less than rounding. */
    static final double SMOOTH = 1e-9;

    /**
     * The same, from which rows that the others imply may not be those any more that they implied before it: its square is far below what is
     * added to the diagonal for these.
     */
    private static final double FAR = 1e-6;

    /** Part of the energy before by which velocities that are brought onto joints may have more, by rounding. */
    private static final double MORE = 1e-6;

    /** Impacts of an island's stops on one another at one instant. */
    private static final int MOST_IMPACTS = 50;

    private double[] move = {};

    /** Places and velocities of an island before it was assembled. */
    private double[] before = {};

    private int corrections;
    private double error;
    private boolean isPatient;

    /** Whether it closes what a stage has, while it is being found which motors and stops act: that is not its business then. */
    private final boolean isOfStage;

    Projection() {
        this(false);
    }

    Projection(boolean isOfStage) {
        this.isOfStage = isOfStage;
    }

    /** Corrections that the last call made. */
    int corrections() {
        return corrections;
    }

    /** What there is to say of islands that move together, when no part of a step was short enough. */
    ConstraintException tooLong(List<Island> those) {
        List<Constraint> all = new ArrayList<>();
        those.forEach(island -> all.addAll(island.inOrder));
        double gap = those.stream().mapToDouble(Slack::largest).max().orElse(0);
        return new ConstraintException("constraints " + all
                + " cannot be kept closed, the time step may be much too long for the motion of their bodies or the forces on them",
                corrections, gap);
    }

    /** Projects positions and velocities, however far that is; throws if there are none, and all is as before. */
    void assemble(Island island, State state, ConstraintSolver solver, Reach reach) {
        island.invariants.end();
        int n = State.BLOCK * island.bodies.size;
        before = before.length < 2 * n ? new double[2 * n] : before;
        for (int k = 0; k < n; k++) {
            before[k] = state.x()[slot(island, k)];
            before[n + k] = state.v()[slot(island, k)];
        }
        boolean done = false;
        int tried = 0;
        boolean was = island.setPlacing(island.rolls());
        try {
            done = project(island, state, solver, false);
            tried = corrections;
            if (!done && reach != Reach.NEWTON) {
                Assembly assembly = new Assembly(this, island, state, solver, before);
                done = assembly.close(reach == Reach.ANYWHERE);
                tried += assembly.corrections();
            }
            if (done && island.switches.bias() == null) {
                temper(island, state, n);
            }
        } finally { // an author's constraint may throw
            island.setPlacing(was);
            for (int k = 0; !done && k < n; k++) {
                state.x()[slot(island, k)] = before[k];
                state.v()[slot(island, k)] = before[n + k];
            }
        }
        if (!done) {
            note(state);
            island.evaluate(state);
            throw Slack.failure(island, tried);
        }
    }

    /**
     * Bringing velocities onto joints gives no energy: μ is their impulse, and what it changes is square to what is left. Where rows nearly depend on
     * one another, as those of a taut chain do, rounding may be all that μ is: then only as much of it is given as takes the most.
     */
    private void temper(Island island, State state, int n) {
        double[] w = state.w().values();
        double[] v = state.v();
        double had = 0;
        double along = 0;
        double square = 0;
        for (int k = 0; k < n; k++) {
            int s = slot(island, k);
            if (w[s] > 0) {
                double change = v[s] - before[n + k];
                had += before[n + k] * before[n + k] / w[s];
                along += before[n + k] * change / w[s];
                square += change * change / w[s];
            }
        }
        if (2 * along + square > MORE * had) {
            double part = Math.max(0, -along / square);
            for (int k = 0; k < n; k++) {
                int s = slot(island, k);
                v[s] = before[n + k] + part * (v[s] - before[n + k]);
            }
        }
    }

    private static int slot(Island island, int k) {
        return State.BLOCK * island.bodies.values[k / State.BLOCK] + k % State.BLOCK;
    }

    /**
     * Projects positions and velocities.
     *
     * @param island the bodies and their constraints
     * @param state its vectors are changed
     * @param solver for the corrections
     * @param gentle whether to give up when the corrections are more than the error of a reasonable step
     * @return false if it gave up, or if there is no position near enough that satisfies the constraints
     */
    boolean project(Island island, State state, ConstraintSolver solver, boolean gentle) {
        if (gentle && island.passage.putBack(state)) {
            return true;
        }
        island.isProjected = gentle;
        note(state); // also if it fails half-way
        boolean done = island.rolls() ? closeRolling(island, state, solver, gentle) : close(island, state, solver, gentle);
        done = done && (island.invariants.restore(state, gentle) || !gentle);
        note(state);
        island.isProjected = false;
        return done && !(gentle && island.passage.endsUnawares());
    }

    /** Projects islands after a reasonable step; false if one has given up. */
    boolean project(List<Island> those, State state, ConstraintSolver solver) {
        boolean well = true;
        for (int k = 0; k < those.size(); k++) {
            well &= project(those.get(k), state, solver, true);
        }
        return well;
    }

    /** Projects islands however far that is; false if one has no such place near, or gains by it what no force gives. */
    boolean force(List<Island> those, State state, ConstraintSolver solver) {
        boolean well = true;
        for (int k = 0; k < those.size() && well; k++) {
            well = project(those.get(k), state, solver, false) && those.get(k).invariants.restore(state, true);
        }
        return well;
    }

    /**
     * Brings an island onto its constraints from a place near a pose where Newton's method halves the way at most each
     * time, as that pose is a double root.
     *
     * @return false if the constraints are not closed afterwards
     */
    boolean projectPatiently(Island island, State state, ConstraintSolver solver) {
        isPatient = true;
        boolean done = project(island, state, solver, false);
        isPatient = false;
        return done;
    }

    /** Notes that positions are written; within a step, where threads may write them, nobody relies on that. */
    private static void note(State state) {
        if (!state.isUnsettled()) {
            state.placedAll();
        }
    }

    /** Closes what has places as if there were no wheels, which may be pushed to anywhere; then velocities are those of all. */
    private boolean closeRolling(Island island, State state, ConstraintSolver solver, boolean gentle) {
        boolean was = island.setPlacing(true);
        boolean done = false;
        try {
            done = close(island, state, solver, gentle);
        } finally {
            island.setPlacing(false);
        }
        if (done) {
            island.evaluate(state);
            solver.prepare(island, state.w().values());
            settle(island, state, solver);
        }
        island.setPlacing(was);
        return done;
    }

    private boolean close(Island island, State state, ConstraintSolver solver, boolean gentle) {
        double[] w = state.w().values();
        island.switches.settle(isOfStage);
        island.evaluate(state);
        error = Slack.error(island, state, ROUNDING);
        double before = Double.POSITIVE_INFINITY;
        double roughness = 0;
        if (!(error > 1)) {
            if (isSettled(island, state)) {
                return true;
            }
            solver.prepare(island, w); // the velocities need it
        }
        for (corrections = 0; error > 1; corrections++) {
            boolean stalls = !(error < 0.5 * before) && error < (isPatient ? CLOSED : 1e4);
            if (stalls && !(island.isProjected && error > OPEN)) {
                if (gentle && error > (island.isProjected ? OPEN : CLOSED) && island.passage.sight.isNear(w)) {
                    return false;
                }
                break; // rounding
            }
            if (stalls) {
                island.isProjected = false; // the damping of a pose near a singular one left more than rounding
            }
            if (!(error < Double.POSITIVE_INFINITY) || corrections == CORRECTIONS) {
                return false;
            }
            roughness = correct(island, state, solver, w);
            if (gentle && (corrections == 0 || !island.isProjected) && roughness > ROUGH) {
                return false;
            }
            if (roughness < SMOOTH && !gentle && !isPatient && Slack.isOpen(island)) {
                return false; // no move closes what contradicts, and the best compromise is not it
            }
            if (roughness < SMOOTH) {
                if (nudge(island, state)) {
                    solver.correct(island, w, state.v(), island.switches.bias());
                    return true; // Newton's method squares what is left
                }
                before = Double.POSITIVE_INFINITY;
                continue;
            }
            island.evaluate(state);
            before = error;
            error = Slack.error(island, state, ROUNDING);
        }
        if (roughness > FAR && (island.isRedundant || island.near() > 0)) {
            solver.prepare(island, w);
        }
        settle(island, state, solver);
        return true;
    }

    /** Moves on by what a smooth correction leaves; false if damping, or pivots that were set aside, leave more, which is to be corrected anew. */
    private boolean nudge(Island island, State state) {
        island.nudge(state, move);
        double left = island.isProjected || island.factor.pivots.lasting() > 0 ? Slack.error(island, state, ROUNDING) : 0;
        boolean isDamped = island.isProjected && left > OPEN;
        if (!isDamped && !(left > SET_ASIDE && island.passage.unlearns())) {
            return true;
        }
        error = left;
        island.isProjected &= !isDamped;
        return false;
    }

    /** Whether the velocities are right to rounding at the positions at which the island is evaluated. */
    private static boolean isSettled(Island island, State state) {
        island.residual(state.v(), island.switches.bias(), island.lambda);
        return Slack.slip(island, state.v(), island.lambda) == 0;
    }

    /** Corrects the positions; returns by how much, in rad or relative to the size of the bodies. */
    private double correct(Island island, State state, ConstraintSolver solver, double[] w) {
        double[] x = state.x();
        clearMove(island, state);
        solver.prepareAndCorrect(island, w, move, island.c);
        double way = 0;
        double turn = 0;
        for (int k = 0; k < island.bodies.size; k++) {
            int s = State.BLOCK * island.bodies.values[k];
            way = Math.max(way, Math.max(Math.abs(move[s]), Math.abs(move[s + 1])));
            turn = Math.max(turn, Math.abs(move[s + 2]));
            x[s] += move[s];
            x[s + 1] += move[s + 1];
            x[s + 2] += move[s + 2];
        }
        return Math.max(way / island.leastSize, turn);
    }

    /** The same of some islands. */
    boolean decide(List<Island> islands, State state, ConstraintSolver solver, double time) {
        boolean hits = false;
        for (int k = 0; k < islands.size(); k++) {
            hits |= decide(islands.get(k), state, solver, time);
        }
        return hits;
    }

    /**
     * Decides which motors and stops act, and gives the bodies the velocities that these ask for; returns whether these may
     * have changed. Stops that are driven against others by this are decided again.
     */
    boolean decide(Island island, State state, ConstraintSolver solver, double time) {
        boolean hits = false;
        boolean isStruck = true;
        for (int k = 0; k < MOST_IMPACTS && isStruck && island.switches.decide(state, time); k++) {
            hits = true;
            if (island.switches.servos == null || !island.switches.servos.settle(state, solver)) {
                island.evaluate(state);
                solver.prepare(island, state.w().values());
                settle(island, state, solver);
            }
            isStruck = island.switches.isStruck(state, time);
        }
        return hits;
    }

    /** Projects the velocities of some islands alone. */
    void settle(List<Island> islands, State state, ConstraintSolver solver) {
        for (int k = 0; k < islands.size(); k++) {
            if (islands.get(k).shake.isCarried(state)) {
                settleCarried(islands.get(k), state, solver);
            } else {
                settle(islands.get(k), state, solver);
            }
        }
    }

    /** The same within a step of a method that carries what rounding leaves of the velocities. */
    private void settleCarried(Island island, State state, ConstraintSolver solver) {
        Carry carry = state.carry();
        double[] v = state.v();
        double[] right = island.shake.scratch();
        double last = Double.POSITIVE_INFINITY;
        for (int k = 0; k < VELOCITY_CORRECTIONS; k++) {
            island.residual(v, island.switches.bias(), right);
            for (int m = 0; m < right.length; m++) {
                right[m] = -right[m];
            }
            island.residual(carry.lowV(), right, right);
            double slip = Slack.slip(island, v, right);
            if (slip == 0 || !(slip < 0.5 * last)) {
                return;
            }
            last = slip;
            for (int m = 0; m < right.length; m++) {
                right[m] = -right[m];
            }
            clearMove(island, state);
            solver.correct(island, state.w().values(), move, right);
            for (int b = 0; b < island.bodies.size; b++) {
                for (int s = State.BLOCK * island.bodies.values[b], end = s + State.BLOCK; s < end; s++) {
                    carry.addV(v, s, move[s]);
                }
            }
            if (slip < SMOOTH) {
                return;
            }
        }
    }

    private void clearMove(Island island, State state) {
        if (move.length < state.x().length) {
            move = new double[state.x().length];
        }
        for (int k = 0; k < island.bodies.size; k++) {
            int s = State.BLOCK * island.bodies.values[k];
            Arrays.fill(move, s, s + State.BLOCK, 0);
        }
    }

    /** Projects the velocities alone; the island is evaluated, and prepared at or near the same positions. */
    void settle(Island island, State state, ConstraintSolver solver) {
        double[] v = state.v();
        double[] bias = island.switches.bias();
        double last = Double.POSITIVE_INFINITY;
        for (int k = 0; k < VELOCITY_CORRECTIONS; k++) {
            island.residual(v, bias, island.lambda);
            double slip = Slack.slip(island, v, island.lambda);
            if (slip == 0 || !(slip < 0.5 * last)) {
                return;
            }
            last = slip;
            solver.correct(island, state.w().values(), v, bias);
            if (slip < SMOOTH) {
                return;
            }
        }
    }
}
