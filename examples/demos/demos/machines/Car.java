// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package demos.machines;

import java.util.ArrayList;
import java.util.List;
import sim.engine.SimState;
import sim.engine.Steppable;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.SliderJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;
import sim.physics.shape.Rectangle;

/** A car with two driven wheels on springs. It turns round when it has not come on for a while. */
public final class Car implements Steppable {
    private static final long serialVersionUID = 1L;

    private static final double RADIUS = 6;
    private static final double SPIN = 12;
    private static final double TORQUE = 40_000;
    private static final double STIFFNESS = 8000;
    private static final double DAMPING = 900;
    private static final int PATIENCE = 90;

    public final Body chassis;
    private final List<Body> bodies = new ArrayList<>();
    private final List<Motor> motors = new ArrayList<>();
    private double sense = 1;
    private int waiting;

    Car(PhysicsEngine physics, double friction, double x, double ground) {
        chassis = add(physics, new Body(new Rectangle(40, 6)).at(x, ground - 14), friction);
        for (int side = -1; side <= 1; side += 2) {
            double axle = x + 13 * side;
            Body hub = add(physics, new Body(new Rectangle(3, 3)).at(axle, ground - RADIUS), 0);
            hub.setCollisionGroup(2, 0); // it bears the wheel and collides with nothing
            Body wheel = add(physics, new Body(new Circle(RADIUS)).at(axle, ground - RADIUS), friction);
            physics.add(new SliderJoint(chassis, hub, axle, ground - RADIUS, 0, 1));
            physics.add(new PinJoint(hub, wheel, axle, ground - RADIUS));
            physics.add(new Spring(chassis, 13 * side, 0, hub, 0, 0, 9.5, STIFFNESS, DAMPING));
            physics.setCollisions(chassis, wheel, false);
            motors.add(physics.add(Motor.turning(wheel, hub, SPIN, TORQUE)));
        }
    }

    private Body add(PhysicsEngine physics, Body body, double friction) {
        body.setFriction(friction);
        body.setRestitution(0);
        bodies.add(body);
        return physics.add(body);
    }

    boolean has(Body body) {
        return bodies.contains(body);
    }

    @Override
    public void step(SimState model) {
        waiting = sense * chassis.getVelocityX() > 0.1 * SPIN * RADIUS ? 0 : waiting + 1;
        if (waiting > PATIENCE) {
            waiting = 0;
            sense = -sense;
            motors.forEach(motor -> motor.setSpeed(sense * SPIN));
        }
    }
}
