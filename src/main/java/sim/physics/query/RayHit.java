// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.query;

import java.io.Serializable;
import sim.physics.motion.Body;

/** Where a ray entered a body; to be used again, so that many rays leave no garbage. An agent that keeps one may be saved with it. */
public final class RayHit implements Serializable {
    private static final long serialVersionUID = 1L;

    private Body body;
    private double x;
    private double y;
    private double nx;
    private double ny;
    private double distance;

    /** Makes the answer of no ray yet. */
    public RayHit() {
        // a ray fills it
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
     * The body that the ray entered.
     *
     * @return null if it entered none; the other values are 0 then, and the distance is the range
     */
    public Body body() {
        return body;
    }

    /**
     * Point on the body's surface, or the start of the ray if that is inside.
     *
     * @return x
     */
    public double x() {
        return x;
    }

    /**
     * Point on the body's surface, or the start of the ray if that is inside.
     *
     * @return y
     */
    public double y() {
        return y;
    }

    /**
     * Unit normal of the surface, out of the body; against the ray if that starts inside.
     *
     * @return its x component
     */
    public double nx() {
        return nx;
    }

    /**
     * Unit normal of the surface, out of the body; against the ray if that starts inside.
     *
     * @return its y component
     */
    public double ny() {
        return ny;
    }

    /**
     * Length from the start of the ray; 0 if that is inside.
     *
     * @return the range of the ray if it entered no body
     */
    public double distance() {
        return distance;
    }
}
