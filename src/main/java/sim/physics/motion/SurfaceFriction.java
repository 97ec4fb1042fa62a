// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.motion;

import sim.physics.internal.Check;

/**
 * Coulomb friction between flat bodies and the plane that they lie on, seen from above: robots, cans, pucks.
 *
 * <p>The weight m g presses on the plane with uniform pressure, and every patch of the body rubs against its own
 * velocity, so sliding and spinning are coupled ({@link SurfacePatch}). Kinetic friction stops a body exactly and never
 * turns it back; a body at rest stays at rest while static friction can hold the other forces. The friction of bodies that
 * joints tie or springs connect grows from rest on, up to a speed of half of μ g times the step with RK4, of μ g times the
 * step with other methods of fixed step, and of √(μ g · tolerance / 2) at most: they come to rest as well, and creep no faster
 * than that under what static friction would bear. The coefficients are the bodies' own,
 * {@link Body#setSurfaceFriction(double, double)}; a body whose coefficients are 0 pays nothing.
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
