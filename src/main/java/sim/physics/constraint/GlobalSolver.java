// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.util.Arrays;
import java.util.List;
import sim.physics.matrix.BiConjugateGradient;
import sim.physics.matrix.BlockSparseMatrix;
import sim.physics.matrix.DenseMatrix;
import sim.physics.matrix.DiagonalMatrix;
import sim.physics.matrix.Matrix;
import sim.physics.matrix.SolverException;

/**
 * Solves in the write-up's own way: J is a {@link BlockSparseMatrix}, W a {@link DiagonalMatrix}, and J W Jᵀ λ = b, (41), is
 * solved by {@link BiConjugateGradient} through {@code times} and {@code transposeTimes} alone. It is the reference for
 * {@link DirectSolver}. Where that does not converge, as it may not where constraints are redundant, the least forces are found that meet
 * all that forces can meet. If these are not found either, a {@link ConstraintException} is thrown, as by constraints that cannot be satisfied.
 */
public final class GlobalSolver extends ConstraintSolver {
    private static final long serialVersionUID = 1L;

    private static final int CORNER = 6;

    private final BiConjugateGradient method = new BiConjugateGradient(1e-15, 20_000);

    /** Creates a solver. */
    public GlobalSolver() {
        // matrices are made anew for each solve
    }

    @Override
    void prepare(Island island, double[] w) {
        // the matrix is used as it is
    }

    @Override
    void correct(Island island, double[] w, double[] u, double[] g) {
        int rows = 2 * island.nodes;
        BlockSparseMatrix jacobian = jacobian(island, w.length);
        Product product = new Product(jacobian, new DiagonalMatrix(w));
        double[] right = new double[rows];
        island.residual(u, g, right);
        double[] inverse = new double[rows];
        for (int k = 0; k < rows; k++) {
            inverse[k] = product.diagonal(k, island, w);
        }
        Arrays.fill(island.lambda, 0);
        if (!converges(product, right, island.lambda, new DiagonalMatrix(inverse))) {
            LeastForces least = new LeastForces(product, inverse);
            if (!least.solve(right, island.lambda)) {
                throw ConstraintException.ofForces(List.of(island.constraints), least.steps(), least.left());
            }
        }
        island.apply(w, island.lambda, u);
    }

    /** Whether the method finds the forces. Where constraints are redundant it may break down, or come no nearer. */
    private boolean converges(Matrix product, double[] right, double[] lambda, DiagonalMatrix inverse) {
        try {
            return method.solveInPlace(product, right, lambda, inverse);
        } catch (SolverException e) {
            return false;
        }
    }

    /** J of an island, with columns for all bodies of the state. */
    static BlockSparseMatrix jacobian(Island island, int columns) {
        island.writeRows();
        BlockSparseMatrix jacobian = new BlockSparseMatrix(2 * island.nodes, columns);
        for (int p = 0; p < island.nodes; p++) {
            if (island.blockA[p] >= 0) {
                jacobian.add(2 * p, island.blockA[p], block(island.j, 2 * CORNER * p));
            }
            if (island.blockB[p] >= 0) {
                jacobian.add(2 * p, island.blockB[p], block(island.j, 2 * CORNER * p + CORNER));
            }
        }
        return jacobian;
    }

    private static DenseMatrix block(double[] j, int o) {
        return new DenseMatrix(2, 3, j[o], j[o + 1], j[o + 2], j[o + 3], j[o + 4], j[o + 5]);
    }

    /** J W Jᵀ, as three products. */
    private static final class Product implements Matrix {
        private static final long serialVersionUID = 1L;

        private final BlockSparseMatrix jacobian;
        private final DiagonalMatrix w;
        private final double[] force;
        private final double[] acceleration;

        Product(BlockSparseMatrix jacobian, DiagonalMatrix w) {
            this.jacobian = jacobian;
            this.w = w;
            force = new double[w.rows()];
            acceleration = new double[w.rows()];
        }

        /** One over a diagonal value; 1 for an empty row. */
        double diagonal(int row, Island island, double[] values) {
            double sum = 0;
            for (int side = 0; side < 2; side++) {
                int block = side == 0 ? island.blockA[row / 2] : island.blockB[row / 2];
                for (int k = 0; block >= 0 && k < 3; k++) {
                    double entry = island.j[2 * CORNER * (row / 2) + CORNER * side + 3 * (row % 2) + k];
                    sum += values[block + k] * entry * entry;
                }
            }
            return sum == 0 ? 1 : 1 / sum;
        }

        @Override
        public int rows() {
            return jacobian.rows();
        }

        @Override
        public int columns() {
            return jacobian.rows();
        }

        @Override
        public int storedValues() {
            return jacobian.storedValues() + w.storedValues();
        }

        @Override
        public void times(double[] x, double[] y) {
            jacobian.transposeTimes(x, force);
            w.times(force, acceleration);
            jacobian.times(acceleration, y);
        }

        @Override
        public void transposeTimes(double[] x, double[] y) {
            times(x, y);
        }
    }
}
