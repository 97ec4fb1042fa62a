// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import java.io.Serializable;
import sim.physics.motion.Body;

/**
 * One to three equations C(x) = 0, (34), between the positions of two bodies, or of a body and the world.
 *
 * <p>The engine keeps C = 0 and Ċ = J ẋ = 0, (35), by forces Jᵀ λ, (40), that do no work. An author's own constraint
 * says what C, J = ∂C/∂x and J̇ ẋ are, at the positions and velocities that its bodies have at the instant of the
 * call; nothing else is asked of it.
 */
public interface Constraint extends Serializable {
    /**
     * The first body.
     *
     * @return never null, and always the same
     */
    Body getBodyA();

    /**
     * The second body.
     *
     * @return always the same; null: the world
     */
    Body getBodyB();

    /**
     * Number of equations.
     *
     * @return 1, 2 or 3, always the same
     */
    int getRows();

    /**
     * Evaluates the equations.
     *
     * @param equations takes C, J and J̇ ẋ of all rows
     */
    void evaluate(Equations equations);

    /**
     * Whether an equation is one between angles: its C is in rad, that of all others is a length.
     *
     * @param row 0, 1, 2
     * @return false unless overridden
     */
    default boolean isAngle(int row) {
        return false;
    }

    /**
     * A length that the constraint's equations are of the size of: positions are accurate to its rounding.
     *
     * @return positive; the radius of the larger body unless overridden
     */
    default double getSize() {
        double size = getBodyA().getShape().boundingRadius();
        return getBodyB() == null ? size : Math.max(size, getBodyB().getShape().boundingRadius());
    }
}
