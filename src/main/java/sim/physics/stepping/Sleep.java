// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import java.util.Arrays;
import java.util.List;
import sim.physics.collision.broad.Pairs;
import sim.physics.constraint.Constraints;
import sim.physics.constraint.TieRows;
import sim.physics.internal.DisjointSets;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.State;
import sim.physics.motion.SteppedForces;

/**
 * Which bodies are asleep: islands of what touches, is tied together or pulls at one another, fixed bodies apart, all of whose bodies have
 * stayed where they are for as long as they would take to fall by two of their radii. They have no velocity, and are neither searched nor
 * solved nor integrated, until something comes near one of them, or one of them is written.
 *
 * <p>What is near is of the island, too, though it does not touch: so whatever a step would solve with a body sleeps and wakes with
 * it, and a step in which an island wakes has the rows that it would have had if none had slept.
 */
public final class Sleep implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Way of a body at rest, and its speed by that of a fall by its radius: rocking stacks are slower than that long before they stand. */
    private static final double WAY = 2e-3;

    private static final double SPEED = 0.02;

    /**
     * The time is that of three windows, since the first one may be one of settling. By how much the way in a window may be more than in all
     * others before, but the first one: what creeps or trembles soon has gone as far as it ever does, what tips over goes twice as far each
     * time. And the way, relative to the radius, that is too short to say.
     */
    private static final int WINDOWS = 3;

    private static final double GROWTH = 1.5;
    private static final double NOISE = 1e-6;

    /** The least number of steps of a window; and of those between looks for islands. */
    private static final int LEAST = 3;

    private static final int EVERY = 8;

    private final State state;
    private final Poses poses;
    private final NearPairs near;
    private final SteppedForces forces;

    /** The rows of the last step, and those of what sleeps. */
    private final ContactRows rows;

    private final ContactRows kept;

    private boolean isAllowed = true;
    private boolean[] asleep = {};

    /** The next body of a sleeper's island, in a ring. */
    private int[] next = {};

    /** The steps of a body's window, where it began, how many windows are over, and the longest way in one but the first. */
    private int[] calm = {};

    private double[] places = {};
    private int[] windows = {};
    private double[] ways = {};

    /** By body: the acceleration against which friction with the plane holds it, and its radius. */
    private double[] plane = {};

    private double[] sizes = {};

    /** Those that were slow when all were looked at; others are looked at every few steps only. */
    private final IntList slow = new IntList();

    private int turn;

    /** Whether some body has rested for long enough. */
    private boolean isAnyRipe;

    /** By body: the one by which its island is known, and whether that must not sleep. */
    private int[] parent = {};

    private boolean[] isRestless = {};

    /** Whether bodies have come, gone, woken or fallen asleep since the list of those that are awake was made. */
    private boolean isStale;

    /** Whether some have woken since somebody asked; and whether some have woken or fallen asleep. */
    private boolean hasWoken;

    private boolean isOther;

    /** Whether the rows are those of a step that was solved. */
    private boolean isSolved;

    private int steps;
    private final IntList found = new IntList();

    Sleep(State state, Poses poses, NearPairs near, SteppedForces forces, ContactRows rows) {
        this.state = state;
        this.poses = poses;
        this.near = near;
        this.forces = forces;
        this.rows = rows;
        kept = new ContactRows(state);
    }

    /**
     * Sets whether bodies may sleep.
     *
     * @param allowed false to wake all
     */
    public void setAllowed(boolean allowed) {
        isAllowed = allowed;
        if (!allowed) {
            wakeAll();
        }
    }

    /**
     * Whether a body is asleep.
     *
     * @param body index
     * @return false also for fixed ones
     */
    public boolean isAsleep(int body) {
        return body < asleep.length && asleep[body];
    }

    /** Wakes all bodies. */
    public void wakeAll() {
        for (int k = 0; k < poses.movable.size; k++) {
            wake(poses.movable.values[k]);
        }
    }

    /** What the sleeping bodies bear. */
    ContactRows kept() {
        return kept;
    }

    /** Takes note that a body is new, or before it gets another box that it was written. */
    void admit(int index, boolean isNew) {
        ensure(index + 1);
        Body body = state.body(index);
        isStale |= isNew || state.touched().isTurned(index);
        if (body.isImmobile()) {
            if (!isNew) {
                wakeAround(index);
            }
            for (int k = 0; k < poses.movable.size && forces.areUneven(); k++) {
                int other = poses.movable.values[k];
                if (asleep[other] && forces.feels(other, body)) {
                    wake(other);
                }
            }
        } else {
            plane[index] = forces.hold(body);
            sizes[index] = poses.hull(index).bounding;
            wake(index);
        }
    }

    private void ensure(int bodies) {
        if (asleep.length < bodies) {
            int length = Growth.length(asleep.length, bodies);
            asleep = Arrays.copyOf(asleep, length);
            next = Arrays.copyOf(next, length);
            calm = Arrays.copyOf(calm, length);
            places = Arrays.copyOf(places, State.BLOCK * length);
            windows = Arrays.copyOf(windows, length);
            ways = Arrays.copyOf(ways, length);
            plane = Arrays.copyOf(plane, length);
            sizes = Arrays.copyOf(sizes, length);
            parent = Arrays.copyOf(parent, length);
            isRestless = Arrays.copyOf(isRestless, length);
        }
    }

    /** Takes note that a body is about to be removed. */
    void remove(int body) {
        wakeAround(body);
        if (!state.body(body).isImmobile()) {
            wake(body);
        }
        isStale = true;
    }

    private void wakeAround(int body) {
        Pairs pairs = near.pairs();
        for (int k = 0; k < pairs.countOf(body); k++) {
            int pair = pairs.of(body, k);
            int other = pairs.other(pair, body);
            if (isMovable(other) && !near.is(pair, NearPairs.FORBIDDEN)) {
                wake(other);
            }
        }
    }

    private boolean isMovable(int body) {
        return state.w().values()[State.BLOCK * body] > 0;
    }

    /** Wakes a movable body with its island; one that is awake is not at rest, as far as one knows. */
    private void wake(int body) {
        stir(body);
        for (int k = body; asleep[k]; k = next[k]) {
            asleep[k] = false;
            stir(k);
            near.revive(k);
            isStale = true;
            isOther = true;
            hasWoken = true;
        }
    }

    /** A body is not at rest, as far as one knows. */
    private void stir(int body) {
        calm[body] = 0;
        windows[body] = 0;
    }

    /** Wakes the two bodies of a pair that are near one another; false if both are awake, or fixed. */
    boolean wakes(int first, int second) {
        boolean is = asleep[first] || asleep[second];
        if (is && isMovable(first)) {
            wake(first);
        }
        if (is && isMovable(second)) {
            wake(second);
        }
        return is;
    }

    /**
     * Wakes the bodies of motors that were set: that is noted nowhere.
     *
     * @param ties rows of all constraints
     */
    void wakeDriven(TieRows ties) {
        ties.findSet(found);
        for (int k = 0; k < found.size; k++) {
            if (isMovable(found.values[k])) {
                wake(found.values[k]);
            }
        }
    }

    /** Whether a pair has no body that moves: nothing will happen to it before one wakes. */
    boolean isIdle(int first, int second) {
        return (asleep[first] || !isMovable(first)) && (asleep[second] || !isMovable(second));
    }

    /** Whether some have woken since the last call. */
    boolean hasWoken() {
        boolean has = hasWoken;
        hasWoken = false;
        return has;
    }

    /** Notes which bodies are awake; true if some have woken or fallen asleep since the last call. */
    boolean refresh() {
        boolean was = isOther;
        isOther = false;
        if (isStale) {
            isStale = false;
            poses.awake.clear();
            for (int k = 0; k < poses.movable.size; k++) {
                if (!asleep[poses.movable.values[k]]) {
                    poses.awake.add(poses.movable.values[k]);
                }
            }
            kept.keepOf(asleep);
            keepSlow();
        }
        return was;
    }

    /** Leaves those among the slow ones that are there and awake. */
    private void keepSlow() {
        int count = 0;
        for (int k = 0; k < slow.size; k++) {
            int body = slow.values[k];
            slow.values[count] = body;
            count += poses.knows(body) && isMovable(body) && !asleep[body] ? 1 : 0;
        }
        slow.size = count;
    }

    /** Which bodies are asleep, by index. */
    boolean[] asleep() {
        return asleep;
    }

    /**
     * Looks, when a step is over, which bodies have stayed where they were.
     *
     * @param h step
     * @param a accelerations of the forces
     */
    void watch(double h, double[] a) {
        isSolved = true;
        isAnyRipe = false;
        if (!isAllowed) {
            return;
        }
        boolean isTurn = turn % EVERY == 0;
        turn++;
        IntList those = isTurn ? poses.awake : slow;
        int n = those.size;
        if (isTurn) {
            slow.clear();
        }
        double even = forces.evenPull();
        boolean isUneven = forces.areUneven();
        for (int k = 0; k < n; k++) {
            int body = those.values[k];
            double pull = Math.max(even, plane[body]);
            if (isUneven) {
                double x = a[State.BLOCK * body];
                double y = a[State.BLOCK * body + 1];
                pull = Math.max(pull, Math.sqrt(x * x + y * y));
            }
            double size = sizes[body];
            if (isFast(State.BLOCK * body, size, pull)) {
                stir(body);
            } else {
                watch(body, size, pull, h);
                if (isTurn) {
                    slow.add(body);
                }
            }
        }
    }

    private boolean isFast(int b, double size, double pull) {
        double[] v = state.v();
        double spin = v[b + 2] * size;
        return v[b] * v[b] + v[b + 1] * v[b + 1] + spin * spin > SPEED * SPEED * pull * size;
    }

    /** Looks how far a slow body has gone, in which time. */
    private void watch(int body, double size, double pull, double h) {
        double[] x = state.x();
        int b = State.BLOCK * body;
        boolean isNew = calm[body] == 0;
        double way = Math.abs(x[b] - places[b]) + Math.abs(x[b + 1] - places[b + 1]) + Math.abs(x[b + 2] - places[b + 2]) * size;
        double most = WAY * size / WINDOWS;
        double time = WINDOWS * calm[body] * h;
        boolean isOver = calm[body] >= LEAST && (time * time * pull >= 4 * size || pull == 0); // as g t²/2 = 2 r
        if (isNew || isOver || way > most) {
            boolean grows = windows[body] >= 2 && way > GROWTH * ways[body] && way > NOISE * size;
            ways[body] = windows[body] >= 2 ? Math.max(ways[body], way) : way;
            windows[body] = isNew || way > most ? 0 : grows ? 2 : Math.min(WINDOWS, windows[body] + 1);
            System.arraycopy(x, b, places, b, State.BLOCK);
            calm[body] = 0;
        }
        calm[body]++;
        isAnyRipe |= windows[body] == WINDOWS;
    }

    /**
     * Lets islands fall asleep that have rested for long enough in the steps so far; their boxes and turns are those of now.
     *
     * @param constraints null for none
     * @param ties their rows
     */
    void settle(Constraints constraints, TieRows ties) {
        steps += isSolved ? 1 : 0; // all steps count, whatever goes on elsewhere
        boolean isDue = isSolved && steps % EVERY == 0;
        isSolved = false;
        if (isDue && isAnyRipe) {
            join(constraints, ties);
            fallAsleep();
        }
    }

    /** Finds the islands of those that are awake, and which of them must not sleep. */
    private void join(Constraints constraints, TieRows ties) {
        IntList awake = poses.awake;
        for (int k = 0; k < awake.size; k++) {
            parent[awake.values[k]] = awake.values[k];
            isRestless[awake.values[k]] = false;
        }
        for (int k = 0; k < rows.count; k++) {
            join(rows.first(k), rows.second(k));
            drive(k);
        }
        for (int k = 0; constraints != null && k < awake.size; k++) {
            if (constraints.isTied(awake.values[k])) {
                join(awake.values[k], constraints.island(awake.values[k]).values[0]);
            }
        }
        for (int k = 0; k < forces.couplings(); k++) {
            join(forces.coupled(k));
        }
        ties.markDriven(isRestless);
        for (int k = 0; k < awake.size; k++) {
            int body = awake.values[k];
            if (windows[body] < WINDOWS || isRestless[body] || forces.mayChange(body)) {
                isRestless[DisjointSets.find(parent, body)] = true;
            }
        }
    }

    /** What a moving surface drives does not sleep, however slow that is. */
    private void drive(int k) {
        boolean is = rows.isDriven(k) && rows.impulse(k) > 0;
        isRestless[rows.first(k)] |= is && isMovable(rows.first(k));
        isRestless[rows.second(k)] |= is && isMovable(rows.second(k));
    }

    private void join(int a, int b) {
        boolean areThere = poses.knows(a) && poses.knows(b); // or they were removed since
        if (areThere && isMovable(a) && isMovable(b) && !asleep[a] && !asleep[b]) {
            DisjointSets.join(parent, a, b);
        }
    }

    private void join(List<Body> bodies) {
        int first = -1;
        for (int k = 0; bodies != null && k < bodies.size(); k++) {
            Body body = bodies.get(k);
            if (body.state() == state && !body.isImmobile()) {
                first = first < 0 ? body.index() : first;
                join(first, body.index());
            }
        }
    }

    private void fallAsleep() {
        double[] v = state.v();
        for (int k = 0; k < poses.awake.size; k++) {
            int body = poses.awake.values[k];
            int root = DisjointSets.find(parent, body);
            if (!isRestless[root]) {
                asleep[body] = true; // a root is the least of its island, and comes first
                next[body] = body == root ? root : next[root];
                next[root] = body;
                Arrays.fill(v, State.BLOCK * body, State.BLOCK * body + State.BLOCK, 0);
                isStale = true;
                isOther = true;
            }
        }
        for (int k = 0; isStale && k < rows.count; k++) {
            if (rows.impulse(k) > 0 && (asleep[rows.first(k)] || asleep[rows.second(k)])) {
                kept.copy(rows, k);
            }
        }
        for (int k = 0; isStale && k < poses.awake.size; k++) {
            if (asleep[poses.awake.values[k]]) {
                rest(poses.awake.values[k]);
            }
        }
    }

    /** Nothing will happen to pairs of a body without a partner that moves. */
    private void rest(int body) {
        Pairs pairs = near.pairs();
        for (int k = 0; k < pairs.countOf(body); k++) {
            int pair = pairs.of(body, k);
            if (isIdle(body, pairs.other(pair, body))) {
                near.leave(pair);
            }
        }
    }
}
