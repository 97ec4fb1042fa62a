// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import sim.physics.motion.Body;

/**
 * The place where a ray enters a body.
 *
 * @param body the body
 * @param x x of the point on its surface, or of the start of the ray if that is inside
 * @param y y of the point on its surface, or of the start of the ray if that is inside
 * @param nx x of the unit normal of the surface, which points out of the body; against the ray if that starts inside
 * @param ny y of the unit normal of the surface, which points out of the body; against the ray if that starts inside
 * @param distance length from the start of the ray; 0 if that is inside
 */
public record Hit(Body body, double x, double y, double nx, double ny, double distance) {}
