// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.util.Arrays;

/**
 * Finds the impulses of a {@link HeapSystem} whose bodies nothing ties by an interior point method (Mehrotra, <i>On the
 * implementation of a primal-dual interior point method</i>, 1992), in some ten to twenty eliminations, however many points open,
 * stick or slide that do not at the start. At each point, with its friction μ, its velocities u less the bound b of the normal one,
 * and its impulses λ,
 *
 * <pre>
 *   λₙ w = ε,   (μ λₙ + λₜ) u₊ = ε,   (μ λₙ − λₜ) u₋ = ε,   uₙ − b = w,   uₜ = u₊ − u₋,
 * </pre>
 *
 * <p>all factors positive, while ε goes to zero, where this is Coulomb's law. The problem is not convex, and the way to its end
 * may be blocked; mostly it is free from another start. What is left of ε {@link HeapNewton} takes away, who can tell then which
 * points are open, stuck, or slide.
 */
final class CentralPath {
    /** Eliminations at most; those that may be in vain near the end, and steps that may be blocked. */
    private static final int STEPS = 40;

    /** Times that points are passed in the time of one. */
    private static final int STEP = 25;

    private static final int VAIN = 1;
    private static final int BLOCKED = 4;

    /** Part of the way to the nearest bound; that from which on a step is short, and from which on it is blocked. */
    private static final double ALMOST = 0.995;

    private static final double SHORT = 0.3;
    private static final double STUCK = 0.05;

    /** Part of ε that is kept in a short step. */
    private static final double KEEP = 0.8;

    /** Part of the bounds of friction within which the way begins. */
    private static final double INSIDE = 0.9;

    /** Part of the first error that is near the end. */
    private static final double NEAR = 1e-3;

    /**
     * Values per point: the impulses, times what the normal one moves, so that these are velocities; w, u₊ and u₋; how all five
     * change in a step, and what the products of their changes are; how the impulses answer to velocities; what is missing in
     * the last two equations, and the right sides of the first three.
     */
    private static final int STRIDE = 21;

    private static final int JN = 0;
    private static final int JT = 1;
    private static final int W = 2;
    private static final int UP = 3;
    private static final int DOWN = 4;
    private static final int CHANGE = 5;
    private static final int PRODUCTS = 10;
    private static final int NN = 13;
    private static final int TN = 14;
    private static final int TT = 15;
    private static final int LACK_N = 16;
    private static final int LACK_T = 17;
    private static final int RIGHT_W = 18;
    private static final int RIGHT_UP = 19;
    private static final int RIGHT_DOWN = 20;

    private final HeapPiece piece;
    private double[] d = {};
    private double[] right = {};
    private double[] best = {};

    /** The mean of the products that are to be ε, and the most that is missing in an equation. */
    private double mean;

    private double lack;

    CentralPath(HeapPiece piece) {
        this.piece = piece;
    }

    /** Makes room for a system. */
    void begin(HeapSystem s) {
        d = d.length < STRIDE * s.size() ? new double[2 * STRIDE * s.size()] : d;
        right = right.length < 3 * s.bodyCount() ? new double[6 * s.bodyCount()] : right;
    }

    /**
     * Improves the impulses of a system, and the velocities with them.
     *
     * @param far a velocity by which the way begins off all bounds: the error of the impulses, or the speed of the bodies
     * @return whether the way was free
     */
    boolean follow(HeapSystem s, double far) {
        for (int p = 0; p < s.size(); p++) {
            start(s, p, far);
        }
        give(s);
        best = s.impulses(best);
        double least = Double.POSITIVE_INFINITY;
        int vain = 0;
        int blocked = 0;
        for (int k = 0; k < STEPS && vain <= VAIN && blocked <= BLOCKED; k++) {
            s.pass(STEP);
            judge(s);
            double error = Math.sqrt(mean) + lack;
            if (error < least) {
                least = error;
                best = s.impulses(best);
                vain = 0;
            } else if (least < NEAR * far) {
                vain++;
            }
            if (!(error < Double.POSITIVE_INFINITY) || !factor(s)) {
                break;
            }
            blocked += step(s) < STUCK ? 1 : 0;
        }
        s.put(best);
        return least < NEAR * far;
    }

