// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import java.io.Serializable;
import sim.physics.motion.Body;

/**
 * The place where a ray entered a body, or where a shape that moved met it, as in a {@link Hit}. It may be used again for the next
 * ray or shape, so that many leave no garbage. If an agent holds one, it may be saved together with the agent.
 */
public final class RayHit implements Serializable {
    private static final long serialVersionUID = 1L;

    private Body body;
    private double x;
    private double y;
    private double nx;
    private double ny;
    private double distance;

    /** Creates an object that holds no answer yet. */
    public RayHit() {
        // a ray or a shape fills it
    }

    void set(Body ofBody, double atX, double atY, double normalX, double normalY, double atDistance) {
        body = ofBody;
        x = atX;
        y = atY;
        nx = normalX;
        ny = normalY;
        distance = atDistance;
    }

    /**
     * Returns the body that the ray entered, or the shape met.
     *
     * @return the body; null if there was none: the other values are then 0, and the distance is the range
     */
    public Body body() {
        return body;
    }

    /**
     * Returns the x coordinate of the point on the body's surface, or of the start if that is inside.
     *
     * @return x
     */
    public double x() {
        return x;
    }

    /**
     * Returns the y coordinate of the point on the body's surface, or of the start if that is inside.
     *
     * @return y
     */
    public double y() {
        return y;
    }

    /**
     * Returns the x component of the unit normal of the surface, which points out of the body, or against the direction if the
     * start is inside.
     *
     * @return x component
     */
    public double nx() {
        return nx;
    }

    /**
     * Returns the y component of the unit normal of the surface, which points out of the body, or against the direction if the
     * start is inside.
     *
     * @return y component
     */
    public double ny() {
        return ny;
    }

    /**
     * Returns the distance from the start of the ray, or how far the shape moved. It is 0 if the start is inside.
     *
     * @return length; the range if there was no body
     */
    public double distance() {
        return distance;
    }
}
