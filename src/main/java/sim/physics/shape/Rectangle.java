// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.shape;

import sim.physics.internal.Check;

/** A rectangle whose sides are parallel to the local axes. */
public final class Rectangle extends Shape {
    private static final long serialVersionUID = 1L;

    private final double width;
    private final double height;

    /**
     * Creates a rectangle.
     *
     * @param width extent along x, length, greater than 0
     * @param height extent along y, length, greater than 0
     * @throws IllegalArgumentException if a length is not a finite number greater than 0, or the area or the moment of inertia
     *     over- or underflows
     */
    public Rectangle(double width, double height) {
        super(
                corners(width, height),
                0,
                new MassProperties(width * height, 0, 0, (width * width + height * height) / 12)
                        .requireUsable("a rectangle of width " + width + " and height " + height));
        this.width = width;
        this.height = height;
    }

    private static double[] corners(double width, double height) {
        double x = 0.5 * Check.positive("width", width);
        double y = 0.5 * Check.positive("height", height);
        return new double[] {-x, -y, x, -y, x, y, -x, y};
    }

    /**
     * Returns the width.
     *
     * @return extent along the local x axis
     */
    public double width() {
        return width;
    }

    /**
     * Returns the height.
     *
     * @return extent along the local y axis
     */
    public double height() {
        return height;
    }

    @Override
    public String toString() {
        return "Rectangle[" + width + " x " + height + "]";
    }
}
