// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.io.Serializable;
import sim.physics.collision.broad.Pairs;
import sim.physics.internal.Agenda;
import sim.physics.internal.IntList;
import sim.physics.internal.Team;
import sim.physics.internal.Work;

/**
 * The pairs whose boxes overlap: when each is looked at again, and when its impact is, if that is in the present step. That
 * is kept as the pair's time. If it is to be looked at in a later step, it is minus the offset in that step up to which the
 * pair is known to be apart; NaN if nothing is known.
 */
final class Watch implements Serializable {
    private static final long serialVersionUID = 1L;

    /** 1 less the rounding of an instant of a later step. */
    private static final double ALMOST = 1 - 0x1p-51;

    /** Pairs from which on it pays to share the looks at them: after a step of the integrator, and of free bodies. */
    private static final int FEWEST_DRIVEN = 512;

    private static final int FEWEST_DUE = 4096;

    /** The time of an impact of a pair that is in a list already. */
    private static final double LISTED = Double.NEGATIVE_INFINITY;

    private final CollisionDetection detection;
    private final Pairs pairs;
    private final PairMarks marks;
    private final PairSearch search;
    private final EventQueue queue;
    private final SpaceOrder order;
    private final Agenda agenda = new Agenda(Pairs.SHIFT, Pairs.WORD);

    private final IntList fresh = new IntList();

    private Work work = new Work();

    /** Null unless threads share the work. */
    private Team team;

    private transient SharedLooks shared;
    private long step;
    private double h;

    Watch(
            CollisionDetection detection, Pairs pairs, PairMarks marks, PairSearch search, EventQueue queue, SpaceOrder order) {
        this.detection = detection;
        this.pairs = pairs;
        this.marks = marks;
        this.search = search;
        this.queue = queue;
        this.order = order;
    }

    void setWork(Work those) {
        work = those;
    }

    void setTeam(Team team) {
        this.team = team;
        shared = null;
    }

    void begin(long number, double length) {
        step = number;
        h = length;
    }

    /** Takes a pair that begins into the list of those to be looked at. */
    void add(int pair) {
        agenda.setRecords(pairs.records());
        search.narrowPhase().forget(pair);
        pairs.setTime(pair, Double.NaN);
        fresh.add(pair);
    }

    /** Plans no look at a pair. */
    void remove(int pair) {
        pairs.setTime(pair, Double.NaN);
        agenda.schedule(pair, Agenda.NEVER);
    }

    /** Begins a new list of pairs to be looked at. */
    void clearList() {
        fresh.clear();
    }

    /** Takes a pair into that list. */
    void list(int pair) {
        fresh.add(pair);
    }

    /** Looks at the pairs that are due in a step that has begun, and at those in the list. */
    void look() {
        IntList due = agenda.advance(step);
        order.sortPairs(due);
        SharedLooks together = sharedLooks(due.size + fresh.size, FEWEST_DUE);
        for (int k = 0; k < due.size; k++) {
            int pair = due.values[k];
            double apart = -pairs.time(pair);
            if (pairs.first(pair) >= 0) {
                look(pair, apart > 0 ? apart : 0, together);
            }
        }
        lookAtList(0, together);
    }

    /** Looks at the pairs in the list. */
    void lookAtList(double tau) {
        lookAtList(tau, sharedLooks(fresh.size, FEWEST_DRIVEN));
    }

    /** Looks at the pairs in the list, at each once; also at those given to who shares the work, if it is shared. */
    private void lookAtList(double tau, SharedLooks together) {
        int count = 0;
        for (int k = 0; k < fresh.size; k++) {
            int pair = fresh.values[k];
            if (pairs.first(pair) >= 0 && pairs.time(pair) != LISTED) {
                pairs.setTime(pair, LISTED);
                fresh.values[count++] = pair;
            }
        }
        for (int k = 0; k < count; k++) {
            pairs.setTime(fresh.values[k], Double.NaN);
        }
        for (int k = 0; k < count; k++) {
            look(fresh.values[k], tau, together);
        }
        fresh.clear();
        if (together != null) {
            together.look();
        }
    }

    private SharedLooks sharedLooks(int count, int least) {
        if (team == null || !team.pays(count, least)) {
            return null;
        }
        shared = shared == null ? new SharedLooks(detection, this, search, team) : shared;
        return shared;
    }

    private void look(int pair, double tau, SharedLooks together) {
        if (together == null) {
            look(pair, tau);
        } else {
            together.add(pair, tau);
        }
    }

    /**
     * Looks at the pairs of a body with a new course.
     *
     * @param body index
     * @param tau offset in the present step from which on to look
     * @param except a pair that need not be looked at, or −1
     * @return whether there is any
     */
    boolean lookAtAll(int body, double tau, int except) {
        boolean watched = false;
        for (int k = 0; k < pairs.countOf(body); k++) {
            int pair = pairs.of(body, k);
            watched |= pair == except || !marks.isUnseen(pair);
            if (pair != except) {
                look(pair, tau);
                spend();
            }
        }
        return watched;
    }

    /** Does the same where everybody has always moved uniformly: most pairs are settled together, by their circles. */
    boolean lookAround(int body, double tau, int except) {
        double[] starts = search.narrowPhase().boundingCirclesOf(body, tau);
        boolean watched = false;
        int n = pairs.countOf(body);
        for (int k = 0; k < n; k++) {
            int pair = pairs.of(body, k);
            double start = starts[k];
            boolean unseen = marks.isUnseen(pair);
            watched |= pair == except || !unseen;
            if (pair == except) {
                continue;
            }
            if (unseen || start == Double.POSITIVE_INFINITY) {
                pairs.setTime(pair, Double.NaN);
                agenda.schedule(pair, Agenda.NEVER);
            } else if (start >= h) {
                schedule(pair, start);
            } else {
                look(pair, tau, start);
                spend();
            }
        }
        return watched;
    }

    /** Counts the looks so far: a body that is thrown about takes many at each of its pairs. */
    private void spend() {
        work.spend(0, search.narrowPhase().evaluations());
    }

    private void look(int pair, double tau, double start) {
        pairs.setTime(pair, Double.NaN);
        double t = start >= tau ? search.lookFrom(pair, tau, start, h) : search.lookWithin(pair, tau, h);
        plan(pair, search.found, t);
    }

    /** Looks for a pair's first contact from an instant on, and plans an impact or the next look. */
    void look(int pair, double tau) {
        pairs.setTime(pair, Double.NaN);
        double t = search.look(pair, tau, detection.pathEnd(pair));
        plan(pair, search.found, t);
    }

    /** Plans what a look at a pair has found. */
    void plan(int pair, byte found, double t) {
        if (found == PairSearch.LATER) {
            schedule(pair, t);
            return;
        }
        pairs.setTime(pair, Double.NaN);
        agenda.schedule(pair, Agenda.NEVER);
        if (found == PairSearch.IMPACT) {
            pairs.setTime(pair, t);
            queue.add(t, pair);
        }
    }

    /** Plans the next look at a pair that is apart up to an offset, which may be infinite. */
    private void schedule(int pair, double tau) {
        double later = Math.max(1, Math.floor(tau / h));
        pairs.setTime(pair, later * h - tau * ALMOST); // the search goes on from there
        agenda.schedule(pair, later < 1e15 ? step + (long) later : Agenda.NEVER);
    }
}
