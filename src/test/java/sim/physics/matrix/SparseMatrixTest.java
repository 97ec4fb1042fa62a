// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** The worked examples of the write-up's chapter <i>Matrix Optimization</i>, and the law of the adjoint. */
class SparseMatrixTest {
    @Test
    void theBlockProductOfTheWriteUp() {
        BlockSparseMatrix matrix = new BlockSparseMatrix(5, 5);
        matrix.add(2, 1, new DenseMatrix(2, 2, 3, 4, 5, 2));
        double[] y = new double[5];
        matrix.times(new double[] {2, 3, 4, 5, 6}, y);
        // the write-up multiplies the block by (4, 5), the section at its row, and prints 32, 30; its printed matrix
        // with the block in columns 2 and 3 gives 3·3 + 4·4 and 5·3 + 2·4
        assertThat(y).containsExactly(0, 0, 25, 23, 0);
        BlockSparseMatrix printed = new BlockSparseMatrix(5, 5);
        printed.add(2, 2, new DenseMatrix(2, 2, 3, 4, 5, 2));
        printed.times(new double[] {2, 3, 4, 5, 6}, y);
        assertThat(y).containsExactly(0, 0, 32, 30, 0);
    }

    private static BorderedIdentityMatrix threeRectangles() {
        BorderedIdentityMatrix matrix = new BorderedIdentityMatrix(9, 2);
        matrix.add(0, 9, new DenseMatrix(3, 2, 0.03, 0, 0, 0.03, -0.02, 0.01));
        matrix.add(3, 9, new DenseMatrix(3, 2, -0.03, 0, 0, -0.03, -0.02, 0.01));
        matrix.add(9, 0, new DenseMatrix(2, 3, -0.46, -0.89, -0.05, 0, 0, 0));
        matrix.add(9, 3, new DenseMatrix(2, 3, 0.46, 0.89, 0.05, 0, 0, 0));
        matrix.add(9, 9, new DenseMatrix(2, 2, 0, 0, -0.89, 0.46));
        return matrix;
    }

    @Test
    void theCollisionMatrixOfThreeRectanglesStores28ValuesOf121() {
        BorderedIdentityMatrix matrix = threeRectangles();
        assertThat(matrix.storedValues()).isEqualTo(28);
        assertThat(matrix.rows() * matrix.columns()).isEqualTo(121);
        double[][] dense = matrix.toDense();
        for (int k = 0; k < 9; k++) {
            assertThat(dense[k][k]).isEqualTo(1);
        }
        assertThat(dense[2]).containsExactly(0, 0, 1, 0, 0, 0, 0, 0, 0, -0.02, 0.01);
        assertThat(dense[4]).containsExactly(0, 0, 0, 0, 1, 0, 0, 0, 0, 0, -0.03);
        assertThat(dense[9]).containsExactly(-0.46, -0.89, -0.05, 0.46, 0.89, 0.05, 0, 0, 0, 0, 0);
        assertThat(dense[10]).containsExactly(0, 0, 0, 0, 0, 0, 0, 0, 0, -0.89, 0.46);
    }

    @Test
    void theJacobianOfOneRobotAndOneCan() {
        // 26 columns as printed: the robot's block begins at column 16, the effectors' at 19 and 22
        BlockSparseMatrix j = new BlockSparseMatrix(4, 26);
        j.add(0, 16, new DenseMatrix(2, 3, -1, 0, 6, 0, -1, -12));
        j.add(2, 16, new DenseMatrix(2, 3, -1, 0, -6, 0, -1, -12));
        j.add(0, 19, new DenseMatrix(2, 3, 1, 0, 0, 0, 1, 0));
        j.add(2, 22, new DenseMatrix(2, 3, 1, 0, 0, 0, 1, 0));
        double[] v = new double[26];
        v[16] = 1;
        v[18] = 0.5;
        double[] rate = new double[4];
        j.times(v, rate);
        assertThat(rate).containsExactly(-1 + 3, -6, -1 - 3, -6);
        assertThat(j.storedValues()).isEqualTo(24);
    }

    @Test
    void theJacobianOfTheDoors() {
        // columns: frame 1, door 1, frame 2, frame 3, door 2, frame 4
        BlockSparseMatrix j = new BlockSparseMatrix(4, 18);
        DenseMatrix ones = new DenseMatrix(2, 3, 1, 1, 1, 1, 1, 1);
        j.add(0, 0, ones);
        j.add(0, 3, ones);
        j.add(2, 12, ones);
        j.add(2, 15, ones);
        double[][] dense = j.toDense();
        assertThat(dense[0]).containsExactly(1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
        assertThat(dense[3]).containsExactly(0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1);
    }

    @Test
    void transposedProductsAreAdjoint() {
        SplittableRandom random = new SplittableRandom(1);
        BlockSparseMatrix sparse = new BlockSparseMatrix(11, 11);
        for (int k = 0; k < 6; k++) {
            DenseMatrix block = new DenseMatrix(2, 3);
            for (int i = 0; i < 6; i++) {
                block.set(i / 3, i % 3, random.nextDouble() - 0.5);
            }
            sparse.add(random.nextInt(10), random.nextInt(9), block);
        }
        adjoint(sparse, random);
        adjoint(threeRectangles(), random);
        adjoint(new DiagonalMatrix(new double[] {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}), random);
    }

    /** ⟨M x, y⟩ = ⟨x, Mᵀ y⟩. */
    private static void adjoint(Matrix m, SplittableRandom random) {
        double[] x = random.doubles(11).toArray();
        double[] y = random.doubles(11).toArray();
        double[] mx = new double[11];
        double[] my = new double[11];
        m.times(x, mx);
        m.transposeTimes(y, my);
        double left = 0;
        double right = 0;
        for (int k = 0; k < 11; k++) {
            left += mx[k] * y[k];
            right += x[k] * my[k];
        }
        assertThat(left).isCloseTo(right, within(1e-13));
    }

    @Test
    void whatDoesNotFitIsRefused() {
        BlockSparseMatrix matrix = new BlockSparseMatrix(4, 4);
        assertThatThrownBy(() -> matrix.add(3, 0, new DenseMatrix(2, 2)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("(3, 0)");
        double[] x = new double[4];
        assertThatThrownBy(() -> matrix.times(x, x)).hasMessageContaining("same array");
        assertThatThrownBy(() -> matrix.times(new double[3], x)).hasMessageContaining("x has 3");
        assertThatThrownBy(() -> new BorderedIdentityMatrix(4, 2).add(1, 1, new DenseMatrix(1, 1)))
                .hasMessageContaining("border");
    }
}
