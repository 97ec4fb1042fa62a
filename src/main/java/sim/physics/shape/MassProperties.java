// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.shape;

import java.io.Serializable;

/**
 * What the dynamics need of a shape of uniform density.
 *
 * @param area length²
 * @param centroidX centroid in the coordinates that the author gave, length
 * @param centroidY centroid in the coordinates that the author gave, length
 * @param unitInertia moment of inertia about the centroid for a unit of mass, length²
 */
public record MassProperties(double area, double centroidX, double centroidY, double unitInertia)
        implements Serializable {}
