// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
/**
 * The write-up's chapter <i>Matrix Optimization</i>: matrices that store only what is not known beforehand, and a solver that
 * needs nothing of them but two products.
 *
 * <p>The matrices of the engine are large and nearly empty. A collision among 1000 bodies without joints has a matrix of 3002 ×
 * 3002 values, of which 28 say something. A row of J has values for two bodies, and zeros for all others. Each form of emptiness
 * has its class:
 *
 * <table>
 * <caption>The forms</caption>
 * <tr><th>Class</th><th>Stored</th><th>The write-up's matrix</th></tr>
 * <tr><td>{@link sim.physics.matrix.DiagonalMatrix}</td><td>n values</td><td>W, mass inverses</td></tr>
 * <tr><td>{@link sim.physics.matrix.BlockSparseMatrix}</td><td>blocks at offsets</td><td>J and J̇, (41)</td></tr>
 * <tr><td>{@link sim.physics.matrix.BorderedIdentityMatrix}</td><td>blocks in the border</td>
 *     <td>collision (16)–(24), with joints (47)–(54)</td></tr>
 * <tr><td>{@link sim.physics.matrix.DenseMatrix}</td><td>all</td><td>a block of the others</td></tr>
 * </table>
 *
 * <p>Each class can multiply itself ({@link sim.physics.matrix.Matrix#times}) and its transpose
 * ({@link sim.physics.matrix.Matrix#transposeTimes}) by a vector, at a cost proportional to what it stores.
 * {@link sim.physics.matrix.BiConjugateGradient} solves M x = b with these two products alone. It gives a solution whose residual
 * it has computed afresh, or says that it has none: by its report if the iterations are used up, and by a
 * {@link sim.physics.matrix.SolverException} if the method breaks down.
 *
 * <p>Vectors may be longer than the matrix needs; the rest is left alone. Products and solutions allocate nothing once the blocks
 * and the solver's workspace are there. Nothing here is safe for use by several threads at a time. All public classes here are
 * for authors.
 */
package sim.physics.matrix;
