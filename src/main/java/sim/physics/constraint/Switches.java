// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import sim.physics.motion.State;
import sim.physics.motion.SwitchedRow;
import sim.physics.motion.SwitchedTies;

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

    /** Whether all push with forces that were found elsewhere. */
    private boolean isFrozen;

    /** Whether forces are kept within their bounds, and whether one that acts has been out of them. */
    private boolean isLimited = true;

    private boolean isOverloaded;

    /** −(the speed that a row keeps), 2 per node of the island. */
    private final double[] bias;

    Switches(Island island) {
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
        bias = new double[2 * island.nodes];
    }

    boolean isEmpty() {
        return rows.length == 0;
    }

    @Override
    public int size() {
        return rows.length;
    }

    @Override
    public boolean read(int k, SwitchedRow row) {
        return rows[k].describe(row, island.blockA[nodes[k]], island.blockB[nodes[k]]);
    }

    @Override
    public void freeze(int k, double force) {
        isFrozen = true;
        rows[k].isOn = false;
        rows[k].force = force;
    }

    @Override
    public void thaw() {
        isFrozen = false;
    }

    @Override
    public boolean isFrozen() {
        return isFrozen;
    }

    /** The right side of the velocity equations; null: 0. */
    double[] bias() {
        return rows.length == 0 ? null : bias;
    }

    /** Lets no row act until that is decided: bodies were written, and have the velocities that somebody wants. */
    void forget() {
        for (Switched s : rows) {
            s.isOn = false;
            s.isOnNow = false;
        }
        setBias();
    }

    /** Lets no row act: an impact's forces are greater than any motor's, and stops have impacts of their own. */
    void release() {
        for (Switched s : rows) {
            s.isOnNow = false;
        }
        setBias();
    }

    /** Lets the rows act that have been decided to; a motor that was overloaded within the step is off from now on. */
    void settle() {
        for (Switched s : rows) {
            if (s.isOn && !s.isOnNow) {
                s.isOn = false;
                s.force = s.forceNow;
            }
            s.isOnNow = s.isOn;
        }
        setBias();
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
        double[] w = state.w().values();
        keep(a);
        for (Switched s : rows) {
            s.isOnNow = s.isOn;
            s.forceNow = s.force;
        }
        boolean changed = true;
        for (int turn = 0; changed && turn < ALL_AT_ONCE + ONE_BY_ONE; turn++) {
            changed = false;
            restore(a);
            island.evaluate(state);
            for (int k = 0; k < rows.length; k++) {
                if (!rows[k].isOnNow && rows[k].forceNow != 0) {
                    rows[k].push(rows[k].forceNow, w, a, island.blockA[nodes[k]], island.blockB[nodes[k]]);
                }
            }
            solver.accelerate(island, state, a);
            for (int k = 0; k < rows.length && isLimited && !(changed && turn >= ALL_AT_ONCE); k++) {
                changed |= rows[k].isOnNow ? limit(rows[k], island.lambda[2 * nodes[k]]) : rows[k].isOn && holds(k, a);
            }
        }
        for (Switched s : rows) {
            isOverloaded |= s.isOn && !s.isOnNow;
        }
    }

    /** Whether a row is to act again that was overloaded: with the force of its bound, its coordinate would go that way. */
    private boolean holds(int k, double[] a) {
        if (!rows[k].passes(a, island.blockA[nodes[k]], island.blockB[nodes[k]])) {
            return false;
        }
        rows[k].isOnNow = true;
        return true;
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
        for (int k = 0; k < n; k++) {
            free[k] = a[State.BLOCK * island.bodies.values[k / 3] + k % 3];
        }
    }

    private void restore(double[] a) {
        for (int k = 0; k < State.BLOCK * island.bodies.size; k++) {
            a[State.BLOCK * island.bodies.values[k / 3] + k % 3] = free[k];
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
        for (Island island : islands) {
            if (hold) {
                island.switches.hold(state);
            } else {
                island.switches.settle();
            }
        }
    }

    /** The least of what is watched in some islands. */
    static double watch(List<Island> islands, State state) {
        double least = Double.POSITIVE_INFINITY;
        for (Island island : islands) {
            least = Math.min(least, island.switches.watch(state));
        }
        return least;
    }

    /** The least time in which a motor of some islands reaches its speed. */
    static double push(List<Island> islands, State state, double[] a) {
        double least = Double.POSITIVE_INFINITY;
        for (Island island : islands) {
            least = Math.min(least, island.switches.push(state, a));
        }
        return least;
    }

    /** Decides which rows act; returns whether some row asks for another speed than there is. */
    boolean decide(State state, double time) {
        island.evaluate(state);
        boolean hits = false;
        for (int k = 0; k < rows.length; k++) {
            double must = rows[k].decide(rows[k].value(), speed(k, state), time);
            rows[k].isOnNow = rows[k].isOn || !Double.isNaN(must);
            bias[2 * nodes[k]] = Double.isNaN(must) ? rows[k].isOn ? -rows[k].target() : 0 : -must;
            hits |= rows[k].isOnNow;
        }
        return hits;
    }

    private double speed(int k, State state) {
        return rows[k].speed(state.v(), island.blockA[nodes[k]], island.blockB[nodes[k]]);
    }

    /** Turns the rows on that are where they may be held. */
    void hold(State state) {
        island.evaluate(state);
        for (Switched s : rows) {
            if (!s.isOn) {
                s.hold(s.value());
                s.isOnNow = s.isOn;
            }
        }
    }

    /** The least time in which a motor that pushes reaches its speed, at the accelerations that were found last. */
    double push(State state, double[] a) {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < rows.length; k++) {
            if (!rows[k].isOn && rows[k].force != 0) {
                double rate = rows[k].speed(a, island.blockA[nodes[k]], island.blockB[nodes[k]]);
                double now = speed(k, state);
                double time = (rows[k].target() - now) / rate;
                boolean isBefore = rows[k].watch(rows[k].value(), now) > 1; // or it yields, at its speed
                least = time > 0 && isBefore ? Math.min(least, time) : least;
            }
        }
        return least;
    }

    /** The least of the values that turn negative when a row must be decided anew. */
    double watch(State state) {
        island.evaluate(state);
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < rows.length; k++) {
            if (!rows[k].isOn) {
                least = Math.min(least, rows[k].watch(rows[k].value(), speed(k, state)));
            }
        }
        return least;
    }
}
