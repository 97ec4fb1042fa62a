// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.motion.State;

/**
 * The accelerations of an island that moves through a singular pose: one in which rows of J, independent before and after,
 * depend on one another, as those of a parallelogram with all bars in one line.
 *
 * <p>Near such a pose λ grows like 1/φ, where φ is how far it is, and the force W Jᵀ λ stays what it is; but of the digits of
 * a deviation y from the motion, J W Jᵀ λ = … makes y/φ². So the force is not computed there: it is extrapolated from those at
 * poses on the way, a little before and a little after. Their mean is an even function of the way, so that four of them
 * leave an error of its eighth power.
 *
 * <p>Beside such a pose, where λ is still known to some digits, a stage's deviation y makes an error of y/φ² in the motion. There the
 * force is that of the place on the constraints next to the stage, with the velocities that they allow, which is as smooth
 * through the pose as the motion is. Steps are taken altogether so, or not at all, since what a method's stages cancel of one
 * another's errors they do for one field of forces only.
 *
 * <p>Rows that depend on one another on the way, too, do so always; they are left to the solver.
 */
final class Passage implements Serializable {
    private static final long serialVersionUID = 1L;

    /** The way to either side, in rad or relative to the size of the bodies. */
    private static final double WAY = 5e-3;

    /** Error of C, in units of its rounding, up to which the constraints count as closed. */
    private static final double CLOSED = 1e3;

    /** The same, up to which a structure is taken as one that fits. */
    private static final double NEARLY_CLOSED = 1e6;

    private static final int LENGTHENINGS = 4;

    /** What the means at one to four ways weigh: the cubic in the square of the way through them, at 0. */
    private static final double[] WEIGHTS = {1.6, -0.8, 8.0 / 35, -1.0 / 35};

    /** Change of the mean from the first way to the second one, relative, from which the motion is too slow for this. */
    private static final double SMOOTH = 1e-2;

    private final Island island;

    /** Times that it is tried to find out which rows are always redundant. */
    private static final int MOST_LESSONS = 8;

    /** Rows that depend on others wherever the island is. */
    private int lasting;

    private int lessons;

    /** Whether the island is found to be a structure that can move to first order only. */
    private boolean stands;

    /** What the island does if it can go no other way. */
    final Creep creep;

    final Sight sight;

    /** Whether the step began beside a singular pose. */
    private boolean isBeside;

    /** Whether one of its stages was within sight of such a pose. */
    private boolean isMet;

    /** A stage's positions and velocities. */
    private double[] stageX = {};

    private double[] stageV = {};

    private double[] place = {};
    private int examinations;

    private Projection projection;
    private double[] x = {};
    private double[] v = {};
    private double[] along = {};
    private double[] u = {};
    private double[] mean = {};
    private double[] change = {};
    private double[] lambda = {};

    Passage(Island island) {
        this.island = island;
        creep = new Creep(island);
        sight = new Sight(island);
    }

    /** Whether the matrix that was just factored says that the pose is near a singular one. */
    boolean isNear() {
        int near = island.near();
        if (near < lasting) {
            lasting = near;
        }
        return near > lasting;
    }

    /** A step begins. */
    void begin() {
        isMet = false;
    }

    /** A stage is where the matrix was factored last. */
    void noteStage() {
        isMet |= island.factor.pivots.isWeakHere();
    }

    /**
     * A step ends where the matrix was factored last. Says whether it met a pose beside which it did not begin, and is to be
     * taken again as one that did.
     */
    boolean endsUnawares() {
        boolean yes = isMet && !isBeside;
        isBeside = yes || island.factor.pivots.isBeside();
        return yes;
    }

    /** Whether the step began beside a singular pose. */
    boolean isBeside() {
        return isBeside;
    }

    /**
     * Moves the island from where a stage has it to the place on its constraints next to that; false, and nothing done, if it is
     * there or there is none.
     */
    boolean close(State state, DirectSolver solver) {
        if (!(Slack.error(island, state, Projection.ROUNDING) > 1)) {
            return false;
        }
        keep(state);
        if (stageX.length == 0) {
            stageX = new double[x.length];
            stageV = new double[x.length];
        }
        System.arraycopy(x, 0, stageX, 0, x.length);
        System.arraycopy(v, 0, stageV, 0, x.length);
        boolean isClosed = projection.project(island, state, solver, false);
        if (!isClosed) {
            restore(state);
        }
        island.evaluate(state);
        return isClosed;
    }

    /** Moves the island back to where the stage has it. */
    void open(State state) {
        put(state, stageX, stageV);
        island.evaluate(state);
    }

