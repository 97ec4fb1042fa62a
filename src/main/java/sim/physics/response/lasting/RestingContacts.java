// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.CollisionDetection;
import sim.physics.collision.broad.Pairs;
import sim.physics.collision.narrow.Manifold;
import sim.physics.internal.IntList;
import sim.physics.motion.Motion;
import sim.physics.motion.State;
import sim.physics.motion.Trajectories;

/**
 * Bodies at rest on fixed ones: where bounces have become too short to matter, a body presses on what bears it by forces from
 * then on, and sticks, slides or rolls by Coulomb's law of friction. The forces are found anew when something happens to the
 * body, when it stops sliding, and at each step in which it moves; one that stands still costs nothing.
 *
 * <p>Bodies that pairs at rest connect form a cluster that is solved as one. So far the collision response lets a body rest
 * on one fixed body only, or on several of the same normal.
 */
public final class RestingContacts implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Gap at which bodies at rest have parted, relative to the smaller one. */
    private static final double PARTED = 1e-6;

    /** Gap that is closed, relative to the smaller body. */
    private static final double OPEN = 1e-14;

    /** Speed that is none, relative to that which the forces give in a step. */
    private static final double STILL = 1e-7;

    /** Acceleration that is none, relative to that of the forces. */
    private static final double BORNE = 1e-9;

    /** Way of the points on one another, relative to the smaller body, after which forces are found anew where they may change. */
    private static final double PACE = 0.02;

    /** Time after which they are not, relative to the step. */
    private static final double SHORTEST = 1.0 / 256;

    private final State state;
    private final Trajectories trajectories;
    private final Motion motion;
    private final CollisionDetection detection;
    private final ContactPoints points;
    private final ContactLedger ledger;
    private final ContactSystem system = new ContactSystem();
    private final EvenGround ground = new EvenGround();
    private final FlushGround flush;

    /** Bodies that rest on something, with their clusters to be solved, and at a standstill; by body. */
    private boolean[] rests = new boolean[8];

    private boolean[] isDirty = new boolean[8];
    private boolean[] isStill = new boolean[8];
    private final IntList resting = new IntList();
    private final IntList dirty = new IntList();

    /** Pairs that have come to rest since clusters were solved last. */
    private final IntList fresh = new IntList();

    /** The cluster that is being solved, and each body's number in it, plus 1. */
    private final IntList cluster = new IntList();

    private int[] place = new int[8];
    /** Where the points come from: two numbers for each pair. */
    private final IntList origin = new IntList();

    private final IntList changed = new IntList();
    private final ContactPoint point = new ContactPoint();
    private transient Manifold manifold;
    private double scale;
    private double size;
    private double worstGap;
    private double pace;
    private final double[] fall = new double[State.BLOCK];

    /**
     * Makes the resting contacts of an engine, none at first.
     *
     * @param state the state vectors
     * @param trajectories the motion of the bodies
     * @param motion says what forces give the bodies, and takes what contacts give them
     * @param detection where the pairs come from
     * @param points loads the points at which they touch
     * @param ledger where it is noted what the points bear
     */
    public RestingContacts(
            State state,
            Trajectories trajectories,
            Motion motion,
            CollisionDetection detection,
            ContactPoints points,
            ContactLedger ledger) {
        this.state = state;
        this.trajectories = trajectories;
        this.motion = motion;
        this.detection = detection;
        this.points = points;
        this.ledger = ledger;
        flush = new FlushGround(state, trajectories, detection);
    }

    /**
     * Whether nothing rests on anything.
     *
     * @return true if there is nothing to do
     */
    public boolean isEmpty() {
        return resting.size == 0;
    }

    /**
     * Whether a body rests on something.
     *
     * @param body index
     * @return false for fixed bodies
     */
    public boolean rests(int body) {
        return body < rests.length && rests[body];
    }

    /**
     * Whether a body lies on several fixed ones, as on tiles in a row, so that it may rest on each of them.
     *
     * @param body index
     * @param tau offset in the present step
     * @return false if it touches anything else
     */
    public boolean isShared(int body, double tau) {
        return flush.isShared(body, tau);
    }

    /**
     * Bodies that rest.
     *
     * @return live; some may not rest any more
     */
    public IntList members() {
        return resting;
    }

    /**
     * Lets the bodies of a pair rest on one another.
     *
     * @param pair number of the pair
     */
    public void add(int pair) {
        detection.hold(pair, true);
        ledger.begin(pair, false);
        fresh.add(pair);
        note(detection.pairs().first(pair));
        note(detection.pairs().second(pair));
    }

    private void note(int body) {
        if (body >= rests.length) {
            int n = Math.max(2 * rests.length, body + 1);
            rests = Arrays.copyOf(rests, n);
            isDirty = Arrays.copyOf(isDirty, n);
            isStill = Arrays.copyOf(isStill, n);
            place = Arrays.copyOf(place, n);
        }
        if (state.body(body).isImmobile()) {
            return;
        }
        if (!rests[body]) {
            rests[body] = true;
            resting.add(body);
        }
        mark(body);
    }

    private void mark(int body) {
        isStill[body] = false;
        if (!isDirty[body]) {
            isDirty[body] = true;
            dirty.add(body);
        }
    }

    /** Marks the clusters that move, at the start of a step. */
    public void begin() {
        int kept = 0;
        for (int k = 0; k < resting.size; k++) {
            int body = resting.values[k];
            if (!rests[body] || state.body(body) == null) {
                rests[body] = false;
                continue;
            }
            resting.values[kept++] = body;
            if (!isStill[body]) {
                mark(body);
            }
        }
        resting.size = kept;
    }

    /**
     * Takes note that a body was struck: its cluster is to be solved, and contacts that bounce are let go of.
     *
     * @param body index
     */
    public void struck(int body) {
        if (!rests(body)) {
            return;
        }
        for (int k = 0; k < detection.pairs().countOf(body); k++) {
            int pair = detection.pairs().of(body, k);
            if (detection.marks().isHeld(pair) && !fresh.contains(pair)) {
                release(pair);
            }
        }
        mark(body);
    }

    /**
     * Asks for new forces on a body at rest.
     *
     * @param body index
     */
    public void again(int body) {
        mark(body);
    }

    /** The acceleration that all but the contacts give to a body. */
    private double fall(int body) {
        motion.fall(body, fall, 0);
        return Math.sqrt(fall[0] * fall[0] + fall[1] * fall[1]);
    }

    private void release(int pair) {
        detection.hold(pair, false);
        ledger.leave(pair, detection.marks().isLasting(pair));
        for (int side = 0; side < 2; side++) {
            int body = side == 0 ? detection.pairs().first(pair) : detection.pairs().second(pair);
            if (rests(body)) {
                mark(body);
            }
        }
    }

    /**
     * Lets go of all that a body rests on, because it was written or leaves.
     *
     * @param body index
     */
    public void forget(int body) {
        if (!rests(body) && !state.body(body).isImmobile()) {
            return;
        }
        Pairs pairs = detection.pairs();
        for (int k = 0; detection.knows(body) && k < pairs.countOf(body); k++) {
            if (detection.marks().isHeld(pairs.of(body, k))) {
                release(pairs.of(body, k));
            }
        }
        if (body < rests.length) {
            rests[body] = false;
        }
    }

    /**
     * Solves the clusters in which something has happened.
     *
     * @param tau offset in the present step
     * @return the bodies whose courses have changed, which the detection must be told of
     */
    public IntList settle(double tau) {
        changed.clear();
        for (int k = 0; k < dirty.size; k++) {
            int body = dirty.values[k];
            if (isDirty[body] && state.body(body) != null && rests[body] && !trajectories.isDriven(body)) {
                gather(body);
                settleCluster(tau);
            }
            isDirty[body] = false;
        }
        dirty.clear();
        fresh.clear();
        return changed;
    }

    /** Finds the bodies that rest on one another with a body. */
    private void gather(int seed) {
        cluster.clear();
        enter(seed);
        for (int k = 0; k < cluster.size; k++) {
            for (int m = 0; m < detection.pairs().countOf(cluster.values[k]); m++) {
                int pair = detection.pairs().of(cluster.values[k], m);
                int other = detection.pairs().other(pair, cluster.values[k]);
                if (detection.marks().isHeld(pair) && !state.body(other).isImmobile() && place[other] == 0) {
                    enter(other);
                }
            }
        }
    }

    private void enter(int body) {
        cluster.add(body);
        place[body] = cluster.size;
        isDirty[body] = false;
    }

    private void settleCluster(double tau) {
        for (int k = 0; k < cluster.size; k++) {
            trajectories.bring(cluster.values[k], tau);
            detection.unplan(cluster.values[k]);
        }
        if (cluster.size == 1) {
            flush.hold(cluster.values[0], tau, ledger);
        }
        collect(tau);
        double none = STILL * scale * trajectories.h();
        if (worstGap > OPEN * size) {
            loadVelocities();
            system.noteParting(none);
            close();
            collect(tau);
        }
        if (system.size() == 0) {
            part();
            return;
        }
        loadVelocities();
        double[] d = trajectories.data();
        system.stop(none);
        for (int p = 0; p < system.size(); p++) {
            ledger.strike(origin.values[p] / 2, origin.values[p] % 2, system.normalForce(p), system.tangentForce(p));
        }
        boolean still = speed() <= none;
        for (int k = 0; k < cluster.size; k++) {
            System.arraycopy(system.u, 3 * k, d, cluster.values[k] * Trajectories.STRIDE + Trajectories.VX, 3);
        }
        system.noteParting(none);
        pace = PACE * size / Math.max(system.noteSliding(none), spin());
        ground.move(system.u[0], system.u[1]);
        for (int k = 0; k < cluster.size; k++) {
            motion.fall(cluster.values[k], system.u, 3 * k);
        }
        system.press();
        pace = Math.max(pace, ground.time(system.u[0], system.u[1], size));
        for (int p = 0; p < system.size(); p++) {
            ledger.press(origin.values[p] / 2, origin.values[p] % 2, system.normalForce(p), system.tangentForce(p));
        }
        still &= speed() <= BORNE * scale;
        publish(still, tau);
    }

    private void loadVelocities() {
        double[] d = trajectories.data();
        for (int k = 0; k < cluster.size; k++) {
            System.arraycopy(d, cluster.values[k] * Trajectories.STRIDE + Trajectories.VX, system.u, 3 * k, 3);
        }
    }

    /** The bodies of the cluster touch nothing any more. */
    private void part() {
        for (int k = 0; k < cluster.size; k++) {
            int body = cluster.values[k];
            place[body] = 0;
            rests[body] = false;
            motion.support(body, 0, 0, 0);
            changed.add(body);
        }
    }

    /** Sets the courses of the cluster's bodies. */
    private void publish(boolean still, double tau) {
        double[] d = trajectories.data();
        double next = Math.max(trajectories.h() * SHORTEST, Math.min(pace, system.untilTouch()));
        next = Math.min(next, Math.max(trajectories.h() * STILL, system.untilStop()));
        double stop = still ? Double.POSITIVE_INFINITY : tau + next;
        for (int k = 0; k < cluster.size; k++) {
            int body = cluster.values[k];
            place[body] = 0;
            isStill[body] = still;
            if (still) {
                Arrays.fill(d, body * Trajectories.STRIDE + Trajectories.VX, body * Trajectories.STRIDE + Trajectories.STEP, 0);
                Arrays.fill(system.u, 3 * k, 3 * k + 3, 0);
            }
            motion.fall(body, fall, 0);
            motion.support(
                    body, system.u[3 * k] - fall[0], system.u[3 * k + 1] - fall[1], system.u[3 * k + 2] - fall[2]);
            if (still) {
                trajectories.accelerate(body, 0, 0, 0);
            }
            changed.add(body);
        }
        if (stop < trajectories.h()) {
            detection.plan(cluster.values[0], stop);
        }
    }

    /** The largest speed of a rim. */
    private double spin() {
        double most = 0;
        for (int k = 0; k < cluster.size; k++) {
            most = Math.max(most, trajectories.radius(cluster.values[k]) * Math.abs(system.u[3 * k + 2]));
        }
        return most;
    }

    /** The largest value of u, of rims for rotations. */
    private double speed() {
        double most = 0;
        for (int k = 0; k < cluster.size; k++) {
            most = Math.max(most, Math.max(Math.abs(system.u[3 * k]), Math.abs(system.u[3 * k + 1])));
        }
        return Math.max(most, spin());
    }

    /** Moves the bodies so that their gaps are closed. */
    private void close() {
        Arrays.fill(system.u, 0, 3 * cluster.size, 0);
        system.close();
        double[] d = trajectories.data();
        for (int k = 0; k < cluster.size; k++) {
            for (int c = 0; c < State.BLOCK; c++) {
                d[cluster.values[k] * Trajectories.STRIDE + c] += system.u[3 * k + c];
            }
        }
    }

    /** Finds the points at which the bodies of the cluster touch, and lets go of pairs that have parted. */
    private void collect(double tau) {
        system.clear(cluster.size);
        origin.clear();
        scale = 0;
        worstGap = 0;
        size = Double.POSITIVE_INFINITY;
        ground.begin(cluster.size);
        for (int k = 0; k < cluster.size; k++) {
            int body = cluster.values[k];
            system.w[2 * k] = state.w().values()[State.BLOCK * body];
            system.w[2 * k + 1] = state.w().values()[State.BLOCK * body + State.THETA];
            scale = Math.max(scale, fall(body));
            size = Math.min(size, trajectories.radius(body));
        }
        collect(tau, false);
        collect(tau, true);
    }

    /** Takes in the points that touch, or those near them that do not yet. */
    private void collect(double tau, boolean near) {
        for (int k = 0; k < cluster.size; k++) {
            for (int m = 0; m < detection.pairs().countOf(cluster.values[k]); m++) {
                int pair = detection.pairs().of(cluster.values[k], m);
                int other = detection.pairs().other(pair, cluster.values[k]);
                if (detection.marks().isHeld(pair) && (state.body(other).isImmobile() || place[other] > k + 1)) {
                    collect(pair, tau, near);
                }
            }
        }
    }

    /** The radius of a body that can move; one that cannot is brought to where it is. */
    private double reach(int body, double tau) {
        if (!state.body(body).isImmobile()) {
            return trajectories.radius(body);
        }
        trajectories.bring(body, tau);
        return Double.POSITIVE_INFINITY;
    }

    private void collect(int pair, double tau, boolean near) {
        int a = detection.pairs().first(pair);
        int b = detection.pairs().second(pair);
        manifold = manifold == null ? new Manifold() : manifold;
        detection.narrowPhase().contact(pair, tau, manifold, PARTED);
        double radius = Math.min(reach(a, tau), reach(b, tau));
        for (int k = manifold.count; near && k < manifold.count + manifold.near; k++) {
            points.load(manifold, pair, k, point);
            system.addNear(number(a), number(b), point, manifold.gaps[k]);
        }
        if (near) {
            return;
        }
        if (manifold.gap > PARTED * radius) {
            detection.hold(pair, false);
            ledger.leave(pair, tau);
            return;
        }
        ledger.open(pair, tau, manifold, !state.body(a).isImmobile());
        ground.add(manifold, !state.body(a).isImmobile());
        for (int k = 0; k < manifold.count; k++) {
            points.load(manifold, pair, k, point);
            origin.add(2 * pair + k);
            worstGap = Math.max(worstGap, Math.abs(manifold.gaps[k]));
            system.add(number(a), number(b), point, manifold.gaps[k], point.turning(manifold, k));
        }
    }

    private int number(int body) {
        return state.body(body).isImmobile() ? -1 : place[body] - 1;
    }
}
