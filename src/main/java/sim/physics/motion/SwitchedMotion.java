// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.internal.IntList;

/**
 * Advances bodies whose ties act at some times only, motors and stops, up to where it must be decided anew which of them act.
 *
 * <p>Ties that are within reach of acting at the start, those <i>near</i>, either leave or are pressed; the others are looked at
 * first, since one of them may be reached before a near one has left.
 */
final class SwitchedMotion implements Serializable {
    private static final long serialVersionUID = 1L;

    private static final double HALF = 0.5;

    /** How much longer motors are followed than it should take until one reaches its speed. */
    private static final double AMPLE = 1.25;

    /** Times that near ties are let act at one start, before the path is taken as it is. */
    private static final int MOST_PRESSED = 3;

    private static final int MOST_LOOKS = 60;

    /** Ties that are looked for which were reached and left again within one path. */
    private static final int MOST_DIPS = 4;

    /** Changes of what acts at the start of a path; with more the forces are at their bounds by rounding only. */
    private static final int MOST_CHANGES = 100;

    /**
     * Part of a step that is too short to matter, and what counts as short, of which a group may make so many in a step; from then on the
     * least part is twice as long after so many more. So a step ends, however fast motors and stops switch one another.
     */
    private static final double TINY = 0x1p-20;

    private static final double BRIEF = 0x1p-12;
    private static final int MOST_BRIEF = 200;
    private static final double DOUBLED_AFTER = 16;

    private final Trajectories trajectories;
    private final State state;
    private final Ties ties;
    private final TiedMotion tied;
    private CourseObserver observer;

    /** What motors and stops remember at the start of a stride, and at its end. */
    private double[] decided = {};

    private double[] kept = {};

    /** Where the ties that are watched will be reached, by what was seen of each of them. */
    private final Crossing crossing = new Crossing();

    /** What was watched at the start of a path. */
    private double startWatch;

    /** Whether forces were within their bounds at both ends of the last stride, but not in between. */
    private boolean isBlurred;

    /** By first body of a group: the step in which it made brief parts last, and how many. */
    private double[] briefIn = {};

    private int[] brief = {};

    SwitchedMotion(State state, Trajectories trajectories, Ties ties, TiedMotion tied) {
        this.state = state;
        this.trajectories = trajectories;
        this.ties = ties;
        this.tied = tied;
    }

    void setObserver(CourseObserver who) {
        observer = who;
    }

    /** Advances a group from an offset until a motor reaches its speed or a joint its stop; returns how long. */
    double advance(Motion motion, IntList group, double t, double tau, double limit, Path path) {
        double length = advanceUntilSwitch(motion, group, t, tau, limit, path);
        double least = tau > 0 ? Math.min(leastLength(group.values[0], length), limit) : 0;
        if (!(length < least)) {
            return length;
        }
        tied.again(group);
        tied.advance(motion, group, t, least, path);
        return least;
    }

    /**
     * How long a stride must be that was to be of some length. Where motors and stops contradict one another, each switches
     * the other at once or nearly so, and so on for ever.
     */
    private double leastLength(int first, double length) {
        if (first >= brief.length) {
            brief = Arrays.copyOf(brief, state.size());
            briefIn = Arrays.copyOf(briefIn, state.size());
        }
        int count = briefIn[first] == trajectories.step() ? brief[first] : 0;
        if (length >= Math.max(BRIEF * trajectories.h(), leastLength(count))) {
            return 0;
        }
        brief[first] = count + 1;
        briefIn[first] = trajectories.step();
        return leastLength(count + 1);
    }

    private double leastLength(int count) {
        return count <= MOST_BRIEF ? 0 : TINY * trajectories.h() * StrictMath.pow(2, (count - MOST_BRIEF) / DOUBLED_AFTER);
    }

