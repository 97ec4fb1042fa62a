// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.broad.Pairs;
import sim.physics.constraint.Onset;
import sim.physics.internal.Growth;
import sim.physics.internal.IntList;
import sim.physics.motion.State;

/**
 * Pairs of bodies that do not bounce and go the same way, so that they are too far apart to touch in a step, unless a third body or a stop is struck by
 * the one that goes ahead: boxes that fall one over the other all land in the step in which the lowest does. They are looked at again, with the speed
 * that the strike may take.
 */
final class Followers implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Speed that a strike takes from a body at most, in terms of that with which the two meet. */
    private static final double GAIN = 2;

    /** How often pairs are looked at again: strikes go through a row of bodies, in either order of their numbers, in one of them. */
    private static final int MOST_ROUNDS = 8;

    private final State state;
    private final NearPairs near;
    private final ContactRows rows;
    private final Onset onset;

    /** Pairs that were not found, and the speeds for which they were looked at. */
    private final IntList left = new IntList();

    private double[] tried = {};
    private final IntList again = new IntList();

    /** By body: what may be taken from it. */
    private double[] gains = {};

    private boolean isAny;
    private int rounds;

    Followers(State state, NearPairs near, ContactRows rows, Onset onset) {
        this.state = state;
        this.near = near;
        this.rows = rows;
        this.onset = onset;
    }

    void begin() {
        left.clear();
        if (isAny) {
            Arrays.fill(gains, 0);
        }
        isAny = false;
        rounds = 0;
    }

    /** A pair was not found; the way of one that bounces is that off a third one already. */
    void leave(int pair, boolean isIdle, boolean bounces) {
        near.flags[pair] = 0;
        if (isIdle) {
            near.leave(pair);
        } else if (!bounces && rounds == 0) {
            left.add(pair);
        }
    }

    /** {@return the speed by which two bodies may meet faster than they do by themselves} */
    double of(int first, int second) {
        return isAny ? Math.max(gains[first], gains[second]) : 0;
    }

    /** Finds pairs that are to be looked at again; none if there are no more. */
    IntList find() {
        again.clear();
        if (rounds == 0) {
            strike();
            tried = tried.length < left.size ? new double[Growth.length(tried.length, left.size)] : tried;
            Arrays.fill(tried, 0, left.size, 0);
        }
        if (!isAny || rounds++ == MOST_ROUNDS) {
            return again;
        }
        boolean goesOn = true;
        for (int k = 0; goesOn && k < MOST_ROUNDS; k++) {
            goesOn = false;
            for (int row = 0; row < rows.count; row++) {
                goesOn |= pass(row);
            }
            for (int row = rows.count - 1; row >= 0; row--) {
                goesOn |= pass(row);
            }
        }
        Pairs pairs = near.pairs();
        for (int k = 0; k < left.size; k++) {
            double speed = of(pairs.first(left.values[k]), pairs.second(left.values[k]));
            if (speed > tried[k]) {
                tried[k] = speed;
                again.add(left.values[k]);
            }
        }
        return again;
    }

    /** Finds what strikes in this step. */
    private void strike() {
        for (int row = 0; rows.fast > 0 && row < rows.count; row++) {
            if (rows.isFast(row)) {
                double speed = 0;
                for (int m = 0; m < rows.pointCount(row); m++) {
                    speed = Math.max(speed, rows.approach(row, m));
                }
                gain(rows.first(row), GAIN * speed);
                gain(rows.second(row), GAIN * speed);
            }
        }
        IntList stopped = onset.stopped();
        for (int k = 0; k < stopped.size; k++) {
            gain(stopped.values[k], GAIN * onset.stop(stopped.values[k]));
        }
    }

    /** What is taken from one of two that are near may be taken from the other one. */
    private boolean pass(int row) {
        double speed = of(rows.first(row), rows.second(row));
        boolean isMore = gain(rows.first(row), speed);
        return gain(rows.second(row), speed) || isMore;
    }

    private boolean gain(int body, double speed) {
        if (!(speed > 0) || state.w().values()[State.BLOCK * body] == 0) {
            return false;
        }
        if (gains.length < state.size()) {
            gains = Arrays.copyOf(gains, Growth.length(gains.length, state.size()));
        }
        boolean isMore = speed > gains[body];
        gains[body] = isMore ? speed : gains[body];
        isAny |= isMore;
        return isMore;
    }
}
