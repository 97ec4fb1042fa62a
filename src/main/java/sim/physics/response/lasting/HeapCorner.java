// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;

/**
 * Solves a {@link HeapSystem} of few points by elimination, as they are now: closed or open, held by friction or sliding. It
 * does what {@link HeapFace} does, at once, and lets the friction of what slides follow its normal impulse, which takes
 * conjugate gradients and sweeps many turns.
 */
final class HeapCorner implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Points up to which this is worth it. */
    static final int MOST = 12;

    /** Times in a row that it may be tried, before it is left to {@link HeapFace}. */
    static final int ROUNDS = 10;

    private static final int REFINEMENTS = 3;

    private final ContactEquations equations = new ContactEquations(true, REFINEMENTS);

    /** By point: its normal and its tangential unknown, or −1; and the part of its normal impulse that its tangential one is. */
    private final int[] normal = new int[MOST];

    private final int[] tangent = new int[MOST];
    private final double[] share = new double[MOST];
    private double[] change = {};
    private boolean hasRoom;

    HeapCorner() {
        // room comes with the first heap
    }

    /** Solves, as far as all points stay as they are; returns 0: of the work that there may be at most it takes nothing. */
    int solve(HeapSystem s) {
        int n = number(s);
        if (n == 0) {
            return 0;
        }
        if (!hasRoom) {
            equations.ensure(2 * MOST);
            hasRoom = true;
        }
        if (change.length < 3 * s.bodyCount()) {
            change = new double[6 * s.bodyCount()];
        }
        for (int p = 0; p < s.size(); p++) {
            column(s, p, normal[p], 1, share[p], n);
            column(s, p, tangent[p], 0, 1, n);
            if (normal[p] >= 0) {
                equations.setRight(normal[p], s.bound(p) - s.normal(p), s.normalMobility(p));
            }
            if (tangent[p] >= 0) {
                equations.setRight(tangent[p], -s.tangent(p), s.tangentMobility(p));
            }
        }
        if (equations.solve(n)) {
            go(s, allowed(s));
        }
        return 0;
    }

    private int number(HeapSystem s) {
        int n = 0;
        for (int p = 0; p < s.size(); p++) {
            boolean closed = s.isClosed(p);
            boolean held = closed && s.isStuck(p);
            normal[p] = closed ? n++ : -1;
            tangent[p] = held ? n++ : -1;
            share[p] = closed && !held ? Math.signum(s.tangentImpulse(p)) * s.friction(p) : 0;
        }
        return n;
    }

    /** What a unit at an unknown does to all. */
    private void column(HeapSystem s, int p, int column, double jn, double jt, int n) {
        if (column < 0) {
            return;
        }
        Arrays.fill(change, 0, 3 * s.bodyCount(), 0);
        s.push(p, jn, jt, change);
        for (int q = 0; q < s.size(); q++) {
            if (normal[q] >= 0) {
                equations.set(normal[q] * n + column, s.normal(q, change));
            }
            if (tangent[q] >= 0) {
                equations.set(tangent[q] * n + column, s.tangent(q, change));
            }
        }
    }

    private double normalStep(int p) {
        return normal[p] < 0 ? 0 : equations.solution(normal[p]);
    }

    private double tangentStep(int p) {
        return tangent[p] < 0 ? share[p] * normalStep(p) : equations.solution(tangent[p]);
    }

    /** The part of the way up to where the first point opens or slides: relaxation has to say what follows. */
    private double allowed(HeapSystem s) {
        double most = 1;
        for (int p = 0; p < s.size(); p++) {
            double n = normalStep(p);
            if (n < 0) {
                most = Math.min(most, -s.normalImpulse(p) / n);
            }
            if (tangent[p] >= 0) {
                double limit = s.friction(p) * s.normalImpulse(p);
                double up = tangentStep(p) - s.friction(p) * n;
                double down = -tangentStep(p) - s.friction(p) * n;
                most = up > 0 ? Math.min(most, (limit - s.tangentImpulse(p)) / up) : most;
                most = down > 0 ? Math.min(most, (limit + s.tangentImpulse(p)) / down) : most;
            }
        }
        return Math.max(0, most);
    }

    private void go(HeapSystem s, double part) {
        for (int p = 0; p < s.size(); p++) {
            if (normal[p] >= 0) {
                double jn = part * normalStep(p);
                double jt = part * tangentStep(p);
                s.addImpulse(p, jn, jt);
                s.apply(p, jn, jt);
            }
        }
    }
}
