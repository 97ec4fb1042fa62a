// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.scenes;

import sim.physics.scenes.SceneData.Box;

/**
 * Random places for circles and for boxes with sides along the axes, without overlap: a place is drawn uniformly and
 * rejected if the body would overlap one that is there already, by the exact test.
 */
final class Placement {
    private final Box inner;
    private final double[] x;
    private final double[] y;
    /** Half extents; those of a circle are 0, so that a circle is a point with a radius. */
    private final double[] halfWidth;

    private final double[] halfHeight;
    private final double[] radius;
    private int count;

    /** Makes an empty space for at most a number of bodies. */
    Placement(Box inner, int capacity) {
        this.inner = inner;
        x = new double[capacity];
        y = new double[capacity];
        halfWidth = new double[capacity];
        halfHeight = new double[capacity];
        radius = new double[capacity];
    }

    /** Places a circle: its x, y and the angle 0. */
    double[] circle(double r, SplitMix64 random, int tries) {
        return place(0, 0, r, random, tries);
    }

    /** Places a box: its x, y and the angle 0. */
    double[] box(double width, double height, SplitMix64 random, int tries) {
        return place(width / 2, height / 2, 0, random, tries);
    }

    private double[] place(double hw, double hh, double r, SplitMix64 random, int tries) {
        double roomX = inner.width() / 2 - hw - r;
        double roomY = inner.height() / 2 - hh - r;
        halfWidth[count] = hw;
        halfHeight[count] = hh;
        radius[count] = r;
        for (int t = 0; t < tries && roomX > 0 && roomY > 0; t++) {
            x[count] = random.between(inner.x() - roomX, inner.x() + roomX);
            y[count] = random.between(inner.y() - roomY, inner.y() + roomY);
            if (isFree()) {
                count++;
                return new double[] {x[count - 1], y[count - 1], 0};
            }
        }
        throw new IllegalStateException("only " + count + " of " + x.length + " bodies fit into "
                + inner.width() + " x " + inner.height() + " by " + tries + " random tries each");
    }

    /** Whether the body at the end of the list overlaps none before it: the boxes' distance exceeds both radii. */
    private boolean isFree() {
        for (int i = 0; i < count; i++) {
            double dx = Math.max(Math.abs(x[i] - x[count]) - halfWidth[i] - halfWidth[count], 0);
            double dy = Math.max(Math.abs(y[i] - y[count]) - halfHeight[i] - halfHeight[count], 0);
            double reach = radius[i] + radius[count];
            if (dx * dx + dy * dy <= reach * reach) {
                return false;
            }
        }
        return true;
    }
}
