// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
/**
 * The narrow phase of collision detection: closest features of two bodies, the time of their impact, and the points at which they
 * touch then, (21). {@link sim.physics.collision.narrow.NarrowPhase} is the way in. Nothing here is for authors.
 */
package sim.physics.collision.narrow;
