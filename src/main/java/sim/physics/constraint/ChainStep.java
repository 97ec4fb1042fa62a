// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import sim.physics.motion.State;

/**
 * A step of a chain of pins under a uniform field: RK4, (13)–(15), with the accelerations of (37), and the
 * {@link Projection} after it, all on the arrays of the chain. What is out of the ordinary it leaves to the general code:
 * then it has changed nothing.
 */
final class ChainStep implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final double[] NODE = {0, 0.5, 0.5, 1};
    private static final double[] WEIGHT = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};

    private static final int CORRECTIONS = 6;

    private final Island island;
    private final PinChain chain;
    private final double[] fallX;
    private final double[] fallY;
    private final double[] fallTurn;

    /** Positions and velocities at the start, and their weighted sums. */
    private final double[][] start = new double[6][];

    private final double[][] sum = new double[6][];
    private boolean isWeighed;

    ChainStep(Island island, PinChain chain) {
        this.island = island;
        this.chain = chain;
        int n = chain.block.length;
        fallX = new double[n];
        fallY = new double[n];
        fallTurn = new double[n];
        for (int k = 0; k < start.length; k++) {
            start[k] = new double[n];
            sum[k] = new double[n];
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
        if (!solver.isPlain(island, state.w().values())) {
            return false;
        }
        if (!isWeighed) {
            chain.weigh(state.w().values());
            isWeighed = true;
        }
        island.invariants.begin(state, gx == 0 && gy == 0);
        double place = gather(state, gx, gy);
        chain.settleAngles();
        boolean sound = true;
        for (int s = 0; s < NODE.length && sound; s++) {
            chain.turnArms();
            chain.askAcceleration(fallX, fallY);
            sound = chain.factorAndSolve();
            stages(s, s + 1 < NODE.length ? NODE[s + 1] * h : 0);
        }
        if (!sound) {
            return false;
        }
        finish(h);
        if (!close(place)) {
            return false;
        }
        scatter(state);
        island.redundantRows = 0;
        island.invariants.restore(state);
        return true;
    }

    /** Takes the state over; returns the largest coordinate. */
    private double gather(State state, double gx, double gy) {
        double[] x = state.x();
        double[] v = state.v();
        double place = island.mostSize;
        for (int k = 0; k < chain.block.length; k++) {
            int b = chain.block[k];
            if (b >= 0) {
                fallX[k] = gx;
                fallY[k] = gy;
                start[0][k] = x[b];
                start[1][k] = x[b + 1];
                start[2][k] = x[b + 2];
                start[3][k] = v[b];
                start[4][k] = v[b + 1];
                start[5][k] = v[b + 2];
                place = Math.max(place, Math.max(Math.abs(x[b]), Math.abs(x[b + 1])));
            }
        }
        int n = fallX.length;
        System.arraycopy(start[0], 0, chain.x, 0, n);
        System.arraycopy(start[1], 0, chain.y, 0, n);
        System.arraycopy(start[2], 0, chain.angle, 0, n);
        System.arraycopy(start[3], 0, chain.u, 0, n);
        System.arraycopy(start[4], 0, chain.v, 0, n);
        System.arraycopy(start[5], 0, chain.omega, 0, n);
        return place;
    }

    /** Adds a stage to the sums and sets the state for the next one. */
    private void stages(int s, double next) {
        double w = WEIGHT[s];
        double keep = s == 0 ? 0 : 1;
        stage(chain.x, chain.u, chain.dx, fallX, start[0], start[3], sum[0], sum[3], w, next, keep);
        stage(chain.y, chain.v, chain.dy, fallY, start[1], start[4], sum[1], sum[4], w, next, keep);
        stage(chain.angle, chain.omega, chain.turn, fallTurn, start[2], start[5], sum[2], sum[5], w, next, keep);
    }

    private static void stage(
            double[] x, double[] v, double[] push, double[] fall, double[] x0, double[] v0, double[] sumX, double[] sumV,
            double weight, double next, double keep) {
        for (int k = 0; k < x.length; k++) {
            double velocity = v[k];
            double acceleration = fall[k] + push[k];
            sumX[k] = keep * sumX[k] + weight * velocity;
            sumV[k] = keep * sumV[k] + weight * acceleration;
            x[k] = x0[k] + next * velocity;
            v[k] = v0[k] + next * acceleration;
        }
    }

    private void finish(double h) {
        move(start[0], sum[0], h, chain.x);
        move(start[1], sum[1], h, chain.y);
        move(start[2], sum[2], h, chain.angle);
        move(start[3], sum[3], h, chain.u);
        move(start[4], sum[4], h, chain.v);
        move(start[5], sum[5], h, chain.omega);
    }

    private static void move(double[] from, double[] by, double scale, double[] to) {
        for (int k = 0; k < to.length; k++) {
            to[k] = from[k] + scale * by[k];
        }
    }

    /** Projects positions and velocities, as {@link Projection} does. */
    private boolean close(double place) {
        double before = Double.POSITIVE_INFINITY;
        for (int corrections = 0; corrections < CORRECTIONS; corrections++) {
            chain.turnArms();
            chain.askPosition();
            double error = chain.largest() / (Projection.ROUNDING * place);
            if (!chain.factorAndSolve()) {
                return false;
            }
            if (error <= 1 || error >= 0.5 * before && error < 1e4) {
                return settle(); // closed; or rounding
            }
            before = error;
            double roughness = correctPlaces();
            if (!(roughness < Projection.ROUGH)) {
                return false;
            }
            if (roughness < Projection.SMOOTH) {
                chain.nudgeArms();
                chain.askVelocity();
                chain.solve();
                correctVelocities();
                return true; // Newton's method squares what is left
            }
        }
        return false;
    }

    /** Projects the velocities, with the factors at hand. */
    private boolean settle() {
        double last = Double.POSITIVE_INFINITY;
        double scale = Math.max(Math.max(most(chain.u), most(chain.v)), most(chain.omega) * island.leastSize);
        for (int k = 0; k < Projection.VELOCITY_CORRECTIONS; k++) {
            chain.askVelocity();
            double slip = chain.largest();
            if (slip <= 2 * 0x1p-52 * scale || !(slip < 0.5 * last)) {
                return slip <= Double.MAX_VALUE;
            }
            last = slip;
            chain.solve();
            correctVelocities();
            if (slip < Projection.SMOOTH * scale) {
                return true;
            }
        }
        return true;
    }

    private static double most(double[] a) {
        double most = 0;
        for (double value : a) {
            most = Math.max(most, Math.abs(value));
        }
        return most;
    }

    /** Moves the bodies by the solution; returns how far, in rad or relative to the size of the bodies. */
    private double correctPlaces() {
        move(chain.x, chain.dx, 1, chain.x);
        move(chain.y, chain.dy, 1, chain.y);
        move(chain.angle, chain.turn, 1, chain.angle);
        return Math.max(Math.max(most(chain.dx), most(chain.dy)) / island.leastSize, most(chain.turn));
    }

    private void correctVelocities() {
        move(chain.u, chain.dx, 1, chain.u);
        move(chain.v, chain.dy, 1, chain.v);
        move(chain.omega, chain.turn, 1, chain.omega);
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
