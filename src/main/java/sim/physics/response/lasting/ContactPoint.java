// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.response.lasting;

import java.io.Serializable;
import sim.physics.collision.narrow.Manifold;

/** A point at which two bodies rest or lie on one another. Filled again for each point by {@link ContactPoints#load}. */
public final class ContactPoint implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Unit normal from body A to body B. */
    public double nx;

    /** Unit normal from body A to body B. */
    public double ny;

    /** Lever of an impulse along the normal on A, zero for a circle. */
    public double leverA;

    /** Lever of an impulse along the normal on B, zero for a circle. */
    public double leverB;

    /** Lever of an impulse along the tangent on A. */
    public double armA;

    /** Lever of an impulse along the tangent on B. */
    public double armB;

    /** What a unit of impulse along the normal changes of the velocity along it. */
    public double normalMobility;

    /** The same along the tangent. */
    public double tangentMobility;

    /** Coefficient of friction; as good as without bounds where the surfaces stick. */
    public double friction;

    /** Angular velocity of A. */
    public double omegaA;

    /** Angular velocity of B. */
    public double omegaB;

    /** Velocity of B's point relative to A's along the normal, negative where they come closer. */
    public double opening;

    /** Velocity of B's point relative to A's along the tangent. */
    public double slip;

    /** The same of their surfaces, beside that of the bodies. */
    public double belt;

    /** Makes an empty point. */
    public ContactPoint() {
        // filled again for each point
    }

    /** The tangential acceleration of B's point relative to A's that comes from the turning of their bodies. */
    double drifting() {
        return omegaB * omegaB * leverB - omegaA * omegaA * leverA;
    }

    /** The normal acceleration of the points that comes from the turning of their bodies. */
    double turning(Manifold manifold, int k) {
        double arm = manifold.roundA ? 0 : manifold.rAx[k] * manifold.nx + manifold.rAy[k] * manifold.ny;
        double sum = omegaA * omegaA * arm;
        arm = manifold.roundB ? 0 : manifold.rBx[k] * manifold.nx + manifold.rBy[k] * manifold.ny;
        return sum - omegaB * omegaB * arm;
    }
}
