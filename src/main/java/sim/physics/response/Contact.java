// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import sim.physics.motion.Body;

/**
 * A collision, as listeners see it.
 *
 * @param a one body
 * @param b the other body
 * @param time simulated time of the collision
 * @param x x of the collision point, length
 * @param y y of the collision point, length
 * @param normalX x of the unit normal from a to b
 * @param normalY y of the unit normal from a to b
 * @param approachSpeed speed along the normal before the collision, length/time, positive
 * @param impulse size of the impulse, mass·length/time; 0 before the collision
 */
public record Contact(
        Body a,
        Body b,
        double time,
        double x,
        double y,
        double normalX,
        double normalY,
        double approachSpeed,
        double impulse) {

    /**
     * Returns the other body of the pair.
     *
     * @param body one of the two bodies
     * @return the other one
     * @throws IllegalArgumentException if the body takes no part in this collision
     */
    public Body other(Body body) {
        if (body == a) {
            return b;
        }
        if (body == b) {
            return a;
        }
        throw new IllegalArgumentException("body is " + body + ": it takes no part in " + this);
    }
}
