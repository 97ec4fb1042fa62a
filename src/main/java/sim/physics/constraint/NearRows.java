// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import sim.physics.motion.State;
import sim.physics.motion.Watched;

/** Which motors and stops of an island that do not act are within reach of acting, and which of these are pressed. */
final class NearRows implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final byte FAR = 0;
    private static final byte NEAR = 1;
    private static final byte PASSED = 2;

    /** Times that rows are held for what they do alone. */
    private static final int FEW_HOLDS = 2;

    private final Island island;
    private final Switched[] rows;
    private final int[] nodes;

    /** Whether a row that does not act was within reach when that was settled, {@link #NEAR}, or far, or had been passed. */
    private final byte[] reach;

    /** Whether a row that was near has been out of reach since, and how often rows were held since it was decided which act. */
    private final boolean[] hasLeft;

    private int holds;

    /** What was watched last, by row. */
    private final double[] watched;

    NearRows(Island island, Switched[] rows, int[] nodes) {
        this.island = island;
        this.rows = rows;
        this.nodes = nodes;
        reach = new byte[rows.length];
        hasLeft = new boolean[rows.length];
        watched = new double[rows.length];
    }

    /** It was decided anew which act. */
    void decided() {
        holds = 0;
    }

    /** How fast the coordinate of a row changes at some velocities, or its speed at some accelerations. */
    double speed(int k, double[] v) {
        return rows[k].speed(v, island.blockA[nodes[k]], island.blockB[nodes[k]]);
    }

    /**
     * Turns the rows on that are where they may be held; what has bounced off one stop is not held because another one is pressed.
     *
     * @param all whether those are held, too, that have left meanwhile, as none is pressed all the time
     * @return whether some row was turned on
     */
    boolean hold(State state, boolean all) {
        boolean isAny = false;
        island.evaluate(state);
        for (int k = 0; k < rows.length; k++) {
            Switched s = rows[k];
            if (!s.isOn && (all || !hasLeft[k] || holds >= FEW_HOLDS)) {
                s.hold(s.value());
                s.isOnNow = s.isOn;
                isAny |= s.isOn;
            }
        }
        holds++;
        return isAny;
    }

    /** Notes which of the rows that do not act are within reach; the island is evaluated. */
    void mark(State state) {
        for (int k = 0; k < rows.length; k++) {
            double watched = rows[k].isOn ? 1 : rows[k].watch(rows[k].value(), speed(k, state.v()));
            reach[k] = watched >= 1 ? FAR : watched > -1 ? NEAR : PASSED;
            hasLeft[k] = false;
        }
    }

    /** The least of the values that turn negative when a row must be decided anew. */
    double watch(State state, boolean near) {
        byte which = near ? NEAR : FAR;
        boolean isAny = false;
        for (int k = 0; k < rows.length; k++) {
            isAny |= !rows[k].isOn && reach[k] == which;
        }
        double least = Double.POSITIVE_INFINITY;
        if (!isAny) {
            return least;
        }
        island.switches.measure(state);
        for (int k = 0; k < rows.length; k++) {
            if (!rows[k].isOn && reach[k] == which) {
                watched[k] = rows[k].watch(rows[k].value(), speed(k, state.v()));
                hasLeft[k] |= near && watched[k] > 1;
                least = Math.min(least, watched[k]);
            }
        }
        return least;
    }

    /** Says what was watched last, by row, and how fast it changes at some accelerations. */
    void tell(State state, boolean near, double[] a, Watched seen) {
        byte which = near ? NEAR : FAR;
        for (int k = 0; k < rows.length; k++) {
            boolean isSeen = !rows[k].isOn && reach[k] == which;
            double change = isSeen && a != null ? speed(k, a) + rows[k].curvature() : Double.NaN;
            double rate = isSeen ? rows[k].slope(rows[k].value(), speed(k, state.v()), change) : Double.NaN;
            seen.take(isSeen ? watched[k] : Double.NaN, rate);
        }
    }

    /** The least time until such a row must be; NaN if a motor is among those that have passed. */
    double toGo(State state, boolean near) {
        byte which = near ? NEAR : FAR;
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < rows.length; k++) {
            if (!rows[k].isOn && reach[k] == which) {
                least = Math.min(least, rows[k].toGo(rows[k].value(), speed(k, state.v())));
            }
        }
        return least;
    }
}
