// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.internal.IntList;

/**
 * The classical method of Runge and Kutta, (13), of fourth order.
 *
 * <pre>
 *    0  |
 *   1/2 | 1/2
 *   1/2 |  0   1/2
 *    1  |  0    0    1
 *   ----+--------------------
 *       | 1/6  1/3  1/3  1/6
 * </pre>
 *
 * <p>The path between the ends is the cubic with their positions and velocities. The write-up says that the method neither gains
 * nor loses energy. In fact it loses a little, of fifth order in the step.
 */
public final class RungeKutta4 implements Integrator {
    private static final long serialVersionUID = 1L;

    private static final double[] NODE = {0, 0.5, 0.5, 1};
    private static final double[] WEIGHT = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};

    /** Creates the method. */
    public RungeKutta4() {
        // no state
    }

    @Override
    public double advance(EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path) {
        advanceWithoutPath(equations, state, bodies, t, h, path);
        double[] v = state.v();
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int end = b + State.BLOCK; b < end; b++) {
                path.cubic(b, path.sumX[b], path.v0[b], v[b], h);
            }
        }
        return h;
    }

    /**
     * Whether a step of this method would leave a body where it is, since it is at rest under forces that depend on its state
     * alone and add up to nothing. Then its path is known; if not, the next step need not ask for the forces where it begins.
     */
    static boolean stays(Motion motion, State state, IntList group, double t, Path path) {
        double[] v = state.v();
        int b = State.BLOCK * group.values[0];
        boolean isStill = v[b] == 0 && v[b + 1] == 0 && v[b + 2] == 0 && group.size == 1;
        if (!isStill || !(motion.getIntegrator() instanceof RungeKutta4) || !motion.generators.areAutonomous(state, group)) {
            return false;
        }
        path.ensure(State.BLOCK * state.size());
        motion.acceleration(group, t, path.stage);
        path.takeFirst(group);
        path.isAtStart = !(path.first[b] == 0 && path.first[b + 1] == 0 && path.first[b + 2] == 0);
        for (int k = 0; k < State.BLOCK && !path.isAtStart; k++) {
            path.straight(b + k);
            v[b + k] = 0; // not −0
        }
        return !path.isAtStart;
    }

    /** The same for one who makes the path himself. */
    void advanceWithoutPath(EquationsOfMotion equations, State state, IntList bodies, double t, double h, Path path) {
        path.ensure(State.BLOCK * state.size());
        for (int s = 0; s < NODE.length; s++) {
            if (s > 0 || !path.putFirst(bodies)) {
                equations.acceleration(bodies, t + NODE[s] * h, path.stage);
            }
            path.takeFirst(bodies);
            if (s == 0) {
                begin(state, bodies, path, NODE[1] * h);
            } else if (s + 1 < NODE.length) {
                stage(state, bodies, path, WEIGHT[s], NODE[s + 1] * h);
            }
        }
        finish(state, bodies, h, path);
    }

    /** Keeps the start, begins the sums, and sets the state for the second stage. */
    private static void begin(State state, IntList bodies, Path path, double next) {
        double[] x = state.x();
        double[] v = state.v();
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int end = b + State.BLOCK; b < end; b++) {
                double place = x[b];
                double velocity = v[b];
                double acceleration = path.stage[b];
                path.x0[b] = place;
                path.v0[b] = velocity;
                path.sumX[b] = WEIGHT[0] * velocity;
                path.sumV[b] = WEIGHT[0] * acceleration;
                x[b] = place + next * velocity;
                v[b] = velocity + next * acceleration;
            }
        }
    }

    /** Adds a stage to the sums, and sets the state for the next one: x0 + c h k, with k = (ẋ, ẍ) of this stage. */
    private static void stage(State state, IntList bodies, Path path, double weight, double next) {
        double[] x = state.x();
        double[] v = state.v();
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int end = b + State.BLOCK; b < end; b++) {
                double velocity = v[b];
                double acceleration = path.stage[b];
                path.sumX[b] += weight * velocity;
                path.sumV[b] += weight * acceleration;
                x[b] = path.x0[b] + next * velocity;
                v[b] = path.v0[b] + next * acceleration;
            }
        }
    }

    private static void finish(State state, IntList bodies, double h, Path path) {
        double[] x = state.x();
        double[] v = state.v();
        double weight = WEIGHT[NODE.length - 1];
        for (int k = 0; k < bodies.size; k++) {
            int b = State.BLOCK * bodies.values[k];
            for (int end = b + State.BLOCK; b < end; b++) {
                path.sumX[b] += weight * v[b];
                x[b] = path.x0[b] + h * path.sumX[b]; // (13)
                v[b] = path.v0[b] + h * (path.sumV[b] + weight * path.stage[b]);
            }
        }
    }

    @Override
    public boolean isConcurrent() {
        return true;
    }

    @Override
    public int order() {
        return 4;
    }

    @Override
    public String toString() {
        return "RungeKutta4";
    }
}
