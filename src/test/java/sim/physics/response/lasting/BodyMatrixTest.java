// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.hipparchus.linear.Array2DRowRealMatrix;
import org.hipparchus.linear.ArrayRealVector;
import org.hipparchus.linear.LUDecomposition;
import org.hipparchus.linear.RealMatrix;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The sparse factors of a heap's equations, against dense ones of a library. */
class BodyMatrixTest {
    private static final int COLUMNS = 5;

    private final SplittableRandom random = new SplittableRandom(3);
    private BodyMatrix matrix;
    private RealMatrix dense;
    private int bodies;

    private double signed() {
        return 2 * random.nextDouble() - 1;
    }

    private double[] three() {
        return new double[] {signed(), signed(), signed()};
    }

    private boolean touch(int a, int b) {
        return b < bodies && (b == a + COLUMNS || b == a + 1 && b % COLUMNS != 0 || b == a + COLUMNS + 1 && b % 3 == 0);
    }

    /** A pile of bodies in rows, some touching those below and beside; given inverse masses and moments. */
    private void pile(int n, double[] w) {
        bodies = n;
        matrix = new BodyMatrix();
        matrix.begin(n);
        for (int a = 0; a < n; a++) {
            for (int b = a + 1; b < n; b++) {
                if (touch(a, b)) {
                    matrix.touch(a, b);
                }
            }
        }
        matrix.lay();
        matrix.clear(w);
        dense = new Array2DRowRealMatrix(3 * n, 3 * n);
        for (int k = 0; k < n; k++) {
            for (int c = 0; c < 3; c++) {
                dense.setEntry(3 * k + c, 3 * k + c, 1 / w[2 * k + c / 2]);
            }
        }
        for (int a = 0; a < n; a++) {
            add(a, a);
            for (int b = 0; b < n; b++) {
                if (touch(Math.min(a, b), Math.max(a, b)) && a != b) {
                    add(a, b);
                }
            }
        }
    }

    private void add(int a, int b) {
        double[] c = three();
        double[] r = three();
        if (a == b) {
            matrix.add(a, c[0], c[1], c[2], r[0], r[1], r[2]);
        } else {
            matrix.addBeyond(matrix.block(a, b), c[0], c[1], c[2], r[0], r[1], r[2]);
        }
        for (int i = 0; i < 9; i++) {
            dense.addToEntry(3 * a + i / 3, 3 * b + i % 3, c[i / 3] * r[i % 3]);
        }
    }

    private double[] masses(int n) {
        return IntStream.range(0, 2 * n).mapToDouble(k -> 0.05 + 0.1 * random.nextDouble()).toArray();
    }

    private void check() {
        double[] right = IntStream.range(0, 3 * bodies).mapToDouble(k -> signed()).toArray();
        double[] expected = new LUDecomposition(dense).getSolver().solve(new ArrayRealVector(right)).toArray();
        matrix.solve(right);
        assertThat(right).containsExactly(expected, within(1e-12));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5, 7, 23, 60})
    void itSolvesWhatADenseMatrixSolves(int n) {
        pile(n, masses(n));
        assertThat(matrix.factor()).isTrue();
        check();
    }

    @ParameterizedTest
    @ValueSource(ints = {7, 23, 60})
    void whatChangesIsFactoredAgain(int n) {
        pile(n, masses(n));
        matrix.factor();
        for (int k = 0; k < 5; k++) {
            int a = random.nextInt(n - COLUMNS);
            add(a, a + COLUMNS);
            add(a + COLUMNS, a + COLUMNS);
            matrix.touchUp(a);
            matrix.touchUp(a + COLUMNS);
            assertThat(matrix.refactor()).isTrue();
            check();
        }
    }
}
