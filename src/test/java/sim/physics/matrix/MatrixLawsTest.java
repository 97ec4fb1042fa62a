// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.LongRange;
import org.junit.jupiter.api.Test;
import sim.physics.Checkpoint;

/** What holds for every matrix of the package, and what each of them refuses. */
class MatrixLawsTest {
    @Property(tries = 300, seed = "24")
    void blocksAddUpToTheDenseMatrixTheyStandFor(
            @ForAll @IntRange(min = 3, max = 14) int rows,
            @ForAll @IntRange(min = 3, max = 14) int columns,
            @ForAll @IntRange(max = 12) int count,
            @ForAll @LongRange(min = 0, max = 1_000_000) long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        BlockSparseMatrix sparse = new BlockSparseMatrix(rows, columns);
        double[][] dense = new double[rows][columns];
        int stored = 0;
        for (int k = 0; k < count; k++) {
            DenseMatrix block = Matrices.dense(1 + random.nextInt(3), 1 + random.nextInt(3), random);
            int row = random.nextInt(rows - block.rows() + 1);
            int column = random.nextInt(columns - block.columns() + 1);
            sparse.add(row, column, block);
            stored += block.rows() * block.columns();
            addTo(dense, row, column, block);
        }
        assertThat(sparse.storedValues()).isEqualTo(stored);
        assertActsLike(dense, sparse, random);
    }

    @Property(tries = 200, seed = "54")
    void aBorderAddsUpToTheDenseMatrixItStandsFor(
            @ForAll @IntRange(max = 9) int identity,
            @ForAll @IntRange(min = 1, max = 5) int border,
            @ForAll @LongRange(min = 0, max = 1_000_000) long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        int n = identity + border;
        BorderedIdentityMatrix bordered = new BorderedIdentityMatrix(identity, border);
        double[][] dense = new double[n][n];
        for (int i = 0; i < identity; i++) {
            dense[i][i] = 1;
        }
        for (int k = 0; k < 6; k++) {
            DenseMatrix block = Matrices.dense(1, 1, random);
            int inBorder = identity + random.nextInt(border);
            int anywhere = random.nextInt(n);
            int row = k % 2 == 0 ? inBorder : anywhere;
            int column = k % 2 == 0 ? anywhere : inBorder;
            bordered.add(row, column, block);
            addTo(dense, row, column, block);
        }
        assertThat(bordered.storedValues()).isEqualTo(6);
        assertActsLike(dense, bordered, random);
    }

    private static void addTo(double[][] dense, int row, int column, DenseMatrix block) {
        for (int i = 0; i < block.rows(); i++) {
            for (int j = 0; j < block.columns(); j++) {
                dense[row + i][column + j] += block.get(i, j);
            }
        }
    }

    /** Dense products, and the law of the adjoint ⟨M x, y⟩ = ⟨x, Mᵀ y⟩. */
    private static void assertActsLike(double[][] dense, Matrix m, SplittableRandom random) {
        double[] x = Matrices.vector(m.columns(), random);
        double[] y = Matrices.vector(m.rows(), random);
        double[] mx = Matrices.vector(m.rows(), random);
        double[] my = Matrices.vector(m.columns(), random);
        m.times(x, mx);
        m.transposeTimes(y, my);
        assertThat(mx).containsExactly(Matrices.product(dense, x), within(1e-13));
        assertThat(my).containsExactly(Matrices.product(Matrices.transpose(dense, m.columns()), y), within(1e-13));
        assertThat(Vectors.dot(mx, y, m.rows())).isCloseTo(Vectors.dot(x, my, m.columns()), within(1e-12));
    }

    @Test
    void aBlockMayBeFilledAgainAfterItWasAdded() {
        BlockSparseMatrix sparse = new BlockSparseMatrix(3, 3);
        BorderedIdentityMatrix bordered = new BorderedIdentityMatrix(1, 2);
        DenseMatrix inSparse = sparse.add(0, 1, 2, 2);
        DenseMatrix inBorder = bordered.add(0, 1, 1, 2);
        for (int round = 1; round <= 2; round++) {
            inSparse.set(1, 0, round);
            inBorder.set(0, 1, 10 * round);
            assertThat(sparse.toDense()).isDeepEqualTo(new double[][] {{0, 0, 0}, {0, round, 0}, {0, 0, 0}});
            assertThat(bordered.toDense()).isDeepEqualTo(new double[][] {{1, 0, 10 * round}, {0, 0, 0}, {0, 0, 0}});
        }
        sparse.clear();
        bordered.clear();
        assertThat(sparse.storedValues()).isZero();
        assertThat(sparse.toDense()).isDeepEqualTo(new double[3][3]);
        assertThat(bordered.toDense()).isDeepEqualTo(new double[][] {{1, 0, 0}, {0, 0, 0}, {0, 0, 0}});
    }

