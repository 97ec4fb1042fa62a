// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import sim.physics.motion.Body;

/**
 * One to three equations C(x) = 0, (34), between the positions of two bodies, or of a body and the world.
 *
 * <p>The engine keeps C = 0 and Ċ = J ẋ = 0, (35), by forces Jᵀ λ, (40), which do no work. A constraint of your own provides C, J
 * = ∂C/∂x and J̇ ẋ for the positions and velocities that its bodies have at the instant of the call. Nothing else is asked of it.
 */
public interface Constraint extends Serializable {
    /**
     * Returns the first body.
     *
     * @return always the same body, never null
     */
    Body getBodyA();

    /**
     * Returns the second body.
     *
     * @return always the same body; null for the world
     */
    Body getBodyB();

    /**
     * Returns the number of equations.
     *
     * @return 1, 2 or 3, always the same
     */
    int getRows();

    /**
     * Evaluates the equations.
     *
     * @param equations the object that takes C, J and J̇ ẋ of all rows
     */
    void evaluate(Equations equations);

    /**
     * Returns whether an equation is one between angles. Its C is then in rad; that of all others is a length.
     *
     * @param row number of the row: 0, 1, 2
     * @return false unless overridden
     */
    default boolean isAngle(int row) {
        return false;
    }

    /**
     * Returns a length that tells the size of the constraint's equations. Positions are accurate to the rounding of this length.
     *
     * @return positive length; the radius of the larger body unless overridden
     */
    default double getSize() {
        double size = getBodyA().getShape().boundingRadius();
        return getBodyB() == null ? size : Math.max(size, getBodyB().getShape().boundingRadius());
    }
}
