// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;

/** Shapes of bodies as shapes of AWT, in local coordinates. */
final class AwtShapes {
    private AwtShapes() {}

    static Shape of(sim.physics.shape.Shape shape) {
        if (shape.vertexCount() == 1) {
            return disc(shape);
        }
        Path2D.Double path = new Path2D.Double(Path2D.WIND_NON_ZERO);
        for (int part = 0; part < shape.partCount(); part++) {
            append(shape.part(part), path);
        }
        return path;
    }

    private static Ellipse2D.Double disc(sim.physics.shape.Shape part) {
        double r = part.radius();
        return new Ellipse2D.Double(part.vertexX(0) - r, part.vertexY(0) - r, 2 * r, 2 * r);
    }

    private static void append(sim.physics.shape.Shape part, Path2D.Double path) {
        if (part.vertexCount() == 1) {
            path.append(disc(part), false);
            return;
        }
        path.moveTo(part.vertexX(0), part.vertexY(0));
        for (int k = 1; k < part.vertexCount(); k++) {
            path.lineTo(part.vertexX(k), part.vertexY(k));
        }
        path.closePath();
    }
}
