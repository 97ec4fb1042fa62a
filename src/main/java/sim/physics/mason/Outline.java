// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;

/** Shapes of bodies as shapes of AWT, in local coordinates. */
final class Outline {
    private Outline() {}

    static Shape of(sim.physics.shape.Shape shape) {
        if (shape.vertexCount() == 1) {
            double r = shape.radius();
            return new Ellipse2D.Double(-r, -r, 2 * r, 2 * r);
        }
        Path2D.Double path = new Path2D.Double(Path2D.WIND_NON_ZERO);
        for (int part = 0; part < shape.partCount(); part++) {
            append(shape.part(part), path);
        }
        return path;
    }

    private static void append(sim.physics.shape.Shape part, Path2D.Double path) {
        path.moveTo(part.vertexX(0), part.vertexY(0));
        for (int k = 1; k < part.vertexCount(); k++) {
            path.lineTo(part.vertexX(k), part.vertexY(k));
        }
        path.closePath();
    }
}
