// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import java.util.function.IntUnaryOperator;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A list of ints is sorted as the JDK sorts it, in every pattern that parts ranges badly. */
class IntListTest {
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 39, 40, 41, 42, 64, 1000, 4097, 100_000})
    void sortingIsThatOfTheJdk(int length) {
        Random random = new Random(length);
        same(length, k -> random.nextInt());
        same(length, k -> random.nextInt(3));
        same(length, k -> 7);
        same(length, k -> k);
        same(length, k -> -k);
        same(length, k -> k % 37);
        same(length, k -> Math.min(k, length - k));
        same(length, k -> Math.max(k, length - k));
        same(length, k -> (k & 1) == 0 ? k : -k);
        same(length, k -> k == length - 1 ? -1 : k);
        same(length, k -> k == 0 ? length : k);
    }

    private static void same(int length, IntUnaryOperator value) {
        IntList list = new IntList();
        for (int k = 0; k < length; k++) {
            list.add(value.applyAsInt(k));
        }
        list.add(Integer.MIN_VALUE);
        list.size--;
        int[] expected = Arrays.copyOf(list.values, length);
        Arrays.sort(expected);
        list.sort();
        assertThat(Arrays.copyOf(list.values, length)).isEqualTo(expected);
        assertThat(list.values[length]).isEqualTo(Integer.MIN_VALUE); // what is beyond is not touched
    }
}
