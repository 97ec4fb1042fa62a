// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import sim.physics.motion.Body;

/**
 * A pin in a slot. A point of one body moves along a straight line of another one, or of the world, and the two turn freely
 * against each other: the equation of a {@link Rail} alone. With a {@link sim.physics.motion.Spring} along the line it is the
 * suspension of a wheel, and a {@link Motor} may turn the wheel against the body with the slot.
 */
public final class SlotJoint extends Rail {
    private static final long serialVersionUID = 1L;

    /**
     * Lets a point of a body move along a line through that point, where the two bodies are now.
     *
     * @param a the body with the pin, such as a wheel
     * @param b the body with the slot, or null for the world
     * @param x x of the point, in world coordinates
     * @param y y of the point, in world coordinates
     * @param dx x of the direction of the slot, of any length
     * @param dy y of the direction of the slot
     */
    public SlotJoint(Body a, Body b, double x, double y, double dx, double dy) {
        super(a, b, x, y, dx, dy);
    }

    @Override
    public int getRows() {
        return 1;
    }

    @Override
    public void evaluate(Equations e) {
        separate(e);
    }
}