    /** Sets a point's values to its impulses and velocities, away from all bounds. */
    private void start(HeapSystem s, int p, double far) {
        int o = STRIDE * p;
        Arrays.fill(d, o, o + STRIDE, 0);
        if (isFixed(s, p)) {
            return;
        }
        double mobility = s.normalMobility(p);
        double along = s.tangent(p);
        d[o + JN] = Math.max(far, s.normalImpulse(p) * mobility);
        d[o + W] = Math.max(far, s.normal(p) - s.bound(p));
        double most = INSIDE * s.friction(p) * d[o + JN];
        d[o + JT] = Math.max(-most, Math.min(most, s.tangentImpulse(p) * mobility));
        d[o + UP] = Math.max(0, along) + far;
        d[o + DOWN] = Math.max(0, -along) + far;
    }

    /** Whether no impulse moves a point. */
    private static boolean isFixed(HeapSystem s, int p) {
        return s.normalMobility(p) == Double.POSITIVE_INFINITY;
    }

    private void give(HeapSystem s) {
        for (int p = 0; p < s.size(); p++) {
            int o = STRIDE * p;
            double mobility = s.normalMobility(p);
            s.start(p, d[o + JN] / mobility, d[o + JT] / mobility);
        }
        s.refresh();
    }

    /** Finds by what the equations are missed. */
    private void judge(HeapSystem s) {
        double sum = 0;
        int count = 0;
        lack = 0;
        for (int p = 0; p < s.size(); p++) {
            if (isFixed(s, p)) {
                continue;
            }
            int o = STRIDE * p;
            double mu = s.friction(p);
            d[o + LACK_N] = s.normal(p) - s.bound(p) - d[o + W];
            sum += d[o + JN] * d[o + W];
            count++;
            lack = Math.max(lack, Math.abs(d[o + LACK_N]));
            if (mu > 0) {
                d[o + LACK_T] = s.tangent(p) - (d[o + UP] - d[o + DOWN]);
                sum += d[o + UP] * (mu * d[o + JN] + d[o + JT]) + d[o + DOWN] * (mu * d[o + JN] - d[o + JT]);
                count += 2;
                lack = Math.max(lack, Math.abs(d[o + LACK_T]));
            }
        }
        mean = count == 0 ? 0 : sum / count;
    }

    /** Sets the equations of a step up and eliminates them. */
    private boolean factor(HeapSystem s) {
        piece.matrix.clear(s.w);
        for (int p = 0; p < s.size(); p++) {
            if (isFixed(s, p)) {
                continue;
            }
            int o = STRIDE * p;
            double mobility = s.normalMobility(p);
            double mu = s.friction(p);
            d[o + NN] = d[o + JN] / (d[o + W] * mobility);
            if (mu > 0) {
                double up = d[o + UP] / (mu * d[o + JN] + d[o + JT]);
                double down = d[o + DOWN] / (mu * d[o + JN] - d[o + JT]);
                d[o + TT] = 1 / ((up + down) * mobility);
                d[o + TN] = -mu * (up - down) / (up + down) * d[o + NN];
            }
            piece.assemble(s, p, d[o + NN], d[o + TN], d[o + TT]);
        }
        return piece.matrix.factor();
    }

    /** Goes a step; returns which part of it was free. */
    private double step(HeapSystem s) {
        solve(s, 0, 0);
        double part = free(s);
        double left = mean(s, part) / mean;
        note(s);
        double centre = mean * Math.min(1, left * left * left);
        solve(s, centre, 1);
        part = Math.min(1, ALMOST * free(s));
        if (part < SHORT) {
            solve(s, KEEP * mean, 0);
            part = Math.min(1, ALMOST * free(s));
        }
        for (int p = 0; p < s.size(); p++) {
            for (int o = STRIDE * p; o < STRIDE * p + CHANGE; o++) {
                d[o] += part * d[o + CHANGE];
            }
        }
        give(s);
        return part;
    }

    /** Finds a step to where all products are about ε, with or without what the products of changes do. */
    private void solve(HeapSystem s, double centre, double second) {
        Arrays.fill(right, 0, 3 * s.bodyCount(), 0);
        for (int p = 0; p < s.size(); p++) {
            if (!isFixed(s, p)) {
                load(s, p, centre, second);
            }
        }
        piece.matrix.solve(right);
        for (int p = 0; p < s.size(); p++) {
            if (!isFixed(s, p)) {
                change(s, p);
            }
        }
    }

