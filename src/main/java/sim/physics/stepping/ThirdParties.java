// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;
import sim.physics.motion.State;

/**
 * Pairs of which listeners have not been asked, and which touch within the step only if a third body strikes one of the two: what lies on a plank
 * that falls goes on when the plank is stopped, and what is put on one that is borne from now on falls by itself. Listeners are asked
 * about those that may be reached so, or nobody would solve them.
 */
final class ThirdParties implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Speed that an impact gives to a body at most, in terms of that with which the two meet. */
    private static final double GAIN = 2;

    /** In the place of a pair: it has been found; and listeners have been asked about it. */
    private static final int FOUND = -1;

    private static final int DECIDED = -2;

    private final State state;
    private final ContactRows rows;

    /** Pairs that wait for it, their bodies, and what must bring these together, as a speed. */
    private final IntList pairs = new IntList();

    private final IntList firsts = new IntList();
    private final IntList seconds = new IntList();
    private double[] lacks = {};

    /** Speed that bodies may get by impacts within the step, and whether one does. */
    private double[] gains = {};

    private boolean isAny;

    ThirdParties(State state, ContactRows rows) {
        this.state = state;
        this.rows = rows;
    }

    void begin() {
        pairs.clear();
        firsts.clear();
        seconds.clear();
        if (isAny) {
            Arrays.fill(gains, 0);
        }
        isAny = false;
    }

    /**
     * The two bodies of a row strike one another.
     *
     * @param isOpen whether listeners are still to be asked about them: what forces give the two in the step then counts, too, as when a stack is put
     *     down at rest. What lies already has given it to others before
     */
    void strike(int row, double h, boolean isOpen) {
        double speed = 0;
        for (int m = 0; m < rows.pointCount(row); m++) {
            double forced = isOpen ? h * rows.of(row, m, ContactRows.FORCED) : 0;
            speed = Math.max(speed, rows.approach(row, m) + Math.max(0, -forced));
        }
        gain(rows.first(row), GAIN * speed);
        gain(rows.second(row), GAIN * speed);
    }

    private boolean gain(int body, double speed) {
        if (!(speed > 0) || state.w().values()[State.BLOCK * body] == 0) {
            return false;
        }
        if (body >= gains.length) {
            gains = Arrays.copyOf(gains, state.size());
        }
        boolean isMore = speed > gains[body];
        gains[body] = isMore ? speed : gains[body];
        isAny |= isMore;
        return isMore;
    }

    /**
     * The two bodies of a row may pass on what others give them, and may be brought together by it.
     *
     * @param isOpen whether they do not touch in a step by themselves, and listeners are still to be asked about them; else the two only pass it on
     */
    void wait(int row, double h, boolean isOpen) {
        double lack = Double.POSITIVE_INFINITY;
        for (int m = 0; m < rows.pointCount(row); m++) {
            double forced = h * rows.of(row, m, ContactRows.FORCED);
            lack = Math.min(lack, rows.of(row, m, ContactRows.GAP) / h - rows.approach(row, m) + forced);
        }
        pairs.add(isOpen ? rows.pair(row) : DECIDED);
        firsts.add(rows.first(row));
        seconds.add(rows.second(row));
        if (pairs.size > lacks.length) {
            lacks = Arrays.copyOf(lacks, 2 * pairs.size);
        }
        lacks[pairs.size - 1] = lack;
    }

    /** Finds the pairs that others may bring together, one after the other. */
    void find(IntList reached) {
        reached.clear();
        boolean goesOn = isAny;
        while (goesOn) {
            goesOn = false;
            for (int k = 0; k < pairs.size; k++) {
                if (pairs.values[k] == FOUND) {
                    continue;
                }
                int a = firsts.values[k];
                int b = seconds.values[k];
                double speed = gained(a) + gained(b);
                if (speed > 0 && lacks[k] <= speed) {
                    if (pairs.values[k] != DECIDED) {
                        reached.add(pairs.values[k]);
                    }
                    pairs.values[k] = FOUND;
                    gain(a, speed);
                    gain(b, speed);
                    goesOn = true;
                }
            }
        }
    }

    private double gained(int body) {
        return body < gains.length ? gains[body] : 0;
    }
}
