// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import java.io.Serializable;

/** What only some bodies have, so that the others need no room for it. */
final class Particulars implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Friction on the plane below. */
    double surfaceFriction;

    double surfaceStaticFriction;
    SurfacePatch patch;

    /** Which bodies it collides with. */
    long category = 1;

    long collidesWith = -1L;

    /** Force and torque that the author applied for the next step. */
    double appliedX;

    double appliedY;
    double appliedTorque;

    Particulars() {
        // as a body is that has none
    }
}
