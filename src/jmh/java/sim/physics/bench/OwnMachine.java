// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import sim.physics.PhysicsEngine;
import sim.physics.constraint.Limit;
import sim.physics.constraint.Motor;
import sim.physics.constraint.PinJoint;
import sim.physics.constraint.SlotJoint;
import sim.physics.motion.Body;
import sim.physics.motion.Gravity;
import sim.physics.motion.Spring;
import sim.physics.shape.Circle;
import sim.physics.shape.Compound;
import sim.physics.shape.Rectangle;
import sim.physics.shape.Shape;

/** A machine in this engine, with RK4. */
final class OwnMachine implements MachineWorld {
    private final PhysicsEngine engine = new PhysicsEngine();
    private final List<Body> bodies = new ArrayList<>();
    private final Map<Integer, Body> carriers = new HashMap<>();
    private final Map<Integer, Motor> motors = new HashMap<>();

    OwnMachine() {
        this(0);
    }

    /** One moved by time stepping, unless the substeps are 0. */
    OwnMachine(int substeps) {
        engine.setTimeStep(STEP);
        engine.setTimeStepping(substeps);
        engine.setSleepAllowed(false); // nor do the peers
        engine.add(new Gravity(0, -GRAVITY));
    }

    private int add(Shape shape, double x, double y, double friction, boolean fixed) {
        Body body = fixed ? Body.fixed(shape) : new Body(shape);
        body.setFriction(friction);
        body.setRestitution(0);
        bodies.add(engine.add(body.at(x, y)));
        return bodies.size() - 1;
    }

    @Override
    public int box(double width, double height, double x, double y, double friction, boolean fixed) {
        return add(new Rectangle(width, height), x, y, friction, fixed);
    }

    @Override
    public int disc(double radius, double x, double y, double friction) {
        return add(new Circle(radius), x, y, friction, false);
    }

    @Override
    public int boxes(double[][] boxes, double x, double y, double friction) {
        return add(compound(boxes), x, y, friction, false);
    }

    static Compound compound(double[][] boxes) {
        double[][] parts = new double[boxes.length][];
        for (int k = 0; k < boxes.length; k++) {
            parts[k] = Compound.box(boxes[k][0], boxes[k][1], boxes[k][2], boxes[k][3]);
        }
        return new Compound(parts);
    }

    @Override
    public void remove(int body) {
        engine.remove(bodies.get(body));
    }

    @Override
    public void pin(int on, int body, double x, double y) {
        engine.add(new PinJoint(bodies.get(on), bodies.get(body), x, y));
        carriers.put(body, bodies.get(on));
    }

    @Override
    public void suspend(int on, int wheel, double x, double y, double hub, double stiffness, double damping) {
        Body chassis = bodies.get(on);
        Body disc = bodies.get(wheel);
        disc.setMass(disc.getMass() + hub, disc.getInertia());
        engine.add(new SlotJoint(disc, chassis, x, y, 0, 1));
        double length = chassis.getY() - y;
        engine.add(new Spring(chassis, x - chassis.getX(), 0, disc, 0, 0, length, stiffness, damping));
        carriers.put(wheel, chassis);
    }

    @Override
    public void motor(int hinge, double speed, double torque) {
        Motor motor = Motor.turning(bodies.get(hinge), carriers.get(hinge), speed, torque);
        engine.add(motor);
        motors.put(hinge, motor);
    }

    @Override
    public void drive(int hinge, double speed) {
        motors.get(hinge).setSpeed(speed);
    }

    @Override
    public void stops(int hinge, double lower, double upper) {
        engine.add(Limit.angle(bodies.get(hinge), carriers.get(hinge), lower, upper));
    }

    @Override
    public void launch(double vx, double vy) {
        bodies.stream().filter(body -> !body.isFixed()).forEach(body -> body.setVelocity(vx, vy));
    }

    @Override
    public void step() {
        engine.step();
    }

    @Override
    public double x(int body) {
        return bodies.get(body).getX();
    }

    @Override
    public double y(int body) {
        return bodies.get(body).getY();
    }

    @Override
    public double angle(int body) {
        return bodies.get(body).getAngle();
    }

    @Override
    public double vx(int body) {
        return bodies.get(body).getVelocityX();
    }
}