    private void load(HeapSystem s, int p, double centre, double second) {
        int o = STRIDE * p;
        double mu = s.friction(p);
        d[o + RIGHT_W] = centre / d[o + JN] - d[o + W] - second * d[o + PRODUCTS] / d[o + JN];
        double n = d[o + RIGHT_W] - d[o + LACK_N];
        double t = 0;
        if (mu > 0) {
            double up = mu * d[o + JN] + d[o + JT];
            double down = mu * d[o + JN] - d[o + JT];
            d[o + RIGHT_UP] = centre / up - d[o + UP] - second * d[o + PRODUCTS + 1] / up;
            d[o + RIGHT_DOWN] = centre / down - d[o + DOWN] - second * d[o + PRODUCTS + 2] / down;
            t = d[o + RIGHT_UP] - d[o + RIGHT_DOWN] - d[o + LACK_T];
        }
        d[o + CHANGE] = n; // until the velocities are known
        d[o + CHANGE + JT] = t;
        s.pushUnits(p, d[o + NN] * n, d[o + TN] * n + d[o + TT] * t, right);
    }

    private void change(HeapSystem s, int p) {
        int o = STRIDE * p;
        double mu = s.friction(p);
        double mobility = s.normalMobility(p);
        double n = d[o + CHANGE] - s.normal(p, right);
        double t = mu == 0 ? 0 : d[o + CHANGE + JT] - s.tangent(p, right);
        double jn = mobility * d[o + NN] * n;
        double jt = mobility * (d[o + TN] * n + d[o + TT] * t);
        d[o + CHANGE + JN] = jn;
        d[o + CHANGE + JT] = jt;
        d[o + CHANGE + W] = d[o + RIGHT_W] - d[o + W] / d[o + JN] * jn;
        if (mu > 0) {
            double up = d[o + UP] / (mu * d[o + JN] + d[o + JT]);
            double down = d[o + DOWN] / (mu * d[o + JN] - d[o + JT]);
            d[o + CHANGE + UP] = d[o + RIGHT_UP] - up * (mu * jn + jt);
            d[o + CHANGE + DOWN] = d[o + RIGHT_DOWN] - down * (mu * jn - jt);
        }
    }

    /** Notes the products of changes. */
    private void note(HeapSystem s) {
        for (int p = 0; p < s.size(); p++) {
            int o = STRIDE * p;
            double jn = s.friction(p) * d[o + CHANGE + JN];
            d[o + PRODUCTS] = d[o + CHANGE + JN] * d[o + CHANGE + W];
            d[o + PRODUCTS + 1] = d[o + CHANGE + UP] * (jn + d[o + CHANGE + JT]);
            d[o + PRODUCTS + 2] = d[o + CHANGE + DOWN] * (jn - d[o + CHANGE + JT]);
        }
    }

    /** The mean of the products after a part of a step. */
    private double mean(HeapSystem s, double part) {
        double sum = 0;
        int count = 0;
        for (int p = 0; p < s.size(); p++) {
            if (isFixed(s, p)) {
                continue;
            }
            int o = STRIDE * p;
            double jn = d[o + JN] + part * d[o + CHANGE + JN];
            double jt = d[o + JT] + part * d[o + CHANGE + JT];
            double most = s.friction(p) * jn;
            sum += jn * (d[o + W] + part * d[o + CHANGE + W]);
            count++;
            if (s.friction(p) > 0) {
                sum += (d[o + UP] + part * d[o + CHANGE + UP]) * (most + jt);
                sum += (d[o + DOWN] + part * d[o + CHANGE + DOWN]) * (most - jt);
                count += 2;
            }
        }
        return sum / count;
    }

    /** The part of a step up to the first bound. */
    private double free(HeapSystem s) {
        double most = 1;
        for (int p = 0; p < s.size(); p++) {
            if (isFixed(s, p)) {
                continue;
            }
            int o = STRIDE * p;
            double mu = s.friction(p);
            most = Math.min(most, free(d[o + JN], d[o + CHANGE + JN]));
            most = Math.min(most, free(d[o + W], d[o + CHANGE + W]));
            if (mu > 0) {
                double bound = mu * d[o + JN];
                double change = mu * d[o + CHANGE + JN];
                most = Math.min(most, free(d[o + UP], d[o + CHANGE + UP]));
                most = Math.min(most, free(d[o + DOWN], d[o + CHANGE + DOWN]));
                most = Math.min(most, free(bound + d[o + JT], change + d[o + CHANGE + JT]));
                most = Math.min(most, free(bound - d[o + JT], change - d[o + CHANGE + JT]));
            }
        }
        return most;
    }

    private static double free(double value, double change) {
        return value + change < 0 ? -value / change : 1;
    }
}
