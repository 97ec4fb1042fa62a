// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Where the method breaks down it starts again or says so, and spoils nothing. */
class BreakdownTest {
    private final BiConjugateGradient solver = new BiConjugateGradient();

    private SolverException broken(Matrix m, double[] b, double[] x) {
        assertThat(solver.solveInPlace(new DiagonalMatrix(new double[] {1}), new double[] {1}, new double[1], null))
                .isTrue();
        double[] bBefore = b.clone();
        double[] xBefore = x.clone();
        String mBefore = Arrays.deepToString(m.toDense());
        SolverException e = catchThrowableOfType(SolverException.class, () -> solver.solve(m, b, x));
        assertThat(e).isNotNull();
        assertThat(b).containsExactly(bBefore);
        assertThat(x).containsExactly(xBefore);
        assertThat(Arrays.deepToString(m.toDense())).isEqualTo(mBefore);
        assertThat(solver.converged()).isFalse();
        assertThat(solver.iterations()).isEqualTo(e.iterations());
        return e;
    }

    @Test
    void aSkewMatrixIsSolvedByAnotherShadow() {
        // p̃·M p = b·M b = 0 whatever b is
        double[] x = new double[2];
        SolveReport report = solver.solve(new DenseMatrix(2, 2, 0, 1, -1, 0), new double[] {3, -4}, x);
        assertThat(report.converged()).isTrue();
        assertThat(report.iterations()).isEqualTo(2);
        assertThat(report.residual()).isLessThan(1e-14);
        assertThat(x[0]).isCloseTo(4, within(1e-13));
    }

    @Test
    void aCyclicShiftIsSolvedByAnotherShadowInAsManyStepsAsUnknowns() {
        for (int n = 2; n <= 8; n++) {
            DenseMatrix shift = new DenseMatrix(n, n);
            for (int i = 0; i < n; i++) {
                shift.set((i + 1) % n, i, 1);
            }
            double[] b = new double[n];
            b[0] = 1;
            SolveReport report = solver.solve(shift, b, new double[n]);
            assertThat(report.converged()).as("n = %d", n).isTrue();
            assertThat(report.iterations()).isBetween(n, 2 * n);
        }
    }

    @Test
    void aBreakdownHiddenByRoundingIsSeenBeforeAnIterationIsSpentOnIt() {
        SplittableRandom random = new SplittableRandom(21);
        int solved = 0;
        for (int t = 0; t < 200; t++) {
            // a skew matrix of random values: b·M b is rounding and not zero
            DenseMatrix skew = new DenseMatrix(4, 4);
            for (int i = 0; i < 4; i++) {
                for (int j = 0; j < i; j++) {
                    double value = random.nextDouble(-1, 1);
                    skew.set(i, j, value);
                    skew.set(j, i, -value);
                }
            }
            double[] b = Matrices.vector(4, random);
            solved += new BiConjugateGradient(1e-9, 5).solve(skew, b, new double[4]).converged() ? 1 : 0;
        }
        assertThat(solved).isGreaterThan(190);
    }

    @Test
    void noSolutionAtAllNamesTheSearchDirection() {
        SolverException e = broken(new DenseMatrix(2, 2, 0, 1, 0, 0), new double[] {0, 1}, new double[] {0.5, 0});
        assertThat(e).hasMessageStartingWith("breakdown: the search direction is orthogonal to its image (p~.Mp = 0)");
        assertThat(e).hasMessageContaining("after " + e.iterations() + " iterations");
        assertThat(e).hasMessageContaining("relative residual of " + e.residual());
        assertThat(e.residual()).isGreaterThan(0.1);
    }

    @Test
    void noSolutionAtAllNamesTheShadow() {
        SolverException e = broken(new DenseMatrix(2, 2, 0, 0, -2, 0), new double[] {0, -2}, new double[] {0, 5});
        assertThat(e).hasMessageStartingWith("breakdown: the residual is orthogonal to its shadow (r~.r = 0)");
    }

    @Test
    void aMatrixOfZerosBreaksDownAtOnce() {
        SolverException e = broken(new DenseMatrix(3, 3), new double[] {1, 2, 3}, new double[] {4, 5, 6});
        assertThat(e).hasMessageContaining("p~.Mp = 0");
        assertThat(e.iterations()).isZero();
        assertThat(e.residual()).isEqualTo(1);
    }

    @Test
    void anInconsistentSystemIsNeverCalledSolved() {
        SplittableRandom random = new SplittableRandom(12);
        for (int t = 0; t < 2_000; t++) {
            // b leaves the range, which is (u, v) times a line
            DenseMatrix m = new DenseMatrix(2, 2);
            double[] u = Matrices.vector(2, random);
            double[] v = Matrices.vector(2, random);
            for (int i = 0; i < 4; i++) {
                m.set(i / 2, i % 2, u[i / 2] * v[i % 2]);
            }
            double[] b = {u[0] - u[1], u[1] + u[0]};
            double[] x = new double[2];
            boolean solved;
            try {
                solved = solver.solveInPlace(m, b, x, null);
            } catch (SolverException e) {
                solved = false;
            }
            assertThat(solved).as("system %d", t).isFalse();
        }
    }

    @Test
    void notANumberIsAnExceptionWhereverItStands() {
        DiagonalMatrix one = new DiagonalMatrix(new double[] {1, 1});
        for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY}) {
            DenseMatrix m = new DenseMatrix(2, 2, 1, 0, bad, 1);
            assertThat(broken(m, new double[] {1, 2}, new double[2])).hasMessageContaining("not a number");
            assertThat(broken(one, new double[] {1, bad}, new double[2])).hasMessageContaining("of b is infinite");
            assertThat(broken(one, new double[] {1, 2}, new double[] {bad, 0})).hasMessageContaining("or of x");
        }
    }

    @Test
    void regularSystemsOfSmallIntegersAreSolvedButForVeryFew() {
        // small integers make exact breakdowns common
        SplittableRandom random = new SplittableRandom(99);
        int regular = 0;
        int solved = 0;
        for (int t = 0; t < 20_000; t++) {
            double[] v = new double[9];
            Arrays.setAll(v, i -> random.nextInt(-2, 3) * random.nextInt(2));
            double[] b = {random.nextInt(-2, 3), random.nextInt(-2, 3), random.nextInt(1, 3)};
            double determinant = v[0] * (v[4] * v[8] - v[5] * v[7])
                    - v[1] * (v[3] * v[8] - v[5] * v[6])
                    + v[2] * (v[3] * v[7] - v[4] * v[6]);
            if (determinant == 0) {
                continue;
            }
            regular++;
            double[] x = new double[3];
            DenseMatrix m = new DenseMatrix(3, 3, v);
            if (solver.solveInPlace(m, b, x, null)) {
                solved++;
                double[] back = new double[3];
                m.times(x, back);
                assertThat(back).containsExactly(b, within(1e-11));
            }
        }
        assertThat(regular).isGreaterThan(2_000);
        assertThat(regular - solved).isLessThanOrEqualTo(1);
    }
}
