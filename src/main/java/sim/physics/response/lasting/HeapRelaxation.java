// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;

/**
 * Makes points of a {@link HeapSystem} right, one while the others keep their impulses: open, held by friction, or sliding, along
 * the normal and the tangent together (as in Jean's block relaxation, 1999).
 */
final class HeapRelaxation implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Determinant, relative to the product of the mobilities, from which on these do not say both impulses. */
    private static final double FLAT = 1e-9;

    /** Sweeps along conjugate directions, and how often in turn; the part of the speeds that their error may be. */
    private static final int ROUND = 15;

    private static final int ROUNDS = 8;
    private static final double PART = 0.04;

    /** How often in a heap so slow that it may come to rest, if errors do not move it; and up to which part of its fair error it is. */
    private static final int MOST_ROUNDS = 64;

    private static final double SLOW = 0.1;

    /** Of impulses, 2 per point. */
    private final ConjugateSweeps sweeps = new ConjugateSweeps();

    HeapRelaxation() {
        // grows with the heaps
    }

    /**
     * Makes one point after the other right, that many times at most.
     *
     * @param enough change at which it may end
     * @return the largest change of the last time, as a velocity
     */
    double sweep(HeapSystem s, int times, double enough) {
        double change = Double.POSITIVE_INFINITY;
        for (int k = 0; k < times && change > enough; k++) {
            change = 0;
            s.pass(1);
            for (int p = 0; p < s.size(); p++) {
                change = Math.max(change, relax(s, p));
            }
        }
        return change;
    }

    /** Makes the points of a large heap as right as is fair to ask, or as so many sweeps get them; returns their error. */
    double relaxFairly(HeapSystem s) {
        double fair = s.tolerance().fair();
        double fastest = 0;
        double error = Double.POSITIVE_INFINITY;
        for (int round = 0; round < (fastest <= SLOW * fair ? MOST_ROUNDS : ROUNDS) && error > Math.min(fair, PART * fastest); round++) {
            error = conjugate(s, ROUND);
            fastest = 0;
            for (int k = 0; k < s.bodyCount(); k++) {
                fastest = Math.max(fastest, BodyScale.largest(s.w, s.v, k));
            }
        }
        return error;
    }

    /** The same along conjugate directions. */
    double conjugate(HeapSystem s, int times) {
        sweeps.begin(2 * s.size());
        for (int k = 0; k < times; k++) {
            sweeps.before = s.impulses(sweeps.before);
            sweep(s, 1, 0);
            sweeps.goesOn(compare(s));
            follow(s);
        }
        return sweep(s, 1, 0);
    }

    /** The square of what a sweep has changed, as an energy. */
    private double compare(HeapSystem s) {
        double square = 0;
        for (int p = 0; p < s.size(); p++) {
            double normal = sweeps.change(2 * p, s.normalImpulse(p));
            double along = sweeps.change(2 * p + 1, s.tangentImpulse(p));
            square += normal == 0 ? 0 : normal * normal * s.normalMobility(p);
            square += along == 0 ? 0 : along * along * s.tangentMobility(p);
        }
        return square;
    }

    private void follow(HeapSystem s) {
        for (int p = 0; p < s.size(); p++) {
            double normal = sweeps.more(2 * p);
            double along = sweeps.more(2 * p + 1);
            if (normal != 0 || along != 0) {
                s.addImpulse(p, normal, along);
                s.apply(p, normal, along);
            }
        }
    }

    /** Makes one point right; returns by how much its velocity has changed. */
    private double relax(HeapSystem s, int p) {
        double[] data = s.data;
        int o = HeapSystem.STRIDE * p;
        double n = data[o + HeapSystem.MOBILITY_N];
        double jn = data[o + HeapSystem.IMPULSE_N];
        double jt = data[o + HeapSystem.IMPULSE_T];
        double gap = s.normal(p) - data[o + HeapSystem.BOUND];
        if (data[o + HeapSystem.FRICTION] == 0) {
            double next = Math.max(data[o + HeapSystem.LEAST], Math.min(data[o + HeapSystem.MOST], jn - gap / n));
            return next == jn && jt == 0 ? 0 : set(s, p, next, 0);
        }
        double t = data[o + HeapSystem.MOBILITY_T];
        if (s.isTied() || !(n < Double.POSITIVE_INFINITY && t < Double.POSITIVE_INFINITY)) {
            return relaxInTurn(s, p, gap);
        }
        double x = data[o + HeapSystem.CROSS];
        double slip = s.tangent(p);
        double det = n * t - x * x;
        if (!(det > FLAT * n * t)) {
            return relaxInTurn(s, p, gap);
        }
        double normal = jn + (slip * x - gap * t) / det;
        double tangent = jt + (gap * x - slip * n) / det;
        double most = data[o + HeapSystem.FRICTION] * normal;
        if (normal > 0 && Math.abs(tangent) <= most) {
            return set(s, p, normal, tangent);
        }
        double open = gap - n * jn - x * jt;
        if (open >= 0) {
            return jn == 0 && jt == 0 ? 0 : set(s, p, 0, 0);
        }
        // it slides: against the impulse that would hold it, from the velocity that it has without any
        double free = slip - x * jn - t * jt - x * open / n;
        double share = free > 0 ? -data[o + HeapSystem.FRICTION] : data[o + HeapSystem.FRICTION];
        double slides = -open / (n + share * x);
        boolean right = n + share * x > 0 && (slip - x * jn - t * jt + (x + share * t) * slides) * share <= 0;
        return right ? set(s, p, slides, share * slides) : relaxInTurn(s, p, gap);
    }

    /** Sets the impulses of a point; returns by how much its velocity changes. */
    private static double set(HeapSystem s, int p, double jn, double jt) {
        double[] data = s.data;
        int o = HeapSystem.STRIDE * p;
        double normal = jn - data[o + HeapSystem.IMPULSE_N];
        double tangential = jt - data[o + HeapSystem.IMPULSE_T];
        data[o + HeapSystem.IMPULSE_N] = jn;
        data[o + HeapSystem.IMPULSE_T] = jt;
        s.apply(p, normal, tangential);
        return Math.max(Math.abs(normal) * data[o + HeapSystem.MOBILITY_N], Math.abs(tangential) * data[o + HeapSystem.MOBILITY_T]);
    }

    /** The same along the normal first, then along the tangent: where both together say nothing, and where ties reply. */
    private static double relaxInTurn(HeapSystem s, int p, double gap) {
        double[] data = s.data;
        int o = HeapSystem.STRIDE * p;
        double old = data[o + HeapSystem.IMPULSE_N];
        double jn = Math.max(0, old - gap / data[o + HeapSystem.MOBILITY_N]);
        double change = 0;
        if (jn != old) {
            data[o + HeapSystem.IMPULSE_N] = jn;
            s.apply(p, jn - old, 0);
            change = Math.abs(jn - old) * data[o + HeapSystem.MOBILITY_N];
        }
        double most = data[o + HeapSystem.FRICTION] * jn;
        double rubbed = data[o + HeapSystem.IMPULSE_T];
        if (most == 0 && rubbed == 0) {
            return change;
        }
        double jt = rubbed - s.tangent(p) / data[o + HeapSystem.MOBILITY_T];
        jt = Math.max(-most, Math.min(most, jt));
        if (jt != rubbed) {
            data[o + HeapSystem.IMPULSE_T] = jt;
            s.apply(p, 0, jt - rubbed);
            change = Math.max(change, Math.abs(jt - rubbed) * data[o + HeapSystem.MOBILITY_T]);
        }
        return change;
    }
}
