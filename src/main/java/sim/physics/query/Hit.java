// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import sim.physics.motion.Body;

/**
 * The place where a ray enters a body, or where a shape that moves straight on meets it. A ray that starts inside, and a shape that
 * overlaps the body at its start, do so at distance 0.
 *
 * @param body the body
 * @param x x of the point on its surface, or of the start of the ray if that is inside; of a shape, the middle if they meet along an
 *     edge, and its centre if they overlap at the start
 * @param y y of that point
 * @param nx x of the unit normal of the surface, which points out of the body; against the direction if the start is inside
 * @param ny y of the unit normal of the surface, which points out of the body; against the direction if the start is inside
 * @param distance length from the start of the ray, or how far the shape moves; 0 if the start is inside
 */
public record Hit(Body body, double x, double y, double nx, double ny, double distance) {}
