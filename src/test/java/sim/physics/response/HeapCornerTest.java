// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Elimination solves small heaps for what their conditions say. */
class HeapCornerTest {
    private static double signed(SplittableRandom random) {
        return 2 * random.nextDouble() - 1;
    }

    /** A chain of bodies that push one another and walls, one or two points a pair. */
    private static HeapSystem random(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        HeapSystem s = new HeapSystem();
        s.clear();
        s.allow(0);
        int bodies = 1 + random.nextInt(5);
        double[][] masses = new double[bodies][];
        for (int k = 0; k < bodies; k++) {
            masses[k] = new double[] {0.2 + random.nextDouble(), 3 + 10 * random.nextDouble()};
            s.enter(k, masses[k][0], masses[k][1]);
        }
        for (int k = 0; k < bodies; k++) {
            int points = 1 + random.nextInt(2);
            double angle = 0.7 * signed(random);
            for (int p = 0; p < points; p++) {
                int a = k - 1; // −1: a wall
                Impact c = new Impact();
                c.nx = StrictMath.cos(angle);
                c.ny = StrictMath.sin(angle);
                c.wA = a < 0 ? 0 : masses[a][0];
                c.iA = a < 0 ? 0 : masses[a][1];
                c.wB = masses[k][0];
                c.iB = masses[k][1];
                c.rAx = 0.3;
                c.rAy = (p - 0.5 * (points - 1)) * 0.4 + 0.05 * signed(random);
                c.rBx = -0.3;
                c.rBy = c.rAy + 0.02 * signed(random);
                c.friction = random.nextInt(4) == 0 ? 0 : 0.6 * random.nextDouble();
                c.setLevers(false, false);
                s.add(a, k, c);
                s.bound(s.size() - 1, 0.1 * signed(random));
            }
        }
        for (int k = 0; k < 3 * bodies; k++) {
            s.v[k] = k % 3 == 0 ? -random.nextDouble() : 0.5 * signed(random);
        }
        return s;
    }

    /** How much the conditions of all points are missed. */
    private static double miss(HeapSystem s) {
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

    /** With the little work of one of several solutions in turn; conjugate gradients and sweeps alone leave 155 unsolved. */
    @Test
    void theConditionsHold() {
        int exact = 0;
        for (long seed = 0; seed < 2000; seed++) {
            HeapSystem s = random(seed);
            boolean right = s.solveInTurn(1);
            exact += right && miss(s) < 1e-11 ? 1 : 0;
        }
        assertThat(exact).isGreaterThan(1980);
    }
}
