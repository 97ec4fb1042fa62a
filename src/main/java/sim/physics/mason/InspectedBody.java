// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.mason;

import java.util.Objects;
import sim.physics.motion.Body;
import sim.util.Interval;

/**
 * A {@link Body} as MASON's inspectors see it: one property for each value, so that each can be changed alone. What is
 * set takes effect at once; what a body refuses, it refuses here too. A fixed body has no velocity and no finite mass.
 */
public final class InspectedBody {
    private final Body body;

    /**
     * Makes the view of a body.
     *
     * @param body live
     */
    public InspectedBody(Body body) {
        this.body = Objects.requireNonNull(body, "body");
    }

    /** {@return the shape with its sizes} */
    public String getShape() {
        return body.getShape().toString();
    }

    /** {@return whether nothing moves the body} */
    public boolean isFixed() {
        return body.isFixed();
    }

    /** {@return x of the centre of mass} */
    public double getX() {
        return body.getX();
    }

    /** @param x of the centre of mass */
    public void setX(double x) {
        body.setPosition(x, body.getY());
    }

    /** {@return y of the centre of mass} */
    public double getY() {
        return body.getY();
    }

    /** @param y of the centre of mass */
    public void setY(double y) {
        body.setPosition(body.getX(), y);
    }

    /** {@return orientation, rad} */
    public double getAngle() {
        return body.getAngle();
    }

    /** @param angle orientation, rad */
    public void setAngle(double angle) {
        body.setAngle(angle);
    }

    /** {@return x of the velocity} */
    public double getVelocityX() {
        return body.getVelocityX();
    }

    /** @param vx x of the velocity */
    public void setVelocityX(double vx) {
        body.setVelocity(vx, body.getVelocityY());
    }

    /** {@return y of the velocity} */
    public double getVelocityY() {
        return body.getVelocityY();
    }

    /** @param vy y of the velocity */
    public void setVelocityY(double vy) {
        body.setVelocity(body.getVelocityX(), vy);
    }

    /** {@return angular velocity, rad/time} */
    public double getAngularVelocity() {
        return body.getAngularVelocity();
    }

    /** @param omega angular velocity, rad/time */
    public void setAngularVelocity(double omega) {
        body.setAngularVelocity(omega);
    }

    /** {@return mass} */
    public double getMass() {
        return body.getMass();
    }

    /** @param mass greater than 0; the moment of inertia changes in proportion */
    public void setMass(double mass) {
        body.setMass(mass, body.getInertia() * (mass / body.getMass()));
    }

    /** {@return moment of inertia about the centre of mass} */
    public double getInertia() {
        return body.getInertia();
    }

    /** {@return coefficient of restitution} */
    public double getRestitution() {
        return body.getRestitution();
    }

    /** @param e coefficient of restitution, 0 … 1 */
    public void setRestitution(double e) {
        body.setRestitution(e);
    }

    /** {@return the range of the restitution, for a slider} */
    public Object domRestitution() {
        return new Interval(0.0, 1.0);
    }

    /** {@return coefficient of friction at impacts} */
    public double getFriction() {
        return body.getFriction();
    }

    /** @param mu coefficient of friction at impacts, not negative */
    public void setFriction(double mu) {
        body.setFriction(mu);
    }

    /** {@return how fast the surface moves along the boundary, counter-clockwise: a conveyor belt's} */
    public double getBeltSpeed() {
        return body.getBeltSpeed();
    }

    /** @param speed how fast the surface moves along the boundary, counter-clockwise */
    public void setBeltSpeed(double speed) {
        body.setBeltSpeed(speed);
    }

    /** {@return kinetic coefficient of friction on the plane below} */
    public double getSurfaceFriction() {
        return body.getSurfaceFriction();
    }

    /** @param mu kinetic coefficient of friction on the plane below; the static one is raised to it if it is less */
    public void setSurfaceFriction(double mu) {
        body.setSurfaceFriction(mu, Math.max(mu, body.getSurfaceStaticFriction()));
    }

    /** {@return static coefficient of friction on the plane below} */
    public double getSurfaceStaticFriction() {
        return body.getSurfaceStaticFriction();
    }

    /** @param mu static coefficient of friction on the plane below, not less than the kinetic one */
    public void setSurfaceStaticFriction(double mu) {
        body.setSurfaceFriction(body.getSurfaceFriction(), mu);
    }

    /** {@return kinetic energy of the body} */
    public double getKineticEnergy() {
        return body.kineticEnergy();
    }
}
