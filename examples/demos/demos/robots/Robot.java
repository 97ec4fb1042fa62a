// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.robots;

import sim.physics.motion.Body;
import sim.physics.motion.ForceGenerator;
import sim.physics.motion.Forces;
import sim.physics.shape.Circle;

/**
 * A round robot on wheels, to be subclassed: it goes to places, turns, stops and backs up by proportional and derivative
 * control, evaluated at every stage of the integrator. {@link Drive} is to be added to the engine once.
 */
public abstract class Robot extends Body {
    private static final long serialVersionUID = 1L;

    private static final double NEAR = 20;
    private static final double AHEAD = Math.toRadians(12);

    /** What the wheels are told to do. */
    private enum Order {
        STOP,
        GO,
        FACE,
        BACK
    }

    private static final double TURN = 10;
    private static final double TURN_LOADED = 25;

    private Order order = Order.STOP;
    private double gain = TURN;
    private double goalX;
    private double goalY;
    private double goalAngle;

    protected Robot(double radius, double mass) {
        super(new Circle(radius));
        setMass(mass);
    }

    /** Lets all robots of an engine drive. */
    public static final class Drive implements ForceGenerator {
        private static final long serialVersionUID = 1L;

        @Override
        public boolean actsOn(Body body) {
            return body instanceof Robot;
        }

        @Override
        public void addForce(Body body, double time, Forces forces) {
            ((Robot) body).drive(forces);
        }
    }

    public void goTo(double x, double y) {
        order = Order.GO;
        goalX = x;
        goalY = y;
    }

    public void face(double angle) {
        order = Order.FACE;
        goalAngle = angle;
    }

    public void stop() {
        order = Order.STOP;
    }

    public void backUp() {
        order = Order.BACK;
    }

    /** Turns harder while it carries something: the load's inertia and friction would make it slow. */
    protected void setLoaded(boolean loaded) {
        gain = loaded ? TURN_LOADED : TURN;
    }

    /** Angle of a point as the robot sees it: 0 straight ahead, from −π to π. */
    public double bearing(double x, double y) {
        return wrap(StrictMath.atan2(y - getY(), x - getX()) - getAngle());
    }

    public double distance(double x, double y) {
        return Math.sqrt((x - getX()) * (x - getX()) + (y - getY()) * (y - getY()));
    }

    public double speed() {
        return Math.sqrt(getVelocityX() * getVelocityX() + getVelocityY() * getVelocityY());
    }

    private static double wrap(double angle) {
        return angle - 2 * Math.PI * Math.rint(angle / (2 * Math.PI));
    }

    private void drive(Forces forces) {
        double omega = getAngularVelocity();
        switch (order) {
            case GO -> {
                double error = bearing(goalX, goalY);
                forces.addTorque(this, gain * error - 500 * omega);
                if (Math.abs(error) < AHEAD) {
                    double way = distance(goalX, goalY);
                    push(forces, way < NEAR ? 4 : 0.2 * way - 10 * speed());
                } else {
                    brake(forces);
                }
            }
            case FACE -> {
                forces.addTorque(this, gain * wrap(goalAngle - getAngle()) - 500 * omega);
                brake(forces);
            }
            case BACK -> push(forces, -4);
            default -> {
                forces.addTorque(this, -200 * omega);
                brake(forces);
            }
        }
    }

    private void push(Forces forces, double force) {
        forces.add(this, force * StrictMath.cos(getAngle()), force * StrictMath.sin(getAngle()));
    }

    private void brake(Forces forces) {
        forces.add(this, -10 * getVelocityX(), -10 * getVelocityY());
    }
}
