// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What an elimination costs, counted: the products of blocks that it takes from later ones. */
class EliminationOrderTest {
    private static long products(int[] a, int[] b, int bodies) {
        EliminationOrder order = new EliminationOrder(a, b, bodies);
        long sum = 0;
        for (int c = 0; c < a.length; c++) {
            long later = order.later(c).size;
            sum += later * (later + 1) / 2;
        }
        return sum;
    }

    /** A chain of n bodies, its first pinned to the world, its last too if closed. */
    private static long chain(int n, boolean isClosed) {
        int pins = isClosed ? n + 1 : n;
        int[] a = new int[pins];
        int[] b = new int[pins];
        for (int c = 0; c < pins; c++) {
            a[c] = c - 1;
            b[c] = c < n ? c : -1;
        }
        return products(a, b, n);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 10, 100, 1000, 100_000})
    void aChainCostsOneProductALink(int n) {
        assertThat(chain(n, false)).isEqualTo(n - 1);
        assertThat(chain(n, true)).isEqualTo(n);
    }

    /** A ring of n bodies: each pin but the last two meets two others. */
    @ParameterizedTest
    @ValueSource(ints = {3, 10, 100, 1000, 100_000})
    void aRingCostsThreeProductsALink(int n) {
        int[] a = new int[n];
        int[] b = new int[n];
        for (int c = 0; c < n; c++) {
            a[c] = c;
            b[c] = (c + 1) % n;
        }
        assertThat(products(a, b, n)).isEqualTo(3L * (n - 2) + 1);
    }

    /** m × m bodies, each pinned to those beside and above it: no more than the power of 3/2 that nested dissection has. */
    @ParameterizedTest
    @ValueSource(ints = {5, 10, 20, 40, 80, 160})
    void aGridCostsThePowerThreeHalves(int m) {
        int[] a = new int[2 * m * (m - 1)];
        int[] b = new int[a.length];
        int c = 0;
        for (int i = 0; i < m; i++) {
            for (int j = 0; j < m; j++) {
                if (j + 1 < m) {
                    a[c] = i * m + j;
                    b[c++] = i * m + j + 1;
                }
                if (i + 1 < m) {
                    a[c] = i * m + j;
                    b[c++] = (i + 1) * m + j;
                }
            }
        }
        assertThat(products(a, b, m * m) / Math.pow(m, 3)).isLessThan(25);
    }
}
