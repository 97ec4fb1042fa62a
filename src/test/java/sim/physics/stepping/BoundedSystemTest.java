// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What is least within bounds, by its own conditions: no slope between them, and none that leads back from one. */
class BoundedSystemTest {
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5, 20, 60})
    void nothingWithinTheBoundsIsLess(int size) {
        SplittableRandom random = new SplittableRandom(size);
        BoundedSystem system = new BoundedSystem();
        for (int turn = 0; turn < 40; turn++) {
            double[][] a = band(random, size, 1 + random.nextInt(8));
            system.reserve(size);
            system.scale = 0;
            for (int i = 0; i < size; i++) {
                system.begins[i] = i;
                for (int j = i; j >= 0; j--) {
                    system.matrix[i * system.room + j] = a[i][j];
                    system.begins[i] = a[i][j] != 0 ? j : system.begins[i];
                }
                system.constant[i] = random.nextDouble() - 0.5;
                system.low[i] = -random.nextDouble();
                system.high[i] = random.nextInt(3) == 0 ? system.low[i] : random.nextInt(2) == 0 ? Double.POSITIVE_INFINITY : random.nextDouble();
                system.x[i] = 0;
            }
            system.solve();
            for (int i = 0; i < size; i++) {
                double slope = system.constant[i];
                for (int j = 0; j < size; j++) {
                    slope += a[i][j] * system.x[j];
                }
                assertThat(system.x[i]).isBetween(system.low[i], system.high[i]);
                if (system.x[i] > system.low[i] && system.x[i] < system.high[i]) {
                    assertThat(slope).isCloseTo(0, within(1e-8));
                } else if (system.low[i] < system.high[i]) {
                    assertThat(system.x[i] == system.low[i] ? slope : -slope).isGreaterThan(-1e-8);
                }
            }
        }
    }

    /** L Lᵀ of a matrix L with a band, with small and large values on its diagonal. */
    private static double[][] band(SplittableRandom random, int size, int width) {
        double[][] l = new double[size][size];
        for (int i = 0; i < size; i++) {
            for (int j = Math.max(0, i - width); j < i; j++) {
                l[i][j] = random.nextDouble() - 0.5;
            }
            l[i][i] = StrictMath.pow(10, 2 * random.nextDouble() - 1.5);
        }
        double[][] a = new double[size][size];
        for (int i = 0; i < size; i++) {
            for (int j = 0; j < size; j++) {
                for (int k = 0; k < size; k++) {
                    a[i][j] += l[i][k] * l[j][k];
                }
            }
        }
        return a;
    }
}
