// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
/**
 * The broad phase of collision detection: which bodies have boxes that overlap.
 *
 * <p>For authors: {@link sim.physics.collision.broad.BroadPhase}, which is the write-up's
 * {@link sim.physics.collision.broad.SortAndSweep}, {@link sim.physics.collision.broad.BruteForce},
 * {@link sim.physics.collision.broad.CellGrid}, or their own, that reads {@link sim.physics.collision.broad.Boxes} and keeps
 * {@link sim.physics.collision.broad.Pairs}.
 */
package sim.physics.collision.broad;
