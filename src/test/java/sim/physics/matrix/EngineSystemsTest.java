// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.LongRange;
import org.junit.jupiter.api.Test;

/** The systems that the engine solves: impulses (16)–(24), constraint forces (41). */
class EngineSystemsTest {
    private final BiConjugateGradient solver = new BiConjugateGradient();

    @Property(tries = 300, seed = "16")
    void theEightEquationsGiveTheClosedFormOfTheImpulse(@ForAll @LongRange(min = 0, max = 1_000_000) long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        double[] w = {random.nextDouble(0.2, 5), random.nextDouble(0.2, 5)};
        double[] inertia = {random.nextDouble(0.2, 5), random.nextDouble(0.2, 5)};
        double angle = random.nextDouble(0, 7);
        double nx = Math.cos(angle);
        double ny = Math.sin(angle);
        double[] r = Matrices.vector(4, random); // rA, rB
        double[] before = Matrices.vector(6, random);
        double e = random.nextDouble();
        double leverA = r[0] * ny - r[1] * nx; // r⊥·n
        double leverB = r[2] * ny - r[3] * nx;

        BorderedIdentityMatrix m = new BorderedIdentityMatrix(6, 2);
        m.add(0, 6, momentum(-1, w[0], inertia[0], r[0], r[1])); // (18), (24)
        m.add(3, 6, momentum(1, w[1], inertia[1], r[2], r[3])); // (19), (24)
        m.add(6, 0, new DenseMatrix(2, 3, nx, ny, leverA, 0, 0, 0)); // (23)
        m.add(6, 3, new DenseMatrix(2, 3, -nx, -ny, -leverB, 0, 0, 0));
        m.add(6, 6, new DenseMatrix(2, 2, 0, 0, -ny, nx)); // (20)
        double un = nx * (before[0] - before[3])
                + ny * (before[1] - before[4])
                + leverA * before[2]
                - leverB * before[5];
        double[] b = {before[0], before[1], before[2], before[3], before[4], before[5], -e * un, 0};
        double[] x = b.clone();
        assertThat(solver.solve(m, b, x).converged()).isTrue();

        // j = −(1 + e) un / K
        double k = w[0] + w[1] + inertia[0] * leverA * leverA + inertia[1] * leverB * leverB;
        double j = -(1 + e) * un / k;
        assertThat(x[6]).isCloseTo(j * nx, within(1e-11));
        assertThat(x[7]).isCloseTo(j * ny, within(1e-11));
        assertThat(x[0]).isCloseTo(before[0] + w[0] * j * nx, within(1e-11));
        assertThat(x[5]).isCloseTo(before[5] - inertia[1] * leverB * j, within(1e-11));
    }

    private static DenseMatrix momentum(double sign, double w, double i, double rx, double ry) {
        return new DenseMatrix(3, 2, sign * w, 0, 0, sign * w, -sign * i * ry, sign * i * rx);
    }

    @Property(tries = 60, seed = "41")
    void aChainOfPinJointsIsSolved(
            @ForAll @IntRange(min = 1, max = 25) int joints, @ForAll @LongRange(min = 0, max = 1_000_000) long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Matrix m = chain(joints, false, random);
        double[] exact = Matrices.vector(2 * joints, random);
        double[] b = new double[2 * joints];
        m.times(exact, b);
        double[] x = new double[2 * joints];
        assertThat(new BiConjugateGradient(1e-13, 0).solve(m, b, x).converged()).isTrue();
        assertThat(x).containsExactly(exact, within(1e-7));
    }

    @Test
    void aJointThatIsThereTwiceMakesTheSystemSingularAndIsSolvedAllTheSame() {
        SplittableRandom random = new SplittableRandom(8);
        Matrix m = chain(4, true, random);
        double[] b = new double[10];
        m.times(Matrices.vector(10, random), b);
        double[] lambda = new double[10];
        assertThat(solver.solve(m, b, lambda).converged()).isTrue();
        double[] back = new double[10];
        m.times(lambda, back);
        assertThat(back).containsExactly(b, within(1e-12));
        // from zero, the two share their force: the solution of least norm
        assertThat(lambda[8]).isCloseTo(lambda[6], within(1e-10));
        assertThat(lambda[9]).isCloseTo(lambda[7], within(1e-10));
    }

    /** J W Jᵀ of a chain, the last joint twice if asked for. */
    private static Matrix chain(int joints, boolean twice, SplittableRandom random) {
        BlockSparseMatrix j = new BlockSparseMatrix(2 * (twice ? joints + 1 : joints), 3 * (joints + 1));
        DenseMatrix left = null;
        DenseMatrix right = null;
        for (int k = 0; k < joints; k++) {
            left = Matrices.pin(1, random.nextDouble(0.3, 1), random.nextDouble(-0.5, 0.5));
            right = Matrices.pin(-1, random.nextDouble(-1, -0.3), random.nextDouble(-0.5, 0.5));
            j.add(2 * k, 3 * k, left);
            j.add(2 * k, 3 * k + 3, right);
        }
        if (twice) {
            j.add(2 * joints, 3 * joints - 3, left);
            j.add(2 * joints, 3 * joints, right);
        }
        double[] w = new double[3 * (joints + 1)];
        for (int i = 0; i < w.length; i++) {
            w[i] = random.nextDouble(0.5, 2);
        }
        return new Matrices.Mobility(j, new DiagonalMatrix(w));
    }
}
