// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** The solver gives the solution, or says that it cannot. */
class BiConjugateGradientTest {
    private final BiConjugateGradient solver = new BiConjugateGradient();

    @Test
    void solvesRandomSystemsThatAreNotSymmetric() {
        SplittableRandom random = new SplittableRandom(2);
        for (int n = 1; n <= 12; n++) {
            DenseMatrix m = new DenseMatrix(n, n);
            for (int i = 0; i < n; i++) {
                for (int j = 0; j < n; j++) {
                    m.set(i, j, random.nextDouble() - 0.5 + (i == j ? n : 0));
                }
            }
            double[] exact = random.doubles(n).toArray();
            double[] b = new double[n];
            m.times(exact, b);
            double[] x = new double[n];
            SolveReport report = solver.solve(m, b, x);
            assertThat(report.converged()).isTrue();
            assertThat(report.iterations()).isLessThanOrEqualTo(20 * n);
            for (int k = 0; k < n; k++) {
                assertThat(x[k]).isCloseTo(exact[k], within(1e-12));
            }
        }
    }

    @Test
    void solvesASingularButConsistentSystem() {
        DenseMatrix m = new DenseMatrix(2, 2, 1, 1, 1, 1);
        double[] x = new double[2];
        assertThat(solver.solve(m, new double[] {2, 2}, x).converged()).isTrue();
        assertThat(x[0] + x[1]).isCloseTo(2, within(1e-13));
    }

    @Test
    void aRightSideOfZeroHasTheSolutionZero() {
        double[] x = {1, 2};
        SolveReport report = solver.solve(new DiagonalMatrix(new double[] {1, 2}), new double[2], x);
        assertThat(report).isEqualTo(new SolveReport(true, 0, 0));
        assertThat(x).containsExactly(0, 0);
    }

    @Test
    void anInconsistentSystemIsNeverCalledSolved() {
        DenseMatrix m = new DenseMatrix(2, 2, 0, 0, 0, 0);
        double[] x = {3, 4};
        assertThatThrownBy(() -> solver.solve(m, new double[] {1, 1}, x))
                .isInstanceOf(SolverException.class)
                .hasMessageContaining("breakdown");
        assertThat(x).containsExactly(3, 4);
    }

    @Test
    void notANumberIsAnException() {
        DenseMatrix m = new DenseMatrix(1, 1, Double.NaN);
        assertThatThrownBy(() -> solver.solve(m, new double[] {1}, new double[1]))
                .isInstanceOf(SolverException.class)
                .hasMessageContaining("not a number");
    }
}