    /**
     * Finds out which rows are redundant always: those that are so on the way before and after, too. Says whether that has
     * become known, or is not true any more, so that the matrix is to be factored again.
     *
     * <p>Rows of motors and stops come and go, and what is redundant with them.
     */
    boolean learns(State state, DirectSolver solver) {
        Pivots pivots = island.factor.pivots;
        boolean isKnown = pivots.lasting() > 0;
        if (isKnown && pivots.strays() == 0 || !island.switches.isEmpty() || lessons >= MOST_LESSONS) {
            return false;
        }
        if (Slack.error(island, state, Projection.ROUNDING) > CLOSED) {
            return false;
        }
        if (isKnown) {
            pivots.forgetRedundant();
            lasting = 0;
            return true;
        }
        double speed = keep(state);
        if (speed == 0) {
            return false;
        }
        lessons++;
        int before = go(state, solver, -WAY / speed) ? redundant(state) : 0;
        int after = before > 0 && go(state, solver, WAY / speed) ? redundant(state) : 0;
        if (after > 0 && after == before) {
            pivots.keepRedundant();
            if (isImplied(state, solver)) {
                lasting = after;
            } else {
                pivots.forgetRedundant();
            }
        }
        restore(state);
        island.evaluate(state);
        return true;
    }

    /**
     * Whether rows that are set aside stay closed wherever the others let the island go, and not only on its way: a rod along two bars in
     * a line, with a pin between them, depends on that pin wherever they fly, but it alone keeps them from bending.
     */
    private boolean isImplied(State state, DirectSolver solver) {
        restore(state);
        island.evaluate(state);
        for (int k = 0; k < along.length; k++) {
            double uneven = (k + 1) * 0.6180339887498949 % 1 - 0.5;
            u[slot(k)] = k % State.BLOCK == State.THETA ? uneven : uneven * island.leastSize;
        }
        solver.prepare(island, state.w().values());
        solver.correct(island, state.w().values(), u, null);
        double speed = keep(u, along);
        return !(speed > Projection.SMOOTH) || staysClosed(state, solver, WAY / speed) && staysClosed(state, solver, -WAY / speed);
    }

    private boolean staysClosed(State state, DirectSolver solver, double time) {
        return go(state, solver, time) && Slack.error(island, state, Projection.ROUNDING) <= CLOSED;
    }

    /** Forgets for good which rows are set aside, as one of them has opened; false if there is none. */
    boolean unlearns() {
        boolean any = island.factor.pivots.lasting() > 0;
        if (any) {
            island.factor.pivots.forgetRedundant();
            lasting = 0;
            lessons = MOST_LESSONS;
        }
        return any;
    }

    /** Whether the island is where it was before it went. */
    private boolean isBack(State state) {
        double moved = 0;
        for (int k = 0; k < x.length; k++) {
            double way = Math.abs(state.x()[slot(k)] - x[k]);
            moved = Math.max(moved, k % State.BLOCK == State.THETA ? way : way / island.leastSize);
        }
        return moved < 0.5 * WAY;
    }

    /** The redundant rows of a pose on the way; 0 if that is the pose of before. */
    private int redundant(State state) {
        if (isBack(state)) {
            return 0;
        }
        island.factor(state.w().values(), 0, Pivots.NOISE, false);
        return island.redundant();
    }

    /**
     * Whether the island is a structure that can move to first order only, as two rods in a line between two supports. Its
     * rows allow one motion, and leave none a little way along it: then it stands.
     *
     * @param a accelerations
     */
    boolean stands(State state, DirectSolver solver, double[] a) {
        if (stands || examinations >= MOST_LESSONS || !island.switches.isEmpty() || freedoms(island.redundantRows) != 1) {
            return stands;
        }
        double speed = keep(state);
        speed = speed > 0 ? speed : keep(a, along);
        if (speed == 0 || Slack.error(island, state, Projection.ROUNDING) > NEARLY_CLOSED) {
            return false;
        }
        examinations++;
        double allowed = allowed(state, solver, speed);
        if (allowed < 0.1) {
            return false; // the forces do not drive it, and these are their rounding errors
        }
        double time = WAY / (allowed * speed);
        stands = true;
        for (int side = -1; side <= 1; side += 2) {
            stands &= go(state, solver, side * time) && isBack(state);
        }
        restore(state);
        island.evaluate(state);
        solver.prepare(island, state.w().values());
        place = stands ? x.clone() : place;
        return stands;
    }

    /** Directions in which the bodies can move to first order, where so many of the rows that act depend on others. */
    private int freedoms(int redundant) {
        int rows = -island.switches.released();
        for (Constraint k : island.constraints) {
            rows += k.getRows();
        }
        return State.BLOCK * island.bodies.size - rows + redundant;
    }

    /** Makes the direction one that the rows allow; returns how much of it is left. */
    private double allowed(State state, DirectSolver solver, double speed) {
        for (int k = 0; k < along.length; k++) {
            u[slot(k)] = along[k];
        }
        solver.prepare(island, state.w().values());
        solver.correct(island, state.w().values(), u, null);
        return keep(u, along) / speed;
    }

    /** Whether the island was found to stand; if so, puts it where it does. */
    boolean putBack(State state) {
        for (int k = 0; stands && k < place.length; k++) {
            state.x()[slot(k)] = place[k];
            state.v()[slot(k)] = 0;
        }
        return stands;
    }

