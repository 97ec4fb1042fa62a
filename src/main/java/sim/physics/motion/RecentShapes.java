// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.shape.Shape;

/** Shapes that were seen last, by their hash, so that bodies of equal shapes share one. */
final class RecentShapes {
    private static final int COUNT = 64;

    private final Shape[] shapes = new Shape[COUNT];

    /** The shape that is shared by all that are equal to a given one, which may be that one itself. */
    Shape share(Shape shape) {
        int hash = shape.hashCode();
        int k = (hash ^ hash >>> 8 ^ hash >>> 16 ^ hash >>> 24) & COUNT - 1;
        boolean isKnown = shape.equals(shapes[k]) && shape.massProperties().equals(shapes[k].massProperties());
        shapes[k] = isKnown ? shapes[k] : shape;
        return shapes[k];
    }
}
