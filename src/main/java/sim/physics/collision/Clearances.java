// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.broad.Pairs;
import sim.physics.collision.narrow.NarrowPhase;
import sim.physics.internal.Growth;
import sim.physics.internal.Tolerances;
import sim.physics.motion.Trajectories;

/**
 * How far pairs are apart at least when a step ends, as the last look says: a pair whose bodies cannot go so far in the next
 * step need not be looked at in it, whatever their new courses are. Where forces change in each step, as in a crowd, all pairs
 * would be looked at anew all the time. Where nobody has ever been accelerated, looks hold for longer themselves, and none of
 * this is kept.
 */
final class Clearances implements Serializable {
    private static final long serialVersionUID = 1L;

    /**
     * Part of the smaller body by which bodies may miss their paths in a step: that of driven ones may be 10⁻⁶ of their size
     * from their motion.
     */
    private static final double MISSED = 1e-3;

    private final Pairs pairs;
    private final Trajectories trajectories;
    private final NarrowPhase narrowPhase;

    /** By pair: distance at the end of a step, at least; and that step. */
    private double[] distance = {};

    private double[] known = {};

    Clearances(Pairs pairs, Trajectories trajectories, NarrowPhase narrowPhase) {
        this.pairs = pairs;
        this.narrowPhase = narrowPhase;
        this.trajectories = trajectories;
    }

    /** Begins a step. */
    void begin() {
        int old = known.length;
        if (!trajectories.areStraight() && old < pairs.capacity()) { // others than these are looked at in any case
            distance = Arrays.copyOf(distance, Growth.length(old, pairs.capacity()));
            known = Arrays.copyOf(known, distance.length);
            Arrays.fill(known, old, known.length, Double.NEGATIVE_INFINITY);
        }
    }

    /** Forgets what is known of a pair: it is another one, or its bodies have been put elsewhere. */
    void forget(int pair) {
        if (pair < known.length) {
            known[pair] = Double.NEGATIVE_INFINITY;
        }
    }

    /** Forgets what is known of the pairs of a body. */
    void forgetAll(int body) {
        for (int k = 0; k < pairs.countOf(body) && known.length > 0; k++) {
            forget(pairs.of(body, k));
        }
    }

    /** Whether a pair surely stays apart up to the end of the step, on the present paths of its bodies. */
    boolean isKept(int pair) {
        if (!(pair < known.length && trajectories.step() - known[pair] <= 1)) {
            return false;
        }
        boolean isOfThisStep = known[pair] == trajectories.step();
        return (isOfThisStep || hasOneCourse(pairs.first(pair)) && hasOneCourse(pairs.second(pair)))
                && keep(pair, distance[pair]);
    }

    /** Whether a body has been on its course since the step began, so that it says how far the body goes in all of it. */
    private boolean hasOneCourse(int body) {
        return trajectories.duration(body, trajectories.h()) >= trajectories.h();
    }

    /** Whether a pair is apart by more than rounding where the step begins. */
    boolean isApart(int pair) {
        double size = Math.min(trajectories.radius(pairs.first(pair)), trajectories.radius(pairs.second(pair)));
        double gap = narrowPhase.gap(pair, 0);
        return gap > Math.max(narrowPhase.roundingOfGap(), Tolerances.OVERLAP * size);
    }

    /** Takes note that a pair is a distance apart at some instant of the step; NaN if that is not known. */
    void note(int pair, double apart) {
        if (pair < known.length) {
            known[pair] = Double.NEGATIVE_INFINITY;
            keep(pair, apart);
        }
    }

    private boolean keep(int pair, double apart) {
        int a = pairs.first(pair);
        int b = pairs.second(pair);
        double missed = MISSED * Math.min(trajectories.radius(a), trajectories.radius(b));
        double left = apart - missed - reach(a) - reach(b);
        if (!(left > 0)) {
            return false;
        }
        distance[pair] = left;
        known[pair] = trajectories.step();
        return true;
    }

    /** How far any point of a body goes at most in the step, from its anchor on if that is made in it. */
    private double reach(int body) {
        int o = body * Trajectories.STRIDE;
        double[] m = trajectories.data();
        double[] k = trajectories.bends();
        double d = trajectories.duration(body, trajectories.h());
        double way = speed(m, k, o, d) + speed(m, k, o + 1, d);
        double turn = narrowPhase.isCircle(body) ? 0 : speed(m, k, o + 2, d) * trajectories.radius(body);
        return Math.min(d, trajectories.h()) * (way + turn);
    }

    /** The greatest speed of a coordinate up to a time after the anchor, or more. */
    private static double speed(double[] m, double[] k, int o, double d) {
        double bend = 2 * Math.abs(k[o + Trajectories.AX]) + 3 * d * Math.abs(k[o + Trajectories.JX]);
        return Math.abs(m[o + Trajectories.VX]) + d * bend;
    }
}
