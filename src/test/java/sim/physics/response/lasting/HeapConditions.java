// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.util.SplittableRandom;

/** What tests of the solvers of heaps share: points between bodies, and what a solution must satisfy. */
final class HeapConditions {
    private HeapConditions() {}

    /** From −1 to 1. */
    static double signed(SplittableRandom random) {
        return 2 * random.nextDouble() - 1;
    }

    /**
     * Lets two bodies touch, a = −1 for what cannot move.
     *
     * @param masses by body, inverse mass and moment of inertia
     * @param normal from a to b, of length 1
     * @param arms from each body's centre to the point, x and y
     */
    static void touch(HeapSystem s, double[][] masses, int a, int b, double[] normal, double[] arms, double friction) {
        ContactPoint c = new ContactPoint();
        c.nx = normal[0];
        c.ny = normal[1];
        c.leverA = arms[0] * c.ny - arms[1] * c.nx;
        c.leverB = arms[2] * c.ny - arms[3] * c.nx;
        c.armA = arms[0] * c.nx + arms[1] * c.ny;
        c.armB = arms[2] * c.nx + arms[3] * c.ny;
        double[] first = a < 0 ? new double[2] : masses[a];
        double[] second = masses[b];
        double both = first[0] + second[0];
        c.normalMobility = both + (first[1] * c.leverA * c.leverA + second[1] * c.leverB * c.leverB);
        c.tangentMobility = both + (first[1] * c.armA * c.armA + second[1] * c.armB * c.armB);
        c.friction = friction;
        s.add(a, b, c);
    }

    /** How much the conditions of all points are missed. */
    static double miss(HeapSystem s) {
        double most = 0;
        for (int p = 0; p < s.size(); p++) {
            double gap = s.normal(p) - s.bound(p);
            double jn = s.normalImpulse(p);
            double jt = s.tangentImpulse(p);
            double limit = s.friction(p) * jn;
            double slip = s.tangent(p);
            most = Math.max(most, Math.max(-gap, -jn));
            most = Math.max(most, Math.min(jn, Math.abs(gap)));
            most = Math.max(most, Math.abs(jt) - limit);
            most = Math.max(most, Math.min(Math.abs(slip), limit - Math.abs(jt)));
            most = Math.max(most, Math.min(Math.abs(slip), Math.max(0, jt * slip)));
        }
        return most;
    }
}
