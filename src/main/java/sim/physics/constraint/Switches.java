// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import sim.physics.motion.State;
import sim.physics.motion.SwitchedRow;
import sim.physics.motion.SwitchedTies;
import sim.physics.motion.Watched;

/** The motors and stops of an island: which of their rows act, and when that must be decided anew. */
final class Switches implements SwitchedTies {
    private static final long serialVersionUID = 1L;

    /** Times that all rows may change that are wrong, and then one of them. */
    private static final int ALL_AT_ONCE = 6;

    private static final int ONE_BY_ONE = 100;

    private final Island island;
    private final Switched[] rows;
    private final int[] nodes;
    private double[] free = {};
    final SwitchedWork work;

    /** The quick way, or null. */
    final Servos servos;

    private final Equations now = new Equations();
    private final NearRows near;

    /** Whether all push with forces that were found elsewhere. */
    private boolean isFrozen;

    /** The island without these, null if not made or if there is none; and whether that is known. */
    private Skeleton skeleton;

    private boolean isSkeletonKnown;

    /** Whether forces are kept within their bounds, and whether one that acts has been out of them. */
    private boolean isLimited = true;

    private boolean isOverloaded;

    private final StoppedMotors stopped;

    /** −(the speed that a row keeps), 2 per node of the island. */
    private final double[] bias;

    Switches(Island island, PinRows pins) {
        this.island = island;
        List<Switched> found = new ArrayList<>();
        List<Integer> at = new ArrayList<>();
        for (int k = 0; k < island.constraints.length; k++) {
            if (island.constraints[k] instanceof Switched s) {
                found.add(s);
                at.add(island.firstNode[k]);
            }
        }
        rows = found.toArray(new Switched[0]);
        nodes = at.stream().mapToInt(Integer::intValue).toArray();
        near = new NearRows(island, rows, nodes);
        servos = Servos.of(island, pins, rows, nodes);
        work = new SwitchedWork(island, rows, nodes);
        bias = new double[2 * island.nodes];
        stopped = new StoppedMotors(rows, nodes);
    }

    boolean isLimited() {
        return isLimited;
    }

    boolean isEmpty() {
        return rows.length == 0;
    }

    /** Whether there are none that act or push, as ropes that are slack. */
    boolean areIdle() {
        boolean yes = true;
        for (int k = 0; yes && k < rows.length; k++) {
            yes = !rows[k].isOn && rows[k].force == 0;
        }
        return yes;
    }

    @Override
    public int size() {
        return rows.length;
    }

    /** How many rows do not act at the stage at hand. */
    int released() {
        int count = 0;
        for (Switched s : rows) {
            count += s.isOnNow ? 0 : 1;
        }
        return count;
    }

    @Override
    public void read(int k, SwitchedRow row) {
        rows[k].describe(row, island.blockA[nodes[k]], island.blockB[nodes[k]]);
    }

    @Override
    public void readNow(int k, SwitchedRow row) {
        rows[k].describeNow(row, now, island.blockA[nodes[k]], island.blockB[nodes[k]]);
    }

    @Override
    public void freeze(int k, double force) {
        isFrozen = true;
        rows[k].isOn = false;
        rows[k].isOnNow = false;
        rows[k].yields = false;
        rows[k].force = force * rows[k].arm();
        rows[k].forceNow = rows[k].force;
    }

    /** Finds the coordinates where the bodies are now, and the rows if they depend on that. */
    void measure(State state) {
        if (servos == null) {
            island.evaluate(state);
            return;
        }
        for (int k = 0; k < rows.length; k++) {
            rows[k].measure(state.x(), island.blockA[nodes[k]], island.blockB[nodes[k]]);
        }
    }

    /** The island that is to be solved now: while these are frozen, that without them, if there is one. */
    Island active(State state) {
        if (!isFrozen) {
            return island;
        }
        if (!isSkeletonKnown) {
            skeleton = Skeleton.of(island, this, state);
            isSkeletonKnown = true;
        }
        return skeleton == null ? island : skeleton.island;
    }

    /** Adds what forces that are given do to accelerations. */
    void push(double[] w, double[] a) {
        for (int k = 0; k < rows.length; k++) {
            if (rows[k].force != 0) {
                rows[k].push(rows[k].force, w, a, island.blockA[nodes[k]], island.blockB[nodes[k]]);
            }
        }
    }

    /** Lets no row act and evaluates the island, and the coordinates; returns the island that is to be solved. */
    Island evaluateReleased(State state) {
        release();
        Island one = active(state);
        one.evaluate(state);
        for (int k = 0; one != island && k < rows.length; k++) {
            rows[k].measure(state.x(), island.blockA[nodes[k]], island.blockB[nodes[k]]);
        }
        return one;
    }

    @Override
    public void thaw() {
        isFrozen = false;
    }

    /** The right side of the velocity equations; null: 0. */
    double[] bias() {
        return rows.length == 0 ? null : bias;
    }

    /** Lets no row act until that is decided: bodies were written, and have the velocities that somebody wants. */
    void forget() {
        for (Switched s : rows) {
            s.forget();
        }
        setBias();
        if (servos != null) {
            servos.forget();
        }
        if (skeleton != null) {
            skeleton.island.forget();
        }
    }

