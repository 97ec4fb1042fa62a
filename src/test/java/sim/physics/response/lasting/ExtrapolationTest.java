// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import sim.physics.internal.IntList;

/** Mixing ends with a linear map of rank 3 after 3 differences, and at once where the map is the one of before. */
class ExtrapolationTest {
    private static final double[] W = {1, 2, 0.5, 3};
    private static final double[] EIGENVALUES = {0.9, -0.5, 0.2, 0, 0, 0};

    private final Extrapolation extrapolation = new Extrapolation();
    private final IntList heap = new IntList();

    /** Errors after each call, of a map whose fixed point is 1. */
    private double[] run(double time, double start, int calls) {
        double[] errors = new double[calls];
        double[] v = new double[6];
        java.util.Arrays.fill(v, start);
        extrapolation.begin(heap, time);
        for (int call = 0; call < calls; call++) {
            for (int k = 0; k < v.length; k++) {
                v[k] = 1 + EIGENVALUES[k] * (v[k] - 1);
            }
            extrapolation.next(W, v);
            for (double one : v) {
                errors[call] = Math.max(errors[call], Math.abs(one - 1));
            }
        }
        return errors;
    }

    @Test
    void aLinearMapIsSolvedByItsDifferences() {
        heap.add(3);
        heap.add(5);
        double[] errors = run(1, 0, 7);
        assertThat(errors[2]).isGreaterThan(1e-6);
        assertThat(errors[4]).isLessThan(1e-12); // by iteration 0.6 would be left
    }

    @Test
    void theNextStepKnowsTheMap() {
        heap.add(3);
        heap.add(5);
        run(1, 0, 7);
        assertThat(run(1.1, -4, 3)[1]).isLessThan(1e-10);
        assertThat(run(3, -4, 3)[1]).isGreaterThan(1e-2); // another time, another map
    }
}
