// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response;

import sim.physics.motion.Body;

/**
 * Two bodies that rest or lie on one another at the end of a step, and the force with which they press: its mean over the
 * step. Two points of an edge that lies flush are one contact, at the point where the force of both acts together. What bore a force
 * and has parted before the step was over is listed for that step.
 *
 * @param a one body
 * @param b the other body
 * @param x where the force acts, at the end of the step, length
 * @param y where the force acts, length
 * @param normalX unit normal from a to b
 * @param normalY unit normal from a to b
 * @param normalForce force on b along the normal, mass·length/time², not negative; on a it is the opposite
 * @param tangentForce force on b along the tangent (−normalY, normalX), that of friction, of either sign; on a it is the
 *     opposite
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
     * The other body of the pair.
     *
     * @param body one of the two
     * @return the other one
     * @throws IllegalArgumentException if the body takes no part in this contact
     */
    public Body other(Body body) {
        return sign(body) > 0 ? a : b;
    }

    /**
     * The force on a body from left to right.
     *
     * @param body one of the two
     * @return mass·length/time²
     * @throws IllegalArgumentException if the body takes no part in this contact
     */
    public double forceX(Body body) {
        return sign(body) * (normalForce * normalX - tangentForce * normalY);
    }

    /**
     * The force on a body along the y axis.
     *
     * @param body one of the two
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
