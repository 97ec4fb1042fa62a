// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import sim.physics.motion.Body;

/**
 * Where a ray enters a body.
 *
 * @param body the body
 * @param x point on its surface, or the start of the ray if that is inside
 * @param y point on its surface, or the start of the ray if that is inside
 * @param nx unit normal of the surface, out of the body; against the ray if that starts inside
 * @param ny unit normal of the surface, out of the body; against the ray if that starts inside
 * @param distance length from the start of the ray; 0 if that is inside
 */
public record Hit(Body body, double x, double y, double nx, double ny, double distance) {}
