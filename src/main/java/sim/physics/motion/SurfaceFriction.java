// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.internal.Check;

/**
 * Coulomb friction between flat bodies and the plane that they lie on, for scenes seen from above: robots, cans, pucks.
 *
 * <p>The weight m g presses on the plane with uniform pressure, and every patch of the body rubs against its own velocity. So
 * sliding and spinning are coupled ({@link SurfacePatch}). Kinetic friction stops a body exactly and never turns it back. A body
 * at rest stays at rest while static friction can hold the other forces.
 *
 * <p>The friction of bodies that joints tie or springs connect grows with their speed, from zero at rest to its full value. With
 * RK4, that is reached at half of μ g times the step. With other methods of fixed step, it is reached at μ g times the step, and
 * with a tolerance at √(μ g · tolerance / 2) at most. These bodies come to rest as well, but under a load that static friction
 * would bear they creep, no faster than that speed.
 *
 * <p>The coefficients are the bodies' own, see {@link Body#setSurfaceFriction(double, double)}. A body whose coefficients are 0
 * costs nothing.
 */
public final class SurfaceFriction implements ForceGenerator {
    private static final long serialVersionUID = 1L;

    private final double gravity;

    /**
     * Creates the friction of a plane.
     *
     * @param gravity acceleration that presses the bodies onto the plane, length/time²
     */
    public SurfaceFriction(double gravity) {
        this.gravity = Check.positive("gravity", gravity);
    }

    /**
     * Returns the acceleration that presses the bodies onto the plane.
     *
     * @return length/time²
     */
    public double getGravity() {
        return gravity;
    }

    @Override
    public boolean actsOn(Body body) {
        return body.getSurfaceStaticFriction() > 0 && body.isDynamic();
    }

    @Override
    public boolean isConcurrent() {
        return true;
    }

    @Override
    public void addForce(Body body, double time, Forces forces) {
        double[] f = forces.workspace;
        double vx = body.getVelocityX();
        double vy = body.getVelocityY();
        double omega = body.getAngularVelocity();
        friction(body, vx, vy, omega, body.getAngle(), f);
        double speed = Math.sqrt(vx * vx + vy * vy + omega * omega * body.getInertia() / body.getMass());
        double left = forces.left(speed, body.getSurfaceFriction() * gravity);
        forces.add(body, left * f[State.X], left * f[State.Y]);
        forces.addTorque(body, left * f[State.THETA]);
    }

    /** Takes the force and torque on a body to out. */
    void friction(Body body, double vx, double vy, double omega, double theta, double[] out) {
        friction(body, vx, vy, omega, theta, false, out);
    }

    /** The same; with the static coefficient at the onset of a motion. */
    void friction(Body body, double vx, double vy, double omega, double theta, boolean isStatic, double[] out) {
        body.surfacePatch().friction(vx, vy, omega, theta, out);
        double coefficient = isStatic ? body.getSurfaceStaticFriction() : body.getSurfaceFriction();
        double weight = coefficient * body.getMass() * gravity;
        out[State.X] *= weight;
        out[State.Y] *= weight;
        out[State.THETA] *= weight;
    }

    /** Whether static friction holds a body at rest against the force and torque on it. */
    boolean holds(Body body, double fx, double fy, double torque) {
        return holds(body, body.getAngle(), fx, fy, torque, false);
    }

    /** The same at another angle; for a body that moves, whether kinetic friction does. */
    boolean holds(Body body, double theta, double fx, double fy, double torque, boolean moves) {
        double coefficient = moves ? body.getSurfaceFriction() : body.getSurfaceStaticFriction();
        return body.surfacePatch().holds(fx, fy, torque, theta, coefficient * body.getMass() * gravity);
    }
}
