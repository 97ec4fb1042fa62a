// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.collision;

import sim.physics.motion.Body;

/**
 * Two bodies that overlap.
 *
 * @param a one body
 * @param b the other body
 * @param depth the shortest displacement that parts them, length, positive
 */
public record Overlap(Body a, Body b, double depth) {}
