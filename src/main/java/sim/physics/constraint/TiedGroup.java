// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import sim.physics.internal.IntList;
import sim.physics.motion.Body;
import sim.physics.motion.State;

/**
 * Bodies that constraints tie together, and those constraints. The {@link Island} that solves for these is made when somebody asks for
 * it: to find the order of elimination for thousands of them takes as long as many steps, and time stepping asks for none.
 */
final class TiedGroup implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Nodes of a body from which on it is a hub. */
    private static final int MANY = 128;

    /** Movable bodies, ascending. */
    final IntList bodies;

    /** In the order in which they were added. */
    final List<Constraint> constraints;

    boolean isDissolved;

    /** Whether some joint can break; null when it is not known. */
    private Boolean breakable;

    /** Null until it is asked for. */
    private Island island;

    /** The constraints of each body: those of body k are around[aroundStart[k]] …; null until somebody asks who is tied to whom. */
    private transient int[] aroundStart;

    private transient int[] around;

    TiedGroup(IntList bodies, List<Constraint> constraints) {
        this.bodies = bodies;
        this.constraints = constraints;
    }

    Island island() {
        if (island == null) {
            island = new Island(bodies, constraints);
        }
        return island;
    }

    /** Keeps what the island knows of its bodies' turns, if it was made. */
    void keepTurns(Map<Turns, double[][]> kept, State state) {
        if (island != null) {
            Island active = island.switches.active(state);
            kept.put(island.turns, island.turns.keep());
            kept.put(active.turns, active.turns.keep());
        }
    }

    /** Number of rows that depend on others, as the last solve found them. */
    int redundantRows(State state) {
        return isDissolved || island == null ? 0 : island.switches.active(state).redundantRows;
    }

    /** Forgets what a body that was written may have changed; also which motors and stops act, though nobody has asked for the island yet. */
    void forget() {
        breakable = null;
        for (int k = 0; k < constraints.size(); k++) {
            if (constraints.get(k) instanceof Switched row) {
                row.forget();
            }
        }
        if (island != null) {
            island.forget();
        }
    }

    boolean isBreakable() {
        breakable = breakable == null ? Grouping.isBreakable(constraints) : breakable;
        return breakable;
    }

    /** Whether a body has so many constraints that their elimination, as the cube of their number, takes as long as many steps. */
    boolean hasHub() {
        list();
        boolean yes = false;
        for (int body = 0; body < bodies.size; body++) {
            int nodes = 0;
            for (int k = aroundStart[body]; k < aroundStart[body + 1] && nodes <= MANY; k++) {
                nodes += constraints.get(around[k]).getRows() + 1 >> 1;
            }
            yes |= nodes > MANY;
        }
        return yes;
    }

    /** Whether constraints between two bodies let them overlap. */
    boolean ties(Body body, Body other) {
        list();
        int one = place(body);
        int two = place(other);
        boolean isShorter = two >= 0 && around(two) < around(one); // of a hub and a spoke that of the spoke
        int of = isShorter ? two : one;
        return Grouping.letOverlap(constraints, around, aroundStart[of], aroundStart[of + 1], isShorter ? body : other);
    }

    private int around(int place) {
        return aroundStart[place + 1] - aroundStart[place];
    }

    private int place(Body body) {
        return body == null || body.isImmobile() ? -1 : Arrays.binarySearch(bodies.values, 0, bodies.size, body.index());
    }

    private void list() {
        if (around != null) {
            return;
        }
        int n = constraints.size();
        int[] ends = new int[2 * n];
        int[] start = new int[bodies.size + 1];
        for (int k = 0; k < n; k++) {
            ends[2 * k] = place(constraints.get(k).getBodyA());
            ends[2 * k + 1] = place(constraints.get(k).getBodyB());
        }
        for (int end : ends) {
            if (end >= 0) {
                start[end + 1]++;
            }
        }
        for (int body = 0; body < bodies.size; body++) {
            start[body + 1] += start[body];
        }
        int[] found = new int[start[bodies.size]];
        int[] next = start.clone();
        for (int k = 0; k < ends.length; k++) {
            if (ends[k] >= 0) {
                found[next[ends[k]]++] = k / 2;
            }
        }
        aroundStart = start;
        around = found;
    }
}
