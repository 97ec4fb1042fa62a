// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

/**
 * A measurement.
 *
 * @param scene where
 * @param contender who
 * @param setting step or tolerance
 * @param cost CPU time per simulated time
 * @param error against the reference
 * @param energy relative change
 * @param gap of joints at the end
 */
record Point(Scene scene, Contender contender, double setting, double cost, double error, double energy, double gap) {}
