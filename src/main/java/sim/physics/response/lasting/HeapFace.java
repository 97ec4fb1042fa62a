// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;

/**
 * Solves the points of a {@link HeapSystem} that are closed or stuck as linear equations, by conjugate gradients, while the
 * others keep their impulses. Relaxation finds soon which points those are, but needs a number of sweeps that grows with the
 * square of a stack's height to find their impulses (subspace minimization: Silcowitz, Niebe and Erleben, <i>Projected
 * Gauss-Seidel subspace minimization method for interactive rigid body dynamics</i>, 2010).
 */
final class HeapFace implements Serializable {
    private static final long serialVersionUID = 1L;

    /** What a direction does, relative to what its points would do alone, from which on equations contradict each other. */
    private static final double FLAT = 1e-9;

    /** Per point: its residuals, the direction, and what that does to it; along the normal and the tangent. */
    private double[] rest = {};

    private double[] direction = {};
    private boolean[] isOn = {};

    /** What the direction does to the velocities. */
    private double[] change = {};

    HeapFace() {
        // grows with the heaps
    }

    /** Solves; returns the number of iterations. */
    int solve(HeapSystem s, double right) {
        ensure(s);
        double square = begin(s);
        int most = 12 * s.bodyCount() + 10;
        int k = 0;
        while (k < most && square > 0) {
            k++;
            s.pass(2);
            double curvature = turn(s);
            if (!(curvature > 0)) {
                break;
            }
            double step = square / curvature;
            double allowed = allowed(s, step);
            for (int i = 0; i < 3 * s.bodyCount(); i++) {
                s.v[i] += allowed * change[i];
            }
            if (allowed < step) {
                for (int p = 0; p < s.size(); p++) {
                    s.addImpulse(p, allowed * direction[2 * p], allowed * direction[2 * p + 1]);
                }
                break; // a point opens or slides: relaxation has to say what follows
            }
            double worst = 0;
            double next = 0;
            for (int p = 0; p < s.size(); p++) {
                s.addImpulse(p, step * direction[2 * p], step * direction[2 * p + 1]);
                if (isOn[2 * p]) {
                    double r = rest[2 * p] - step * s.normal(p, change);
                    rest[2 * p] = r;
                    next += r * r / s.normalMobility(p);
                    worst = Math.max(worst, Math.abs(r));
                }
                if (isOn[2 * p + 1]) {
                    double r = rest[2 * p + 1] - step * s.tangent(p, change);
                    rest[2 * p + 1] = r;
                    next += r * r / s.tangentMobility(p);
                    worst = Math.max(worst, Math.abs(r));
                }
            }
            if (worst <= 0.1 * right) {
                break;
            }
            proceed(s, next / square);
            square = next;
        }
        return k;
    }

    private void ensure(HeapSystem s) {
        if (rest.length < 2 * s.size()) {
            rest = new double[4 * s.size()];
            direction = new double[4 * s.size()];
            isOn = new boolean[4 * s.size()];
        }
        if (change.length < 3 * s.bodyCount()) {
            change = new double[6 * s.bodyCount()];
        }
    }

    /** The residuals of the equations, and the first direction. */
    private double begin(HeapSystem s) {
        double square = 0;
        for (int p = 0; p < s.size(); p++) {
            isOn[2 * p] = s.isClosed(p);
            isOn[2 * p + 1] = s.isClosed(p) && s.isStuck(p);
            rest[2 * p] = isOn[2 * p] ? s.bound(p) - s.normal(p) : 0;
            rest[2 * p + 1] = isOn[2 * p + 1] ? -s.tangent(p) : 0;
            direction[2 * p] = rest[2 * p] / s.normalMobility(p);
            direction[2 * p + 1] = rest[2 * p + 1] / s.tangentMobility(p);
            square += rest[2 * p] * direction[2 * p] + rest[2 * p + 1] * direction[2 * p + 1];
        }
        return square;
    }

    /** What the direction does to the velocities; returns its product with what it does to the points. */
    private double turn(HeapSystem s) {
        java.util.Arrays.fill(change, 0, 3 * s.bodyCount(), 0);
        for (int p = 0; p < s.size(); p++) {
            if (isOn[2 * p]) {
                s.push(p, direction[2 * p], direction[2 * p + 1], change);
            }
        }
        double sum = 0;
        double alone = 0;
        for (int p = 0; p < s.size(); p++) {
            if (isOn[2 * p]) {
                sum += direction[2 * p] * s.normal(p, change);
                alone += direction[2 * p] * direction[2 * p] * s.normalMobility(p);
            }
            if (isOn[2 * p + 1]) {
                sum += direction[2 * p + 1] * s.tangent(p, change);
                alone += direction[2 * p + 1] * direction[2 * p + 1] * s.tangentMobility(p);
            }
        }
        return sum > FLAT * alone ? sum : 0;
    }

    /** How far the direction may be followed before an impulse is beyond its bounds. */
    private double allowed(HeapSystem s, double step) {
        double most = step;
        for (int p = 0; p < s.size(); p++) {
            double n = direction[2 * p];
            double t = direction[2 * p + 1];
            if (isOn[2 * p] && n != 0) {
                double bound = n < 0 ? s.leastImpulse(p) : s.mostImpulse(p);
                most = Math.min(most, (bound - s.normalImpulse(p)) / n);
            }
            if (isOn[2 * p + 1]) {
                double limit = s.friction(p) * s.normalImpulse(p);
                double up = t - s.friction(p) * n;
                double down = -t - s.friction(p) * n;
                most = up > 0 ? Math.min(most, (limit - s.tangentImpulse(p)) / up) : most;
                most = down > 0 ? Math.min(most, (limit + s.tangentImpulse(p)) / down) : most;
            }
        }
        return Math.max(0, most);
    }

    private void proceed(HeapSystem s, double beta) {
        for (int p = 0; p < s.size(); p++) {
            if (isOn[2 * p]) {
                direction[2 * p] = rest[2 * p] / s.normalMobility(p) + beta * direction[2 * p];
            }
            if (isOn[2 * p + 1]) {
                direction[2 * p + 1] = rest[2 * p + 1] / s.tangentMobility(p) + beta * direction[2 * p + 1];
            }
        }
    }
}
