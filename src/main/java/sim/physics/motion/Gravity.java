// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.internal.Check;

/**
 * A uniform field: the same acceleration for every movable body. Bodies that feel nothing else follow parabolas. The engine knows
 * these exactly, without an integrator.
 */
public final class Gravity implements ForceGenerator {
    private static final long serialVersionUID = 1L;

    private final double gx;
    private final double gy;

    /**
     * Creates a uniform field.
     *
     * @param gx acceleration along x, length/time²
     * @param gy acceleration along y, length/time²
     */
    public Gravity(double gx, double gy) {
        this.gx = Check.finite("gx", gx);
        this.gy = Check.finite("gy", gy);
    }

    /**
     * Returns the acceleration along x.
     *
     * @return length/time²
     */
    public double getX() {
        return gx;
    }

    /**
     * Returns the acceleration along y.
     *
     * @return length/time²
     */
    public double getY() {
        return gy;
    }

    @Override
    public boolean isAutonomous() {
        return true;
    }

    @Override
    public void addForce(Body body, double time, Forces forces) {
        forces.add(body, body.getMass() * gx, body.getMass() * gy); // (5)
    }
}
