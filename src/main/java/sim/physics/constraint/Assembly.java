// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import sim.physics.motion.State;

/**
 * Finds places that satisfy the constraints of an island where Newton's method, which knows no bounds, has found none: a body
 * with a long arm and a small moment of inertia is turned by it too far, and then back again.
 *
 * <p>It goes down on the sum of the squares of C, by Levenberg's and Marquardt's steps (Nocedal and Wright, <i>Numerical
 * Optimization</i>, 2006, chapter 10), none of which turns a body by more than {@value #MOST_TURN} rad:
 *
 * <pre>
 *   x += s W Jᵀ δ,   (J W Jᵀ + μ) δ = −C
 * </pre>
 *
 * <p>As long as the rows of J are independent, as they are in trees of joints, this cannot end but in C = 0. In loops it may end
 * in a valley; then it starts anew from places beside, which depend on nothing but the number of the start. What it has found is
 * drawn back to where the bodies were for as long as that makes the mass-weighted displacement less.
 */
final class Assembly {
    /** Beyond this, what J says of where points go by a turn is of no use. */
    private static final double MOST_TURN = 0.5;

    /** Starts of an island with few rows, of any island; and rows with which there are as many. */
    private static final int MOST_STARTS = 32;

    private static final int LEAST_STARTS = 4;
    private static final int FEW_NODES = 50;

    /** Steps from a start, and steps on end that hardly go down, after which it ends in a valley. */
    private static final int MOST_STEPS = 1000;

    private static final int MOST_IDLE = 6;

    /** Products of blocks that all of it may take, some seconds; and factorizations that it may make in any case. */
    private static final long MOST_WORK = 200_000_000;

    private static final int LEAST_SOLVES = 30;

    /** What hardly goes down: less than this part of the sum. */
    private static final double IDLE = 1e-2;

    private static final int HALVINGS = 3;
    private static final int EASINGS = 6;
    private static final int RETURNS = 30;

    /** Gaps relative to the size of the bodies, or in rad, from which Newton's method is tried again; and if it fails, this part of them. */
    private static final double NEAR = 1e-3;

    private static final double NEARER = 1e-3;
    private static final double NEAREST = 1e-10;

    /** μ, relative to the diagonal. */
    private static final double LEAST_DAMPING = 1e-9;

    private static final double DAMPING = 1e-4;
    private static final double MOST_DAMPING = 1e4;

    /** Change of the displacement from which it is as small as it gets. */
    private static final double LEVEL = 1e-6;

    private final Projection projection;
    private final Island island;
    private final State state;
    private final ConstraintSolver solver;
    private final double[] w;

    /** Places of the island from which it begins, and then its velocities; and places to go back to. */
    private final double[] before;

    private final double[] here;

    /** W of the steps, and the longest arm of each body so far. */
    private final double[] metric;

    private final double[] arms;

    /** A step, by blocks of the state. */
    private final double[] move;

    private int corrections;

    /** Factorizations that may still be made. */
    private long solves;

    /**
     * Prepares for an island.
     *
     * @param projection for what ends it
     * @param island the bodies and their constraints
     * @param state its places and velocities are changed
     * @param solver for the projection
     * @param before places, and then velocities, from which it begins
     */
    Assembly(Projection projection, Island island, State state, ConstraintSolver solver, double[] before) {
        this.projection = projection;
        this.island = island;
        this.state = state;
        this.solver = solver;
        this.before = before;
        w = state.w().values();
        metric = w.clone();
        arms = new double[island.bodies.size];
        here = new double[size()];
        move = new double[state.x().length];
        solves = Math.max(LEAST_SOLVES, MOST_WORK / island.factor.work());
    }

    /** Steps and corrections that were made. */
    int corrections() {
        return corrections;
    }

