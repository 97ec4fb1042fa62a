// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import sim.physics.PhysicsEngine;
import sim.physics.constraint.Motor;

/** A {@link Motor} of an engine as MASON's inspectors see it. */
public class InspectedMotor extends InspectedConstraint {
    private final Motor motor;

    /**
     * Makes the view of a motor.
     *
     * @param engine that it is, or was, in
     * @param motor live
     */
    public InspectedMotor(PhysicsEngine engine, Motor motor) {
        super(engine, motor);
        this.motor = motor;
    }

    /** {@return the speed that it aims at} */
    public double getSpeed() {
        return motor.getSpeed();
    }

    /** @param speed to aim at */
    public void setSpeed(double speed) {
        motor.setSpeed(speed);
    }

    /** {@return the greatest force or torque} */
    public double getLimit() {
        return motor.getLimit();
    }

    /** @param limit the greatest force or torque, greater than 0 */
    public void setLimit(double limit) {
        motor.setLimit(limit);
    }

    /** {@return 0: a motor keeps a speed and no place} */
    @Override
    public double getGap() {
        return 0;
    }

    /** {@return that a motor has no gap to show} */
    public boolean hideGap() {
        return true;
    }
}
