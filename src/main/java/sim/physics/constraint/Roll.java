// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

/** What motors of a {@link Wheel} drive: the speed of its point along the direction in which it rolls, or across it. It has no C. */
final class Roll extends Joint {
    private static final long serialVersionUID = 1L;

    final Wheel wheel;
    private final boolean isAcross;

    Roll(Wheel wheel, boolean isAcross) {
        super(wheel.getBodyA(), null);
        this.wheel = wheel;
        this.isAcross = isAcross;
    }

    @Override
    public int getRows() {
        return 1;
    }

    @Override
    public void evaluate(Equations e) {
        if (isAcross) {
            wheel.evaluate(e);
        } else {
            wheel.evaluateRolling(e);
        }
    }

    /** Whether a constraint is one of velocities alone, which has no part where places are sought. */
    static boolean isOf(Constraint constraint) {
        return constraint instanceof Wheel || constraint instanceof Switched s && s.coordinate() instanceof Roll;
    }
}
