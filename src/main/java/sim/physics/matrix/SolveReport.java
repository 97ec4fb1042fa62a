// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.matrix;

/**
 * What an iterative solver did.
 *
 * @param converged whether the residual is within the tolerance
 * @param iterations how many steps it took
 * @param residual ‖b − M x‖ / ‖b‖, computed from x and not updated along the way
 */
public record SolveReport(boolean converged, int iterations, double residual) {}
