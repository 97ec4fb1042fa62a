// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.internal.Check;

/**
 * A drag that grows with speed, F = −μ g m v, where μ is a body's (kinetic) coefficient of surface friction. It is not dry
 * friction: it exerts no torque, holds nothing at rest, and stops nothing for good. {@link SurfaceFriction} does all three.
 *
 * <p>Bodies whose coefficient is 0 do not feel it.
 */
public final class ViscousFriction implements ForceGenerator {
    private static final long serialVersionUID = 1L;

    private final double g;

    /**
     * Creates a drag.
     *
     * @param g weight per mass and speed, 1/time, not negative
     */
    public ViscousFriction(double g) {
        this.g = Check.notNegative("g", g);
    }

    @Override
    public boolean actsOn(Body body) {
        return body.getSurfaceFriction() > 0;
    }

    @Override
    public boolean isConcurrent() {
        return true;
    }

    @Override
    public boolean isAutonomous() {
        return true;
    }

    @Override
    public void addForce(Body body, double time, Forces forces) {
        double drag = body.getSurfaceFriction() * g * body.getMass();
        forces.add(body, -drag * body.getVelocityX(), -drag * body.getVelocityY());
    }
}
