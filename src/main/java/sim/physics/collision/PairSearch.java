// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.io.Serializable;
import sim.physics.collision.broad.Pairs;
import sim.physics.collision.narrow.NarrowPhase;
import sim.physics.motion.Trajectories;

/**
 * A look at a pair: when its bodies touch first, or until when they are apart. It depends on the two bodies' paths and on
 * what is known of the pair, and changes nothing else.
 */
final class PairSearch implements Serializable {
    private static final long serialVersionUID = 1L;

    /** The bodies never touch on their present paths. */
    static final byte NEVER = 0;

    /** They are apart up to the offset that was found. */
    static final byte LATER = 1;

    /** They touch at that offset. */
    static final byte IMPACT = 2;

    private final Pairs pairs;
    private final Trajectories trajectories;
    private final PairMarks marks;
    private final NarrowPhase narrowPhase;

    /** What the last look found: one of the above. */
    byte found;

    PairSearch(Pairs pairs, Trajectories trajectories, PairMarks marks, NarrowPhase narrowPhase) {
        this.pairs = pairs;
        this.trajectories = trajectories;
        this.marks = marks;
        this.narrowPhase = narrowPhase;
    }

    NarrowPhase narrowPhase() {
        return narrowPhase;
    }

    /** One for another thread, to look at pairs while this one looks at others. */
    PairSearch twin() {
        return new PairSearch(pairs, trajectories, marks, narrowPhase.twin());
    }

    /**
     * Looks for a pair's first contact.
     *
     * @param pair its number
     * @param tau offset in the present step from which on to look
     * @param end until when the bodies' paths hold
     * @return an offset, if there is one that matters
     */
    double look(int pair, double tau, double end) {
        found = NEVER;
        if (marks.isUnseen(pair)) {
            return 0;
        }
        if (narrowPhase.isContinuous() && marks.clearances().isKept(pair)) {
            found = LATER;
            return trajectories.h();
        }
        return look(pair, tau, narrowPhase.boundingCircles(pair, tau), end);
    }

    /** The same for a pair that is to be looked at, and whose circles are known to meet at an offset. */
    double lookFrom(int pair, double tau, double start, double end) {
        narrowPhase.meets(pair);
        return look(pair, tau, start, end);
    }

    /** The same for a pair that is to be looked at, whose circles overlap, and where nobody has ever been accelerated. */
    double lookWithin(int pair, double tau, double end) {
        return look(pair, tau, narrowPhase.boundingCirclesWithin(pair, tau), end);
    }

    /**
     * The same from the offset on up to which the pair's circles are apart.
     *
     * @param pair its number, of one that is to be looked at
     * @param tau offset in the present step from which on to look
     * @param start what {@link NarrowPhase#boundingCircles} has just found
     * @param end until when the bodies' paths hold
     * @return an offset, if there is one that matters
     */
    private double look(int pair, double tau, double start, double end) {
        found = NEVER;
        if (start == Double.POSITIVE_INFINITY) {
            marks.clearances().forget(pair); // on this course the two may come nearer than on the one before
            return 0;
        }
        double depth = marks.depth(pair);
        double t = depth > 0
                ? narrowPhase.firstContact(pair, tau, start, end, depth)
                : narrowPhase.firstContact(pair, tau, start, end);
        if (!trajectories.areStraight()) {
            marks.clearances().note(pair, depth > 0 ? Double.NaN : narrowPhase.clearance());
        }
        boolean isApart = narrowPhase.isApart();
        if (!isApart && narrowPhase.isTouching() && t < end) {
            found = IMPACT;
            return t;
        }
        if (trajectories.stands(pairs.first(pair)) && trajectories.stands(pairs.second(pair))) {
            return 0; // until one of them has another course
        }
        found = LATER;
        if (isApart) {
            return t;
        }
        boolean driven = !narrowPhase.isContinuous()
                || !trajectories.areStraight()
                        && (trajectories.isDriven(pairs.first(pair)) || trajectories.isDriven(pairs.second(pair)));
        return driven ? trajectories.h() : t;
    }
}