    /** Brings the island onto its constraints; false if no place was found, and then it is anywhere. */
    boolean close(boolean anywhere) {
        int most = anywhere ? Math.max(LEAST_STARTS, MOST_STARTS * FEW_NODES / Math.max(FEW_NODES, island.nodes)) : 1;
        boolean done = false;
        for (int start = 0; start < most && !done && solves > 0; start++) {
            begin(start, (double) start / most);
            done = descend();
        }
        if (done) {
            goBack();
        }
        return done;
    }

    private int size() {
        return State.BLOCK * island.bodies.size;
    }

    private int slot(int k) {
        return State.BLOCK * island.bodies.values[k / State.BLOCK] + k % State.BLOCK;
    }

    /** Goes to a start: 0 is where the bodies were, and later ones are farther from there, up to half a turn and their size. */
    private void begin(int start, double far) {
        for (int k = 0; k < size(); k++) {
            int s = slot(k);
            double uneven = 2 * ((start * 0.7548776662466927 + (k + 1) * (start + 1) * 0.5698402909980532) % 1) - 1;
            double most = k % State.BLOCK == State.THETA ? Math.PI : island.mostSize;
            state.x()[s] = before[k] + (start == 0 || !(w[s] > 0) ? 0 : far * most * uneven);
        }
        putVelocities();
    }

    private void putVelocities() {
        int n = size();
        for (int k = 0; k < n; k++) {
            state.v()[slot(k)] = before[n + k];
        }
    }

    /** Goes down from where the island is; returns whether that ends on the constraints. */
    private boolean descend() {
        double damping = LEAST_DAMPING;
        double near = NEAR;
        int idle = 0;
        island.evaluate(state);
        for (int step = 0; step < MOST_STEPS && idle < MOST_IDLE && solves > 0; step++) {
            if (widest() <= near) {
                keep();
                if (project()) {
                    return true;
                }
                putBack();
                near *= NEARER;
                if (near < NEAREST) {
                    return false;
                }
            }
            corrections++;
            double part = advance(damping);
            if (!(part <= 1)) {
                damping = Math.max(10 * damping, DAMPING);
                if (damping > MOST_DAMPING) {
                    return false;
                }
            } else {
                damping = Math.max(0.1 * damping, LEAST_DAMPING);
                idle = part > 1 - IDLE ? idle + 1 : 0;
            }
        }
        return false;
    }

    /** The widest gap, relative to the size of the bodies or in rad. */
    private double widest() {
        double most = 0;
        for (int k = 0; k < island.constraints.length; k++) {
            most = Math.max(most, Slack.gap(island, k, false) / island.constraints[k].getSize());
            most = Math.max(most, Slack.gap(island, k, true));
        }
        return most;
    }

    private boolean project() {
        boolean done = projection.project(island, state, solver, false);
        corrections += projection.corrections();
        return done;
    }

    /** Makes a step down; returns which part of the sum of squares is left, NaN if none leads down, and all is as before. */
    private double advance(double damping) {
        weigh();
        boolean isEased = true;
        for (int k = 0; k < EASINGS && isEased; k++) {
            solve(damping);
            isEased = ease();
        }
        double way = unit(false);
        double turn = unit(true);
        double sum = sum(way, turn);
        keep();
        double scale = Math.min(1, MOST_TURN / turns());
        for (int half = 0; half <= HALVINGS && sum <= Double.MAX_VALUE; half++, scale *= 0.5) {
            go(scale);
            island.evaluate(state);
            double left = sum(way, turn) / sum;
            if (left < 1 - 1e-4 * scale) {
                return left;
            }
        }
        putBack();
        return Double.NaN;
    }

    /** Finds the step. */
    private void solve(double damping) {
        solves--;
        island.assembleOther(metric, island.factor);
        island.factor.factor(damping, Pivots.NOISE, true);
        for (int k = 0; k < island.lambda.length; k++) {
            island.lambda[k] = -island.c[k];
        }
        island.solve(island.lambda);
        for (int k = 0; k < size(); k++) {
            move[slot(k)] = 0;
        }
        island.applyOther(metric, island.lambda, move);
    }

