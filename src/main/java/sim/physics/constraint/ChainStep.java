// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import sim.physics.motion.Loads;
import sim.physics.motion.State;

/**
 * A step of a chain of pins under a uniform field, or what else is even over the step: RK4, (13)–(15), with the accelerations of (37), and the
 * {@link Projection} after it, all on the arrays of the chain. What is out of the ordinary it leaves to the general code:
 * then it has changed nothing.
 */
final class ChainStep implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final int STAGES = 4;
    private static final int CORRECTIONS = 6;

    /** Correction, in rad, for which the arms need not be turned from the start. */
    private static final double NUDGE = 1e-4;

    private final Island island;
    private final PinChain chain;
    private final double[] fallX;
    private final double[] fallY;
    private final double[] zero;

    /** What turns the bodies; null until something does, and whether something does now. */
    private double[] fallTurn;

    private boolean isTurned;

    /** Positions and velocities at the start. */
    private final double[] x0;

    private final double[] y0;
    private final double[] angle0;
    private final double[] u0;
    private final double[] v0;
    private final double[] omega0;

    /** Accelerations at the stages; corrections in the first of them. */
    private final double[][] ax = new double[STAGES][];

    private final double[][] ay = new double[STAGES][];
    private final double[][] turn = new double[STAGES][];
    private boolean isWeighed;

    ChainStep(Island island, PinChain chain) {
        this.island = island;
        this.chain = chain;
        int n = chain.block.length;
        fallX = new double[n];
        fallY = new double[n];
        zero = new double[n];
        x0 = new double[n];
        y0 = new double[n];
        angle0 = new double[n];
        u0 = new double[n];
        v0 = new double[n];
        omega0 = new double[n];
        for (int s = 0; s < STAGES; s++) {
            ax[s] = new double[n];
            ay[s] = new double[n];
            turn[s] = new double[n];
        }
    }

    void forgetMasses() {
        isWeighed = false;
    }

    /**
     * Advances the chain.
     *
     * @param state its vectors are changed, if all is well
     * @param solver one whose results these are
     * @param gx the field
     * @param gy the field
     * @param h step
     * @return false if the general code must make this step
     */
    boolean advance(State state, ConstraintSolver solver, double gx, double gy, double h) {
        if (!begin(state, solver)) {
            return false;
        }
        if (gx == 0 && gy == 0) {
            island.invariants.begin(state, true);
        }
        for (int k = 0; k < chain.block.length; k++) {
            fallX[k] = chain.block[k] < 0 ? 0 : gx;
            fallY[k] = chain.block[k] < 0 ? 0 : gy;
        }
        isTurned = false;
        return advance(state, null, h);
    }

    /**
     * Advances the chain under loads that are the same over the step.
     *
     * @param state its vectors are changed, if all is well
     * @param solver one whose results these are
     * @param loads the loads
     * @param a gets the accelerations at the start, with what the pins do, [x″, y″, θ″] per body of the state
     * @param t time of the start
     * @param h step
     * @return false if the general code must make this step
     */
    boolean advance(State state, ConstraintSolver solver, Loads loads, double[] a, double t, double h) {
        if (!begin(state, solver)) {
            return false;
        }
        fallTurn = fallTurn == null ? new double[zero.length] : fallTurn;
        loads.load(island.bodies, t, a);
        for (int k = 0; k < chain.block.length; k++) {
            int b = chain.block[k];
            fallX[k] = b < 0 ? 0 : a[b];
            fallY[k] = b < 0 ? 0 : a[b + 1];
            fallTurn[k] = b < 0 ? 0 : a[b + 2];
        }
        isTurned = true;
        return advance(state, a, h);
    }

    private boolean begin(State state, ConstraintSolver solver) {
        if (!solver.isPlain(island, state.w().values())) {
            return false;
        }
        if (!isWeighed) {
            chain.weigh(state.w().values());
            isWeighed = true;
        }
        island.invariants.end();
        return true;
    }

    private boolean advance(State state, double[] first, double h) {
        island.effort.pass((long) STAGES * chain.block.length);
        double place = gather(state);
        chain.settleAngles();
        accelerate(0);
        tellFirst(first);
        Lanes.add(angle0, 0.5 * h, omega0, chain.angle); // the accelerations depend on angles and their rates alone
        Lanes.add(omega0, 0.5 * h, turn[0], chain.omega);
        accelerate(1);
        Lanes.add(angle0, 0.5 * h, chain.omega, chain.angle);
        Lanes.add(omega0, 0.5 * h, turn[1], chain.omega);
        accelerate(2);
        Lanes.add(angle0, h, chain.omega, chain.angle);
        Lanes.add(omega0, h, turn[2], chain.omega);
        accelerate(3);
        finish(h);
        if (!close(place) || !isWithinWork(state.w().values())) {
            return false;
        }
        scatter(state);
        island.redundantRows = 0;
        if (!island.invariants.restore(state, true)) {
            putBack(state);
            return false;
        }
        return true;
    }

    /**
     * Whether the kinetic energy has changed by the work of the loads, which are even: pins do none. A step that says otherwise is too long for a chain
     * that is nearly taut: the general code corrects it, or makes it in parts.
     */
    private boolean isWithinWork(double[] w) {
        double before = 0;
        double growth = 0;
        double most = 0;
        double rounding = 0;
        for (int k = 0; k < chain.block.length; k++) {
            int b = chain.block[k];
            if (b < 0) {
                continue;
            }
            double fallen = isTurned ? fallTurn[k] : 0;
            double workX = fallX[k] * (chain.x[k] - x0[k]);
            double workY = fallY[k] * (chain.y[k] - y0[k]);
            double workTurn = fallen * (chain.angle[k] - angle0[k]);
            before += 0.5 * ((u0[k] * u0[k] + v0[k] * v0[k]) / w[b] + omega0[k] * omega0[k] / w[b + 2]);
            growth += 0.5 * (((chain.u[k] - u0[k]) * (chain.u[k] + u0[k]) + (chain.v[k] - v0[k]) * (chain.v[k] + v0[k])) / w[b]
                            + (chain.omega[k] - omega0[k]) * (chain.omega[k] + omega0[k]) / w[b + 2])
                    - (workX + workY) / w[b] - workTurn / w[b + 2];
            most += (Math.abs(workX) + Math.abs(workY)) / w[b] + Math.abs(workTurn) / w[b + 2];
            rounding += (Math.abs(fallX[k]) * Math.max(Math.abs(x0[k]), island.mostSize)
                                    + Math.abs(fallY[k]) * Math.max(Math.abs(y0[k]), island.mostSize)) / w[b]
                    + Math.abs(fallen) * Math.max(Math.abs(angle0[k]), 1) / w[b + 2];
        }
        return most == 0 || Math.abs(growth) <= Invariants.LEFT * (before + most) + Invariants.ROUNDING * rounding;
    }

    /** Takes the state over; returns the largest coordinate. */
    private double gather(State state) {
        double[] x = state.x();
        double[] v = state.v();
        for (int k = 0; k < chain.block.length; k++) {
            int b = chain.block[k];
            if (b >= 0) {
                x0[k] = x[b];
                y0[k] = x[b + 1];
                angle0[k] = x[b + 2];
                u0[k] = v[b];
                v0[k] = v[b + 1];
                omega0[k] = v[b + 2];
            }
        }
        int n = fallX.length;
        System.arraycopy(angle0, 0, chain.angle, 0, n);
        System.arraycopy(omega0, 0, chain.omega, 0, n);
        return Math.max(island.mostSize, Lanes.most(x0, y0) * 0.5); // at most the largest coordinate
    }

    /** (37) at a stage. */
    private void accelerate(int s) {
        chain.turnArms();
        chain.askAcceleration(fallX, fallY);
        if (isTurned) {
            chain.askTurning(fallTurn);
        }
        chain.factorAndSolve(fallX, fallY, ax[s], ay[s], turn[s]);
        if (isTurned) {
            Lanes.add(turn[s], fallTurn, turn[s]);
        }
    }

    /** Tells the accelerations at the start, to whom wants to know. */
    private void tellFirst(double[] a) {
        for (int k = 0; a != null && k < chain.block.length; k++) {
            int b = chain.block[k];
            if (b >= 0) {
                a[b] = ax[0][k];
                a[b + 1] = ay[0][k];
                a[b + 2] = turn[0][k];
            }
        }
    }

    private void finish(double h) {
        Lanes.weigh(x0, u0, ax[0], ax[1], ax[2], h, chain.x);
        Lanes.weigh(y0, v0, ay[0], ay[1], ay[2], h, chain.y);
        Lanes.weigh(angle0, omega0, turn[0], turn[1], turn[2], h, chain.angle);
        Lanes.weigh(u0, ax[0], ax[1], ax[2], ax[3], chain.u, h);
        Lanes.weigh(v0, ay[0], ay[1], ay[2], ay[3], chain.v, h);
        Lanes.weigh(omega0, turn[0], turn[1], turn[2], turn[3], chain.omega, h);
    }

    /** Projects positions and velocities, as {@link Projection} does. */
    private boolean close(double place) {
        double rounding = Projection.ROUNDING * place;
        chain.turnArms();
        for (int corrections = 0; corrections < CORRECTIONS; corrections++) {
            chain.askPosition();
            boolean closed = corrections == 0 && chain.largest() <= rounding;
            chain.factorAndSolve(zero, zero, ax[0], ay[0], turn[0]);
            if (corrections == 0 && !chain.isSound()) {
                return false;
            }
            if (closed) {
                return settle(0);
            }
            double roughness = correctPlaces();
            if (!(roughness < Projection.ROUGH)) {
                return false;
            }
            if (roughness < NUDGE) {
                chain.nudgeArms(turn[0]);
            } else {
                chain.turnArms();
            }
            if (roughness < Projection.SMOOTH || roughness * roughness * island.leastSize < rounding) {
                return settle(roughness); // Newton's method squares what is left
            }
        }
        return false;
    }

    /**
     * Projects the velocities, with the factors at hand.
     *
     * @param moved by how much the bodies have moved since, in rad or relative to their size
     */
    private boolean settle(double moved) {
        if (moved > 0 && moved < Projection.SMOOTH) {
            chain.askVelocity();
            correctVelocities();
            return true;
        }
        double last = Double.POSITIVE_INFINITY;
        double scale = 0.5 * Lanes.most(1, chain.u, chain.v, island.leastSize, chain.omega);
        for (int k = 0; k < Projection.VELOCITY_CORRECTIONS; k++) {
            chain.askVelocity();
            double slip = chain.largest();
            if (slip <= 2 * 0x1p-52 * scale || !(slip < 0.5 * last)) {
                return slip <= Double.MAX_VALUE;
            }
            last = slip;
            correctVelocities();
            if (slip < Projection.SMOOTH * scale) {
                return true;
            }
        }
        return true;
    }

    /** Moves the bodies by the solution; returns how far, in rad or relative to the size of the bodies. */
    private double correctPlaces() {
        Lanes.add(chain.x, ax[0], chain.x);
        Lanes.add(chain.y, ay[0], chain.y);
        Lanes.add(chain.angle, turn[0], chain.angle);
        return Lanes.most(1 / island.leastSize, ax[0], ay[0], 1, turn[0]);
    }

    private void correctVelocities() {
        chain.solve(chain.u, chain.v, chain.u, chain.v, turn[0]);
        Lanes.add(chain.omega, turn[0], chain.omega);
    }

    private void putBack(State state) {
        double[] x = state.x();
        double[] v = state.v();
        for (int k = 0; k < chain.block.length; k++) {
            int b = chain.block[k];
            if (b >= 0) {
                x[b] = x0[k];
                x[b + 1] = y0[k];
                x[b + 2] = angle0[k];
                v[b] = u0[k];
                v[b + 1] = v0[k];
                v[b + 2] = omega0[k];
            }
        }
    }

    private void scatter(State state) {
        double[] x = state.x();
        double[] v = state.v();
        for (int k = 0; k < chain.block.length; k++) {
            int b = chain.block[k];
            if (b >= 0) {
                x[b] = chain.x[k];
                x[b + 1] = chain.y[k];
                x[b + 2] = chain.angle[k];
                v[b] = chain.u[k];
                v[b + 1] = chain.v[k];
                v[b + 2] = chain.omega[k];
            }
        }
    }
}
