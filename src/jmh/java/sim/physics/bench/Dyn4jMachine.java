// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.dynamics.joint.AngularMotorJoint;
import org.dyn4j.dynamics.joint.Joint;
import org.dyn4j.dynamics.joint.RevoluteJoint;
import org.dyn4j.dynamics.joint.WheelJoint;
import org.dyn4j.geometry.Convex;
import org.dyn4j.geometry.Geometry;
import org.dyn4j.geometry.Mass;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Vector2;
import org.dyn4j.world.World;

/** A machine in dyn4j, as delivered, but without rest; a wheel on a spring is its wheel joint. */
final class Dyn4jMachine implements MachineWorld {
    private final World<Body> world = new World<>();
    private final List<Body> bodies = new ArrayList<>();
    private final Map<Integer, Joint<Body>> joints = new HashMap<>();

    Dyn4jMachine() {
        world.setGravity(0, -GRAVITY);
        world.getSettings().setStepFrequency(STEP);
        world.getSettings().setAtRestDetectionEnabled(false);
    }

    private int add(Convex shape, double x, double y, double friction, boolean fixed) {
        return add(List.of(shape), x, y, friction, fixed);
    }

    private int add(List<? extends Convex> shapes, double x, double y, double friction, boolean fixed) {
        Body body = new Body();
        for (Convex shape : shapes) {
            BodyFixture fixture = body.addFixture(shape, 1);
            fixture.setFriction(friction);
            fixture.setRestitution(0);
        }
        body.setMass(fixed ? MassType.INFINITE : MassType.NORMAL);
        body.translate(x, y);
        world.addBody(body);
        bodies.add(body);
        return bodies.size() - 1;
    }

    @Override
    public int box(double width, double height, double x, double y, double friction, boolean fixed) {
        return add(Geometry.createRectangle(width, height), x, y, friction, fixed);
    }

    @Override
    public int disc(double radius, double x, double y, double friction) {
        return add(Geometry.createCircle(radius), x, y, friction, false);
    }

    @Override
    public int boxes(double[][] boxes, double x, double y, double friction) {
        List<Convex> shapes = new ArrayList<>();
        for (double[] box : boxes) {
            Convex shape = Geometry.createRectangle(box[2], box[3]);
            shape.translate(box[0], box[1]);
            shapes.add(shape);
        }
        return add(shapes, x, y, friction, false);
    }

    @Override
    public void remove(int body) {
        world.removeBody(bodies.get(body));
    }

    @Override
    public void pin(int on, int body, double x, double y) {
        join(body, new RevoluteJoint<>(bodies.get(on), bodies.get(body), new Vector2(x, y)));
    }

    private void join(int body, Joint<Body> joint) {
        world.addJoint(joint);
        joints.put(body, joint);
    }

    @Override
    public void suspend(int on, int wheel, double x, double y, double hub, double stiffness, double damping) {
        Body chassis = bodies.get(on);
        Body disc = bodies.get(wheel);
        Mass mass = disc.getMass();
        disc.setMass(new Mass(mass.getCenter(), mass.getMass() + hub, mass.getInertia()));
        double reduced = 1 / (1 / chassis.getMass().getMass() + 1 / disc.getMass().getMass());
        WheelJoint<Body> joint = new WheelJoint<>(chassis, disc, new Vector2(x, y), new Vector2(0, 1));
        joint.setSpringEnabled(true);
        joint.setSpringStiffness(stiffness);
        joint.setSpringDamperEnabled(true);
        joint.setSpringDampingRatio(damping / (2 * Math.sqrt(stiffness * reduced)));
        join(wheel, joint);
    }

    @Override
    public void motor(int hinge, double speed, double torque) {
        AngularMotorJoint joint = (AngularMotorJoint) joints.get(hinge);
        joint.setMotorEnabled(true);
        joint.setMaximumMotorTorqueEnabled(true);
        joint.setMaximumMotorTorque(torque);
        joint.setMotorSpeed(speed);
    }

    @Override
    public void drive(int hinge, double speed) {
        ((AngularMotorJoint) joints.get(hinge)).setMotorSpeed(speed);
    }

    @Override
    public void stops(int hinge, double lower, double upper) {
        ((RevoluteJoint<Body>) joints.get(hinge)).setLimitsEnabled(lower, upper);
    }

    @Override
    public void launch(double vx, double vy) {
        bodies.stream()
                .filter(body -> body.getMass().getType() == MassType.NORMAL)
                .forEach(body -> body.setLinearVelocity(vx, vy));
    }

    @Override
    public void step() {
        world.step(1);
    }

    @Override
    public double x(int body) {
        return bodies.get(body).getWorldCenter().x;
    }

    @Override
    public double y(int body) {
        return bodies.get(body).getWorldCenter().y;
    }

    @Override
    public double angle(int body) {
        return bodies.get(body).getTransform().getRotationAngle();
    }

    @Override
    public double vx(int body) {
        return bodies.get(body).getLinearVelocity().x;
    }
}
