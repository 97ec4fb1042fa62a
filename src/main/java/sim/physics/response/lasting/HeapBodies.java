// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;
import sim.physics.motion.Trajectories;

/** What {@link Heaps} knows of bodies, by their indices. */
final class HeapBodies implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Times that something happens to a body in a step which is quiet; and after which its pauses get no longer. */
    private static final int QUIET = 10;

    private static final int LONGEST = 7;

    /** The same of bodies that are tied to others, whose bounces cost more. */
    private static final int LONGEST_TIED = 1;

    /**
     * Times that something may happen in a step to a driven body that moves alone before its pairs do not last any more:
     * in a crowd bounces then cost less. What is tied to others may be given more of them.
     */
    private static final int MOST = 10;

    private static final int MOST_TIED = 40;

    /** The same for each of many that are tied together: what happens to one of them happens to all. */
    private static final double MOST_EACH = 2.5;

    /** The same for bodies that are not driven. */
    private static final int MOST_OF_ALL = 2000;

    /** Times that forces on it may be found in a step before that. */
    private static final int MOST_ENDS = 40;

    private static final int MOST_ENDS_TIED = 300;

    /** By how much longer forces are to hold on driven bodies than last time, if no point has closed. */
    private static final double LONGER = 1.2;

    /** Bounds of the gaps that are kept for that; how much wider they get, and closer again. */
    private static final double LEAST_SAG = 1e-6;

    private static final double MOST_SAG = 1e-4;
    private static final double WIDER = 4;
    private static final double CLOSER = 0.95;

    /** Whether a body lies in a heap, stands still there, and is to be solved for. */
    boolean[] lies = {};

    boolean[] isStill = {};
    boolean[] isDirty = {};

    /** Until when it has got what the forces give it, as an offset in the step. */
    double[] paidUntil = {};

    /** The velocities that driven ones are to have then, 3 each. */
    double[] expected = {};

    /** From when on, and how much that is with the heap's impulses, 3 each. */
    double[] paidFrom = {};

    double[] paid = {};

    /** Whether that is for half of the time: what they have in the middle of it, and is not complete at its end yet. */
    boolean[] isHalf = {};

    /** Of driven bodies: for how long forces hold, 0 for the step; and whether a point has closed before that. */
    double[] pace = {};

    boolean[] hasClosed = {};

    /** How much the gaps of driven bodies change while forces hold, relative to the smaller body of a pair. */
    double[] sag = {};

    /** Whether its forces have been found too often in this step, and hold for the rest of it. */
    boolean[] isHurried = {};

    /** The number of the step before which it does not lie on anything, because it was struck too often. */
    double[] givenUp = {};

    /** How often that was so without a quiet step between. */
    int[] givenUpTimes = {};

    /** How often something has happened to it in this step, and the energy that it has lost in heaps. */
    int[] turns = {};
    int[] ends = {};

    double[] lost = {};

    /** How often its heap could not be solved in this step. */
    int[] failures = {};

    /** Solutions for which open points of its heap are taken for closed. */
    int[] relents = {};

    /** The last step in which its heap was solved as a large one, plus 1; and how often in that step. */
    double[] solvedIn = {};

    int[] solutions = {};

    /** The step before which it is; the last one in which it was solved exactly in a large one, and how often in that. */
    double[] roughUntil = {};

    double[] exactIn = {};
    int[] exact = {};
    int[] hard = {};

    /** What forces give to a driven one in a unit of time; 0 before that is known. */
    double[] pull = {};

    /** The last step in which the time of a solution of its heap ended early, as a point was to strike; plus 1. */
    double[] closedIn = {};

    /** Its number in the heap that is being solved, plus 1. */
    int[] place = {};

    HeapBodies() {
        // empty until something lies on something
    }

    boolean knows(int body) {
        return body < lies.length;
    }

    boolean has(int body) {
        return body < lies.length && lies[body];
    }

    void ensure(int body) {
        if (body >= lies.length) {
            int n = Math.max(2 * lies.length, body + 1);
            lies = Arrays.copyOf(lies, n);
            isStill = Arrays.copyOf(isStill, n);
            isDirty = Arrays.copyOf(isDirty, n);
            paidUntil = Arrays.copyOf(paidUntil, n);
            expected = Arrays.copyOf(expected, 3 * n);
            paidFrom = Arrays.copyOf(paidFrom, n);
            paid = Arrays.copyOf(paid, 3 * n);
            isHalf = Arrays.copyOf(isHalf, n);
            pace = Arrays.copyOf(pace, n);
            hasClosed = Arrays.copyOf(hasClosed, n);
            sag = Arrays.copyOf(sag, n);
            isHurried = Arrays.copyOf(isHurried, n);
            givenUp = Arrays.copyOf(givenUp, n);
            givenUpTimes = Arrays.copyOf(givenUpTimes, n);
            turns = Arrays.copyOf(turns, n);
            ends = Arrays.copyOf(ends, n);
            lost = Arrays.copyOf(lost, n);
            relents = Arrays.copyOf(relents, n);
            failures = Arrays.copyOf(failures, n);
            solvedIn = Arrays.copyOf(solvedIn, n);
            solutions = Arrays.copyOf(solutions, n);
            roughUntil = Arrays.copyOf(roughUntil, n);
            exactIn = Arrays.copyOf(exactIn, n);
            exact = Arrays.copyOf(exact, n);
            hard = Arrays.copyOf(hard, n);
            pull = Arrays.copyOf(pull, n);
            closedIn = Arrays.copyOf(closedIn, n);
            place = Arrays.copyOf(place, n);
        }
    }

    /** Lets a driven body lie on nothing for some steps; for more steps each time, but not many if it is tied to others. */
    void giveUp(int body, double step, boolean isTied) {
        ensure(body); // it may have been tied to one in a heap just now
        givenUpTimes[body] = Math.min(givenUpTimes[body] + 1, isTied ? LONGEST_TIED : LONGEST);
        givenUp[body] = step + (2 << givenUpTimes[body]);
    }

    /** Lets a body lie on others again. */
    void resume(int body) {
        if (knows(body)) {
            givenUp[body] = 0;
        }
    }

    /** Whether so much has happened to a body in this step, which is tied to some others or to none, that it is to lie on nothing. */
    boolean hasTooMany(int body, boolean isDriven, int tied) {
        if (!isDriven) {
            return turns[body] > MOST_OF_ALL; // on driven ones that cannot be stopped, as free heaps are
        }
        boolean isTied = tied > 0;
        return turns[body] > (isTied ? Math.max(MOST_TIED, MOST_EACH * tied) : MOST)
                || ends[body] > (isTied ? MOST_ENDS_TIED : MOST_ENDS);
    }

    /** Takes note of a change of velocity. */
    void pay(int body, double tau, double[] from, double[] to, int at) {
        paidFrom[body] = tau;
        for (int c = 0; c < 3; c++) {
            paid[3 * body + c] = to[at + c] - from[at + c];
        }
    }

    /**
     * Gives a body what it is to have at the end of the time already now, if a force acts on it; without any that would be what contacts
     * give in turning, and energy.
     *
     * @return false if it has that
     */
    boolean complete(int body, double[] v, int o, boolean isPulled) {
        for (int c = 0; c < 3 && isHalf[body] && isPulled; c++) {
            v[o + c] += paid[3 * body + c];
            paid[3 * body + c] *= 2;
        }
        boolean yes = isHalf[body];
        isHalf[body] = false;
        return yes;
    }

    /** Takes back what was paid for the time that is left. */
    void unpay(int body, double tau, double[] v, int o) {
        double part = left(body, tau);
        for (int c = 0; c < 3 && paidUntil[body] > tau; c++) {
            v[o + c] -= part * paid[3 * body + c];
        }
    }

    private double left(int body, double tau) {
        double part = (paidUntil[body] - tau) / (paidUntil[body] - paidFrom[body]);
        return isHalf[body] ? 2 * part - 1 : part;
    }

    /** The velocity of a point along a normal that a body which is not driven has been given for the time that is left. */
    double toCome(int body, Trajectories trajectories, double nx, double ny, double lever) {
        double tau = trajectories.offset(body);
        if (!has(body) || !(paidUntil[body] > tau) || trajectories.isDriven(body)) {
            return 0;
        }
        double part = left(body, tau);
        int o = 3 * body;
        return part * (paid[o] * nx + paid[o + 1] * ny + paid[o + 2] * lever);
    }

    /**
     * For how long forces are to hold on driven bodies: where points have closed too early, their gaps are to be kept wider,
     * and when that is not enough, forces hold half as long.
     */
    double pace(IntList bodies, double h, double shortest) {
        double least = h;
        double most = 0;
        boolean closed = false;
        boolean hurried = false;
        for (int k = 0; k < bodies.size; k++) {
            int body = bodies.values[k];
            closed |= hasClosed[body];
            hurried |= isHurried[body];
            most = Math.max(most, sag[body]);
            least = Math.min(least, pace[body] == 0 ? h : pace[body]);
        }
        boolean isWide = most >= MOST_SAG;
        least = Math.max(closed && isWide ? 0.5 * least : Math.min(h, LONGER * least), shortest);
        most = closed ? Math.min(MOST_SAG, Math.max(LEAST_SAG, WIDER * most)) : most > LEAST_SAG ? CLOSER * most : 0;
        for (int k = 0; k < bodies.size; k++) {
            pace[bodies.values[k]] = least;
            sag[bodies.values[k]] = most;
            hasClosed[bodies.values[k]] = false;
        }
        return hurried ? h : least;
    }

    /** Lets forces hold for no longer than a time. */
    void hold(IntList bodies, double time) {
        for (int k = 0; k < bodies.size; k++) {
            pace[bodies.values[k]] = time;
        }
    }

    /** How often something has happened in this step to one of some bodies, at most. */
    int mostTurns(IntList bodies) {
        int most = 0;
        for (int k = 0; k < bodies.size; k++) {
            most = Math.max(most, turns[bodies.values[k]]);
        }
        return most;
    }

    /** Whether bodies have lost as much energy before in the step as they would gain now, but for what they are lent; takes note of it then. */
    boolean afford(IntList bodies, double gain, double lent) {
        double sum = -gain;
        for (int k = 0; k < bodies.size; k++) {
            sum += lost[bodies.values[k]];
        }
        boolean yes = sum >= -lent;
        for (int k = 0; k < bodies.size && yes; k++) {
            lost[bodies.values[k]] = Math.max(0, sum / bodies.size);
        }
        return yes;
    }

    /** Begins a step, or a body's time in a heap. */
    void begin(int body) {
        paidUntil[body] = 0;
        isHalf[body] = false;
        givenUpTimes[body] = turns[body] + ends[body] < QUIET ? 0 : givenUpTimes[body];
        turns[body] = 0;
        isHurried[body] = false;
        ends[body] = 0;
        failures[body] = 0;
        lost[body] = 0;
    }
}