    /** Forgets what was found: bodies were moved. */
    void forget() {
        stands = false;
        isBeside = false;
        isMet = false;
        examinations = 0;
        creep.forget();
    }

    /** Goes a time along the velocities, and back onto the constraints; false if that fails. */
    private boolean go(State state, DirectSolver solver, double time) {
        restore(state);
        for (int k = 0; k < x.length; k++) {
            state.x()[slot(k)] += time * along[k];
        }
        if (!projection.project(island, state, solver, false)) {
            return false;
        }
        island.evaluate(state);
        solver.prepare(island, state.w().values());
        return true;
    }

    /**
     * Finds the accelerations from both sides. Where the other rows leave no motion, as where every hinge of a bridge is braked, there is no
     * way to go, and accelerations are known without: to look for them along the rounding of velocities cost seconds.
     *
     * @param state positions and velocities; put back
     * @param a accelerations without those of the constraints, and with them afterwards
     * @return false if there are none: the island is at rest, or its rows depend on one another along its way
     */
    boolean accelerate(State state, DirectSolver solver, double[] a) {
        int near = island.near();
        if (!island.switches.isEmpty() && freedoms(near) <= 0) {
            lasting = near;
            return false;
        }
        double speed = keep(state);
        boolean found = false;
        double time = WAY / speed;
        for (int k = 0; k < LENGTHENINGS && speed > 0 && !found; k++, time *= 2) {
            Arrays.fill(mean, 0);
            Arrays.fill(change, 0);
            Arrays.fill(lambda, 0);
            found = true;
            for (int way = 1; way <= WEIGHTS.length && found; way++) {
                found = look(state, solver, a, way, time) && look(state, solver, a, way, -time);
            }
        }
        boolean isSmooth = found && isSmooth();
        restore(state);
        island.evaluate(state);
        // that the velocities can be projected, as after a step
        island.isProjected = isSmooth;
        solver.prepare(island, state.w().values());
        island.isProjected = false;
        lasting = found ? lasting : near;
        if (!isSmooth) {
            return false;
        }
        System.arraycopy(lambda, 0, island.lambda, 0, lambda.length);
        for (int k = 0; k < mean.length; k++) {
            a[slot(k)] = mean[k];
        }
        return true;
    }

    private boolean isSmooth() {
        double most = 0;
        double mostChange = 0;
        for (int k = 0; k < mean.length; k++) {
            double unit = k % State.BLOCK == State.THETA ? island.leastSize : 1;
            most = Math.max(most, unit * Math.abs(mean[k]));
            mostChange = Math.max(mostChange, unit * Math.abs(change[k]));
        }
        return mostChange <= SMOOTH * most;
    }

    /** Adds the accelerations at a pose on the way to the mean; false if that is singular, too. */
    private boolean look(State state, DirectSolver solver, double[] a, int way, double time) {
        if (!go(state, solver, way * time) || island.near() > lasting) {
            return false;
        }
        double[] w = state.w().values();
        for (int k = 0; k < mean.length; k++) {
            u[slot(k)] = a[slot(k)];
        }
        solver.correct(island, w, u, island.rate);
        double weight = 0.5 * WEIGHTS[way - 1];
        for (int k = 0; k < mean.length; k++) {
            mean[k] += weight * u[slot(k)];
            change[k] += way == 1 ? 0.5 * u[slot(k)] : way == 2 ? -0.5 * u[slot(k)] : 0;
        }
        for (int k = 0; k < lambda.length; k++) {
            lambda[k] += weight * island.lambda[k];
        }
        return true;
    }

    /** Where the island's k-th coordinate is in the state vectors. */
    private int slot(int k) {
        return State.BLOCK * island.bodies.values[k / State.BLOCK] + k % State.BLOCK;
    }

    /** Keeps positions and velocities; returns the speed, in rad or relative to the size of the bodies. */
    private double keep(State state) {
        int n = State.BLOCK * island.bodies.size;
        if (mean.length == 0) {
            projection = new Projection(true);
            x = new double[n];
            v = new double[n];
            along = new double[n];
            mean = new double[n];
            change = new double[n];
            lambda = new double[island.lambda.length];
        }
        if (u.length < state.x().length) {
            u = new double[state.x().length];
        }
        for (int k = 0; k < n; k++) {
            x[k] = state.x()[slot(k)];
        }
        keep(state.v(), v);
        return keep(state.v(), along);
    }

    /** Keeps the island's part of a vector; returns its size, in rad or relative to the size of the bodies. */
    private double keep(double[] from, double[] to) {
        double most = 0;
        for (int k = 0; k < to.length; k++) {
            to[k] = from[slot(k)];
            most = Math.max(most, Math.abs(to[k]) / (k % State.BLOCK == State.THETA ? 1 : island.leastSize));
        }
        return most;
    }

    private void restore(State state) {
        put(state, x, v);
    }

    private void put(State state, double[] positions, double[] velocities) {
        for (int k = 0; k < positions.length; k++) {
            int s = slot(k);
            state.x()[s] = positions[k];
            state.v()[s] = velocities[k];
        }
    }
}
