// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import sim.physics.internal.Check;
import sim.physics.motion.Body;

/**
 * Makes two bodies turn in a fixed ratio: θA + ratio · θB keeps its present value. Angles do not wrap, so this holds after any
 * number of turns.
 */
public final class GearJoint extends Joint {
    private static final long serialVersionUID = 1L;

    private final double ratio;
    private final double sum;

    /**
     * Gears two bodies.
     *
     * @param a a body
     * @param b another body, or null to keep the angle of the first one
     * @param ratio turns of the first body, in the opposite sense, for one turn of the second, not 0; −1 keeps the angle between them
     * @throws IllegalArgumentException if the ratio is 0 or not finite, or both bodies are the same
     */
    public GearJoint(Body a, Body b, double ratio) {
        super(a, b);
        this.ratio = Check.finite("ratio", ratio);
        if (ratio == 0) {
            throw new IllegalArgumentException("ratio is " + ratio + ": it must not be 0, with which the second body had no part in it;"
                    + " a joint with null in its place keeps the angle of the first one");
        }
        sum = a.getAngle() + ratio * angle(b);
    }

    /**
     * Returns the number of turns that the first body makes, in the opposite sense, for one turn of the second.
     *
     * @return any number but 0
     */
    public double getRatio() {
        return ratio;
    }

    @Override
    public int getRows() {
        return 1;
    }

    @Override
    public boolean isAngle(int row) {
        return true;
    }

    /** C at some angles. */
    double open(double a, double b) {
        return a + ratio * b - sum;
    }

    @Override
    public void evaluate(Equations e) {
        e.set(0, getBodyA().getAngle() + ratio * angle(getBodyB()) - sum, 0);
        e.setA(0, 0, 0, 1);
        e.setB(0, 0, 0, ratio);
    }

    @Override
    boolean isInternal() {
        return ratio == -1;
    }

    @Override
    boolean describe(JointRows rows, int node) {
        rows.addAngle(node, 0, this, ratio, sum);
        return true;
    }
}
