// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import java.util.Objects;
import sim.physics.motion.Body;
import sim.physics.motion.Spring;
import sim.util.Double2D;

/** A {@link Spring} as MASON's inspectors see it. */
public final class InspectedSpring {
    private final Spring spring;

    /**
     * Makes the view of a spring.
     *
     * @param spring live
     */
    public InspectedSpring(Spring spring) {
        this.spring = Objects.requireNonNull(spring, "spring");
    }

    /** {@return the first body} */
    public Body getBodyA() {
        return spring.getBodyA();
    }

    /** {@return the second body, null for the world} */
    public Body getBodyB() {
        return spring.getBodyB();
    }

    /** {@return the length at which it gives no force} */
    public double getRestLength() {
        return spring.getLength();
    }

    /** {@return its length now} */
    public double getLength() {
        return LinkPlaces.first(spring).distance(LinkPlaces.second(spring));
    }

    /** {@return force by length} */
    public double getStiffness() {
        return spring.getStiffness();
    }

    /** {@return force by speed} */
    public double getDamping() {
        return spring.getDamping();
    }

    /** {@return the force with which it pulls its ends together, negative if it pushes} */
    public double getTension() {
        Double2D a = LinkPlaces.first(spring);
        Double2D b = LinkPlaces.second(spring);
        double distance = a.distance(b);
        if (distance == 0) {
            return 0;
        }
        Double2D n = a.subtract(b).multiply(1 / distance);
        double rate = n.dot(velocity(spring.getBodyA(), a).subtract(velocity(spring.getBodyB(), b)));
        return spring.getStiffness() * (distance - spring.getLength()) + spring.getDamping() * rate;
    }

    private static Double2D velocity(Body body, Double2D point) {
        if (body == null) {
            return new Double2D();
        }
        double omega = body.getAngularVelocity();
        return new Double2D(
                body.getVelocityX() - omega * (point.y - body.getY()), body.getVelocityY() + omega * (point.x - body.getX()));
    }

    /** {@return the energy that is stored in it} */
    public double getEnergy() {
        return spring.energy();
    }
}
