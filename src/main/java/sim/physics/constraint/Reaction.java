// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;

/**
 * The force and torque of a constraint on its first body at one instant: Jᵀ λ, (40). The second body gets the opposite force at
 * the same place, but for a {@link PulleyJoint}, whose rope pulls either body towards its pulley.
 *
 * @param forceX force along x
 * @param forceY force along y
 * @param torque torque about the first body's centre of mass
 */
public record Reaction(double forceX, double forceY, double torque) implements Serializable {
    /**
     * Returns the size of the force.
     *
     * @return force, not negative
     */
    public double force() {
        return Math.sqrt(forceX * forceX + forceY * forceY);
    }
}
