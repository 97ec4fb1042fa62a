// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.util.Arrays;
import sim.physics.internal.Team;
import sim.physics.internal.Work;

/** What threads have done with groups of driven bodies in a step before it was the groups' turn, by their first bodies. */
final class Ahead {
    static final byte NOTHING = 0;

    /** The whole step was made at once. */
    static final byte LEAP = 1;

    /** The integrator has gone through it, or to where a motor or a stop switches. */
    static final byte STRIDE = 2;

    /** The step cannot be made at once, and where the integrator would have to go depends on who is near. */
    static final byte REFUSAL = 3;

    private byte[] done = {};
    private double[] length = {};
    private double[] error = {};
    private double[] fineLength = {};
    private long[] cost = {};
    private boolean isUsed;

    /** What integrating a group has thrown, if one has, and its first body. */
    private Throwable failure;

    private int failed;

    Ahead() {
        // grows with the bodies
    }

    /** Begins a step. */
    void begin(int bodies) {
        if (done.length < bodies) {
            done = new byte[bodies];
            length = new double[bodies];
            error = new double[bodies];
            fineLength = new double[bodies];
            cost = new long[bodies];
        } else if (isUsed) {
            Arrays.fill(done, NOTHING); // a step that was not finished leaves some
        }
        isUsed = true;
        failure = null;
        failed = -1;
    }

    void leap(int first, double h, boolean isCoarse) {
        length[first] = h;
        error[first] = isCoarse ? Double.POSITIVE_INFINITY : 0;
        done[first] = LEAP;
    }

    void stride(int first, double length, double error, double fineLength) {
        this.fineLength[first] = fineLength;
        this.length[first] = length;
        this.error[first] = error;
        done[first] = STRIDE;
    }

    void refuse(int first) {
        error[first] = Double.POSITIVE_INFINITY;
        done[first] = REFUSAL;
    }

    /** Takes note of what it has cost. */
    void charge(int first, long units) {
        cost[first] = units;
    }

    /** Takes note that integrating a group has thrown something, which is thrown when it is the group's turn. */
    void fail(int first, Throwable thrown) {
        forget(first);
        failed = first;
        failure = thrown;
    }

    void forget(int first) {
        done[first] = NOTHING;
    }

    /** What has been done with a group; that is made use of now, and its work taken over. */
    int take(int first, Work work) {
        if (first == failed) {
            Team.rethrow(failure);
        }
        int what = first < done.length ? done[first] : NOTHING;
        if (what != NOTHING) {
            done[first] = NOTHING;
            work.takeOver(cost[first]);
        }
        return what;
    }

    /** Whether a group has its path, near enough for bodies that others are near. */
    boolean isFine(int first) {
        return done[first] != NOTHING && error[first] <= 1;
    }

    boolean isCoarse(int first) {
        return error[first] > 1;
    }

    double length(int first) {
        return length[first];
    }

    /** The length of a step that would have been fine enough. */
    double fineLength(int first) {
        return fineLength[first];
    }

    double error(int first) {
        return error[first];
    }
}
