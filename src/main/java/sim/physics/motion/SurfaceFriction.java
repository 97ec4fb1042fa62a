// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.internal.Check;

/**
 * Coulomb friction between flat bodies and the plane that they lie on, seen from above: robots, cans, pucks.
 *
 * <p>The weight m g presses on the plane with uniform pressure, and every patch of the body rubs against its own
 * velocity, so sliding and spinning are coupled ({@link SurfacePatch}). Kinetic friction stops a body exactly and never
 * turns it back; a body at rest stays at rest while static friction can hold the other forces. The coefficients are
 * the bodies' own, {@link Body#setSurfaceFriction(double, double)}; a body whose coefficients are 0 pays nothing.
 */
public final class SurfaceFriction implements ForceGenerator {
    private static final long serialVersionUID = 1L;

    private final double gravity;

    /**
     * Makes the friction of a plane.
     *
     * @param gravity acceleration that presses the bodies on the plane, length/time²
     */
    public SurfaceFriction(double gravity) {
        this.gravity = Check.positive("gravity", gravity);
    }

    /**
     * The acceleration that presses the bodies on the plane.
     *
     * @return length/time²
     */
    public double getGravity() {
        return gravity;
    }

    @Override
    public boolean actsOn(Body body) {
        return body.getSurfaceStaticFriction() > 0;
    }

    @Override
    public boolean isConcurrent() {
        return true;
    }

    @Override
    public void addForce(Body body, double time, Forces forces) {
        double[] unit = forces.workspace;
        double weight = body.getSurfaceFriction() * body.getMass() * gravity;
        body.surfacePatch()
                .friction(
                        body.getVelocityX(),
                        body.getVelocityY(),
                        body.getAngularVelocity(),
                        body.getAngle(),
                        unit);
        forces.add(body, weight * unit[State.X], weight * unit[State.Y]);
        forces.addTorque(body, weight * unit[State.THETA]);
    }

    /** Whether static friction holds a body at rest against the force and torque on it. */
    boolean holds(Body body, double fx, double fy, double torque) {
        double limit = body.getSurfaceStaticFriction() * body.getMass() * gravity;
        return body.surfacePatch().holds(fx, fy, torque, body.getAngle(), limit);
    }
}
