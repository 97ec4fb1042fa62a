// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** The matrices that the write-up prints, against dense ones typed in from the page. */
class PrintedMatricesTest {
    private final SplittableRandom random = new SplittableRandom(41);

    @Test
    void theFiveByFiveExampleNeedsItsBlockAtColumnThreeForThePrintedResult() {
        // As printed, the block is in columns 2 and 3 (of 5, counted from 1), and the page multiplies it by (4, 5), the
        // section at its ROW, giving 32, 30. The printed matrix times the printed vector is 25, 23.
        double[] x = {2, 3, 4, 5, 6};
        double[][] printed = {{0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}, {0, 3, 4, 0, 0}, {0, 5, 2, 0, 0}, {0, 0, 0, 0, 0}};
        assertThat(Matrices.product(printed, x)).containsExactly(0, 0, 25, 23, 0);
        BlockSparseMatrix matrix = new BlockSparseMatrix(5, 5);
        matrix.add(2, 1, new DenseMatrix(2, 2, 3, 4, 5, 2));
        Matrices.assertActsAs(printed, matrix, random);
        double[] y = new double[5];
        matrix.clear();
        matrix.add(2, 2, new DenseMatrix(2, 2, 3, 4, 5, 2));
        matrix.times(x, y);
        assertThat(y).containsExactly(0, 0, 32, 30, 0);
    }

    @Test
    void theCollisionMatrixOfThreeRectanglesActsAsItsPrintedValues() {
        double[][] printed = {
            {1, 0, 0, 0, 0, 0, 0, 0, 0, 0.03, 0.00},
            {0, 1, 0, 0, 0, 0, 0, 0, 0, 0.00, 0.03},
            {0, 0, 1, 0, 0, 0, 0, 0, 0, -0.02, 0.01},
            {0, 0, 0, 1, 0, 0, 0, 0, 0, -0.03, 0.00},
            {0, 0, 0, 0, 1, 0, 0, 0, 0, 0.00, -0.03},
            {0, 0, 0, 0, 0, 1, 0, 0, 0, -0.02, 0.01},
            {0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0},
            {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0},
            {0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0},
            {-0.46, -0.89, -0.05, 0.46, 0.89, 0.05, 0, 0, 0, 0.00, 0.00},
            {0.00, 0.00, 0.00, 0.00, 0.00, 0.00, 0, 0, 0, -0.89, 0.46}
        };
        BorderedIdentityMatrix matrix = threeRectangles();
        assertThat(matrix.storedValues()).isEqualTo(28);
        Matrices.assertActsAs(printed, matrix, random);
    }

    static BorderedIdentityMatrix threeRectangles() {
        BorderedIdentityMatrix matrix = new BorderedIdentityMatrix(9, 2);
        matrix.add(0, 9, new DenseMatrix(3, 2, 0.03, 0, 0, 0.03, -0.02, 0.01));
        matrix.add(3, 9, new DenseMatrix(3, 2, -0.03, 0, 0, -0.03, -0.02, 0.01));
        matrix.add(9, 0, new DenseMatrix(2, 3, -0.46, -0.89, -0.05, 0, 0, 0));
        matrix.add(9, 3, new DenseMatrix(2, 3, 0.46, 0.89, 0.05, 0, 0, 0));
        matrix.add(9, 9, new DenseMatrix(2, 2, 0, 0, -0.89, 0.46));
        return matrix;
    }

    @Test
    void theCollisionMatrixOfThreeRectanglesIsSolved() {
        double[] b = {1, 2, 0.5, -1, 0, 0.25, 3, 4, 5, -0.7, 0};
        double[] x = b.clone();
        assertThat(new BiConjugateGradient().solve(threeRectangles(), b, x).converged()).isTrue();
        double[] back = new double[11];
        threeRectangles().times(x, back);
        assertThat(back).containsExactly(b, within(1e-12));
        assertThat(x[6]).isCloseTo(3, within(1e-12)); // the third rectangle is not hit
    }

    @Test
    void theJacobianOfOneRobotAndOneCanActsAsItsPrintedValues() {
        // The page prints 26 columns for "a total of 4 objects", which would have 12; 26 is not even a multiple of 3.
        // So the offsets are those of the page, not 3 · index: robot from column 16, its effectors from 19 and 22.
        double[][] printed = {
            {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 6, 1, 0, 0, 0, 0, 0, 0},
            {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, -12, 0, 1, 0, 0, 0, 0, 0},
            {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, -6, 0, 0, 0, 1, 0, 0, 0},
            {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, -12, 0, 0, 0, 0, 1, 0, 0}
        };
        BlockSparseMatrix j = new BlockSparseMatrix(4, 26);
        j.add(0, 16, Matrices.pin(-1, 12, 6));
        j.add(0, 19, Matrices.pin(1, 0, 0));
        j.add(2, 16, Matrices.pin(-1, 12, -6));
        j.add(2, 22, Matrices.pin(1, 0, 0));
        assertThat(j.storedValues()).isEqualTo(24);
        Matrices.assertActsAs(printed, j, random);
    }

    @Test
    void theJacobianOfTheDoorsHasTheBlocksOfThePage() {
        // columns: frame 1, door 1, frame 2, frame 3, door 2, frame 4; the page prints x for "some value"
        BlockSparseMatrix j = new BlockSparseMatrix(4, 18);
        j.add(0, 0, Matrices.pin(1, 2, 3));
        j.add(0, 3, Matrices.pin(-1, 4, 5));
        j.add(2, 12, Matrices.pin(1, 6, 7));
        j.add(2, 15, Matrices.pin(-1, 8, 9));
        double[][] dense = {
            {1, 0, -3, -1, 0, 5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},
            {0, 1, 2, 0, -1, -4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},
            {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, -7, -1, 0, 9},
            {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 6, 0, -1, -8}
        };
        Matrices.assertActsAs(dense, j, random);
    }

    @Test
    void theMassInversesActAsTheirPrintedMatrix() {
        double[][] printed = {
            {0.5, 0, 0, 0, 0, 0},
            {0, 0.5, 0, 0, 0, 0},
            {0, 0, 0.1, 0, 0, 0},
            {0, 0, 0, 0.25, 0, 0},
            {0, 0, 0, 0, 0.25, 0},
            {0, 0, 0, 0, 0, 0.2}
        };
        Matrices.assertActsAs(printed, new DiagonalMatrix(new double[] {0.5, 0.5, 0.1, 0.25, 0.25, 0.2}), random);
    }
}
