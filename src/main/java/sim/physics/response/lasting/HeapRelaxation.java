// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;

/**
 * Makes points of a {@link HeapSystem} right, one while the others keep their impulses: open, held by friction, or sliding, along
 * the normal and the tangent together (as in Jean's block relaxation, 1999).
 */
final class HeapRelaxation implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Determinant, relative to the product of the mobilities, from which on these do not say both impulses. */
    private static final double FLAT = 1e-9;

    /** Impulses before a sweep, or what it changes; and the direction in which they go; 2 per point. */
    private double[] before = {};

    private double[] direction = {};

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
            for (int p = 0; p < s.size(); p++) {
                change = Math.max(change, relax(s, p));
            }
        }
        return change;
    }

    /**
     * The same with the changes of each sweep taken for the gradients of a method of conjugate directions (Silcowitz-Hansen, Niebe
     * and Erleben, <i>A nonsmooth nonlinear conjugate gradient method for interactive contact force problems</i>, 2010).
     */
    double conjugate(HeapSystem s, int times) {
        if (direction.length < 2 * s.size()) {
            direction = new double[4 * s.size()];
        }
        Arrays.fill(direction, 0, 2 * s.size(), 0);
        double last = 0;
        for (int k = 0; k < times; k++) {
            before = s.impulses(before);
            sweep(s, 1, 0);
            double square = compare(s);
            follow(s, k > 0 && square < last ? square / last : 0);
            last = square;
        }
        return sweep(s, 1, 0);
    }

    /** Puts changes in the place of the impulses of before; returns their square, as an energy. */
    private double compare(HeapSystem s) {
        double square = 0;
        for (int p = 0; p < s.size(); p++) {
            double normal = s.normalImpulse(p) - before[2 * p];
            double along = s.tangentImpulse(p) - before[2 * p + 1];
            before[2 * p] = normal;
            before[2 * p + 1] = along;
            square += normal == 0 ? 0 : normal * normal * s.normalMobility(p);
            square += along == 0 ? 0 : along * along * s.tangentMobility(p);
        }
        return square;
    }

    /** Goes on along the last direction, a part of it. */
    private void follow(HeapSystem s, double beta) {
        for (int p = 0; p < s.size(); p++) {
            double normal = beta == 0 ? 0 : beta * direction[2 * p];
            double along = beta == 0 ? 0 : beta * direction[2 * p + 1];
            direction[2 * p] = before[2 * p] + normal;
            direction[2 * p + 1] = before[2 * p + 1] + along;
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
