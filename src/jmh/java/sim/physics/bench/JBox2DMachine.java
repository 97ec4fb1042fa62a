// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.bench;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.joints.RevoluteJoint;
import org.jbox2d.dynamics.joints.RevoluteJointDef;
import org.jbox2d.dynamics.joints.WheelJoint;
import org.jbox2d.dynamics.joints.WheelJointDef;

/** A machine in JBox2D, with 8 and 3 iterations, without sleep; a wheel on a spring is its wheel joint. */
final class JBox2DMachine implements MachineWorld {
    private final World world = new World(new Vec2(0, (float) -GRAVITY));
    private final List<Body> bodies = new ArrayList<>();
    private final Map<Integer, Joint> joints = new HashMap<>();

    JBox2DMachine() {
        world.setAllowSleep(false);
    }

    private int add(Shape shape, double x, double y, double friction, boolean fixed) {
        return add(List.of(shape), x, y, friction, fixed);
    }

    private int add(List<? extends Shape> shapes, double x, double y, double friction, boolean fixed) {
        BodyDef def = new BodyDef();
        def.type = fixed ? BodyType.STATIC : BodyType.DYNAMIC;
        def.position.set((float) x, (float) y);
        Body body = world.createBody(def);
        for (Shape shape : shapes) {
            FixtureDef fixture = new FixtureDef();
            fixture.shape = shape;
            fixture.density = 1;
            fixture.friction = (float) friction;
            fixture.restitution = 0;
            body.createFixture(fixture);
        }
        bodies.add(body);
        return bodies.size() - 1;
    }

    @Override
    public int box(double width, double height, double x, double y, double friction, boolean fixed) {
        PolygonShape box = new PolygonShape();
        box.setAsBox((float) (width / 2), (float) (height / 2));
        return add(box, x, y, friction, fixed);
    }

    @Override
    public int disc(double radius, double x, double y, double friction) {
        CircleShape circle = new CircleShape();
        circle.m_radius = (float) radius;
        return add(circle, x, y, friction, false);
    }

    @Override
    public int boxes(double[][] boxes, double x, double y, double friction) {
        List<PolygonShape> shapes = new ArrayList<>();
        for (double[] box : boxes) {
            PolygonShape shape = new PolygonShape();
            shape.setAsBox((float) (box[2] / 2), (float) (box[3] / 2), new Vec2((float) box[0], (float) box[1]), 0);
            shapes.add(shape);
        }
        return add(shapes, x, y, friction, false);
    }

    @Override
    public void remove(int body) {
        world.destroyBody(bodies.get(body));
    }

    @Override
    public void pin(int on, int body, double x, double y) {
        RevoluteJointDef def = new RevoluteJointDef();
        def.initialize(bodies.get(on), bodies.get(body), new Vec2((float) x, (float) y));
        joints.put(body, world.createJoint(def));
    }

    @Override
    public void suspend(int on, int wheel, double x, double y, double hub, double stiffness, double damping) {
        Body chassis = bodies.get(on);
        Body disc = bodies.get(wheel);
        MassData mass = new MassData();
        disc.getMassData(mass);
        mass.mass += (float) hub;
        disc.setMassData(mass);
        double arm = x - chassis.getPosition().x;
        double reduced = 1 / (1.0 / chassis.getMass() + 1.0 / disc.getMass() + arm * arm / chassis.getInertia());
        double omega = Math.sqrt(stiffness / reduced);
        WheelJointDef def = new WheelJointDef();
        def.initialize(chassis, disc, new Vec2((float) x, (float) y), new Vec2(0, 1));
        def.frequencyHz = (float) (omega / (2 * Math.PI));
        def.dampingRatio = (float) (damping / (2 * reduced * omega));
        joints.put(wheel, world.createJoint(def));
    }

    @Override
    public void motor(int hinge, double speed, double torque) {
        if (joints.get(hinge) instanceof WheelJoint wheel) {
            wheel.enableMotor(true);
            wheel.setMaxMotorTorque((float) torque);
        } else {
            RevoluteJoint joint = (RevoluteJoint) joints.get(hinge);
            joint.enableMotor(true);
            joint.setMaxMotorTorque((float) torque);
        }
        drive(hinge, speed);
    }

    @Override
    public void drive(int hinge, double speed) {
        if (joints.get(hinge) instanceof WheelJoint wheel) {
            wheel.setMotorSpeed((float) speed);
        } else {
            ((RevoluteJoint) joints.get(hinge)).setMotorSpeed((float) speed);
        }
    }

    @Override
    public void stops(int hinge, double lower, double upper) {
        RevoluteJoint joint = (RevoluteJoint) joints.get(hinge);
        joint.setLimits((float) lower, (float) upper);
        joint.enableLimit(true);
    }

    @Override
    public void launch(double vx, double vy) {
        bodies.forEach(body -> body.setLinearVelocity(new Vec2((float) vx, (float) vy)));
    }

    @Override
    public void step() {
        world.step((float) STEP, 8, 3);
    }

    @Override
    public double x(int body) {
        return bodies.get(body).getPosition().x;
    }

    @Override
    public double y(int body) {
        return bodies.get(body).getPosition().y;
    }

    @Override
    public double angle(int body) {
        return bodies.get(body).getAngle();
    }

    @Override
    public double vx(int body) {
        return bodies.get(body).getLinearVelocity().x;
    }
}
