// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

import java.io.Serializable;

/**
 * Tells what an iterative solver did.
 *
 * @param converged whether the residual is as small as was asked for, see {@link BiConjugateGradient}
 * @param iterations number of steps over all restarts
 * @param residual ‖b − M x‖ / ‖b‖, computed from x and not updated along the way
 */
public record SolveReport(boolean converged, int iterations, double residual) implements Serializable {
    private static final long serialVersionUID = 1L;
}
