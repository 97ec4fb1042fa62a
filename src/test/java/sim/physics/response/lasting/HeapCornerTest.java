// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import static org.assertj.core.api.Assertions.assertThat;
import static sim.physics.response.lasting.HeapConditions.miss;
import static sim.physics.response.lasting.HeapConditions.signed;
import static sim.physics.response.lasting.HeapConditions.touch;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Elimination solves small heaps for what their conditions say. */
class HeapCornerTest {
    /** A chain of bodies that push one another and walls, one or two points a pair. */
    private static HeapSystem random(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        HeapSystem s = new HeapSystem();
        s.clear();
        s.tolerance().allow(0);
        int bodies = 1 + random.nextInt(5);
        double[][] masses = new double[bodies][];
        for (int k = 0; k < bodies; k++) {
            masses[k] = new double[] {0.2 + random.nextDouble(), 3 + 10 * random.nextDouble()};
            s.enter(k, masses[k][0], masses[k][1]);
        }
        for (int k = 0; k < bodies; k++) {
            int points = 1 + random.nextInt(2);
            double angle = 0.7 * signed(random);
            double[] normal = {StrictMath.cos(angle), StrictMath.sin(angle)};
            for (int p = 0; p < points; p++) {
                int a = k - 1; // −1: a wall
                double high = (p - 0.5 * (points - 1)) * 0.4 + 0.05 * signed(random);
                double[] arms = {0.3, high, -0.3, high + 0.02 * signed(random)};
                double friction = random.nextInt(4) == 0 ? 0 : 0.6 * random.nextDouble();
                touch(s, masses, a, k, normal, arms, friction);
                s.bound(s.size() - 1, 0.1 * signed(random));
            }
        }
        for (int k = 0; k < 3 * bodies; k++) {
            s.v[k] = k % 3 == 0 ? -random.nextDouble() : 0.5 * signed(random);
        }
        return s;
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
