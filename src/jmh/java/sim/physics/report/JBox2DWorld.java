// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: 2026 The mason-physics authors
package sim.physics.report;

import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.joints.DistanceJointDef;
import org.jbox2d.dynamics.joints.PrismaticJointDef;
import org.jbox2d.dynamics.joints.RevoluteJointDef;

/** A scene in JBox2D 2.2.1.1, single precision: with 8 and 3 iterations, or tuned with 20 and 10; no sleeping. */
final class JBox2DWorld implements World {
    /** Half of what shapes overlap at rest, so that polygons lie flush. */
    private static final float SKIN = 0.0025f;

    private final org.jbox2d.dynamics.World world;
    private final Body[] bodies;
    private final float dt;
    private final float push;
    private final float friction;
    private final boolean tuned;

    JBox2DWorld(Model model, double dt, boolean tuned) {
        this.dt = (float) dt;
        this.tuned = tuned;
        push = (float) model.push;
        friction = (float) model.friction;
        world = new org.jbox2d.dynamics.World(new Vec2((float) model.across, (float) -model.gravity));
        world.setAllowSleep(false);
        bodies = new Body[model.parts.size()];
        for (int k = 0; k < bodies.length; k++) {
            bodies[k] = body(model.parts.get(k));
        }
        Body ground = world.createBody(new BodyDef());
        for (Model.Pin pin : model.pins) {
            RevoluteJointDef joint = new RevoluteJointDef();
            joint.initialize(pin.b() < 0 ? ground : bodies[pin.b()], bodies[pin.a()], vector(pin.x(), pin.y()));
            world.createJoint(joint);
        }
        for (Model.Rod rod : model.rods) {
            DistanceJointDef joint = new DistanceJointDef();
            joint.initialize(ground, bodies[rod.a()], vector(rod.x(), rod.y()), bodies[rod.a()].getPosition());
            world.createJoint(joint);
        }
        for (Model.Slide slide : model.slides) {
            PrismaticJointDef joint = new PrismaticJointDef();
            joint.initialize(ground, bodies[slide.a()], bodies[slide.a()].getPosition(), vector(1, 0));
            world.createJoint(joint);
        }
        for (Model.Elastic s : model.springs) {
            DistanceJointDef joint = new DistanceJointDef();
            joint.initialize(ground, bodies[s.a()], vector(s.x(), s.y()), vector(s.px(), s.py()));
            joint.length = (float) s.length();
            double omega = Math.sqrt(s.stiffness() / model.parts.get(s.a()).mass());
            joint.frequencyHz = (float) (omega / (2 * Math.PI));
            joint.dampingRatio = (float) (s.damping() / (2 * omega * model.parts.get(s.a()).mass()));
            world.createJoint(joint);
        }
    }

    private static Vec2 vector(double x, double y) {
        return new Vec2((float) x, (float) y);
    }

    private Body body(Model.Part part) {
        double[] s = part.start();
        BodyDef definition = new BodyDef();
        definition.type = part.fixed() ? BodyType.STATIC : BodyType.DYNAMIC;
        definition.position.set((float) s[0], (float) s[1]);
        definition.angle = (float) s[2];
        definition.linearVelocity.set((float) s[3], (float) s[4]);
        definition.angularVelocity = (float) s[5];
        definition.allowSleep = false;
        Body body = world.createBody(definition);
        FixtureDef fixture = new FixtureDef();
        fixture.shape = shape(part);
        fixture.density = 1;
        // of two coefficients the geometric mean counts
        fixture.friction = friction;
        // of two coefficients the larger one counts there
        fixture.restitution = part.fixed() ? 0 : (float) part.e();
        if (!part.collides()) {
            fixture.filter.maskBits = 0;
        }
        body.createFixture(fixture);
        if (!part.fixed()) {
            MassData mass = new MassData();
            mass.mass = (float) part.mass();
            mass.I = (float) part.inertia();
            mass.center.setZero();
            body.setMassData(mass);
        }
        return body;
    }

    private Shape shape(Model.Part part) {
        if (part.kind() == Model.Kind.DISC) {
            CircleShape circle = new CircleShape();
            circle.m_radius = (float) part.size()[0];
            return circle;
        }
        double[][] corners = Model.corners(part);
        Vec2[] all = new Vec2[corners.length];
        for (int k = 0; k < all.length; k++) {
            all[k] = vector(corners[k][0], corners[k][1]);
        }
        PolygonShape polygon = new PolygonShape();
        polygon.set(all, all.length);
        if (tuned) {
            polygon.m_radius = SKIN;
        }
        return polygon;
    }

    @Override
    public void step() {
        if (push != 0) {
            bodies[0].applyForceToCenter(new Vec2(push, 0));
        }
        world.step(dt, tuned ? 20 : 8, tuned ? 10 : 3);
    }

    @Override
    public void read(double[] state) {
        for (int k = 0; k < bodies.length; k++) {
            int b = Model.BLOCK * k;
            state[b] = bodies[k].getPosition().x;
            state[b + 1] = bodies[k].getPosition().y;
            state[b + 2] = bodies[k].getAngle();
            state[b + 3] = bodies[k].getLinearVelocity().x;
            state[b + 4] = bodies[k].getLinearVelocity().y;
            state[b + 5] = bodies[k].getAngularVelocity();
        }
    }
}