    /** Lets no row act: an impact's forces are greater than any motor's, and stops have impacts of their own. */
    void release() {
        for (Switched s : rows) {
            s.isOnNow = false;
        }
        setBias();
    }

    /**
     * Lets the rows act that have been decided to; a motor that was overloaded within the step is off from now on.
     *
     * @param isOfStage whether those act that do at the stage at hand, and nothing is decided
     */
    void settle(boolean isOfStage) {
        for (Switched s : rows) {
            if (s.isOn && !s.isOnNow && !isOfStage) {
                giveWay(s, s.forceNow);
            }
            s.isOnNow = isOfStage ? s.isOnNow : s.isOn;
        }
        setBias();
    }

    private static void giveWay(Switched s, double force) {
        s.isOn = false;
        s.force = force;
        s.yields = true;
    }

    /**
     * Changes the first of the rows that act although their force is out of its bounds, or have yielded although they are
     * pressed, at the accelerations that were just found; false if there is none. As long as there is one, what acts is not
     * settled: this is Murty's rule (1974), by which that is found in the end.
     */
    static boolean reconsider(List<Island> islands, double[] a) {
        for (int k = 0; k < islands.size(); k++) {
            if (islands.get(k).switches.reconsider(a)) {
                return true;
            }
        }
        return false;
    }

    private boolean reconsider(double[] a) {
        for (int k = 0; k < rows.length; k++) {
            Switched s = rows[k];
            double f = island.lambda[2 * nodes[k]];
            if (s.isOn && s.isOnNow && !(f >= s.least() && f <= s.greatest())) {
                giveWay(s, f < s.least() ? s.least() : s.greatest());
                return true;
            }
            if (!s.isOn && s.yields && s.isPressed(a, island.blockA[nodes[k]], island.blockB[nodes[k]])) {
                s.isOn = true;
                s.force = 0;
                s.yields = false;
                return true;
            }
        }
        return false;
    }

    private void setBias() {
        for (int k = 0; k < rows.length; k++) {
            bias[2 * nodes[k]] = rows[k].isOnNow ? -rows[k].target() : 0;
        }
    }

    /**
     * Accelerations at a stage: rows whose force would be out of its bounds do not act, and push with that bound, unless the
     * motion would pass with that what they keep. Changed one at a time, if all at once do not come to an end (Murty 1974).
     */
    void accelerate(State state, ConstraintSolver solver, double[] a) {
        boolean anyOn = false;
        for (int k = 0; k < rows.length; k++) {
            rows[k].isOnNow = rows[k].isOn;
            rows[k].forceNow = rows[k].force;
            anyOn |= rows[k].isOn;
        }
        if (anyOn && isLimited) {
            keep(a);
        }
        for (int turn = 0; solveOnce(state, solver, a, turn < ALL_AT_ONCE) && turn < ALL_AT_ONCE + ONE_BY_ONE; turn++) {
            restore(a);
        }
        for (Switched s : rows) {
            isOverloaded |= s.isOn && !s.isOnNow;
        }
    }

    /** Finds accelerations; returns whether a row that acted was out of its bounds, or one that did not will have to. */
    private boolean solveOnce(State state, ConstraintSolver solver, double[] a, boolean all) {
        if (servos == null || !servos.accelerate(state, solver, a)) {
            solveAll(state, solver, a);
        }
        boolean changed = false;
        for (int k = 0; k < rows.length && isLimited && (all || !changed); k++) {
            changed |= rows[k].isOnNow ? limit(rows[k], island.lambda[2 * nodes[k]]) : rows[k].isOn && holds(k, a);
        }
        return changed;
    }

    private void solveAll(State state, ConstraintSolver solver, double[] a) {
        double[] w = state.w().values();
        island.evaluate(state);
        for (int k = 0; k < rows.length; k++) {
            if (!rows[k].isOnNow && rows[k].forceNow != 0) {
                rows[k].push(rows[k].forceNow, w, a, island.blockA[nodes[k]], island.blockB[nodes[k]]);
            }
        }
        solver.accelerate(island, state, a);
    }

    /** Whether a row is to act again that was overloaded: with the force of its bound, its coordinate would go that way. */
    private boolean holds(int k, double[] a) {
        rows[k].isOnNow = rows[k].isPressedNow(a, island.blockA[nodes[k]], island.blockB[nodes[k]]);
        return rows[k].isOnNow;
    }

    /** Sets whether forces are kept within their bounds; returns whether one has been out of them since this was last set. */
    static boolean limit(List<Island> islands, boolean yes) {
        boolean was = false;
        for (int k = 0; k < islands.size(); k++) {
            Switches one = islands.get(k).switches;
            was |= one.isOverloaded;
            one.isLimited = yes;
            one.isOverloaded = false;
        }
        return was;
    }

