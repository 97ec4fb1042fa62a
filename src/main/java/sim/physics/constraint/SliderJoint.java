// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import sim.physics.motion.Body;

/**
 * A rail. A point of one body moves along a straight line of another one, or of the world, and the two do not turn against each
 * other: the equation of a {@link Rail}, and C1 = θA − θB − c.
 */
public final class SliderJoint extends Rail {
    private static final long serialVersionUID = 1L;

    private final double angle;

    /**
     * Lets a body slide along a line through a point, where the two bodies are now.
     *
     * @param a the body that slides
     * @param b the body with the rail, or null for the world
     * @param x x of the point, in world coordinates
     * @param y y of the point, in world coordinates
     * @param dx x of the direction of the line, of any length
     * @param dy y of the direction of the line
     */
    public SliderJoint(Body a, Body b, double x, double y, double dx, double dy) {
        super(a, b, x, y, dx, dy);
        angle = a.getAngle() - angle(b);
    }

    @Override
    public int getRows() {
        return 2;
    }

    @Override
    public boolean isAngle(int row) {
        return row == 1;
    }

    @Override
    public void evaluate(Equations e) {
        separate(e);
        e.set(1, getBodyA().getAngle() - angle(getBodyB()) - angle, 0);
        e.setA(1, 0, 0, 1);
        e.setB(1, 0, 0, -1);
    }

    @Override
    boolean describe(JointRows rows, int node) {
        super.describe(rows, node);
        rows.addAngle(node, 1, this, -1, angle);
        return true;
    }
}
