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

    /** The same for the last step in which any were applied; and whether they are applied once more, to see what they did. */
    double actedX;

    double actedY;
    double actedTorque;
    boolean isRecalled;

    Particulars() {
        // as a body is that has none
    }

    /** What was applied has acted. */
    void clearApplied() {
        if (appliedX != 0 || appliedY != 0 || appliedTorque != 0) { // not the second time in a step
            actedX = appliedX;
            actedY = appliedY;
            actedTorque = appliedTorque;
            apply(0, 0, 0);
        }
    }

    /** Applies what has acted once more, where nothing else is applied; or no longer. */
    void recall(boolean yes) {
        if (yes && !isRecalled && appliedX == 0 && appliedY == 0 && appliedTorque == 0) {
            apply(actedX, actedY, actedTorque);
            isRecalled = true;
        } else if (!yes && isRecalled) {
            apply(0, 0, 0);
            isRecalled = false;
        }
    }

    void forgetActed() {
        actedX = 0;
        actedY = 0;
        actedTorque = 0;
    }

    void apply(double fx, double fy, double torque) {
        appliedX = fx;
        appliedY = fy;
        appliedTorque = torque;
    }
}