    /** By how much the forces that the last accelerations need are within their bounds, in units of what counts as reached. */
    static double spare(List<Island> islands) {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < islands.size(); k++) {
            Switches one = islands.get(k).switches;
            for (int m = 0; m < one.rows.length; m++) {
                if (one.rows[m].isOnNow) {
                    least = Math.min(least, one.rows[m].spare(one.island.lambda[2 * one.nodes[m]]));
                }
            }
        }
        return least;
    }

    static boolean any(List<Island> islands) {
        for (int k = 0; k < islands.size(); k++) {
            if (!islands.get(k).switches.isEmpty() && !islands.get(k).switches.isFrozen) {
                return true;
            }
        }
        return false;
    }

    private static boolean limit(Switched s, double force) {
        if (force >= s.least() && force <= s.greatest()) {
            return false;
        }
        s.isOnNow = false;
        s.forceNow = force < s.least() ? s.least() : s.greatest();
        return true;
    }

    private void keep(double[] a) {
        int n = State.BLOCK * island.bodies.size;
        if (free.length < n) {
            free = new double[n];
        }
        for (int k = 0, m = 0; k < island.bodies.size; k++, m += State.BLOCK) {
            int s = State.BLOCK * island.bodies.values[k];
            free[m] = a[s];
            free[m + 1] = a[s + 1];
            free[m + 2] = a[s + 2];
        }
    }

    private void restore(double[] a) {
        for (int k = 0, m = 0; k < island.bodies.size; k++, m += State.BLOCK) {
            int s = State.BLOCK * island.bodies.values[k];
            a[s] = free[m];
            a[s + 1] = free[m + 1];
            a[s + 2] = free[m + 2];
        }
    }

    /** Copies what the rows of some islands remember to an array, or a larger one, or from there. */
    static double[] exchange(List<Island> islands, double[] kept, boolean restore) {
        double[] values = kept;
        int at = 0;
        for (int k = 0; k < islands.size(); k++) {
            for (Switched s : islands.get(k).switches.rows) {
                if (restore) {
                    s.restore(values, at);
                } else {
                    values = values.length < at + Switched.MEMORY ? Arrays.copyOf(values, 2 * at + Switched.MEMORY) : values;
                    s.keep(values, at);
                }
                at += Switched.MEMORY;
            }
        }
        return values;
    }

    /** Turns rows of some islands on that are where they may be held, or settles which act. */
    static void confirm(List<Island> islands, State state, boolean hold) {
        boolean isAny = false;
        for (int k = 0; k < islands.size(); k++) {
            Switches switches = islands.get(k).switches;
            if (hold) {
                isAny |= switches.near.hold(state, false);
            } else {
                switches.settle(false);
                switches.near.mark(state);
            }
        }
        for (int k = 0; hold && !isAny && k < islands.size(); k++) {
            islands.get(k).switches.near.hold(state, true);
        }
    }

    /** The least of what is watched in some islands. */
    static double watch(List<Island> islands, State state, boolean near) {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < islands.size(); k++) {
            least = Math.min(least, islands.get(k).switches.near.watch(state, near));
        }
        return least;
    }

    /** The least time until a stop of some islands is reached; says what was watched of each row. */
    static double toGo(List<Island> islands, State state, boolean near, double[] a, Watched seen) {
        double least = Double.POSITIVE_INFINITY;
        seen.clear();
        for (int k = 0; k < islands.size(); k++) {
            islands.get(k).switches.near.tell(state, near, a, seen);
            least = Math.min(least, islands.get(k).switches.near.toGo(state, near));
        }
        return least;
    }

    /** The least time in which a motor of some islands reaches its speed. */
    static double push(List<Island> islands, State state, double[] a) {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < islands.size(); k++) {
            least = Math.min(least, islands.get(k).switches.push(state, a));
        }
        return least;
    }

    /** Decides which rows act; returns whether some row asks for another speed than there is. */
    boolean decide(State state, double time) {
        measure(state);
        near.decided();
        boolean hits = false;
        for (int k = 0; k < rows.length; k++) {
            double must = rows[k].decide(rows[k].value(), near.speed(k, state.v()), time);
            rows[k].isOnNow = rows[k].isOn || !Double.isNaN(must);
            rows[k].yields = false;
            bias[2 * nodes[k]] = Double.isNaN(must) ? rows[k].isOn ? -rows[k].target() : 0 : -must;
            hits |= rows[k].isOnNow;
        }
        stopped.giveWay(bias);
        return hits;
    }

    /** Whether an impact that was just decided has driven other rows against their stops, or motors past their speeds. */
    boolean isStruck(State state, double time) {
        boolean yes = false;
        for (int k = 0; k < rows.length && !yes; k++) {
            yes = rows[k].isStruck(rows[k].value(), near.speed(k, state.v()), time);
        }
        return yes;
    }

    /** The least time in which a motor that pushes reaches its speed, at the accelerations that were found last. */
    double push(State state, double[] a) {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < rows.length; k++) {
            if (!rows[k].isOn && rows[k].force != 0) {
                double rate = near.speed(k, a);
                double now = near.speed(k, state.v());
                double time = (rows[k].target() - now) / rate;
                boolean isBefore = rows[k].watch(rows[k].value(), now) > 1; // or it yields, at its speed
                least = time > 0 && isBefore ? Math.min(least, time) : least;
            }
        }
        return least;
    }
}