    private double advanceUntilSwitch(Motion motion, IntList group, double t, double tau, double limit, Path path) {
        if (ties.decide(group, trajectories.h())) {
            for (int k = 0; k < group.size; k++) {
                trajectories.anchor(group.values[k], tau, state);
            }
        }
        path.ensure(state.x().length);
        begin(motion, group, t, path);
        double most = Math.min(limit, AMPLE * ties.push(group, path.stage));
        for (int tries = 0; ; tries++) {
            double length = strideUntilReached(motion, group, t, most, path);
            if (tries == MOST_PRESSED || ties.watch(group, true) > -HALF) {
                return length;
            }
            double from = leave(motion, group, t, length, path);
            if (from > 0) {
                tied.again(group);
                tied.advance(motion, group, t, length, path);
                return find(motion, group, t, from, length, true, path);
            }
            ties.confirm(group, true); // they are pressed against their stops
            begin(motion, group, t, path);
        }
    }

    /** Finds the accelerations at the start, and settles which ties act. */
    private void begin(Motion motion, IntList group, double t, Path path) {
        motion.acceleration(group, t, path.stage);
        ties.confirm(group, false);
        int changes = 0;
        while (changes < MOST_CHANGES && ties.reconsider(group, path.stage)) {
            changes++;
            ties.limit(group, false);
            motion.acceleration(group, t, path.stage);
        }
        if (changes > 0) {
            ties.limit(group, true);
            motion.acceleration(group, t, path.stage);
            ties.confirm(group, false);
        }
        path.knowsFirst = false;
        path.takeFirst(group);
        tied.setStartKnown(motion.getIntegrator() instanceof RungeKutta4);
        crossing.begin();
        startWatch = ties.watch(group, false);
        ties.toGo(group, false, path.first, crossing.start());
        if (observer != null) {
            observer.decided(group);
        }
    }

    /** A stride to where the first tie is reached that was not within reach; also one which is left again before the stride ends. */
    private double strideUntilReached(Motion motion, IntList group, double t, double limit, Path path) {
        double length = strideUntilClear(motion, group, t, limit, path);
        if (ties.watch(group, false) <= -HALF) {
            length = find(motion, group, t, 0, length, false, path);
        }
        for (int k = 0; k < MOST_DIPS; k++) {
            crossing.beginAgain();
            ties.toGo(group, false, null, crossing.at(length));
            double dip = crossing.dip(length);
            if (!(dip < length)) {
                return length;
            }
            tied.again(group);
            tied.advance(motion, group, t, dip, path);
            if (ties.watch(group, false) > -HALF) {
                tied.again(group);
                tied.advance(motion, group, t, length, path);
                return length;
            }
            length = find(motion, group, t, 0, dip, false, path);
        }
        return length;
    }

    /**
     * The same, but not so long that a force which has been out of its bounds in between, and is not at its end, has let a stop go that is
     * passed: when that was would be searched for on motions on which the stop had never acted.
     */
    private double strideUntilClear(Motion motion, IntList group, double t, double limit, Path path) {
        double length = strideUntilYield(motion, group, t, limit, path);
        while (isBlurred && length > BRIEF * trajectories.h() && ties.watch(group, false) <= -HALF) {
            tied.again(group);
            ties.switches(group, decided, true);
            ties.limit(group, false);
            motion.acceleration(group, t, path.stage);
            length = strideUntilYield(motion, group, t, HALF * length, path);
        }
        return length;
    }

    /** A stride from where accelerations were just found, or to where a motor begins to yield or a stop lets go. */
    private double strideUntilYield(Motion motion, IntList group, double t, double limit, Path path) {
        double spare = ties.spare(group);
        isBlurred = false;
        decided = ties.switches(group, decided, false);
        ties.limit(group, true);
        double length = tied.stride(motion, group, t, limit, path);
        if (motion.getIntegrator().isAdaptive() && spare < Double.POSITIVE_INFINITY) {
            motion.acceleration(group, t + length, path.stage); // not all of them look at the end
        }
        return ties.limit(group, true) ? untilYield(motion, group, t, length, spare, path) : length;
    }

    /**
     * Ends a stride in which a motor was overloaded, or a stop let go, where that begins: the forces that it would need are
     * followed without their bounds until one reaches them. So the step is made of parts that are smooth.
     */
    private double untilYield(Motion motion, IntList group, double t, double length, double spare, Path path) {
        kept = ties.switches(group, kept, false);
        ties.switches(group, decided, true);
        ties.limit(group, false);
        double last = spare(motion, group, t + length, path);
        double time = length;
        if (last < 0 && spare > 0) {
            time = findYield(motion, group, t, length, spare, last, path);
        } else {
            ties.switches(group, kept, true); // it has yielded for a while only, or from the start on
            isBlurred = spare > 0;
        }
        ties.limit(group, true);
        return time;
    }

