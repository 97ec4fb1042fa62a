// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.shape;

import java.io.Serializable;

/**
 * The properties of a shape of uniform density that its dynamics depend on.
 *
 * @param area length²
 * @param centroidX centroid in the coordinates in which the shape was given, length
 * @param centroidY centroid in the coordinates in which the shape was given, length
 * @param unitInertia moment of inertia about the centroid, per unit of mass, length²
 */
public record MassProperties(double area, double centroidX, double centroidY, double unitInertia)
        implements Serializable {
    private static final long serialVersionUID = 1L;

    /** The same, or an exception if a body could not move with these: they have over- or underflowed. */
    MassProperties requireUsable(String shape) {
        if (!isNormal(area) || !isNormal(unitInertia)) {
            throw new IllegalArgumentException(shape + " is too large or too small: its area is " + area
                    + " and its moment of inertia for a unit of mass " + unitInertia
                    + ", both must be finite and at least " + Double.MIN_NORMAL);
        }
        return this;
    }

    private static boolean isNormal(double value) {
        return value >= Double.MIN_NORMAL && value < Double.POSITIVE_INFINITY;
    }
}
