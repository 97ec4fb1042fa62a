// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import sim.physics.motion.Body;

/**
 * A pin in a slot: a point of one body moves along a straight line of another one, or of the world, and the two turn freely
 * against each other, {@link Rail}. With a {@link sim.physics.motion.Spring} along the line it is the suspension of a wheel, which a
 * {@link Motor} may turn against the body with the slot.
 */
public final class SlotJoint extends Rail {
    private static final long serialVersionUID = 1L;

    /**
     * Lets a point of a body move along a line through it, where the two bodies are now.
     *
     * @param a the body with the pin: the wheel
     * @param b the body with the slot, or null for the world
     * @param x point, in world coordinates
     * @param y point, in world coordinates
     * @param dx direction of the slot, of any length
     * @param dy direction of the slot
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
