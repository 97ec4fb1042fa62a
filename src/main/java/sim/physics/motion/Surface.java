// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;

/** How a body's surface behaves in contacts. It never changes, so that bodies share one. */
final class Surface implements Serializable {
    private static final long serialVersionUID = 1L;

    /** That of a body nobody has said anything about. */
    static final Surface SMOOTH = new Surface(1, 0, 0);

    /** Coefficient of restitution. */
    final double restitution;

    /** Coefficient of friction. */
    final double friction;

    /** How fast it moves along the body's boundary, counter-clockwise. */
    final double speed;

    private Surface(double restitution, double friction, double speed) {
        this.restitution = restitution;
        this.friction = friction;
        this.speed = speed;
    }

    /** One with given values: this one or another one, if they are the same. */
    Surface with(double newRestitution, double newFriction, double newSpeed, Surface other) {
        if (is(newRestitution, newFriction, newSpeed)) {
            return this;
        }
        return other.is(newRestitution, newFriction, newSpeed) ? other : new Surface(newRestitution, newFriction, newSpeed);
    }

    private boolean is(double otherRestitution, double otherFriction, double otherSpeed) {
        return restitution == otherRestitution && friction == otherFriction && speed == otherSpeed;
    }
}
