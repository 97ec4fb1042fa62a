// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import sim.physics.motion.Body;

/**
 * Two bodies that rest or lie on one another at the end of a step, and the force with which they press, as its mean over the
 * step. The two points of a flush edge are one contact, at the point where their forces act together. A contact that bore a force
 * and parted before the end of the step is listed for that step.
 *
 * @param a one body
 * @param b the other body
 * @param x x of the point where the force acts, at the end of the step, length
 * @param y y of the point where the force acts, length
 * @param normalX x of the unit normal from a to b
 * @param normalY y of the unit normal from a to b
 * @param normalForce force on b along the normal, mass·length/time², not negative; the force on a is the opposite
 * @param tangentForce force on b along the tangent (−normalY, normalX), which is that of friction, of either sign; the force on a
 *     is the opposite
 */
public record LastingContact(
        Body a,
        Body b,
        double x,
        double y,
        double normalX,
        double normalY,
        double normalForce,
        double tangentForce) {

    /**
     * Returns the other body of the pair.
     *
     * @param body one of the two bodies
     * @return the other one
     * @throws IllegalArgumentException if the body takes no part in this contact
     */
    public Body other(Body body) {
        return sign(body) > 0 ? a : b;
    }

    /**
     * Returns the force on a body along the x axis.
     *
     * @param body one of the two bodies
     * @return mass·length/time²
     * @throws IllegalArgumentException if the body takes no part in this contact
     */
    public double forceX(Body body) {
        return sign(body) * (normalForce * normalX - tangentForce * normalY);
    }

    /**
     * Returns the force on a body along the y axis.
     *
     * @param body one of the two bodies
     * @return mass·length/time²
     * @throws IllegalArgumentException if the body takes no part in this contact
     */
    public double forceY(Body body) {
        return sign(body) * (normalForce * normalY + tangentForce * normalX);
    }

    private int sign(Body body) {
        if (body != a && body != b) {
            throw new IllegalArgumentException("body is " + body + ": it takes no part in " + this);
        }
        return body == b ? 1 : -1;
    }
}