    /** Makes it harder to turn bodies that the step would turn too far; false if it turns none so. */
    private boolean ease() {
        boolean any = false;
        for (int k = 0; k < arms.length; k++) {
            int s = State.BLOCK * island.bodies.values[k] + State.THETA;
            double turn = Math.abs(move[s]);
            if (turn > MOST_TURN) {
                metric[s] *= MOST_TURN / turn;
                any = true;
            }
        }
        return any;
    }

    /** Makes a body turn no more easily than the points of its joints are moved by its centre. */
    private void weigh() {
        island.writeRows();
        for (int p = 0; p < island.nodes; p++) {
            for (int row = 0; row < 2; row++) {
                int o = Island.J * p + 3 * row + State.THETA;
                note(island.a[p], 2 * p + row, o);
                note(island.b[p], 2 * p + row, o + 6);
            }
        }
        for (int k = 0; k < arms.length; k++) {
            int s = State.BLOCK * island.bodies.values[k];
            if (w[s] > 0 && arms[k] > 0) {
                metric[s + State.THETA] = Math.min(w[s + State.THETA], w[s] / (arms[k] * arms[k]));
            }
        }
    }

    private void note(int body, int row, int entry) {
        if (body >= 0 && !island.isAngle[row]) {
            arms[body] = Math.max(arms[body], Math.abs(island.j[entry]));
        }
    }

    /** The largest diagonal value among rows of a unit. */
    private double unit(boolean isAngle) {
        double[] size = island.factor.pivots.size;
        double most = 0;
        for (int k = 0; k < size.length; k++) {
            most = island.isAngle[k] == isAngle && island.c[k] != 0 ? Math.max(most, size[k]) : most;
        }
        return most > 0 ? most : 1;
    }

    /** The sum of the squares of C, in which ways and angles count as much as they do in the steps. */
    private double sum(double way, double turn) {
        double sum = 0;
        for (int k = 0; k < island.c.length; k++) {
            sum += island.c[k] * island.c[k] / (island.isAngle[k] ? turn : way);
        }
        return sum;
    }

    /** By how much the step turns a body at most. */
    private double turns() {
        double most = 0;
        for (int k = State.THETA; k < size(); k += State.BLOCK) {
            most = Math.max(most, Math.abs(move[slot(k)]));
        }
        return most;
    }

    private void go(double scale) {
        for (int k = 0; k < size(); k++) {
            state.x()[slot(k)] = here[k] + scale * move[slot(k)];
        }
    }

    private void keep() {
        for (int k = 0; k < size(); k++) {
            here[k] = state.x()[slot(k)];
        }
    }

    private void putBack() {
        for (int k = 0; k < size(); k++) {
            state.x()[slot(k)] = here[k];
        }
        putVelocities();
        island.evaluate(state);
    }

    /** Goes along the constraints to the place on them that is nearest to where the bodies were. */
    private void goBack() {
        double distance = distance();
        for (int k = 0; k < RETURNS; k++) {
            keep();
            island.evaluate(state);
            solver.prepare(island, w);
            for (int m = 0; m < size(); m++) {
                move[slot(m)] = before[m] - here[m];
            }
            solver.correct(island, w, move, null);
            double left = approach(distance);
            if (!(left < (1 - LEVEL) * distance)) {
                return;
            }
            distance = left;
        }
    }

    /** Makes a step along the constraints to where the bodies were; returns the displacement that is left. */
    private double approach(double distance) {
        double scale = Math.min(1, MOST_TURN / turns());
        for (int half = 0; half <= HALVINGS; half++, scale *= 0.5) {
            putVelocities();
            go(scale);
            if (project() && distance() < distance) {
                return distance();
            }
        }
        putBack();
        project(); // where it was on them; the velocities, too
        return distance;
    }

    /** The mass-weighted square of the displacement from where the bodies were. */
    private double distance() {
        double sum = 0;
        for (int k = 0; k < size(); k++) {
            double way = state.x()[slot(k)] - before[k];
            sum += w[slot(k)] > 0 ? way * way / w[slot(k)] : 0;
        }
        return sum;
    }
}
