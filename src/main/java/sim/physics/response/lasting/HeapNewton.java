// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.util.Arrays;

/**
 * Newton's method for the points of a {@link HeapSystem} whose bodies nothing ties (Alart and Curnier, <i>A mixed formulation
 * for frictional contact problems prone to Newton like solution methods</i>, 1991): by the impulses and velocities so far
 * each point is open, stuck, or slides; that makes all rows equations, which are solved as a whole; and so on until nothing
 * changes. A pile that rests is solved in one or two steps, however high it is.
 *
 * <p>The equations are those of a {@link HeapPiece}, solved again for what its softness leaves (method of multipliers:
 * Hestenes 1969),
 *
 * <pre>
 *   (M + Pᵀ D C) δv = Pᵀ D r,   δλ = D (r − C δv),   r = b − C v,
 * </pre>
 *
 * <p>so that of all impulses that do the same about the nearest ones are taken.
 */
final class HeapNewton {
    /** Solutions in turn of one system at most; steps in a row that may be in vain. */
    private static final int PASSES = 4;

    private static final int VAIN = 2;

    /** Times that points are passed in the time of a step. */
    private static final int STEP = 12;

    private final HeapPiece piece;

    /** By point: what its normal and its tangent lack, and the best impulses so far; 2 each. */
    private double[] lack = {};

    private double[] best = {};
    private double[] right = {};

    HeapNewton(HeapPiece piece) {
        this.piece = piece;
    }

    /** Makes room for a system. */
    void begin(HeapSystem s) {
        lack = lack.length < 2 * s.size() ? new double[4 * s.size()] : lack;
        right = right.length < 3 * s.bodyCount() ? new double[6 * s.bodyCount()] : right;
    }

    /**
     * Improves the impulses of a system, and the velocities with them.
     *
     * @param exact error of velocities at which they are right
     * @param steps at most
     * @return the error of the impulses that the system has then, the best ones that were met
     */
    double solve(HeapSystem s, double exact, int steps) {
        double least = Double.POSITIVE_INFINITY;
        int vain = 0;
        for (int k = 0; ; k++) {
            double error = classify(s);
            if (error < least) {
                least = error;
                vain = 0;
                best = s.impulses(best);
            } else {
                vain++;
            }
            if (least <= exact || k == steps || vain > VAIN || !step(s, exact)) {
                break;
            }
        }
        s.put(best);
        return least;
    }

    /** Finds what each point does; returns by how much the impulses miss it at most, as a velocity. */
    double classify(HeapSystem s) {
        double worst = 0;
        for (int p = 0; p < s.size(); p++) {
            piece.isClosed[p] = false;
            piece.slides[p] = 0;
            double n = s.normalMobility(p);
            if (n == Double.POSITIVE_INFINITY) {
                continue;
            }
            double jn = s.normalImpulse(p);
            double free = jn - (s.normal(p) - s.bound(p)) / n;
            double normal = Math.max(0, free);
            piece.isClosed[p] = free > 0;
            worst = Math.max(worst, Math.abs(normal - jn) * n);
            if (s.friction(p) > 0) {
                double t = s.tangentMobility(p);
                double jt = s.tangentImpulse(p);
                double held = jt - s.tangent(p) / t;
                double most = s.friction(p) * normal;
                piece.slides[p] = held >= most ? 1 : held <= -most ? -1 : 0;
                double now = s.friction(p) * jn; // errors are judged beside what bears it now
                worst = Math.max(worst, Math.abs(Math.max(-now, Math.min(now, held)) - jt) * t);
            }
        }
        return worst;
    }

    /** Solves the equations of the piece; false if they cannot be solved. */
    private boolean step(HeapSystem s, double exact) {
        s.pass(STEP);
        for (int p = 0; p < s.size(); p++) {
            double jn = piece.isClosed[p] ? s.normalImpulse(p) : 0;
            s.start(p, jn, piece.isStuck(s, p) ? s.tangentImpulse(p) : piece.rub(s, p) * jn);
        }
        s.refresh();
        if (!piece.factor(s)) {
            return false;
        }
        double last = Double.POSITIVE_INFINITY;
        for (int pass = 0; pass < PASSES; pass++) {
            double missing = load(s);
            if (!(missing < last) || missing <= 0.1 * exact) {
                break;
            }
            last = missing;
            piece.matrix.solve(right);
            relieve(s);
        }
        return true;
    }

    /** The right side of the equations by what points lack, of which the most is returned. */
    private double load(HeapSystem s) {
        double most = 0;
        Arrays.fill(right, 0, 3 * s.bodyCount(), 0);
        for (int p = 0; p < s.size(); p++) {
            if (piece.isClosed[p]) {
                lack[2 * p] = s.bound(p) - s.normal(p);
                lack[2 * p + 1] = piece.isStuck(s, p) ? -s.tangent(p) : 0;
                most = Math.max(most, Math.max(Math.abs(lack[2 * p]), Math.abs(lack[2 * p + 1])));
                double jn = HeapPiece.normalStiffness(s, p) * lack[2 * p];
                s.pushUnits(p, jn, along(s, p, jn, lack[2 * p + 1]), right);
            }
        }
        return most;
    }

    private double along(HeapSystem s, int p, double jn, double lack) {
        return piece.isStuck(s, p) ? HeapPiece.tangentStiffness(s, p) * lack : piece.rub(s, p) * jn;
    }

    /** Changes the impulses by the solution. */
    private void relieve(HeapSystem s) {
        for (int p = 0; p < s.size(); p++) {
            if (piece.isClosed[p]) {
                double jn = HeapPiece.normalStiffness(s, p) * (lack[2 * p] - s.normal(p, right));
                double jt = along(s, p, jn, lack[2 * p + 1] - s.tangent(p, right));
                s.addImpulse(p, jn, jt);
                s.apply(p, jn, jt);
            }
        }
    }
}