    @Test
    void vectorsMayBeLongerAndTheRestIsLeftAlone() {
        SplittableRandom random = new SplittableRandom(7);
        BlockSparseMatrix sparse = new BlockSparseMatrix(2, 2);
        sparse.add(0, 0, Matrices.dense(2, 2, random));
        BorderedIdentityMatrix bordered = new BorderedIdentityMatrix(1, 1);
        for (Matrix m : new Matrix[] {new DiagonalMatrix(2), Matrices.dense(2, 2, random), sparse, bordered}) {
            double[] y = {9, 9, 9};
            m.times(new double[] {0, 0, 5}, y);
            assertThat(y).containsExactly(0, 0, 9);
            y[0] = 9;
            m.transposeTimes(new double[] {0, 0, 5}, y);
            assertThat(y).containsExactly(0, 0, 9);
        }
    }

    @Test
    void theDiagonalIsLive() {
        DiagonalMatrix w = new DiagonalMatrix(2);
        w.values()[1] = 3;
        w.set(0, 2);
        assertThat(w.get(1)).isEqualTo(3);
        assertThat(w.toDense()).isDeepEqualTo(new double[][] {{2, 0}, {0, 3}});
    }

    @Test
    void matricesComeBackFromACheckpoint() {
        BorderedIdentityMatrix matrix = PrintedMatricesTest.threeRectangles();
        assertThat(Checkpoint.copy(matrix).toDense())
                .isDeepEqualTo(matrix.toDense());
    }

    @Test
    void productsRefuseWhatDoesNotFit() {
        double[] two = new double[2];
        double[] three = new double[3];
        BlockSparseMatrix sparse = new BlockSparseMatrix(2, 3);
        for (Matrix m : new Matrix[] {new DenseMatrix(2, 3), sparse}) {
            refused(() -> m.times(two, new double[2]), "x has 2 values: the product needs 3");
            refused(() -> m.times(three, new double[1]), "y has room for 1 values: the product has 2");
            refused(() -> m.transposeTimes(two, new double[2]), "y has room for 2 values: the product has 3");
            refused(() -> m.transposeTimes(new double[1], three), "x has 1 values: the product needs 2");
            refused(() -> m.times(three, three), "same array");
            refused(() -> m.transposeTimes(three, three), "same array");
        }
        for (Matrix m : new Matrix[] {new DiagonalMatrix(3), new BorderedIdentityMatrix(2, 1)}) {
            refused(() -> m.times(two, three), "x has 2");
            refused(() -> m.transposeTimes(two, three), "x has 2");
            refused(() -> m.times(three, three), "same array");
        }
    }

    @Test
    void sizesAndPlacesThatCannotBeAreRefused() {
        refused(() -> new DiagonalMatrix(-1), "n is -1");
        refused(() -> new DenseMatrix(0, 3), "0 x 3");
        refused(() -> new DenseMatrix(2, 2, 1, 2, 3), "3 values were given: a 2 x 2 matrix has 4");
        refused(() -> new DenseMatrix(70_000, 70_000), "too large");
        refused(() -> new BlockSparseMatrix(2, -3), "columns is -3");
        refused(() -> new BorderedIdentityMatrix(-1, 3), "identity is -1");
        refused(() -> new BorderedIdentityMatrix(3, -1), "border is -1");
        refused(() -> new BorderedIdentityMatrix(Integer.MAX_VALUE, 1), "border is 1");
        refused(() -> new DenseMatrix(2, 3).get(0, 3), "column is 3: it must be from 0 to 2");
        refused(() -> new DenseMatrix(2, 3).set(-1, 0, 1), "row is -1");
        refused(() -> new DiagonalMatrix(2).get(2), "i is 2");
        BlockSparseMatrix sparse = new BlockSparseMatrix(4, 5);
        refused(() -> sparse.add(3, 0, 2, 2), "(3, 0): it must lie within 4 x 5");
        refused(() -> sparse.add(0, 4, 2, 2), "(0, 4)");
        refused(() -> sparse.add(-1, 0, 1, 1), "(-1, 0)");
        refused(() -> sparse.add(Integer.MAX_VALUE, 0, 1, 1), "it must lie within");
        refused(() -> new BorderedIdentityMatrix(4, 2).add(3, 3, 1, 1), "block at (3, 3): it must lie in the border");
        assertThat(sparse.storedValues()).isZero();
    }

    private static void refused(Runnable call, String part) {
        assertThatIllegalArgumentException().isThrownBy(call::run).withMessageContaining(part);
    }
}