    private double spare(Motion motion, IntList group, double t, Path path) {
        motion.acceleration(group, t, path.stage);
        return ties.spare(group);
    }

    /** The time at which a force is beyond its bound by about what counts as reached, by the Illinois method. */
    private double findYield(
            Motion motion, IntList group, double t, double length, double first, double last, Path path) {
        Bracket in = new Bracket(0, first + HALF, length, last + HALF);
        double time = length;
        for (int k = 0; k < MOST_LOOKS && in.b - in.a > 0x1p-50 * length; k++) {
            time = k % 8 == 7 || Double.isInfinite(in.fa) || !(in.fb < 0) ? in.middle() : in.secant();
            tied.again(group);
            ties.switches(group, decided, true);
            tied.advance(motion, group, t, time, path);
            double f = spare(motion, group, t + time, path) + HALF;
            if (Math.abs(f) < HALF) {
                break;
            }
            in.take(time, f);
        }
        return time;
    }

    /** A time at which the near ties have been left, or 0 if there is none and the group is back at the start. */
    private double leave(Motion motion, IntList group, double t, double length, Path path) {
        for (double to = 0.5 * length; to > 1e-4 * length; to *= 0.5) {
            tied.again(group);
            tied.advance(motion, group, t, to, path);
            if (ties.watch(group, true) > 1) {
                return to;
            }
        }
        tied.again(group);
        return 0;
    }

    /**
     * Goes to where the first tie, near or not, is reached: by Newton's method from the end at hand, or where that cannot be said by
     * what was seen of each tie, on motions made anew; within what is left between the last places before and behind, which are
     * otherwise approached by the Illinois method.
     */
    private double find(Motion motion, IntList group, double t, double low, double high, boolean near, Path path) {
        Bracket in = new Bracket(low, 1, high, ties.watch(group, near));
        if (low == 0) {
            in.fa = startWatch;
            crossing.beginAgain();
        } else {
            crossing.begin();
        }
        double toGo = ties.toGo(group, near, null, crossing.at(high));
        double time = high;
        double next = Double.isNaN(toGo) ? crossing.next() : high + toGo;
        for (int k = 0; k < MOST_LOOKS && in.b - in.a > 0x1p-50 * high; k++) {
            if (k % 8 == 7) {
                next = in.middle();
            } else if (!in.has(next)) {
                next = in.secant();
            }
            next = in.has(next) ? next : in.middle(); // values may be infinite
            time = next;
            tied.again(group);
            tied.advance(motion, group, t, time, path);
            double f = ties.watch(group, near);
            if (Math.abs(f) <= HALF) {
                break;
            }
            toGo = ties.toGo(group, near, null, crossing.at(time));
            next = Double.isFinite(toGo) ? time + toGo : crossing.next();
            in.take(time, f);
        }
        return time;
    }

    /** Between its ends, where f is positive and where it is not, something becomes zero. */
    private static final class Bracket {
        double a;
        double b;
        double fa;
        double fb;

        /** −1 or +1: the end that was taken last. */
        private int last;

        Bracket(double a, double fa, double b, double fb) {
            this.a = a;
            this.b = b;
            this.fa = fa;
            this.fb = fb;
        }

        double middle() {
            return 0.5 * (a + b);
        }

        double secant() {
            return (a * fb - b * fa) / (fb - fa);
        }

        boolean has(double time) {
            return time > a && time < b;
        }

        /** Takes a time between for one of the ends; f at the other one is halved if that stays again, by the Illinois method. */
        void take(double time, double f) {
            if (f > 0) {
                a = time;
                fa = f;
                fb *= last < 0 ? HALF : 1;
                last = -1;
            } else {
                b = time;
                fb = f;
                fa *= last > 0 ? HALF : 1;
                last = 1;
            }
        }
    }
}
