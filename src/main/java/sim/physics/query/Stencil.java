// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import sim.physics.internal.Trig;
import sim.physics.motion.Body;
import sim.physics.shape.Shape;

/** A shape that is put somewhere, and whether bodies meet it there. Coordinates are relative to its centre. */
class Stencil {
    final double[] turn = new double[2];
    Shape shape;
    double x;
    double y;

    /** The directions in which the body faces that is looked at. */
    double cos;

    double sin;

    /** A part of the shape, and a part of a body. */
    final Corners own = new Corners();

    final Corners other = new Corners();

    /** Puts a shape somewhere. */
    void put(Shape what, double atX, double atY, double angle) {
        shape = what;
        x = atX;
        y = atY;
        turn[0] = 1;
        turn[1] = 0;
        if (what.vertexCount() > 1) {
            Trig.sinCos(angle, turn, 0);
        }
    }

    /** Turns to where a body faces; discs need no angle. */
    final void face(Body body) {
        cos = 1;
        sin = 0;
        if (body.getShape().vertexCount() > 1) {
            cos = Trig.cos(body.getAngle());
            sin = Trig.sin(body.getAngle());
        }
    }

    double x() {
        return x;
    }

    double y() {
        return y;
    }

    /** Farthest point from the centre. */
    double reach() {
        return shape.boundingRadius();
    }

    /** Whether a body touches it or overlaps it. */
    boolean meets(Body body) {
        Shape of = body.getShape();
        face(body);
        for (int i = 0; i < shape.partCount(); i++) {
            own.put(shape.part(i), 0, 0, turn[0], turn[1]);
            for (int k = 0; k < of.partCount(); k++) {
                other.put(of.part(k), body.getX() - x, body.getY() - y, cos, sin);
                if (doMeet()) {
                    return true;
                }
            }
        }
        return false;
    }

    private boolean doMeet() {
        if (own.count > 1 && other.count > 1) {
            return !own.parts(other) && !other.parts(own);
        }
        double radii = own.radius + other.radius;
        double square;
        if (own.count == 1 && other.count == 1) {
            double dx = other.x[0] - own.x[0];
            double dy = other.y[0] - own.y[0];
            square = dx * dx + dy * dy;
        } else {
            square = own.count == 1 ? other.square(own.x[0], own.y[0]) : own.square(other.x[0], other.y[0]);
        }
        return square <= radii * radii;
    }
}
