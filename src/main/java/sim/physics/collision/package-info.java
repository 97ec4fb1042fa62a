// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
/**
 * The write-up's chapter <i>Collision Detection</i>: the impacts of a step in time order. The broad phase says which pairs are
 * looked at, the narrow phase when they touch.
 *
 * <p>For authors: {@link sim.physics.collision.Overlap}, as {@code PhysicsEngine.overlaps} lists them.
 */
package sim.physics.collision;
