// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import java.util.Arrays;
import sim.physics.collision.narrow.Manifold;

/**
 * What turning and sliding take of the gaps of a heap's points, by the velocities that its bodies reach: known when they have
 * been solved for. Bodies that set off from rest do not show it before.
 */
final class HeapBends implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Values per point: radii of the bodies that are not round, arms of those that are, gap, depth, and the most that counts. */
    private static final int STRIDE = 7;

    private static final int RADIUS_A = 0;
    private static final int RADIUS_B = 1;
    private static final int ARM_A = 2;
    private static final int ARM_B = 3;
    private static final int GAP = 4;
    private static final int DEPTH = 5;
    private static final int MOST = 6;

    private final Regain regain = new Regain();
    private double[] data = {};

    /** The bodies' numbers in the heap, −1 for what cannot move. */
    private int[] bodies = {};

    HeapBends() {
        // grows with the heaps
    }

    /** Takes in a point. */
    void set(int p, int a, int b, Manifold m, int k, ContactPoint point, BodyScale scales, int bodyA, int bodyB, double depth) {
        if (bodies.length < 2 * p + 2) {
            bodies = Arrays.copyOf(bodies, 4 * p + 4);
            data = Arrays.copyOf(data, STRIDE * (2 * p + 2));
        }
        int o = STRIDE * p;
        bodies[2 * p] = a;
        bodies[2 * p + 1] = b;
        data[o + RADIUS_A] = m.roundA ? 0 : scales.radius(bodyA);
        data[o + RADIUS_B] = m.roundB ? 0 : scales.radius(bodyB);
        data[o + ARM_A] = m.roundA ? point.armA : 0;
        data[o + ARM_B] = m.roundB ? point.armB : 0;
        data[o + GAP] = m.gaps[k];
        data[o + DEPTH] = depth;
        data[o + MOST] = scales.mostBend(bodyA, bodyB);
    }

    /** Raises the least velocities of points that would be too deep at the end of a time; returns whether there are any. */
    boolean raise(HeapSystem s, double[] before, double time) {
        boolean any = false;
        regain.set(time, time, 0);
        for (int p = 0; p < s.size(); p++) {
            int o = STRIDE * p;
            double turnA = time * turn(2 * p, data[o + RADIUS_A], s.v, before);
            double turnB = time * turn(2 * p + 1, data[o + RADIUS_B], s.v, before);
            double slide = time * Math.max(slide(s, p, s.v), slide(s, p, before));
            double bend = BodyScale.bend(turnA, data[o + RADIUS_A], turnB, data[o + RADIUS_B], slide, data[o + MOST]);
            double least = HeapGaps.leastSpeed(data[o + GAP], data[o + DEPTH], bend, regain, true, true, false);
            if (least > s.bound(p)) {
                s.bound(p, least);
                any = true;
            }
        }
        return any;
    }

    /** The larger spin of a body that is not round, at the start and in the end. */
    private double turn(int side, double radius, double[] v, double[] before) {
        int at = 3 * bodies[side] + 2;
        return radius == 0 || at < 0 ? 0 : Math.max(Math.abs(v[at]), Math.abs(before[at]));
    }

    /** How fast a point's bodies slide on one another, but for the spin of round ones, which moves no normal. */
    private double slide(HeapSystem s, int p, double[] v) {
        int a = 3 * bodies[2 * p] + 2;
        int b = 3 * bodies[2 * p + 1] + 2;
        double spinA = a < 0 ? 0 : v[a] * data[STRIDE * p + ARM_A];
        double spinB = b < 0 ? 0 : v[b] * data[STRIDE * p + ARM_B];
        return Math.abs(s.tangent(p, v) + spinA - spinB);
    }
}
