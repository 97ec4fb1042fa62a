// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.internal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Each unknown that is eliminated has the fewest neighbours then, and is said to meet just these. */
class MinimumDegreeTest {
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theOrderIsOfMinimumDegree(boolean isSorted) {
        MinimumDegree order = new MinimumDegree(isSorted);
        SplittableRandom random = new SplittableRandom(1);
        for (int turn = 0; turn < 200; turn++) {
            int n = 1 + random.nextInt(30);
            List<Set<Integer>> near = join(order, n, random.nextInt(3 * n), random);
            order.find();
            for (int k = 0; k < n; k++) {
                int next = order.order[k];
                Set<Integer> met = near.get(next);
                assertThat(order.place[next]).isEqualTo(k);
                assertThat(met).hasSize(near.stream().filter(Objects::nonNull).mapToInt(Set::size).min().orElseThrow());
                IntList later = order.later(next);
                assertThat(Arrays.stream(later.values, 0, later.size).boxed())
                        .doesNotHaveDuplicates()
                        .containsExactlyInAnyOrderElementsOf(met);
                near.set(next, null);
                for (int other : met) {
                    near.get(other).addAll(met);
                    near.get(other).removeAll(Set.of(next, other));
                }
            }
        }
    }

    private static List<Set<Integer>> join(MinimumDegree order, int n, int edges, SplittableRandom random) {
        List<Set<Integer>> near = new ArrayList<>();
        for (int k = 0; k < n; k++) {
            near.add(new HashSet<>());
        }
        order.begin(n);
        for (int e = 0; e < edges; e++) {
            int a = random.nextInt(n);
            int b = random.nextInt(n);
            if (a != b) {
                order.join(a, b);
                near.get(a).add(b);
                near.get(b).add(a);
            }
        }
        return near;
    }
}
