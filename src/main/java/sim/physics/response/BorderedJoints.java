// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import sim.physics.internal.IntList;
import sim.physics.matrix.BiConjugateGradient;
import sim.physics.matrix.BorderedIdentityMatrix;
import sim.physics.matrix.DenseMatrix;
import sim.physics.matrix.SolveReport;
import sim.physics.matrix.SolverException;
import sim.physics.motion.State;
import sim.physics.motion.Ties;

/**
 * The write-up's own way to the impulses of an impact on jointed bodies: the momenta of all bodies of the islands,
 * (47)–(52), the joints' velocities, (53) and (54), and the impact, (20) and (23), as one bordered system.
 *
 * <pre>
 *   ẋ − W Jᵀ μ − W Jcᵀ R = ẋ before        the identity, bordered on the right
 *   J ẋ                  = 0               bordered below
 *   (vA − vB)·n          = −e (vA − vB)·n before
 *   R⊥·n                 = 0
 * </pre>
 */
final class BorderedJoints implements Serializable {
    private static final long serialVersionUID = 1L;

    private final BiConjugateGradient method = new BiConjugateGradient(1e-15, 5000);

    BorderedJoints() {
        // the matrix is made anew for each impact
    }

    /** Gives all bodies of an impact of one point their velocities afterwards, and the impact its impulse. */
    void solve(Impact c, int a, int b, int[] body, double[][] velocity, int bodies, State state, Ties ties) {
        List<double[]> rows = joints(body, bodies, ties);
        int n = 3 * bodies;
        BorderedIdentityMatrix matrix = new BorderedIdentityMatrix(n, rows.size() + 2);
        double[] right = new double[n + rows.size() + 2];
        double[] w = new double[n];
        for (int k = 0; k < bodies; k++) {
            for (int m = 0; m < 3; m++) {
                w[3 * k + m] = state.w().values()[State.BLOCK * body[k] + m];
                right[3 * k + m] = velocity[k][m];
            }
        }
        for (int r = 0; r < rows.size(); r++) {
            border(matrix, w, rows.get(r), n + r);
        }
        double e = c.restitution * c.normalVelocity();
        double size = contact(matrix, w, c, place(body, bodies, a), place(body, bodies, b), n + rows.size());
        right[n + rows.size()] = e / Math.sqrt(size);
        double[] x = right.clone();
        SolveReport report = method.solve(matrix, right, x);
        if (!report.converged()) {
            throw new SolverException("the impulses did not converge", report.iterations(), report.residual());
        }
        for (int k = 0; k < n; k++) {
            velocity[k / 3][k % 3] = x[k];
        }
        int r = n + rows.size();
        c.jn = -(x[r] * c.nx + x[r + 1] * c.ny) / Math.sqrt(size);
        c.jt = 0;
    }

    /** The rows of J over the bodies of the impact, each of about the size of one in the metric of W. */
    private static List<double[]> joints(int[] body, int bodies, Ties ties) {
        List<double[]> rows = new ArrayList<>();
        List<IntList> done = new ArrayList<>();
        for (int k = 0; k < bodies; k++) {
            if (!ties.isTied(body[k]) || done.contains(ties.island(body[k]))) {
                continue;
            }
            done.add(ties.island(body[k]));
            for (double[] wide : ties.jacobian(ties.island(body[k])).toDense()) {
                double[] row = new double[3 * bodies];
                boolean empty = true;
                for (int m = 0; m < 3 * bodies; m++) {
                    row[m] = wide[State.BLOCK * body[m / 3] + m % 3];
                    empty &= row[m] == 0;
                }
                if (!empty) {
                    rows.add(row);
                }
            }
        }
        return rows;
    }

    private static void border(BorderedIdentityMatrix matrix, double[] w, double[] row, int at) {
        double size = 0;
        for (int k = 0; k < row.length; k++) {
            size += w[k] * row[k] * row[k];
        }
        double scale = 1 / Math.sqrt(size);
        for (int k = 0; k < row.length; k += 3) {
            if (row[k] != 0 || row[k + 1] != 0 || row[k + 2] != 0) {
                double x = scale * row[k];
                double y = scale * row[k + 1];
                double turn = scale * row[k + 2];
                matrix.add(at, k, new DenseMatrix(1, 3, x, y, turn));
                matrix.add(k, at, new DenseMatrix(3, 1, -w[k] * x, -w[k + 1] * y, -w[k + 2] * turn));
            }
        }
    }

    /** The collision's rows and columns, scaled by the root of the contact's mobility, which is returned. */
    private static double contact(BorderedIdentityMatrix matrix, double[] w, Impact c, int a, int b, int at) {
        double size = c.normalMobility();
        double s = 1 / Math.sqrt(size);
        if (a >= 0) {
            int k = 3 * a;
            matrix.add(k, at, new DenseMatrix(3, 2,
                    -s * w[k], 0, 0, -s * w[k], s * w[k + 2] * c.rAy, -s * w[k + 2] * c.rAx));
            matrix.add(at, k, new DenseMatrix(2, 3, s * c.nx, s * c.ny, s * c.leverA, 0, 0, 0));
        }
        if (b >= 0) {
            int k = 3 * b;
            matrix.add(k, at, new DenseMatrix(3, 2,
                    s * w[k], 0, 0, s * w[k], -s * w[k + 2] * c.rBy, s * w[k + 2] * c.rBx));
            matrix.add(at, k, new DenseMatrix(2, 3, -s * c.nx, -s * c.ny, -s * c.leverB, 0, 0, 0));
        }
        matrix.add(at, at, new DenseMatrix(2, 2, 0, 0, -c.ny, c.nx));
        return size;
    }

    private static int place(int[] body, int bodies, int index) {
        for (int k = 0; k < bodies; k++) {
            if (body[k] == index) {
                return k;
            }
        }
        return -1;
    }
}
