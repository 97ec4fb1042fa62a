// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import sim.physics.motion.Body;
import sim.physics.motion.Link;

/** Makes two bodies move as one: a {@link PinJoint} that does not turn either. */
public final class WeldJoint extends Joint implements Link {
    private static final long serialVersionUID = 1L;

    private final PinJoint pin;
    private final double angle;

    /**
     * Welds two bodies together, where they are now.
     *
     * @param a a body
     * @param b another body, or null for the world
     * @param x x of the point at which the joint's force is read, in world coordinates
     * @param y y of the point at which the joint's force is read, in world coordinates
     */
    public WeldJoint(Body a, Body b, double x, double y) {
        super(a, b);
        pin = new PinJoint(a, b, x, y);
        angle = a.getAngle() - angle(b);
    }

    PinJoint pin() {
        return pin;
    }

    /** Angle of the first body less that of the second. */
    double angle() {
        return angle;
    }

    @Override
    public double getAnchorAX() {
        return pin.getAnchorAX();
    }

    @Override
    public double getAnchorAY() {
        return pin.getAnchorAY();
    }

    @Override
    public double getAnchorBX() {
        return pin.getAnchorBX();
    }

    @Override
    public double getAnchorBY() {
        return pin.getAnchorBY();
    }

    @Override
    public int getRows() {
        return 3;
    }

    @Override
    public boolean isAngle(int row) {
        return row == 2;
    }

    @Override
    public void evaluate(Equations e) {
        pin.evaluate(e);
        e.set(2, getBodyA().getAngle() - angle(getBodyB()) - angle, 0);
        e.setA(2, 0, 0, 1);
        e.setB(2, 0, 0, -1);
    }

    @Override
    boolean describe(JointRows rows, int node) {
        rows.addAngle(node + 1, 0, this, -1, angle); // the pin is with the other pins
        return true;
    }
}
