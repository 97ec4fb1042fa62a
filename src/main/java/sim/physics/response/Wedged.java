// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.CollisionDetection;
import sim.physics.internal.IntList;
import sim.physics.internal.Tolerances;
import sim.physics.motion.Trajectories;
import sim.physics.response.lasting.Heaps;

/**
 * Pairs of bodies, driven or put into one another, that meet again and again at next to one instant: they collapse on one
 * another with others, and are stopped together with these. Where that does not help, as they are too deep for an impulse at
 * their points to part them, they may be as deep as they are for the rest of the step, and a little deeper each time that
 * they meet so once more; so time goes on. From the next step on they may only be as deep as they still are.
 */
final class Wedged implements Serializable {
    private static final long serialVersionUID = 2L;

    /** Times that a pair may meet at one instant. */
    private static final int MOST = 40;

    /** Times that it may meet again at once, in a step; from then on it is stopped, or may be deeper each time, twice as much as before. */
    private static final int MOST_AT_ONCE = 200;

    private static final int MOST_DOUBLINGS = 24;

    /** Times that it may meet again at once after each of these, if it has been apart or on its way for longer in between. */
    private static final int MOST_AGAIN = 60;

    /** Time that is none, relative to the step. */
    private static final double INSTANT = 1e-12;

    /** The same in which no bounce of bodies that are pressed together ends. */
    private static final double AT_ONCE = 1e-6;

    /** Impacts of all bodies in such a time in which none is expected to have as many. */
    private static final int MANY = 1000;

    /** By how much deeper they may be, relative to the smaller body. */
    private static final double DEEPER = 1e-7;

    /** Times that it is stopped in a step before it is let be deeper instead. */
    private static final int MOST_STOPS = 256;

    /** The same at one instant. */
    private static final int MOST_REPEATS = 8;

    /** Way, relative to its size, that it hops in a step if it is stopped again and again. */
    private static final double MOST_HOP = 1.0 / 16;

    private final Trajectories trajectories;
    private final CollisionDetection detection;
    private final IntList pairs = new IntList();

    /** Pairs that have met once too often at this instant, with their gaps and sizes. */
    private final IntList due = new IntList();

    private double[] dueAt = new double[4];
    private double[] last = {};
    private int[] times = {};

    /** When the pair was stopped last, and how often in the step. */
    private double[] stopped = {};

    private int[] stops = {};

    /** How often it was at the same instant. */
    private int[] repeats = {};

    /** Meetings at once after the last one, in its step; and how often it was allowed to be deeper for them. */
    private int[] atOnce = {};

    private int[] deepened = {};

    /** Offset from which on impacts are counted, and their number; whether there were too many in this step. */
    private double from;

    private int count;
    private boolean isStalled;

    Wedged(Trajectories trajectories, CollisionDetection detection) {
        this.trajectories = trajectories;
        this.detection = detection;
    }

    /**
     * Counts an impact, and whether time has come to stand still in the step: where bodies spin flush side by side, elastic ones bounce off
     * by rounding only, and what presses them together is their own motion.
     */
    boolean stalls(double tau) {
        if (!(tau - from <= AT_ONCE * trajectories.h())) {
            from = tau;
            count = 0;
        }
        count++;
        isStalled |= count > MANY;
        return isStalled;
    }

    /** Counts a meeting; whether the two are to go on as they are, until all that has met at this instant is {@link #settle settled}. */
    boolean meet(int pair, double tau, double gap, double size) {
        boolean deep = gap < -Tolerances.OVERLAP * size;
        if (!deep && !isStalled && !isDriven(pair)) {
            return false;
        }
        ensure(pair);
        double now = now(tau);
        boolean same = isSame(now, last[pair]);
        if (last[pair] < trajectories.step()) {
            atOnce[pair] = 0;
            deepened[pair] = 0;
            stops[pair] = 0;
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
        dueAt = dueAt.length < 2 * due.size + 2 ? Arrays.copyOf(dueAt, 4 * due.size + 4) : dueAt;
        dueAt[2 * due.size] = gap;
        dueAt[2 * due.size + 1] = size;
        due.add(pair);
        return true;
    }

    /** Stops pairs that have met too often, or lets them be as deep as they are; notes the bodies whose courses change. */
    void settle(Heaps heaps, double tau, IntList changed) {
        for (int k = 0; k < due.size; k++) {
            int pair = due.values[k];
            double gap = dueAt[2 * k];
            double size = dueAt[2 * k + 1];
            boolean isStoppable = isDriven(pair) && gap >= -Tolerances.PUT * size && stops[pair] < MOST_STOPS;
            repeats[pair] = isSame(now(tau), stopped[pair]) ? repeats[pair] + 1 : 0;
            if (isStoppable && repeats[pair] < MOST_REPEATS) {
                stopped[pair] = now(tau);
                stops[pair]++;
                if (heaps.stop(pair, tau, Math.min(MOST_HOP, stops[pair] * Tolerances.RATTLE_SIZE), changed)) {
                    continue;
                }
            }
            deepen(pair, gap, size);
        }
        due.clear();
    }

    private void deepen(int pair, double gap, double size) {
        deepened[pair] += atOnce[pair] < MOST_AT_ONCE ? 0 : 1;
        double deeper = DEEPER * (1L << Math.min(deepened[pair], MOST_DOUBLINGS));
        if (!(detection.marks().depth(pair) > 0)) {
            pairs.add(pair);
        }
        detection.marks().setDepth(pair, Math.max(0, -gap) + deeper * size);
    }

    private boolean isDriven(int pair) {
        return trajectories.isDriven(detection.pairs().first(pair)) || trajectories.isDriven(detection.pairs().second(pair));
    }

    private double now(double tau) {
        return trajectories.step() + tau / trajectories.h();
    }

    private static boolean isSame(double now, double before) {
        return Math.abs(now - before) <= INSTANT * Math.max(1, now);
    }

    private void ensure(int pair) {
        if (pair >= times.length) {
            int before = times.length;
            last = Arrays.copyOf(last, Math.max(2 * before, pair + 1));
            times = Arrays.copyOf(times, last.length);
            atOnce = Arrays.copyOf(atOnce, last.length);
            deepened = Arrays.copyOf(deepened, last.length);
            stopped = Arrays.copyOf(stopped, last.length);
            Arrays.fill(stopped, before, last.length, -1);
            stops = Arrays.copyOf(stops, last.length);
            repeats = Arrays.copyOf(repeats, last.length);
        }
    }

    /** Begins a step: time goes on; pairs that are not as deep any more must not get so again. */
    void begin() {
        from = 0;
        count = 0;
        isStalled = false;
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
