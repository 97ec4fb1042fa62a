// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import sim.physics.internal.Trig;
import sim.physics.motion.Body;

/** A point of a body, or of the world: its arm, place and velocity at the instant of an evaluation. */
final class Anchor implements Serializable {
    private static final long serialVersionUID = 1L;

    /** How far from the centre of its body, relative to that, a point is that was meant to be there. */
    private static final double MIDDLE = 1e-9;

    final Body body;
    final double localX;
    final double localY;

    /** From the body's centre to the point; 0 for the world. */
    double rx;

    double ry;
    double x;
    double y;
    double vx;
    double vy;

    /** θ̇ of the body. */
    double omega;

    double cos = 1;
    double sin;

    /** The angle at which cosine and sine are known. */
    private double known = Double.NaN;

    private Anchor(Body body, double localX, double localY) {
        this.body = body;
        this.localX = localX;
        this.localY = localY;
    }

    static Anchor local(Body body, String of, double localX, double localY) {
        Joint.point(of, localX, localY);
        return new Anchor(body, localX, localY);
    }

    static Anchor at(Body body, String of, double x, double y) {
        Joint.point(of, x, y);
        return new Anchor(body, Joint.localX(body, x, y), Joint.localY(body, x, y));
    }

    /** Whether this is the centre of its body, or a point of the world. */
    boolean isMiddle() {
        return body == null || Math.max(Math.abs(localX), Math.abs(localY)) <= MIDDLE * body.getShape().boundingRadius();
    }

    void evaluate() {
        if (body != null) {
            turn();
            move();
        } else {
            x = localX;
            y = localY;
        }
    }

    /** The same without cosine and sine where they are not needed: at the centre of a body, as that of a wheel. */
    void evaluateArm() {
        if (body == null || localX != 0 || localY != 0) {
            evaluate();
        } else {
            move(); // the arm is 0
        }
    }

    private void turn() {
        double angle = body.getAngle();
        if (angle != known) {
            cos = Trig.cos(angle);
            sin = Trig.sin(angle);
            known = angle;
        }
        rx = cos * localX - sin * localY;
        ry = sin * localX + cos * localY;
    }

    private void move() {
        omega = body.getAngularVelocity();
        x = body.getX() + rx;
        y = body.getY() + ry;
        vx = body.getVelocityX() - omega * ry; // (22)
        vy = body.getVelocityY() + omega * rx;
    }

    /** r⊥ · n. */
    double lever(double nx, double ny) {
        return rx * ny - ry * nx;
    }

    /** What the turning alone does to the point's acceleration along n: −θ̇² r · n. */
    double centripetal(double nx, double ny) {
        return -omega * omega * (rx * nx + ry * ny);
    }
}
