// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.util.Arrays;

/**
 * Impulses to start a solution from. Where more points bear a body than it needs, what each of them gives is not unique: the solution
 * shares the load as its start did, and one that bears next to nothing has no friction to roll or hold with.
 */
final class HeapStart {
    /** Part of the mean impulse along normals which is next to nothing. */
    private static final double LITTLE = 0.05;

    /** How many times what is known it may be at most. */
    private static final double MOST = 1e3;

    private HeapStart() {}

    /** Starts from nothing if there are as many rows as freedoms, and a closed point would start with next to no impulse, and not come to bear. */
    static void leaveNoneOut(HeapSystem s) {
        double sum = 0;
        for (int p = 0; p < s.contacts(); p++) {
            sum += s.normalImpulse(p);
        }
        double little = LITTLE * sum / s.contacts();
        boolean yes = false;
        for (int p = 0; p < s.contacts() && !s.isTied() && 2 * s.contacts() >= 3 * s.bodyCount(); p++) {
            yes |= s.normalImpulse(p) <= little && s.bound(p) > -s.tolerance().enough();
        }
        if (yes) {
            s.startFromNothing();
        }
    }

    /** Starts from that part of the impulses which comes nearest: what is too much would be taken from some points, and not from others. */
    static void temper(HeapSystem s) {
        double[] u = s.scratch();
        Arrays.fill(u, 0, 3 * s.bodyCount(), 0);
        s.pushAlone(u);
        double lacks = 0;
        double gives = 0;
        for (int p = 0; p < s.contacts(); p++) {
            double jn = s.normalImpulse(p);
            double jt = s.tangentImpulse(p);
            lacks -= jn * (s.normal(p) - s.bound(p)) + jt * s.tangent(p);
            gives += jn * s.normal(p, u) + jt * s.tangent(p, u);
        }
        double part = lacks / gives;
        for (int p = 0; p < s.contacts() && part > 0 && part < MOST; p++) {
            s.start(p, part * s.normalImpulse(p), part * s.tangentImpulse(p));
        }
    }
}
