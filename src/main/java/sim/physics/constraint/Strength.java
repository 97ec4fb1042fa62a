// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.constraint;

import sim.physics.motion.Body;

/** What motors can press with. */
public final class Strength {
    private Strength() {}

    /**
     * The sum of what the motors can give.
     *
     * @param constraints live
     * @return force: that of a torque is at the rim of the smaller of its bodies
     */
    public static double of(Constraints constraints) {
        double sum = 0;
        for (Constraint constraint : constraints.register.all()) {
            if (constraint instanceof Motor motor) {
                sum += motor.isAngle(0) ? motor.getLimit() / Math.min(radius(motor.getBodyA()), radius(motor.getBodyB())) : motor.getLimit();
            }
        }
        return sum;
    }

    private static double radius(Body body) {
        return body != null && body.isDynamic() ? body.getShape().boundingRadius() : Double.POSITIVE_INFINITY;
    }
}
