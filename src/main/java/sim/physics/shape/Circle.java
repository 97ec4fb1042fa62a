// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.shape;

import sim.physics.internal.Check;

/** A circle. */
public final class Circle extends Shape {
    private static final long serialVersionUID = 1L;

    /**
     * Creates a circle.
     *
     * @param radius length, greater than 0
     * @throws IllegalArgumentException if the radius is not a finite number greater than 0, or the area or the moment of inertia
     *     over- or underflows
     */
    public Circle(double radius) {
        super(
                new double[2],
                Check.positive("radius", radius),
                new MassProperties(Math.PI * radius * radius, 0, 0, 0.5 * radius * radius)
                        .requireUsable("a circle of radius " + radius));
    }

    @Override
    public String toString() {
        return "Circle[radius " + radius() + "]";
    }
}
