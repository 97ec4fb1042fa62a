// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.machines;

import sim.physics.PhysicsEngine;
import sim.physics.constraint.Limit;
import sim.physics.constraint.PinJoint;
import sim.physics.motion.Body;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** A head, a trunk, two arms, and two legs of two links, whose joints have stops. */
final class Ragdoll {
    private final PhysicsEngine physics;
    private final double friction;
    private final double spin;

    Ragdoll(PhysicsEngine physics, double friction, double x, double y, double spin) {
        this.physics = physics;
        this.friction = friction;
        this.spin = spin;
        Body trunk = add(new Rectangle(5, 10), x, y);
        limb(trunk, new Circle(2.5), x, y - 7.5, y - 5, 0.5);
        for (int side = -1; side <= 1; side += 2) {
            limb(trunk, new Rectangle(1.5, 8), x + 3.5 * side, y, y - 4, 1.5);
            Body thigh = limb(trunk, new Rectangle(2, 10), x + 1.5 * side, y + 10, y + 5, 0.8);
            limb(thigh, new Rectangle(2, 10), x + 1.5 * side, y + 20, y + 15, 1.2);
        }
    }

    private Body add(Shape shape, double x, double y) {
        Body body = physics.add(new Body(shape).at(x, y).moving(0, 0, spin));
        body.setFriction(friction);
        body.setRestitution(0);
        return body;
    }

    /** A limb at (x, y) with its hinge above or below it, which bends by so much to either side. */
    private Body limb(Body from, Shape shape, double x, double y, double hinge, double bend) {
        Body limb = add(shape, x, y);
        physics.add(new PinJoint(from, limb, x, hinge));
        physics.add(Limit.angle(limb, from, -bend, bend));
        return limb;
    }
}
