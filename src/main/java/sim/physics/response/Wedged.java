// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.CollisionDetection;
import sim.physics.internal.IntList;
import sim.physics.motion.Trajectories;

/**
 * Pairs of bodies, driven or put into one another, that meet again and again at one instant, being too deep for an impulse
 * at their points to part them. They may be as deep as they are for the rest of the step, and a little deeper each time that
 * they meet so once more; so time goes on. From the next step on they may only be as deep as they still are.
 */
final class Wedged implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Times that a pair may meet at one instant. */
    private static final int MOST = 40;

    /** Times that it may meet again at once, in a step; from then on it may be deeper each time, twice as much as before. */
    private static final int MOST_AT_ONCE = 200;

    private static final int MOST_DOUBLINGS = 24;

    /** Times that it may meet again at once after each of these, if it has been apart or on its way for longer in between. */
    private static final int MOST_AGAIN = 60;

    /** Time that is none, relative to the step. */
    private static final double INSTANT = 1e-12;

    /** The same in which no bounce of bodies that are pressed together ends. */
    private static final double AT_ONCE = 1e-6;

    /** By how much deeper they may be, relative to the smaller body. */
    private static final double DEEPER = 1e-7;

    private final Trajectories trajectories;
    private final CollisionDetection detection;
    private final IntList pairs = new IntList();
    private double[] last = {};
    private int[] times = {};

    /** Meetings at once after the last one, in its step; and how often it was allowed to be deeper for them. */
    private int[] atOnce = {};

    private int[] deepened = {};

    Wedged(Trajectories trajectories, CollisionDetection detection) {
        this.trajectories = trajectories;
        this.detection = detection;
    }

    /** Counts a meeting; whether the two are to go on as they are. */
    boolean meet(int pair, double tau, double gap, double size) {
        if (pair >= times.length) {
            last = Arrays.copyOf(last, Math.max(2 * last.length, pair + 1));
            times = Arrays.copyOf(times, last.length);
            atOnce = Arrays.copyOf(atOnce, last.length);
            deepened = Arrays.copyOf(deepened, last.length);
        }
        double now = trajectories.step() + tau / trajectories.h();
        boolean same = Math.abs(now - last[pair]) <= INSTANT * Math.max(1, now);
        if (last[pair] < trajectories.step()) {
            atOnce[pair] = 0;
            deepened[pair] = 0;
        } else if (now - last[pair] <= AT_ONCE) {
            atOnce[pair]++;
        } else if (atOnce[pair] >= MOST_AT_ONCE) {
            atOnce[pair] = MOST_AT_ONCE - MOST_AGAIN;
        }
        last[pair] = now;
        times[pair] = same ? times[pair] + 1 : 0;
        if (times[pair] < MOST && atOnce[pair] < MOST_AT_ONCE) {
            return false;
        }
        times[pair] = 0;
        deepened[pair] += atOnce[pair] < MOST_AT_ONCE ? 0 : 1;
        double deeper = DEEPER * (1L << Math.min(deepened[pair], MOST_DOUBLINGS));
        if (!(detection.marks().depth(pair) > 0)) {
            pairs.add(pair);
        }
        detection.marks().setDepth(pair, Math.max(0, -gap) + deeper * size);
        return true;
    }

    /** Begins a step: pairs that are not as deep any more must not get so again. */
    void begin() {
        int kept = 0;
        for (int k = 0; k < pairs.size; k++) {
            int pair = pairs.values[k];
            if (detection.pairs().first(pair) < 0 || !(detection.marks().depth(pair) > 0)) {
                continue; // the pair has ended
            }
            double gap = detection.narrowPhase().gap(pair, 0);
            detection.marks().setDepth(pair, Math.max(0, -gap));
            if (gap < 0) {
                pairs.values[kept++] = pair;
            }
        }
        pairs.size = kept;
    }
}
