// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import sim.physics.Checkpoint;

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
    void theStartValueIsUsed() {
        DiagonalMatrix m = new DiagonalMatrix(new double[] {1, 2, 4});
        double[] x = {1, 1, 1};
        assertThat(solver.solve(m, new double[] {1, 2, 4}, x)).isEqualTo(new SolveReport(true, 0, 0));
        assertThat(x).containsExactly(1, 1, 1);
    }

    @Test
    void aDiagonalOfThreeValuesTakesThreeIterationsAndOneWithItsPreconditioner() {
        DiagonalMatrix m = new DiagonalMatrix(new double[] {1, 2, 4});
        DiagonalMatrix inverse = new DiagonalMatrix(new double[] {1, 0.5, 0.25});
        double[] b = {1, 1, 1};
        assertThat(solver.solve(m, b, new double[3]).iterations()).isEqualTo(3);
        double[] x = new double[3];
        assertThat(solver.solve(m, b, x, inverse).iterations()).isEqualTo(1);
        assertThat(x).containsExactly(new double[] {1, 0.5, 0.25});
    }

    @Test
    void aPreconditionerChangesTheWayButNotTheSolution() {
        SplittableRandom random = new SplittableRandom(3);
        for (int t = 0; t < 50; t++) {
            DenseMatrix m = Matrices.dense(9, 9, random);
            DiagonalMatrix inverse = new DiagonalMatrix(9);
            for (int i = 0; i < 9; i++) {
                double value = Math.pow(10, random.nextDouble(-3, 3));
                for (int j = 0; j < 9; j++) {
                    m.set(i, j, value * (m.get(i, j) + (i == j ? 9 : 0)));
                }
                inverse.set(i, 1 / m.get(i, i));
            }
            double[] exact = Matrices.vector(9, random);
            double[] b = new double[9];
            m.times(exact, b);
            double[] x = new double[9];
            SolveReport report = solver.solve(m, b, x, inverse);
            assertThat(report.converged()).isTrue();
            assertThat(report.residual()).isCloseTo(relativeResidual(m, b, x), within(1e-15));
            assertThat(report.iterations()).isLessThanOrEqualTo(30);
        }
    }

    private static double relativeResidual(Matrix m, double[] b, double[] x) {
        double[] r = new double[b.length];
        m.times(x, r);
        for (int i = 0; i < b.length; i++) {
            r[i] = b[i] - r[i];
        }
        return Vectors.norm(r, b.length) / Vectors.norm(b, b.length);
    }

    @Test
    void withTooFewIterationsItSaysSoAndGivesTheBestSoFar() {
        SplittableRandom random = new SplittableRandom(4);
        DiagonalMatrix m = new DiagonalMatrix(new double[] {1, 2, 3, 4, 5, 6});
        double[] b = Matrices.vector(6, random);
        for (int limit = 1; limit <= 5; limit++) {
            double[] x = new double[6];
            SolveReport report = new BiConjugateGradient(1e-14, limit).solve(m, b, x);
            assertThat(report.converged()).isFalse();
            assertThat(report.iterations()).isEqualTo(limit);
            assertThat(report.residual()).isLessThan(1).isCloseTo(relativeResidual(m, b, x), within(1e-15));
        }
        assertThat(new BiConjugateGradient(1e-14, 12).solve(m, b, new double[6]).converged()).isTrue();
    }

    @Test
    void theResidualOfWhatItGivesIsNeverWorseThanThatOfTheStart() {
        SplittableRandom random = new SplittableRandom(14);
        int worse = 0;
        for (int t = 0; t < 400; t++) {
            DenseMatrix m = Matrices.dense(8, 8, random);
            double[] b = Matrices.vector(8, random);
            double[] x = new double[8];
            SolveReport report = new BiConjugateGradient(1e-14, 1 + t % 6).solve(m, b, x);
            assertThat(report.residual()).isLessThanOrEqualTo(1).isCloseTo(relativeResidual(m, b, x), within(1e-14));
            worse += report.residual() == 1 ? 1 : 0;
        }
        assertThat(worse).isGreaterThan(20); // it did happen that the iterates were
    }

    @Test
    void aGradedSymmetricSystemTakesTheIterationsOfConjugateGradients() {
        double[] values = new double[80];
        Arrays.setAll(values, i -> Math.pow(10, 3.0 * i / 79));
        SplittableRandom random = new SplittableRandom(15);
        SolveReport report = new BiConjugateGradient(1e-10, 0)
                .solve(new DiagonalMatrix(values), Matrices.vector(80, random), new double[80]);
        assertThat(report.converged()).isTrue();
        assertThat(report.iterations()).isBetween(80, 200);
    }

    @Test
    void aLooseToleranceIsCheaperAndStillKept() {
        SplittableRandom random = new SplittableRandom(6);
        double[] values = new double[40];
        Arrays.setAll(values, i -> 1 + i);
        DiagonalMatrix m = new DiagonalMatrix(values);
        double[] b = Matrices.vector(40, random);
        SolveReport loose = new BiConjugateGradient(1e-3, 0).solve(m, b, new double[40]);
        SolveReport tight = solver.solve(m, b, new double[40]);
        assertThat(loose.converged()).isTrue();
        assertThat(loose.residual()).isBetween(1e-9, 1e-3);
        assertThat(tight.iterations()).isGreaterThan(loose.iterations());
        assertThat(tight.residual()).isLessThanOrEqualTo(1e-13);
    }

    @Test
    void magnitudesDoNotMatter() {
        for (double size : new double[] {1e-300, 1e-170, 1e-20, 1e20, 1e170, 1e300}) {
            double[] x = new double[2];
            double[] b = {size, 3 * size};
            assertThat(solver.solve(new DenseMatrix(2, 2, 2, 1, 0, 4), b, x).converged()).isTrue();
            assertThat(x[0] / size).isCloseTo(0.125, within(1e-14));
            assertThat(x[1] / size).isCloseTo(0.75, within(1e-14));
            double other = size > 1 ? Math.min(size, 1e200) : Math.max(size, 1e-200);
            DenseMatrix scaled = new DenseMatrix(2, 2, 2 * other, other, 0, 4 * other);
            assertThat(solver.solve(scaled, new double[] {1, 3}, new double[2]).converged()).isTrue();
        }
    }

    @Test
    void aReusedSolverGivesTheBitsOfANewOneAlsoAfterACheckpoint() {
        SplittableRandom random = new SplittableRandom(5);
        DenseMatrix large = Matrices.dense(12, 12, random);
        DenseMatrix small = new DenseMatrix(3, 3, 4, 1, 0, -1, 5, 2, 0, 1, 6);
        double[] b = Matrices.vector(12, random);
        double[] fresh = new double[3];
        SolveReport report = solver.solve(small, b, fresh);
        solver.solveInPlace(large, b, new double[12], null);
        BiConjugateGradient copy = Checkpoint.copy(solver);
        assertThat(copy.iterations()).isEqualTo(solver.iterations());
        for (BiConjugateGradient s : new BiConjugateGradient[] {solver, copy}) {
            double[] x = new double[3];
            assertThat(s.solve(small, b, x)).isEqualTo(report);
            assertThat(x).containsExactly(fresh);
            assertThat(s.converged()).isTrue();
            assertThat(s.residual()).isEqualTo(report.residual());
        }
    }

    @Test
    void solvingInPlaceAllocatesNothing() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        BorderedIdentityMatrix m = PrintedMatricesTest.threeRectangles();
        double[] b = {1, 2, 0.5, -1, 0, 0.25, 3, 4, 5, -0.7, 0};
        double[] x = new double[11];
        long allocated = Long.MAX_VALUE;
        for (int round = 0; round < 5; round++) { // the first ones load classes
            long before = threads.getCurrentThreadAllocatedBytes();
            for (int k = 0; k < 100; k++) {
                Arrays.fill(x, 0);
                solver.solveInPlace(m, b, x, null);
            }
            allocated = Math.min(allocated, threads.getCurrentThreadAllocatedBytes() - before);
        }
        assertThat(allocated).isLessThan(100); // less than a byte per solution: only the measurement itself
    }

    @Test
    void argumentsThatDoNotFitAreRefused() {
        DiagonalMatrix m = new DiagonalMatrix(new double[] {1, 2});
        double[] two = {1, 2};
        refused(() -> solver.solve(new DenseMatrix(2, 3), two, new double[2]), "2 x 3: it must be square");
        refused(() -> solver.solve(m, new double[1], two), "b has 1 values: the system has 2 unknowns");
        refused(() -> solver.solve(m, two, new double[1]), "x has 1 values: the system has 2 unknowns");
        refused(() -> solver.solve(m, two, two), "b and x are the same array");
        refused(() -> solver.solve(m, two, new double[2], new DiagonalMatrix(3)), "preconditioner has 3 values");
        refused(() -> solver.solve(m, two, new double[2], new DiagonalMatrix(2)), "preconditioner has 0.0 in row 0");
        refused(() -> new BiConjugateGradient(0, 1), "tolerance is 0.0");
        refused(() -> new BiConjugateGradient(Double.NaN, 1), "tolerance is NaN");
        refused(() -> new BiConjugateGradient(1e-10, -1), "maxIterations is -1");
    }

    private static void refused(Runnable call, String part) {
        assertThatThrownBy(call::run).isInstanceOf(IllegalArgumentException.class).hasMessageContaining(part);
    }
}
