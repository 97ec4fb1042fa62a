// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import sim.physics.matrix.BiConjugateGradient;
import sim.physics.matrix.BorderedIdentityMatrix;
import sim.physics.matrix.DenseMatrix;
import sim.physics.matrix.SolveReport;
import sim.physics.matrix.SolverException;

/**
 * The write-up's own way to find the impulse: the eight equations (16)–(24) of two rigid bodies form one
 * {@link BorderedIdentityMatrix}, which {@link BiConjugateGradient} solves. It is the reference for the closed form. It knows
 * neither friction nor sticking.
 *
 * <pre>
 *   ẋA − wA R       = ẋA before     (18)        6 rows: the identity, with 3 × 2 blocks on the right
 *   θ̇A − iA rA⊥·R   = θ̇A before     (24)
 *   ẋB + wB R       = ẋB before     (19)
 *   (vA − vB)·n     = −e (vA − vB)·n before     (23)   2 rows: 2 × 3 blocks below, of which the second row is zero
 *   R⊥·n            = 0             (20)        and the corner
 * </pre>
 *
 * <p>Unknowns are scaled by the mobility of the contact, so that the method converges at any ratio of masses.
 */
public final class BorderedImpulse implements ImpulseSolver {
    private static final long serialVersionUID = 1L;

    private final BiConjugateGradient solver = new BiConjugateGradient(1e-15, 500);
    private final TwoBodyImpulse withFriction = new TwoBodyImpulse();

    /** Creates a solver. */
    public BorderedImpulse() {
        // the matrix is made anew for each impact
    }

    @Override
    public void solve(Impact c) {
        if (c.friction != 0 || c.sticky) {
            withFriction.solve(c);
            return;
        }
        double k = c.normalMobility();
        BorderedIdentityMatrix matrix = matrix(c, k);
        double[] before = {c.vAx, c.vAy, c.omegaA, c.vBx, c.vBy, c.omegaB};
        double[] b = new double[8];
        System.arraycopy(before, 0, b, 0, 6);
        b[6] = c.restitution * c.normalVelocity(); // −e (vA − vB)·n
        double[] x = new double[8];
        System.arraycopy(before, 0, x, 0, 6);
        SolveReport report = solver.solve(matrix, b, x);
        if (!report.converged()) {
            throw new SolverException("the impulse did not converge", report.iterations(), report.residual());
        }
        // R = k⁻¹ (x6, x7) acts on A, and −R along the normal is what the bodies part with
        c.jn = -(x[6] * c.nx + x[7] * c.ny) / k;
        c.jt = 0;
    }

    /** The matrix of an impact; the impulse is scaled by k. */
    static BorderedIdentityMatrix matrix(Impact c, double k) {
        BorderedIdentityMatrix matrix = new BorderedIdentityMatrix(6, 2);
        double wA = c.wA / k;
        double wB = c.wB / k;
        double iA = c.iA / k;
        double iB = c.iB / k;
        // r⊥ · R = rx Ry − ry Rx, but for a circle its lever along the normal is exactly zero
        matrix.add(0, 6, new DenseMatrix(3, 2, -wA, 0, 0, -wA, iA * c.rAy, -iA * c.rAx));
        matrix.add(3, 6, new DenseMatrix(3, 2, wB, 0, 0, wB, -iB * c.rBy, iB * c.rBx));
        matrix.add(6, 0, new DenseMatrix(2, 3, c.nx, c.ny, c.leverA, 0, 0, 0));
        matrix.add(6, 3, new DenseMatrix(2, 3, -c.nx, -c.ny, -c.leverB, 0, 0, 0));
        matrix.add(6, 6, new DenseMatrix(2, 2, 0, 0, -c.ny, c.nx)); // R⊥·n with R⊥ = (−Ry, Rx), turned round
        return matrix;
    }
}
